/* Proves: linear filtering between strong colours and alphas, at a very large magnification. */
#include "../scene.h"


SCENE(tex_linear_colors, SHADED, 256, 256, 0, "a 4 x 4 texture magnified 60 times, blended by its alpha")
{
    static const GLubyte image[64] = {255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 0, 255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 0, 64, 0, 255, 255, 255, 255, 0, 255, 30,
        10, 200, 30, 255, 200, 10, 90, 255, 90, 10, 200, 128, 1, 2, 3, 4, 255, 255, 255, 0, 128, 128, 128, 255, 64, 64, 64, 255, 0, 0, 0, 0};
    pixels(width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    quad_textured(8, 8, 248, 248, 0);
}
