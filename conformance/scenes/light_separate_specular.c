/* Proves: separate specular colour is added after texturing. */
#include "../scene.h"

#ifndef GL_LIGHT_MODEL_COLOR_CONTROL
#define GL_LIGHT_MODEL_COLOR_CONTROL 0x81F8
#define GL_SEPARATE_SPECULAR_COLOR 0x81FA
#define GL_SINGLE_COLOR 0x81F9
#endif

SCENE(light_separate_specular, SHADED, 256, 256, 0, "single against separate specular colour on a textured sphere")
{
    GLfloat position[] = {1, 1, 2, 0}, white[] = {1, 1, 1, 1};
    perspective(45, (double)width / height, 1, 20);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT, GL_SPECULAR, white);
    glMaterialf(GL_FRONT, GL_SHININESS, 16);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    checker_texture(32, 4, GL_LINEAR, GL_LINEAR);
    for (int i = 0; i < 2; i++) {
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, i ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
        glPushMatrix();
        glTranslatef(i ? 0.9f : -0.9f, 0, -5);
        sphere(0.85, 30, 20);
        glPopMatrix();
    }
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR);
}
