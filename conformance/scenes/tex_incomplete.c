/* Proves: an incomplete mipmap chain turns texturing off for that unit. */
#include "../scene.h"


SCENE(tex_incomplete, SHADED, 256, 256, 0, "incomplete textures draw as if texturing were off")
{
    pixels(width, height);
    glEnable(GL_TEXTURE_2D);
    checker_texture(32, 4, GL_NEAREST, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glColor3f(1, 0.5f, 0.2f);
    quad_textured(10, 10, 120, 120, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    quad_textured(130, 10, 240, 120, 0);
}
