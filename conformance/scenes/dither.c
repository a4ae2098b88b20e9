/* Proves: what GL_DITHER does to an 8 bit buffer: nothing. */
#include "../scene.h"


SCENE(dither, EXACT, 256, 256, 0, "a gradient with and without GL_DITHER")
{
    pixels(width, height);
    for (int i = 0; i < 2; i++) {
        if (i) glDisable(GL_DITHER);
        else glEnable(GL_DITHER);
        glBegin(GL_TRIANGLE_STRIP);
        glColor3f(0.1f, 0.1f, 0.2f), glVertex2d(4, 4 + i * 126), glColor3f(0.2f, 0.15f, 0.2f), glVertex2d(252, 4 + i * 126);
        glColor3f(0.15f, 0.2f, 0.2f), glVertex2d(4, 124 + i * 126), glColor3f(0.1f, 0.3f, 0.25f), glVertex2d(252, 124 + i * 126);
        glEnd();
    }
    glEnable(GL_DITHER);
}
