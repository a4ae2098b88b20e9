/* Proves: MODULATE, DECAL, BLEND, REPLACE and ADD for each base format, with alpha blended in. */
#include "../scene.h"

#ifndef GL_ADD
#define GL_ADD 0x0104
#endif

SCENE(tex_env, SHADED, 384, 256, 0, "every environment mode on every base format")
{
    static const GLenum modes[] = {GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE, GL_ADD};
    static const GLenum formats[] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA};
    GLfloat constant[] = {0.9f, 0.3f, 0.1f, 0.6f};
    unsigned char *image = checker(16, 16, 4);
    pixels(width, height);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (int f = 0; f < 6; f++) {
        glTexImage2D(GL_TEXTURE_2D, 0, (GLint)formats[f], 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
        for (int m = 0; m < 5; m++) {
            if (modes[m] == GL_DECAL && f < 4) continue; /* undefined */
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, (GLint)modes[m]);
            glColor4d(0.7, 0.8, m / 5.0, 0.8);
            quad_textured(f * 64 + 2, m * 51 + 2, f * 64 + 62, m * 51 + 49, 0);
        }
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    free(image);
}
