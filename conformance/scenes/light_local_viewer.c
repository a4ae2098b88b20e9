/* Proves: highlights of a local viewer against those of an infinite one. */
#include "../scene.h"


SCENE(light_local_viewer, SHADED, 256, 256, 0, "local and infinite viewer")
{
    GLfloat position[] = {0, 2, 2, 1}, white[] = {1, 1, 1, 1};
    perspective(60, (double)width / height, 1, 20);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT, GL_SPECULAR, white);
    glMaterialf(GL_FRONT, GL_SHININESS, 12);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 2; i++) {
        glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, i);
        glPushMatrix();
        glTranslatef(i ? 1.1f : -1.1f, 0, -4);
        sphere(1, 30, 20);
        glPopMatrix();
    }
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 0);
}
