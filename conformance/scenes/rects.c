/* Proves: glRect in all its forms, with either winding. */
#include "../scene.h"


SCENE(rects, EXACT, 256, 256, 0, "glRect of all types, culled by winding")
{
    static const GLfloat a[] = {10.5f, 70.25f}, b[] = {60.75f, 110.5f};
    static const GLint c[] = {200, 200}, d[] = {240, 245};
    pixels(width, height);
    glEnable(GL_CULL_FACE);
    glColor3f(1, 0.5f, 0), glRectf(10.2f, 10.7f, 100.4f, 60.6f), glColor3f(1, 1, 0), glRectd(120, 10, 110, 60);
    glColor3f(0, 1, 0.5f), glRecti(130, 60, 160, 10), glColor3f(0, 0.5f, 1), glRects(170, 10, 250, 60);
    glColor3f(1, 0, 1), glRectfv(a, b), glColor3f(1, 1, 1), glRectiv(c, d);
    glDisable(GL_CULL_FACE);
    glColor3f(0.3f, 0.9f, 0.2f), glRectd(180, 180, 100, 100);
}
