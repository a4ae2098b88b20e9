/* Proves: the parallelograms that wide aliased lines cover. */
#include "../scene.h"


SCENE(line_width, OTHER, 256, 256, 0, "lines of widths 1 to 12")
{
    pixels(width, height);
    for (int i = 0; i < 24; i++) {
        double a = i * M_PI / 12;
        glLineWidth(1 + (GLfloat)i / 2);
        glBegin(GL_LINES);
        glColor3d(1, i / 24.0, 0), glVertex2d(128 + 30 * cos(a), 128 + 30 * sin(a));
        glColor3d(0, i / 24.0, 1), glVertex2d(128 + 115 * cos(a), 128 + 115 * sin(a));
        glEnd();
    }
    glLineWidth(1);
}
