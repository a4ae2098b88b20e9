/* Proves: the depth mask, depth clears to other values, depth test without writes. */
#include "../scene.h"


SCENE(depth_mask, EXACT, 256, 256, 0, "depth masks and depth clears")
{
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(60, 60, 100, 100);
    glClearDepth(0.25);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glClearDepth(1);
    for (int i = 0; i < 8; i++) {
        glDepthMask((GLboolean)(i & 1));
        glColor3d(i / 8.0, 1 - i / 8.0, 0.5);
        glBegin(GL_TRIANGLES);
        glVertex3d(5 + i * 10, 10 + i * 5, -0.9 + i * 0.1), glVertex3d(240, 20 + i * 20, 0.9 - i * 0.1), glVertex3d(40 + i * 12, 240, -0.2);
        glEnd();
    }
    glDepthMask(GL_FALSE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDepthMask(GL_TRUE);
}
