/* Proves: sphere mapping of a curved surface. */
#include "../scene.h"


SCENE(texgen_sphere_map, SHADED, 256, 256, 0, "sphere mapping of a torus")
{
    perspective(45, (double)width / height, 1, 20);
    glTranslatef(0, 0, -4.2f);
    glRotatef(50, 1, 0.4f, 0);
    checker_texture(64, 8, GL_LINEAR, GL_LINEAR);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP), glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    glEnable(GL_TEXTURE_GEN_S), glEnable(GL_TEXTURE_GEN_T), glEnable(GL_TEXTURE_2D), glEnable(GL_DEPTH_TEST);
    torus(0.5, 1.1, 24, 40);
}
