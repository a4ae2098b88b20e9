/* Proves: colour masks in drawing, blending and clearing. */
#include "../scene.h"


SCENE(color_mask, EXACT, 256, 256, 0, "all sixteen colour masks")
{
    pixels(width, height);
    glEnable(GL_SCISSOR_TEST);
    for (int i = 0; i < 16; i++) {
        glColorMask(i & 1, (i >> 1) & 1, (i >> 2) & 1, (i >> 3) & 1);
        glScissor(i % 4 * 64, i / 4 * 64, 64, 64);
        glClearColor(0.9f, 0.8f, 0.7f, 0.2f);
        glClear(GL_COLOR_BUFFER_BIT);
        glColor4d(0.1, 0.9, 0.3, 0.6);
        quad(i % 4 * 64 + 10, i / 4 * 64 + 10, i % 4 * 64 + 40, i / 4 * 64 + 40, 0);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glColor4d(0.9, 0.1, 0.9, 0.6);
        quad(i % 4 * 64 + 25, i / 4 * 64 + 25, i % 4 * 64 + 60, i / 4 * 64 + 60, 0);
        glDisable(GL_BLEND);
    }
    glColorMask(1, 1, 1, 1);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.1f, 0.1f, 0.15f, 1);
}
