/* Proves: antialiasing by accumulating eight jittered frames, as the red book does. */
#include "../scene.h"


SCENE(accum_jitter, OTHER, 256, 256, ACCUM, "eight jittered frames accumulated")
{
    glClear(GL_ACCUM_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 8; i++) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glTranslated(((i * 3 % 8) / 8.0 - 0.5) * 2 / width, ((i * 5 % 8) / 8.0 - 0.5) * 2 / height, 0);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glColor3f(1, 0.8f, 0.2f);
        glBegin(GL_TRIANGLES);
        for (int k = 0; k < 12; k++) {
            double a = k * M_PI / 6;
            glVertex3d(0.1 * cos(a), 0.1 * sin(a), 0), glVertex3d(0.9 * cos(a - 0.1), 0.9 * sin(a - 0.1), 0.1), glVertex3d(0.9 * cos(a + 0.1), 0.9 * sin(a + 0.1), -0.1);
        }
        glEnd();
        glAccum(i ? GL_ACCUM : GL_LOAD, 0.125f);
    }
    glAccum(GL_RETURN, 1);
}
