/* Proves: the squares that points of sizes 1 to 20 cover, at many subpixel positions. */
#include "../scene.h"


SCENE(point_sizes, OTHER, 256, 256, 0, "points of sizes 1 to 20 at many subpixel positions")
{
    pixels(width, height);
    seed(31);
    for (int i = 0; i < 60; i++) {
        glPointSize(1 + (GLfloat)i / 3.0f);
        glBegin(GL_POINTS);
        for (int k = 0; k < 3; k++) glColor3d(uniform(0.2, 1), uniform(0.2, 1), uniform(0.2, 1)), glVertex2d(uniform(10, 246), uniform(10, 246));
        glEnd();
    }
    glPointSize(1);
}
