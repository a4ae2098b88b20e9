/* Proves: a 16 bit depth buffer rounds as one. */
#include "../scene.h"


SCENE(depth_16, EXACT, 256, 256, DEPTH16, "nearly coplanar triangles in a 16 bit depth buffer")
{
    perspective(60, (double)width / height, 1, 100);
    look_at(0, 3, 6, 0, 0, 0);
    glEnable(GL_DEPTH_TEST);
    seed(41);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 200; i++) {
        double cx = uniform(-1.6, 1.6), cz = uniform(-1.6, 1.6);
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        for (int k = 0; k < 3; k++) glVertex3d(cx + uniform(-0.9, 0.9), uniform(-0.001, 0.001), cz + uniform(-0.9, 0.9));
    }
    glEnd();
}
