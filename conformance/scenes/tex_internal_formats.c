/* Proves: the sized internal formats keep as many bits as they promise (or as many as the reference keeps). */
#include "../scene.h"


SCENE(tex_internal_formats, SHADED, 256, 256, 0, "sized internal formats of a smooth gradient")
{
    static const GLenum formats[] = {GL_RGBA8, GL_RGB8, GL_RGBA4, GL_RGB5_A1, GL_RGB5, GL_R3_G3_B2, GL_RGBA2, GL_RGB10_A2, GL_RGBA12, GL_RGBA16, GL_LUMINANCE4, GL_LUMINANCE8,
        GL_LUMINANCE4_ALPHA4, GL_INTENSITY8, GL_ALPHA8, GL_RGB16};
    GLubyte image[64 * 4 * 4];
    pixels(width, height);
    for (int i = 0; i < 256; i++) image[4 * i] = (GLubyte)i, image[4 * i + 1] = (GLubyte)(255 - i), image[4 * i + 2] = (GLubyte)(i * 5), image[4 * i + 3] = (GLubyte)(i * 3);
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (int i = 0; i < 16; i++) {
        glTexImage2D(GL_TEXTURE_2D, 0, (GLint)formats[i], 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
        double x = i % 4 * 64, y = i / 4 * 64;
        quad_textured(x + 1, y + 1, x + 63, y + 63, 0);
    }
}
