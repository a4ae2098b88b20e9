/* Proves: triangles thinner than a pixel, long and short, cover exactly the pixel centres that they contain. */
#include "../scene.h"


SCENE(slivers, EXACT, 256, 256, 0, "slivers thinner than a pixel")
{
    pixels(width, height);
    seed(20);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 500; i++) {
        double x = uniform(1, 255), y = uniform(1, 255), a = uniform(0, 2 * M_PI), t = uniform(0.001, 1.5);
        double ex = 128 + uniform(-126, 126), ey = 128 + uniform(-126, 126);
        glColor3d(uniform(0.2, 1), uniform(0.2, 1), uniform(0.2, 1));
        glVertex2d(x, y), glVertex2d(ex, ey), glVertex2d(fmin(fmax(x + t * cos(a), 0), 256), fmin(fmax(y + t * sin(a), 0), 256));
    }
    glEnd();
}
