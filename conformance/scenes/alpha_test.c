/* Proves: the eight alpha functions against interpolated and equal alphas. */
#include "../scene.h"


SCENE(alpha_test, EXACT, 256, 256, 0, "all alpha functions")
{
    static const GLenum funcs[] = {GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
    pixels(width, height);
    glEnable(GL_ALPHA_TEST);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 8; i++) {
        double y = 4 + i * 31;
        glAlphaFunc(funcs[i], 0.5f);
        glColor4f(1, 0, 0, 0), glBegin(GL_QUADS), glVertex2d(4, y), glColor4f(0, 1, 0, 1), glVertex2d(180, y), glVertex2d(180, y + 27), glColor4f(1, 0, 0, 0), glVertex2d(4, y + 27), glEnd();
        glColor4f(1, 1, 0, 0.5f);
        quad(190, y, 215, y + 27, 0);
        glColor4f(0, 1, 1, 128 / 255.0f);
        quad(222, y, 250, y + 27, 0);
    }
    glDisable(GL_ALPHA_TEST);
}
