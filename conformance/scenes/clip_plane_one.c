/* Proves: one user clip plane, turned by the model-view matrix, cuts a smooth surface. */
#include "../scene.h"


SCENE(clip_plane_one, OTHER, 256, 256, 0, "a user clip plane cuts a torus")
{
    static const GLdouble plane[4] = {0.3, 1, 0.2, 0.1};
    perspective(45, (double)width / height, 1, 20);
    glTranslatef(0, 0, -5);
    glEnable(GL_DEPTH_TEST);
    glRotatef(20, 1, 0, 0);
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    for (int i = 0; i < 30; i++) {
        double a = i * M_PI / 15, b = (i + 1) * M_PI / 15;
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j <= 16; j++) {
            double c = j * M_PI / 8, r = 1.2 + 0.5 * cos(c), z = 0.5 * sin(c);
            glColor3d(0.5 + 0.5 * cos(a), 0.5 + 0.5 * sin(c), 0.3), glVertex3d(r * cos(b), r * sin(b), z), glVertex3d(r * cos(a), r * sin(a), z);
        }
        glEnd();
    }
    glDisable(GL_CLIP_PLANE0);
}
