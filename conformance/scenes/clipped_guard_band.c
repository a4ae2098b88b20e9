/* Proves: triangles far larger than the window, with all depths inside: the guard band of the reference. */
#include "../scene.h"


SCENE(clipped_guard_band, OTHER, 256, 256, 0, "triangles up to a thousand times larger than the window")
{
    UNUSED_SIZE;
    glEnable(GL_DEPTH_TEST);
    seed(18);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 40; i++) {
        double scale = pow(10, uniform(-0.5, 3));
        for (int k = 0; k < 3; k++) {
            glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
            glVertex3d(uniform(-1, 1) * (k ? 0.9 : scale), uniform(-1, 1) * (k > 1 ? scale : 0.9), uniform(-1, 1));
        }
    }
    glEnd();
}
