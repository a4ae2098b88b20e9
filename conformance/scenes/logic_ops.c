/* Proves: the sixteen logic operations; they win over blending. */
#include "../scene.h"


SCENE(logic_ops, EXACT, 256, 256, 0, "all logic operations")
{
    pixels(width, height);
    for (int i = 0; i < 8; i++) glColor4d((i & 1) * 0.7 + 0.1, (i & 2) * 0.4, (i & 4) * 0.2, i / 8.0), quad(i * 32, 0, i * 32 + 32, 256, 0);
    glEnable(GL_COLOR_LOGIC_OP);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (int i = 0; i < 16; i++) {
        glLogicOp((GLenum)(GL_CLEAR + i));
        glColor4d(0.65, 0.3, 0.9, 0.4);
        quad(4, i * 16 + 2, 252, i * 16 + 14, 0);
    }
    glDisable(GL_COLOR_LOGIC_OP);
    glDisable(GL_BLEND);
}
