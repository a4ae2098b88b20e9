/* Proves: row length, skips, alignment, swapped bytes and bit order in unpacking, and packing to match. */
#include "../scene.h"


SCENE(pixel_store, OTHER, 256, 256, 0, "pixel store: alignment, row length, skips, swapped bytes")
{
    unsigned char *image = noise(128, 64), packed[64 * 8];
    pixels(width, height);
    for (int a = 1, i = 0; a <= 8; a *= 2, i++) {
        glPixelStorei(GL_UNPACK_ALIGNMENT, a);
        glRasterPos2i(5 + i * 62, 5);
        /* Another pointer each time: the reference takes the same pointer for the same image, whatever the pixel store says. */
        glDrawPixels(53, 50, GL_RGB, GL_UNSIGNED_BYTE, image + 8 * i);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 57);
        glPixelStorei(GL_UNPACK_SKIP_ROWS, 2);
        glPixelStorei(GL_UNPACK_SKIP_PIXELS, i);
        glRasterPos2i(5 + i * 62, 65);
        glDrawPixels(51, 50, GL_LUMINANCE, GL_UNSIGNED_BYTE, image + 8 * i);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
        glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
        glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
        /* Not together with skips: there the reference reads beyond the image. */
        glPixelStorei(GL_UNPACK_SWAP_BYTES, i & 1);
        glRasterPos2i(5 + i * 62, 130);
        glDrawPixels(20, 50, GL_RGB, GL_UNSIGNED_SHORT, image + 8 * i);
        glPixelStorei(GL_UNPACK_SWAP_BYTES, 0);
        memset(packed, 0xEE, sizeof packed);
        glPixelStorei(GL_PACK_ALIGNMENT, a);
        glPixelStorei(GL_PACK_ROW_LENGTH, 7);
        glPixelStorei(GL_PACK_SKIP_PIXELS, 1);
        glPixelStorei(GL_PACK_SWAP_BYTES, i & 1);
        glReadPixels(10, 10, 5, 3, GL_RGB, i & 1 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE, packed);
        unsigned sum = 0;
        for (size_t k = 0; k < sizeof packed; k++) sum = sum * 31 + packed[k];
        text("alignment %d: %08x", a, sum);
        glPixelStorei(GL_PACK_SWAP_BYTES, 0);
        glPixelStorei(GL_PACK_ROW_LENGTH, 0);
        glPixelStorei(GL_PACK_SKIP_PIXELS, 0);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    free(image);
}
