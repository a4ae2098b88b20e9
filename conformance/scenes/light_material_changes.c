/* Proves: glMaterial inside Begin/End changes the vertices that follow it. */
#include "../scene.h"


SCENE(light_material_changes, SHADED, 256, 256, 0, "materials changed between vertices of one primitive")
{
    GLfloat position[] = {0.3f, 0.4f, 1, 0}, ambient[] = {0.5f, 0.4f, 0.3f, 1};
    pixels(width, height);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glNormal3f(0, 0, 1);
    for (int f = 0; f < 2; f++) {
        glShadeModel(f ? GL_FLAT : GL_SMOOTH);
        glBegin(GL_TRIANGLE_STRIP);
        for (int i = 0; i < 24; i++) {
            GLfloat c[] = {(GLfloat)(i % 3) / 2, (GLfloat)(i % 5) / 4, (GLfloat)i / 24, 1}, e[] = {0, 0, (GLfloat)(i & 1) * 0.4f, 1};
            glMaterialfv(GL_FRONT_AND_BACK, i & 4 ? GL_AMBIENT : GL_DIFFUSE, c);
            glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, e);
            glVertex2d(10 + i / 2 * 21, 20 + f * 120 + (i & 1 ? 100 : 0));
        }
        glEnd();
    }
    glShadeModel(GL_SMOOTH);
}
