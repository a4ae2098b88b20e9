/* Proves: texture objects keep their images and parameters apart; deletion, residence, default object. */
#include "../scene.h"


SCENE(tex_objects, SHADED, 256, 256, 0, "many texture objects, some deleted and bound again")
{
    GLuint names[6];
    GLint bound;
    GLboolean resident[6];
    pixels(width, height);
    glEnable(GL_TEXTURE_2D);
    for (int i = 0; i < 6; i++) names[i] = checker_texture(8 << (i % 3), 2 + i, i & 1 ? GL_LINEAR : GL_NEAREST, i & 1 ? GL_LINEAR : GL_NEAREST);
    glDeleteTextures(1, &names[5]);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    text("bound after deletion %d, is texture %d %d", bound, glIsTexture(names[4]), glIsTexture(names[5]));
    text("all resident %d", glAreTexturesResident(5, names, resident));
    for (int i = 0; i < 6; i++) {
        glBindTexture(GL_TEXTURE_2D, i < 5 ? names[i] : 0);
        quad_textured(4 + i % 3 * 84, 4 + i / 3 * 126, 82 + i % 3 * 84, 122 + i / 3 * 126, 0);
    }
    glBindTexture(GL_TEXTURE_1D, names[0]);
    text_error("a 2D texture bound as 1D");
    glDeleteTextures(5, names);
}
