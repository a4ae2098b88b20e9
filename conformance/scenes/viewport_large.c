/* Proves: viewports larger than the window and with negative origins. */
#include "../scene.h"


SCENE(viewport_large, OTHER, 256, 256, 0, "viewports beyond the window")
{
    glViewport(-200, -300, 700, 900);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0), glVertex2f(-0.9f, -0.8f), glColor3f(0, 1, 0), glVertex2f(0.9f, -0.7f), glColor3f(0, 0, 1), glVertex2f(0, 0.9f);
    glEnd();
    glViewport(128, 128, 512, 512);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 1, 0), glVertex2f(-1, -1), glColor3f(0, 1, 1), glVertex2f(1, -0.8f), glColor3f(1, 0, 1), glVertex2f(-0.4f, 1);
    glEnd();
    glViewport(0, 0, width, height);
}
