/* Proves: object-linear coordinates from planes. */
#include "../scene.h"


SCENE(texgen_object_linear, SHADED, 256, 256, 0, "object-linear texture coordinates")
{
    static const GLfloat s[] = {1.5f, 0.3f, 0, 0.1f}, t[] = {0, 1.2f, 0.7f, 0};
    perspective(45, (double)width / height, 1, 20);
    glTranslatef(0, 0, -4.2f);
    glRotatef(30, 1, 1, 0);
    checker_texture(32, 4, GL_LINEAR, GL_LINEAR);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR), glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGenfv(GL_S, GL_OBJECT_PLANE, s), glTexGenfv(GL_T, GL_OBJECT_PLANE, t);
    glEnable(GL_TEXTURE_GEN_S), glEnable(GL_TEXTURE_GEN_T), glEnable(GL_TEXTURE_2D), glEnable(GL_DEPTH_TEST);
    torus(0.5, 1.1, 24, 40);
}
