/* Proves: the cases in which the reference splits quads along 1-3: glDrawElements and quads compiled in a display list. */
#include "../scene.h"


SCENE(quads_diagonal_other, EXACT, 256, 256, 0, "quads by DrawElements and in display lists: the diagonal 1-3")
{
    static const GLfloat color[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
    static const GLfloat vertex[4][2] = {{140, 140}, {240, 150}, {230, 240}, {130, 230}};
    static const GLubyte index[4] = {0, 1, 2, 3};
    pixels(width, height);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, vertex);
    glColorPointer(3, GL_FLOAT, 0, color);
    glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, index);
    glNewList(1, GL_COMPILE);
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; i++) glColor3fv(color[i]), glVertex2f(10 + 100.0f * (i == 1 || i == 2), 10 + 100.0f * (i >= 2));
    glEnd();
    glEndList();
    glCallList(1);
    glDeleteLists(1, 1);
}
