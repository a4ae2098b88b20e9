/* Proves: viewports inside, beyond and partly outside the window, and depth ranges, reversed ones among them. */
#include "../scene.h"


SCENE(viewport_depth_range, EXACT, 256, 256, 0, "viewports and depth ranges, reversed ones among them")
{
    UNUSED_SIZE;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    for (int i = 0; i < 16; i++) {
        glViewport(i % 4 * 64 + i / 4, i / 4 * 64 + i % 4, 60 - i, 45 + i);
        glDepthRange(i / 16.0, i & 1 ? 0.1 : 1.0);
        glColor3d(i / 16.0, 0.5, 1 - i / 16.0);
        glBegin(GL_TRIANGLES);
        glVertex3d(-0.9, -0.8, -0.9), glVertex3d(0.95, -0.7, 0.1), glVertex3d(0.1, 0.9, 0.9);
        glEnd();
    }
    glDepthRange(0, 1);
    glViewport(0, 0, width, height);
}
