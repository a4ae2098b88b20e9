/* Proves: which diagonal splits a quad whose corner colours are not planar, in immediate mode and glDrawArrays: 0-2. */
#include "../scene.h"


SCENE(quads_diagonal, EXACT, 256, 256, 0, "quads with colours that are not planar: the diagonal 0-2")
{
    static const GLfloat color[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
    pixels(width, height);
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; i++) glColor3fv(color[i]), glVertex2f(10 + 100.0f * (i == 1 || i == 2), 10 + 100.0f * (i >= 2));
    glEnd();
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i < 6; i++) glColor3fv(color[i % 4]), glVertex2f(140 + 50.0f * (GLfloat)(i / 2), i & 1 ? 110 : 10);
    glEnd();
    glBegin(GL_POLYGON);
    for (int i = 0; i < 7; i++) glColor3fv(color[i % 4]), glVertex2d(60 + 50 * cos(i * M_PI / 3.5), 190 + 50 * sin(i * M_PI / 3.5));
    glEnd();
    static const GLfloat vertex[4][2] = {{140, 140}, {240, 150}, {230, 240}, {130, 230}};
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, vertex);
    glColorPointer(3, GL_FLOAT, 0, color);
    glDrawArrays(GL_QUADS, 0, 4);
}
