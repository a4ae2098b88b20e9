/* Proves: eight lights at once: positional and directional, coloured, added and clamped. */
#include "../scene.h"


SCENE(light_eight, SHADED, 256, 256, 0, "eight coloured lights")
{
    perspective(45, (double)width / height, 1, 20);
    for (int i = 0; i < 8; i++) {
        double a = i * M_PI / 4;
        GLfloat position[] = {3 * (GLfloat)cos(a), 3 * (GLfloat)sin(a), i & 1 ? 1.0f : -2.0f, i & 1 ? 0.0f : 1.0f};
        GLfloat color[] = {0.5f + 0.5f * (GLfloat)cos(a), 0.5f + 0.5f * (GLfloat)sin(a), (GLfloat)i / 8, 1}, ambient[] = {0.02f, 0.02f, 0.02f * (GLfloat)i, 1};
        GLenum light = (GLenum)(GL_LIGHT0 + i);
        glLightfv(light, GL_POSITION, position);
        glLightfv(light, GL_DIFFUSE, color);
        glLightfv(light, GL_SPECULAR, color);
        glLightfv(light, GL_AMBIENT, ambient);
        glEnable(light);
    }
    glTranslatef(0, 0, -4);
    GLfloat white[] = {0.8f, 0.8f, 0.8f, 1};
    glMaterialfv(GL_FRONT, GL_SPECULAR, white);
    glMaterialf(GL_FRONT, GL_SHININESS, 40);
    glEnable(GL_LIGHTING);
    glEnable(GL_DEPTH_TEST);
    torus(0.5, 1.1, 24, 40);
}
