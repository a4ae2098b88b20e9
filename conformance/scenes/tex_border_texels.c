/* Proves: images with a one texel border are taken as the reference takes them. */
#include "../scene.h"


SCENE(tex_border_texels, SHADED, 256, 256, 0, "images with border texels")
{
    pixels(width, height);
    unsigned char *image = checker(18, 18, 3);
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 18, 18, 1, GL_RGBA, GL_UNSIGNED_BYTE, image);
    GLint w, b;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &w);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_BORDER, &b);
    text("width %d border %d", w, b);
    quad_textured(5, 5, 250, 250, 0);
    free(image);
}
