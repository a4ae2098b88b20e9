/* Proves: round antialiased points, blended. */
#include "../scene.h"


SCENE(point_smooth, OTHER, 256, 256, 0, "smooth points of several sizes, blended")
{
    pixels(width, height);
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < 36; i++) {
        glPointSize(1 + (GLfloat)i * 0.75f);
        glColor3f(1, (GLfloat)i / 36, 0.3f);
        glBegin(GL_POINTS);
        glVertex2d(22 + i % 6 * 42 + i * 0.07, 22 + i / 6 * 42 + i * 0.05);
        glEnd();
    }
}
