/* Proves: nearest filtering of magnified and shrunk textures, straight and turned. */
#include "../scene.h"


SCENE(tex_nearest, SHADED, 256, 256, 0, "nearest filtering, magnified, shrunk and turned")
{
    pixels(width, height);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    checker_texture(32, 4, GL_NEAREST, GL_NEAREST);
    quad_textured(3.3, 3.3, 123.7, 123.7, 0);
    quad_textured(130, 10, 150, 30, 0);
    glTranslatef(190, 190, 0);
    glRotatef(27, 0, 0, 1);
    quad_textured(-40, -40, 40, 40, 0);
    glRotatef(20, 0, 0, 1);
    glTranslatef(-120, 40, 0);
    quad_textured(-10, -10, 10, 10, 0);
}
