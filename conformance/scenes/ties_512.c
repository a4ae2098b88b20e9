/* Proves: snapping of vertices that lie exactly between two subpixel positions (odd multiples of 1/512 pixel). */
#include "../scene.h"


SCENE(ties_512, EXACT, 512, 512, 0, "384 triangles with vertices on 1/512 ties: snapping rounds as the reference does")
{
    pixels(width, height);
    seed(13);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 384; i++) {
        double cx = 20 + (i % 24) * 20.0, cy = 30 + (i / 24) * 29.0;
        glColor3d(uniform(0.2, 1), uniform(0.2, 1), uniform(0.2, 1));
        for (int k = 0; k < 3; k++) {
            double x = floor(uniform(-9, 9)) + (floor(uniform(0, 256)) * 2 + 1) / 512;
            double y = floor(uniform(-13, 13)) + (floor(uniform(0, 256)) * 2 + 1) / 512;
            glVertex2d(cx + x, cy + y);
        }
    }
    glEnd();
}
