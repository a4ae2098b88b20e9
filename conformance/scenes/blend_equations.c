/* Proves: add, subtract, reverse subtract, minimum, maximum, and the constant colour factors. */
#include "../scene.h"




SCENE(blend_equations, EXACT, 256, 256, 0, "blend equations and constant colours")
{
    static const GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    static const GLenum factors[] = {GL_ONE, GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR, GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA};
    pixels(width, height);
    glBegin(GL_TRIANGLE_STRIP);
    glColor4f(1, 0.2f, 0.1f, 0.3f), glVertex2i(0, 0), glColor4f(0.1f, 0.9f, 0.3f, 1), glVertex2i(256, 0);
    glColor4f(0.3f, 0.3f, 1, 0), glVertex2i(0, 256), glColor4f(0.9f, 0.7f, 0.2f, 0.7f), glVertex2i(256, 256);
    glEnd();
    glEnable(GL_BLEND);
    glBlendColor(0.7f, 0.3f, 0.5f, 0.4f);
    for (int e = 0; e < 5; e++)
        for (int f = 0; f < 5; f++) {
            double x = f * 50 + 4, y = e * 50 + 4;
            glBlendEquation(equations[e]);
            glBlendFunc(factors[f], factors[(f + 2) % 5]);
            glBegin(GL_TRIANGLE_STRIP);
            glColor4f(0.8f, 0.1f, 0.5f, 0.1f), glVertex2d(x, y), glColor4f(0.2f, 0.9f, 0.4f, 0.9f), glVertex2d(x + 45, y);
            glColor4f(0.6f, 0.6f, 0.1f, 0.5f), glVertex2d(x, y + 45), glColor4f(0.1f, 0.3f, 1, 1), glVertex2d(x + 45, y + 45);
            glEnd();
        }
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}
