/* Proves: scaled normals with GL_NORMALIZE, with GL_RESCALE_NORMAL and with neither. */
#include "../scene.h"


SCENE(light_normalize, SHADED, 256, 256, 0, "scaled normals: plain, normalised, rescaled")
{
    GLfloat position[] = {1, 1, 2, 0}, white[] = {0.5f, 0.5f, 0.5f, 1};
    perspective(45, (double)width / height, 1, 20);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT, GL_SPECULAR, white);
    glMaterialf(GL_FRONT, GL_SHININESS, 16);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 4; i++) {
        if (i == 1) glEnable(GL_NORMALIZE);
        if (i == 2) glDisable(GL_NORMALIZE), glEnable(GL_RESCALE_NORMAL);
        if (i == 3) glEnable(GL_NORMALIZE);
        glPushMatrix();
        glTranslatef(i & 1 ? 0.8f : -0.8f, i & 2 ? 0.8f : -0.8f, -4.5f);
        if (i == 3) glScalef(0.5f, 1.5f, 0.8f);
        else glScalef(0.7f, 0.7f, 0.7f);
        sphere(1, 24, 16);
        glPopMatrix();
    }
    glDisable(GL_NORMALIZE);
    glDisable(GL_RESCALE_NORMAL);
}
