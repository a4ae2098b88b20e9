/* Proves: 40 draws with a matrix and a colour tint of their own, 2,240 triangles in all: batches that span many draws keep
 * order, transforms and colours. Also a timing scene. */
#include "../scene.h"


SCENE(draws_40_2240, EXACT, 1024, 768, TIMED, "40 draws of 56 triangles, each with its own matrix")
{
    perspective(50, (double)width / height, 1, 50);
    glTranslatef(0, 0, -14);
    glEnable(GL_DEPTH_TEST);
    for (int n = 0; n < 40; n++) {
        glPushMatrix();
        glTranslatef((GLfloat)(n % 8) * 1.7f - 6.0f, (GLfloat)(n / 8) * 1.9f - 3.8f, (GLfloat)(n % 5) * 0.4f);
        glRotatef((GLfloat)n * 17, 1, 2, 3);
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 7; j++) {
                double p[4][3];
                for (int k = 0; k < 4; k++) {
                    double a = M_PI * ((i + (k >> 1)) / 4.0 - 0.5) * 0.96, b = 2 * M_PI * (j + ((k ^ (k >> 1)) & 1)) / 7.0;
                    p[k][0] = cos(a) * cos(b), p[k][1] = sin(a), p[k][2] = cos(a) * sin(b);
                }
                static const int corners[6] = {0, 1, 2, 0, 2, 3};
                for (int k = 0; k < 6; k++) {
                    double *v = p[corners[k]];
                    glColor3d(0.5 + 0.5 * v[0], 0.5 + 0.5 * v[1] * (n % 3) / 2.0, (n + 1) / 41.0);
                    glVertex3dv(v);
                }
            }
        glEnd();
        glPopMatrix();
    }
}
