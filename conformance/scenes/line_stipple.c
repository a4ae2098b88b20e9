/* Proves: stipple patterns and factors, continuing along strips and restarting with each separate line. */
#include "../scene.h"


SCENE(line_stipple, OTHER, 256, 256, 0, "line stipple: patterns, factors, strips and separate lines")
{
    static const GLushort patterns[] = {0xAAAA, 0x0F0F, 0x00FF, 0x1C47, 0x8001, 0xFFFE};
    pixels(width, height);
    glEnable(GL_LINE_STIPPLE);
    for (int i = 0; i < 24; i++) {
        glLineStipple(1 + i / 6 * 2, patterns[i % 6]);
        glLineWidth(i % 3 == 2 ? 3 : 1);
        glColor3d(1, i / 24.0, 0.5);
        glBegin(i & 1 ? GL_LINE_STRIP : GL_LINES);
        double y = 6.5 + i * 10;
        glVertex2d(4.5, y), glVertex2d(80.5, y + 3), glVertex2d(100.5, y + 1), glVertex2d(250.5, y + 6);
        glEnd();
    }
    glLineWidth(1);
}
