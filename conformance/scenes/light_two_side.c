/* Proves: two-sided lighting: back faces use the reversed normal and the back material. */
#include "../scene.h"


SCENE(light_two_side, SHADED, 256, 256, 0, "two-sided lighting of an open shell")
{
    GLfloat position[] = {1, 1, 3, 0}, front[] = {0.9f, 0.3f, 0.2f, 1}, back[] = {0.2f, 0.4f, 0.9f, 1}, glow[] = {0, 0.1f, 0, 1};
    perspective(45, (double)width / height, 1, 20);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glTranslatef(0, 0, -4);
    glRotatef(-50, 0.2f, 1, 0.1f);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, front);
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
    glMaterialfv(GL_BACK, GL_EMISSION, glow);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 20; i++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j <= 10; j++)
            for (int k = 0; k < 2; k++) {
                double a = (i + 1 - k) * M_PI / 14, b = j * M_PI / 10;
                glNormal3d(cos(a) * sin(b), sin(a) * sin(b), cos(b));
                glVertex3d(1.2 * cos(a) * sin(b), 1.2 * sin(a) * sin(b), 1.2 * cos(b));
            }
        glEnd();
    }
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_FALSE);
}
