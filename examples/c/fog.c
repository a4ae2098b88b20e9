/* An avenue of columns fading into each of the three fogs: fog-linear.png, fog-exp.png, fog-exp2.png. */
#include "offscreen.h"

int main(void)
{
    static const struct { GLenum mode; const char *name; } fogs[] = {{GL_LINEAR, "fog-linear.png"}, {GL_EXP, "fog-exp.png"}, {GL_EXP2, "fog-exp2.png"}};
    GLfloat mist[] = {0.7f, 0.75f, 0.8f, 1}, sun[] = {1, 2, 1.5f, 0};
    offscreen_open(640, 360);
    glClearColor(mist[0], mist[1], mist[2], 1);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_FOG);
    glEnable(GL_NORMALIZE);
    glFogfv(GL_FOG_COLOR, mist);
    glFogf(GL_FOG_START, 4);
    glFogf(GL_FOG_END, 40);
    glHint(GL_FOG_HINT, GL_NICEST);
    for (int f = 0; f < 3; f++) {
        glFogi(GL_FOG_MODE, (GLint)fogs[f].mode);
        glFogf(GL_FOG_DENSITY, fogs[f].mode == GL_EXP ? 0.06f : 0.04f);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        camera(50, 0.5, 80, 1.2, 1.1, 7);
        glLightfv(GL_LIGHT0, GL_POSITION, sun);
        material(0.35f, 0.5f, 0.3f);
        glNormal3d(0, 1, 0);
        for (int i = 0; i < 30; i++) {
            glBegin(GL_QUADS);
            glVertex3d(-20, -1, 8 - i * 2), glVertex3d(20, -1, 8 - i * 2), glVertex3d(20, -1, 6 - i * 2), glVertex3d(-20, -1, 6 - i * 2);
            glEnd();
        }
        for (int i = 0; i < 24; i++) {
            material(0.8f, 0.4f, 0.3f);
            glPushMatrix();
            glTranslated(i & 1 ? 2 : -2, 0, 2 - i / 2 * 3);
            solid_box(0.5, 2, 0.5);
            material(0.9f, 0.8f, 0.5f);
            glTranslated(0, 1.35, 0);
            solid_sphere(0.35, 24, 16);
            glPopMatrix();
        }
        offscreen_save(fogs[f].name);
    }
    offscreen_close();
    return 0;
}
