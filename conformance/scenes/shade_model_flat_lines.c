/* Proves: which vertex colours a flat line. */
#include "../scene.h"


SCENE(shade_model_flat_lines, OTHER, 256, 256, 0, "flat shading: the provoking vertex of each line type")
{
    static const GLenum modes[3] = {GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP};
    pixels(width, height);
    glShadeModel(GL_FLAT);
    for (int m = 0; m < 3; m++) {
        glBegin(modes[m]);
        for (int i = 0; i < 12; i++) {
            glColor3d(i % 3 / 2.0, i % 4 / 3.0, i / 11.0);
            glVertex2d(45 + m * 84 + 38 * cos(i * M_PI / 6), 128 + 100 * sin(i * M_PI / 6));
        }
        glEnd();
    }
    glShadeModel(GL_SMOOTH);
}
