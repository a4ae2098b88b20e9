/* Proves: antialiased lines, blended. */
#include "../scene.h"


SCENE(line_smooth, OTHER, 256, 256, 0, "smooth lines of several widths, blended")
{
    pixels(width, height);
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < 30; i++) {
        double a = i * M_PI / 15 + 0.05;
        glLineWidth(1 + (GLfloat)(i % 5) * 0.8f);
        glColor3d(1, 1 - i / 30.0, i / 30.0);
        glBegin(GL_LINES);
        glVertex2d(128 + 20 * cos(a), 128 + 20 * sin(a)), glVertex2d(128 + 118 * cos(a), 128 + 118 * sin(a));
        glEnd();
    }
    glLineWidth(1);
}
