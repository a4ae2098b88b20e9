/* Proves: primitives that touch the window's borders exactly: no pixel too many or too few. */
#include "../scene.h"


SCENE(edge_coordinates, EXACT, 256, 256, 0, "triangles that touch the borders of the window exactly")
{
    UNUSED_SIZE;
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0), glVertex2f(-1, -1), glVertex2f(1, -1), glVertex2f(-1, 1);
    glColor3f(0, 1, 0), glVertex2f(1, -1), glVertex2f(1, 1), glVertex2f(-1, 1);
    glColor3f(0, 0, 1), glVertex3f(0, 0, -1), glVertex3f(0.5f, 0, 1), glVertex3f(0, 0.5f, 1);
    glEnd();
}
