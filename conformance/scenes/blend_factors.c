/* Proves: every pair of source and destination factors, in unorm8 arithmetic. */
#include "../scene.h"


SCENE(blend_factors, EXACT, 320, 256, 0, "all pairs of blend factors")
{
    static const GLenum src[] = {GL_ZERO, GL_ONE, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_SRC_ALPHA_SATURATE};
    static const GLenum dst[] = {GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA};
    pixels(width, height);
    glBegin(GL_TRIANGLE_STRIP);
    glColor4f(1, 0.2f, 0.1f, 0.3f), glVertex2i(0, 0), glColor4f(0.1f, 0.9f, 0.3f, 1), glVertex2i(320, 0);
    glColor4f(0.3f, 0.3f, 1, 0), glVertex2i(0, 256), glColor4f(0.9f, 0.7f, 0.2f, 0.7f), glVertex2i(320, 256);
    glEnd();
    glEnable(GL_BLEND);
    for (int s = 0; s < 9; s++)
        for (int d = 0; d < 8; d++) {
            double x = s * 35 + 3, y = d * 32 + 2;
            glBlendFunc(src[s], dst[d]);
            glBegin(GL_TRIANGLE_STRIP);
            glColor4f(0.8f, 0.1f, 0.5f, 0.1f), glVertex2d(x, y), glColor4f(0.2f, 0.9f, 0.4f, 0.9f), glVertex2d(x + 30, y);
            glColor4f(0.6f, 0.6f, 0.1f, 0.5f), glVertex2d(x, y + 28), glColor4f(0.1f, 0.3f, 1, 1), glVertex2d(x + 30, y + 28);
            glEnd();
        }
    glDisable(GL_BLEND);
}
