/* Proves: spot lights: cutoff, exponent and direction, on a finely divided plane. */
#include "../scene.h"


SCENE(light_spots, SHADED, 256, 256, 0, "spot lights with cutoffs and exponents")
{
    perspective(60, (double)width / height, 1, 20);
    glTranslatef(0, 0, -4);
    glEnable(GL_LIGHTING);
    for (int i = 0; i < 4; i++) {
        GLfloat position[] = {i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, 1.5f, 1}, direction[] = {0.1f * (GLfloat)i, 0.1f, -1};
        GLfloat color[] = {i != 1, i != 2, i != 3, 1};
        GLenum light = (GLenum)(GL_LIGHT0 + i);
        glLightfv(light, GL_POSITION, position);
        glLightfv(light, GL_SPOT_DIRECTION, direction);
        glLightf(light, GL_SPOT_CUTOFF, 20 + 10 * (GLfloat)i);
        glLightf(light, GL_SPOT_EXPONENT, 4 * (GLfloat)i);
        glLightfv(light, GL_DIFFUSE, color);
        glEnable(light);
    }
    glNormal3f(0, 0, 1);
    for (int i = 0; i < 50; i++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j <= 50; j++) glVertex3d(-2 + j * 0.08, -2 + (i + 1) * 0.08, 0), glVertex3d(-2 + j * 0.08, -2 + i * 0.08, 0);
        glEnd();
    }
}
