/* Proves: squared exponential fog, with a hint that asks for the nicest. */
#include "../scene.h"


SCENE(fog_exp2, SHADED, 256, 256, 0, "squared exponential fog on a tilted strip")
{
    GLfloat color[] = {0.2f, 0.3f, 0.6f, 1};
    perspective(50, (double)width / height, 1, 60);
    glEnable(GL_FOG);
    glHint(GL_FOG_HINT, GL_NICEST);
    glFogi(GL_FOG_MODE, GL_EXP2);
    glFogf(GL_FOG_DENSITY, 0.07f);
    glFogfv(GL_FOG_COLOR, color);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 20; i++) glColor3d(1, i / 20.0, 0), glVertex3d(-0.5, -0.5 + i * 0.3, -2 - i), glVertex3d(0.5, -0.5 + i * 0.3, -2 - i);
    glEnd();
}
