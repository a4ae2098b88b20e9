/* Proves: images of every type and most formats, byte order and alignment variants among them, unpack to the same texels. */
#include "../scene.h"


SCENE(tex_unpack_types, SHADED, 256, 256, 0, "texture images of every type and format")
{
    static const GLenum types[] = {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT};
    static const GLenum formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_RGBA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
    unsigned char data[8 * 8 * 4 * 4];
    pixels(width, height);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (int t = 0; t < 7; t++) {
        glPixelStorei(GL_UNPACK_SWAP_BYTES, t == 2 || t == 5);
        for (size_t i = 0; i < sizeof data / 4; i++) {
            if (types[t] == GL_FLOAT) ((GLfloat *)data)[i] = (GLfloat)(i * 37 % 256) / 255;
            else ((GLuint *)data)[i] = (GLuint)i * 2654435761u;
        }
        for (int f = 0; f < 8; f++) {
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, formats[f], types[t], data);
            quad_textured(f * 32 + 1, t * 36 + 1, f * 32 + 31, t * 36 + 35, 0);
        }
    }
    glPixelStorei(GL_UNPACK_SWAP_BYTES, 0);
}
