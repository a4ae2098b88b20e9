/* Proves: glArrayElement inside Begin/End takes every enabled array and leaves the others at their current value. */
#include "../scene.h"


SCENE(arrays_array_element, EXACT, 256, 256, 0, "glArrayElement mixed with immediate-mode attributes")
{
    static const GLfloat v[][2] = {{10, 10}, {120, 20}, {60, 120}, {130, 130}, {250, 140}, {190, 250}};
    static const GLfloat c[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
    pixels(width, height);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, v);
    glColorPointer(3, GL_FLOAT, 0, c);
    glEnableClientState(GL_COLOR_ARRAY);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 6; i++) glArrayElement(i);
    glEnd();
    glDisableClientState(GL_COLOR_ARRAY);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0.5f, 0), glArrayElement(3), glVertex2f(20, 240), glColor3f(1, 1, 1), glArrayElement(2);
    glEnd();
}
