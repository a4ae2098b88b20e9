/* Proves: constant, linear and quadratic attenuation. */
#include "../scene.h"


SCENE(light_attenuation, SHADED, 256, 256, 0, "constant, linear and quadratic attenuation")
{
    perspective(60, (double)width / height, 1, 20);
    glTranslatef(0, 0, -4);
    glEnable(GL_LIGHTING);
    for (int i = 0; i < 3; i++) {
        GLfloat position[] = {(GLfloat)i * 1.4f - 1.4f, 0, 0.5f, 1}, color[] = {i == 0, i == 1, i == 2, 1};
        GLenum light = (GLenum)(GL_LIGHT0 + i);
        glLightfv(light, GL_POSITION, position);
        glLightf(light, GL_CONSTANT_ATTENUATION, i == 0 ? 1.3f : 0.2f);
        glLightf(light, GL_LINEAR_ATTENUATION, i == 1 ? 1.5f : 0);
        glLightf(light, GL_QUADRATIC_ATTENUATION, i == 2 ? 2 : 0);
        glLightfv(light, GL_DIFFUSE, color);
        glEnable(light);
    }
    glNormal3f(0, 0, 1);
    for (int i = 0; i < 40; i++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j <= 40; j++) glVertex3d(-2 + j * 0.1, -2 + (i + 1) * 0.1, 0), glVertex3d(-2 + j * 0.1, -2 + i * 0.1, 0);
        glEnd();
    }
}
