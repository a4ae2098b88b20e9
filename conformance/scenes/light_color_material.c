/* Proves: each mode of glColorMaterial follows the current colour and leaves the rest of the material alone. */
#include "../scene.h"


SCENE(light_color_material, SHADED, 256, 256, 0, "colour material in all five modes")
{
    static const GLenum modes[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE};
    GLfloat position[] = {1, 1, 1, 0}, grey[] = {0.4f, 0.4f, 0.4f, 1};
    pixels(width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, width, 0, height, -60, 60);
    glMatrixMode(GL_MODELVIEW);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 5; i++) {
        glDisable(GL_COLOR_MATERIAL);
        glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, grey), glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, grey);
        glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, grey), glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 10);
        GLfloat none[] = {0, 0, 0, 1};
        glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, none);
        glColorMaterial(GL_FRONT_AND_BACK, modes[i]);
        glEnable(GL_COLOR_MATERIAL);
        glPushMatrix();
        glTranslatef(45 + (GLfloat)(i % 3) * 83, 64 + (GLfloat)(i / 3) * 128, 0);
        glColor3f(0.9f, 0.2f * (GLfloat)i, 0.3f);
        sphere(38, 24, 16);
        glPopMatrix();
        GLfloat m[4];
        glGetMaterialfv(GL_FRONT, modes[i] == GL_AMBIENT_AND_DIFFUSE ? GL_DIFFUSE : modes[i], m);
        text("%.4f %.4f %.4f %.4f", m[0], m[1], m[2], m[3]);
    }
    glDisable(GL_COLOR_MATERIAL);
}
