/* Proves: the stencil operations (fail, depth fail, pass) at their bounds, wrap variants among them. */
#include "../scene.h"

#ifndef GL_INCR_WRAP
#define GL_INCR_WRAP 0x8507
#define GL_DECR_WRAP 0x8508
#endif

SCENE(stencil_ops, EXACT, 256, 256, 0, "all stencil operations at fail, depth fail and pass")
{
    static const GLenum ops[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
    pixels(width, height);
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glColor3f(0.3f, 0.3f, 0.3f);
    for (int i = 0; i < 4; i++) {
        static const int start[] = {0, 1, 254, 255};
        glStencilFunc(GL_ALWAYS, start[i], ~0u);
        glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
        quad(i * 64, 0, i * 64 + 64, 256, -0.2 * (i & 1));
    }
    for (int i = 0; i < 24; i++) {
        GLenum op = ops[i % 8];
        if (i < 8) glStencilOp(op, GL_KEEP, GL_KEEP), glStencilFunc(GL_NEVER, 77, ~0u);
        else if (i < 16) glStencilOp(GL_KEEP, op, GL_KEEP), glStencilFunc(GL_ALWAYS, 77, ~0u);
        else glStencilOp(GL_KEEP, GL_KEEP, op), glStencilFunc(GL_ALWAYS, 77, ~0u);
        glColor3d(1, i / 24.0, 0);
        for (int k = 0; k < 2; k++) quad(3, i * 10.5 + 1, 253, i * 10.5 + 10, i < 16 && i >= 8 ? -0.9 : 0.1);
    }
    glDisable(GL_STENCIL_TEST);
}
