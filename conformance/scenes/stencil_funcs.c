/* Proves: the eight stencil functions with masks. */
#include "../scene.h"


SCENE(stencil_funcs, EXACT, 256, 256, 0, "all stencil functions with masks")
{
    static const GLenum funcs[] = {GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
    pixels(width, height);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
    glColorMask(0, 0, 0, 0);
    for (int i = 0; i < 16; i++) glStencilFunc(GL_ALWAYS, i * 17, ~0u), quad(i * 16, 0, i * 16 + 16, 256, 0);
    glColorMask(1, 1, 1, 1);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    for (int i = 0; i < 16; i++) {
        glStencilFunc(funcs[i % 8], i < 8 ? 102 : 0x3C, i < 8 ? ~0u : 0x0Fu);
        glColor3d(1, i / 16.0, 0.3);
        quad(2, i * 16 + 1, 254, i * 16 + 14, 0);
    }
    glDisable(GL_STENCIL_TEST);
}
