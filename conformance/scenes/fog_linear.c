/* Proves: linear fog over depth. */
#include "../scene.h"


SCENE(fog_linear, SHADED, 256, 256, 0, "linear fog on spheres going away")
{
    GLfloat color[] = {0.6f, 0.6f, 0.7f, 1};
    perspective(50, (double)width / height, 1, 40);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 3);
    glFogf(GL_FOG_END, 25);
    glFogfv(GL_FOG_COLOR, color);
    for (int i = 0; i < 8; i++) {
        glPushMatrix();
        glTranslatef(-2.2f + 1.6f * (GLfloat)i, -0.8f + 0.6f * (GLfloat)i, -4 - 3 * (GLfloat)i);
        glColor3f(0.9f, 0.1f * (GLfloat)i, 0.2f);
        sphere(1, 20, 12);
        glPopMatrix();
    }
}
