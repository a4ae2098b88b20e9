/* Proves: interpolated colour and depth of a few overlapping triangles, depth tested, inside the frustum. */
#include "../scene.h"

SCENE(triangles_smooth, EXACT, 256, 256, 0, "interpolated colour and depth of overlapping triangles")
{
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    seed(1);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 120; i++) {
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        glVertex3d(uniform(0, width), uniform(0, height), uniform(-1, 1));
    }
    glEnd();
}
