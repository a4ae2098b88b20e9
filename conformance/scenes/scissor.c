/* Proves: the scissor cuts drawing, clearing, bitmaps and pixel rectangles. */
#include "../scene.h"


SCENE(scissor, EXACT, 256, 256, 0, "scissor boxes, some empty or beyond the window")
{
    pixels(width, height);
    glEnable(GL_SCISSOR_TEST);
    for (int i = 0; i < 20; i++) {
        glScissor(i * 13 - 20, i * 11 - 10, 60 - i * 2, 25 + i);
        glColor3d(i / 20.0, 0.6, 1 - i / 20.0);
        glBegin(GL_TRIANGLES);
        glVertex2f(5, 10), glVertex2f(250, 30), glVertex2f(120, 250);
        glEnd();
        if (i % 4 == 0) glClearColor(0, (GLfloat)i / 20, 0, 1), glScissor(i * 12, 220, 9, 30), glClear(GL_COLOR_BUFFER_BIT);
    }
    glScissor(10, 10, 0, 50);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.1f, 0.1f, 0.15f, 1);
}
