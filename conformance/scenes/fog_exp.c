/* Proves: exponential fog. */
#include "../scene.h"


SCENE(fog_exp, SHADED, 256, 256, 0, "exponential fog on a long floor")
{
    GLfloat color[] = {0.6f, 0.6f, 0.7f, 1};
    perspective(50, (double)width / height, 1, 60);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_EXP);
    glFogf(GL_FOG_DENSITY, 0.08f);
    glFogfv(GL_FOG_COLOR, color);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 40; i++) {
        glColor3d(0.9, i % 3 / 2.0, i % 5 / 4.0);
        glVertex3d(-0.4 - 0.0 * i, -0.4, -1.2 - i), glVertex3d(0.4, -0.4, -1.2 - i), glVertex3d(0, 0.4 + i * 0.01, -2 - i * 1.2);
    }
    glEnd();
}
