/* Proves: as zfight_planes, but through a perspective projection and with both windings. */
#include "../scene.h"


SCENE(zfight_perspective, EXACT, 1024, 768, 0, "400 coplanar triangles of both windings in perspective")
{
    perspective(60, (double)width / height, 1, 100);
    look_at(0, 2.6, 3.4, 0, 0, 0);
    glEnable(GL_DEPTH_TEST);
    seed(12);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 400; i++) {
        double cx = uniform(-1.6, 1.6), cz = uniform(-1.6, 1.6);
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        for (int k = 0; k < 3; k++) glVertex3d(cx + uniform(-0.7, 0.7), 0, cz + uniform(-0.7, 0.7));
    }
    glEnd();
}
