/* Proves: sub-images with skips and row lengths replace just their rectangle. */
#include "../scene.h"


SCENE(tex_sub_image, SHADED, 256, 256, 0, "sub-images with unpack skips and row length")
{
    pixels(width, height);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    checker_texture(64, 8, GL_NEAREST, GL_NEAREST);
    unsigned char *image = noise(40, 40);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 40);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 3);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 10, 20, 30, 25, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 60, 60, 4, 4, GL_BGRA, GL_UNSIGNED_BYTE, image);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 60, 60, 5, 4, GL_RGBA, GL_UNSIGNED_BYTE, image);
    text_error("a rectangle beyond the image");
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    quad_textured(0, 0, 256, 256, 0);
    free(image);
}
