/* Proves: aliased lines of width 1 in all directions: strips, loops, separate lines, interpolated colours. */
#include "../scene.h"


SCENE(lines_directions, OTHER, 256, 256, 0, "lines of width 1 in all directions")
{
    pixels(width, height);
    glBegin(GL_LINES);
    for (int i = 0; i < 64; i++) {
        double a = i * M_PI / 32;
        glColor3d(1, 1, 1), glVertex2d(64 + 8 * cos(a), 64 + 8 * sin(a));
        glColor3d(i / 64.0, 0, 1), glVertex2d(64 + 60 * cos(a), 64 + 60 * sin(a));
    }
    glEnd();
    glBegin(GL_LINE_LOOP);
    for (int i = 0; i < 23; i++) glColor3d(i / 23.0, 1, 0), glVertex2d(192 + 50 * cos(i * 2 * M_PI / 23 * 5), 64 + 50 * sin(i * 2 * M_PI / 23 * 5));
    glEnd();
    glBegin(GL_LINE_STRIP);
    seed(33);
    for (int i = 0; i < 40; i++) glColor3d(1, uniform(0, 1), uniform(0, 1)), glVertex2d(uniform(4, 252), uniform(132, 252));
    glEnd();
}
