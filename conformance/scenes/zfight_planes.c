/* Proves: 400 triangles that lie in one tilted plane but have different vertices, so that the last bit of each depth decides
 * which one is seen: plane equations, their order of operations and the depth format are the reference's. */
#include "../scene.h"


SCENE(zfight_planes, EXACT, 1024, 768, 0, "400 coplanar triangles fighting in one tilted plane")
{
    UNUSED_SIZE;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    seed(11);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 400; i++) {
        double cx = uniform(-0.6, 0.6), cy = uniform(-0.6, 0.6);
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        for (int k = 0; k < 3; k++) {
            double x = cx + uniform(-0.38, 0.38), y = cy + uniform(-0.38, 0.38);
            glVertex3d(x, y, 0.31 * x + 0.23 * y + 0.11);
        }
    }
    glEnd();
}
