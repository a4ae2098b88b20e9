/* Proves: triangles that cross every side of the frustum, near and far among them, are cut where the reference cuts them. */
#include "../scene.h"


SCENE(clipped_triangles, OTHER, 256, 256, 0, "triangles that cross all six planes of the frustum")
{
    perspective(60, (double)width / height, 1, 10);
    glEnable(GL_DEPTH_TEST);
    seed(17);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 60; i++) {
        for (int k = 0; k < 3; k++) {
            glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
            glVertex3d(uniform(-6, 6), uniform(-6, 6), uniform(-12, 1));
        }
    }
    glEnd();
}
