/* Proves: where points of size 1 land, with interpolation-free colours and depth. */
#include "../scene.h"


SCENE(points_colors, OTHER, 256, 256, 0, "points of size 1 at random places, depth tested")
{
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    seed(30);
    glBegin(GL_POINTS);
    for (int i = 0; i < 3000; i++) {
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        glVertex3d(uniform(0, width), uniform(0, height), uniform(-1, 1));
    }
    glEnd();
}
