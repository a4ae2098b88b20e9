/* Proves: glDrawPixels of colour formats and types at raster positions, some of them fractional. */
#include "../scene.h"


SCENE(draw_pixels_formats, OTHER, 256, 256, 0, "glDrawPixels of most formats and types")
{
    static const GLenum formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_RGBA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
    static const GLenum types[] = {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT};
    unsigned char data[24 * 24 * 4 * 4];
    pixels(width, height);
    for (int t = 0; t < 7; t++) {
        for (size_t i = 0; i < sizeof data / 4; i++) {
            if (types[t] == GL_FLOAT) ((GLfloat *)data)[i] = (GLfloat)(i * 37 % 300) / 280 - 0.05f;
            else ((GLuint *)data)[i] = (GLuint)i * 2654435761u;
        }
        for (int f = 0; f < 8; f++) {
            glRasterPos2d(f * 32 + 2 + f * 0.13, t * 36 + 3 + t * 0.21);
            glDrawPixels(24, 24, formats[f], types[t], data);
        }
    }
}
