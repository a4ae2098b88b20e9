/* Proves: glCopyTexImage2D, glCopyTexSubImage2D and their 1D siblings take pixels from the framebuffer. */
#include "../scene.h"


SCENE(tex_copy, SHADED, 256, 256, 0, "textures copied from the framebuffer")
{
    pixels(width, height);
    seed(40);
    for (int i = 0; i < 30; i++) glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1)), quad(uniform(0, 100), uniform(0, 100), uniform(0, 128), uniform(0, 128), 0);
    glColor3f(1, 1, 1);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 128, 128, 0);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 16, 16, 60, 60, 40, 30);
    glEnable(GL_TEXTURE_2D);
    quad_textured(128, 0, 256, 128, 0);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 32, 32, 64, 64, 0);
    quad_textured(0, 128, 128, 256, 0);
    glDisable(GL_TEXTURE_2D);
    glCopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 0, 50, 128, 0);
    glCopyTexSubImage1D(GL_TEXTURE_1D, 0, 40, 0, 90, 32);
    glEnable(GL_TEXTURE_1D);
    quad_textured(128, 128, 256, 256, 0);
    glDisable(GL_TEXTURE_1D);
}
