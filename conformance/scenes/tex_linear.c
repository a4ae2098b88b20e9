/* Proves: linear filtering of magnified and shrunk textures; the reference filters with 8 bits of weight. */
#include "../scene.h"


SCENE(tex_linear, SHADED, 256, 256, 0, "linear filtering, magnified, shrunk and turned")
{
    pixels(width, height);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    checker_texture(16, 4, GL_LINEAR, GL_LINEAR);
    quad_textured(3.3, 3.3, 123.7, 123.7, 0);
    quad_textured(130, 10, 142, 22, 0);
    glTranslatef(190, 190, 0);
    glRotatef(27, 0, 0, 1);
    quad_textured(-45, -45, 45, 45, 0);
}
