/* Proves: hit records of selection mode: names, depths, several names, overflow. */
#include "../scene.h"


static void hits(const GLuint *buffer, int count)
{
    text("hits %d", count);
    for (int i = 0; i < count; i++) {
        GLuint names = *buffer++;
        text("names %u near %.4f far %.4f", names, buffer[0] / 4294967295.0, buffer[1] / 4294967295.0);
        buffer += 2;
        for (GLuint k = 0; k < names; k++) text("  name %u", *buffer++);
    }
}

SCENE(selection, EXACT, 64, 64, TEXT_ONLY, "selection: names, depths, culling, overflow")
{
    GLuint buffer[64], tiny[5];
    GLint depth;
    pixels(width, height);
    glSelectBuffer(64, buffer);
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(1);
    quad(10, 10, 30, 30, 0.5);
    glLoadName(2);
    quad(100, 100, 130, 130, 0);
    glPushName(7);
    glBegin(GL_TRIANGLES), glVertex3f(10, 10, -0.5f), glVertex3f(60, 10, 0.25f), glVertex3f(30, 60, 0.75f), glEnd();
    glPushName(8);
    glBegin(GL_LINES), glVertex3f(-50, 30, -0.9f), glVertex3f(100, 30, 0.9f), glEnd();
    glGetIntegerv(GL_NAME_STACK_DEPTH, &depth);
    text("depth %d", depth);
    glPopName();
    glPopName();
    glLoadName(4);
    glBegin(GL_POINTS), glVertex3f(20, 20, 0.1f), glVertex3f(200, 20, 0.1f), glEnd();
    glEnable(GL_CULL_FACE);
    glLoadName(5);
    glBegin(GL_TRIANGLES), glVertex3f(10, 10, 0), glVertex3f(30, 60, 0), glVertex3f(60, 10, 0), glEnd();
    glDisable(GL_CULL_FACE);
    glLoadName(6);
    glRasterPos2i(5, 5);
    hits(buffer, glRenderMode(GL_RENDER));
    glSelectBuffer(5, tiny);
    glRenderMode(GL_SELECT);
    glInitNames();
    glLoadName(3), text_error("LoadName on an empty stack");
    glPushName(1), quad(0, 0, 9, 9, 0), glLoadName(2), quad(0, 0, 9, 9, 0);
    text("overflow %d", glRenderMode(GL_RENDER));
    glPopName(), text_error("PopName outside selection");
    glInitNames();
}
