/* Proves: the stencil write mask in drawing and clearing. */
#include "../scene.h"


SCENE(stencil_mask, EXACT, 256, 256, 0, "stencil masks in drawing and clearing")
{
    pixels(width, height);
    glEnable(GL_STENCIL_TEST);
    glClearStencil(0xA5);
    glClear(GL_STENCIL_BUFFER_BIT);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (int i = 0; i < 8; i++) {
        glStencilMask(1u << i | 0x10);
        glStencilFunc(GL_ALWAYS, 0x5A + i, ~0u);
        glColor3d(i / 8.0, 1, 0);
        quad(10 + i * 25, 10 + i * 10, 60 + i * 25, 180 + i * 8, 0);
    }
    glEnable(GL_SCISSOR_TEST);
    glScissor(100, 100, 100, 30);
    glStencilMask(0x0F);
    glClearStencil(300);
    glClear(GL_STENCIL_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glStencilMask(~0u);
    glClearStencil(0);
    glDisable(GL_STENCIL_TEST);
}
