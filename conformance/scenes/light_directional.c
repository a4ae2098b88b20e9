/* Proves: one directional light with ambient, diffuse and specular terms on a sphere. */
#include "../scene.h"


SCENE(light_directional, SHADED, 256, 256, 0, "a directional light with specular highlight")
{
    GLfloat direction[] = {1, 1, 1, 0}, color[] = {0.9f, 0.5f, 0.3f, 1}, white[] = {1, 1, 1, 1};
    perspective(45, (double)width / height, 1, 20);
    glLightfv(GL_LIGHT0, GL_POSITION, direction);
    glTranslatef(0, 0, -4);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color);
    glMaterialfv(GL_FRONT, GL_SPECULAR, white);
    glMaterialf(GL_FRONT, GL_SHININESS, 20);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    sphere(1.3, 40, 24);
}
