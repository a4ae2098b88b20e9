/* Proves: GL_LOAD, ACCUM, MULT, ADD and RETURN with clamping and masks. */
#include "../scene.h"


SCENE(accum_ops, OTHER, 256, 256, ACCUM, "all accumulation operations")
{
    pixels(width, height);
    glEnable(GL_SCISSOR_TEST);
    for (int i = 0; i < 8; i++) {
        glScissor(i % 4 * 64, i / 4 * 128, 62, 126);
        glClearAccum(0.1f, 0.2f, 0.05f, 0.15f);
        glClear(GL_ACCUM_BUFFER_BIT);
        glBegin(GL_TRIANGLES);
        glColor4f(1, 0, 0.3f, 1), glVertex2d(i % 4 * 64, i / 4 * 128), glColor4f(0, 1, 0.5f, 0.5f), glVertex2d(i % 4 * 64 + 62, i / 4 * 128 + 10);
        glColor4f(0, 0.2f, 1, 0.2f), glVertex2d(i % 4 * 64 + 20, i / 4 * 128 + 120);
        glEnd();
        if (i != 1) glAccum(i & 1 ? GL_ACCUM : GL_LOAD, i == 2 ? 0.5f : i & 1 ? 0.7f : 0.9f); /* beyond -1..1 the result is undefined */
        if (i == 3) glAccum(GL_MULT, 0.7f);
        if (i == 4) glAccum(GL_ADD, 0.1f);
        if (i == 5) glAccum(GL_ACCUM, 0.1f), glAccum(GL_ADD, -0.2f);
        if (i == 6) glAccum(GL_ACCUM, 0.1f), glColorMask(1, 0, 1, 1);
        glAccum(GL_RETURN, i == 7 ? 0.6f : 1);
        glColorMask(1, 1, 1, 1);
    }
    glDisable(GL_SCISSOR_TEST);
}
