/* Proves: bitmaps with origins, moves, bit order, skips; the raster colour; bits that are off leave the pixel. */
#include "../scene.h"


SCENE(bitmaps, OTHER, 256, 256, 0, "bitmaps with origins and moves, bit order, row lengths")
{
    static const GLubyte letter[] = {0x00, 0x00, 0xc3, 0xc3, 0xc3, 0xc3, 0xff, 0xc3, 0xc3, 0xc3, 0x66, 0x3c, 0x18};
    GLubyte big[64 * 8];
    GLfloat position[4];
    pixels(width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int line = 0; line < 6; line++) {
        glColor3d(1, line / 6.0, 0.3);
        glRasterPos2d(5.3 + line * 0.2, 10 + line * 16.4);
        for (int i = 0; i < 12; i++) glBitmap(8, 13, 0, (GLfloat)(i % 3), 10.5f, i & 1 ? 1.5f : -1.5f, letter);
    }
    glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
    text("%.4f %.4f", position[0], position[1]);
    for (int i = 0; i < 512; i++) big[i] = (GLubyte)(i * 73 + i / 8 * 5);
    glColor3f(0, 1, 1);
    glRasterPos2i(10, 130);
    glBitmap(61, 50, 0, 0, 70, 0, big);
    glPixelStorei(GL_UNPACK_LSB_FIRST, 1);
    glBitmap(61, 50, 0, 0, 70, 0, big);
    glPixelStorei(GL_UNPACK_LSB_FIRST, 0);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 64);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 3);
    glBitmap(50, 50, 0, 0, 0, 0, big);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}
