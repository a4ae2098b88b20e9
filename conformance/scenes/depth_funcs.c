/* Proves: the eight depth functions on crossing surfaces. */
#include "../scene.h"


SCENE(depth_funcs, EXACT, 256, 256, 0, "all depth functions on crossing triangles")
{
    static const GLenum funcs[] = {GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 8; i++) {
        double x = 4 + i % 4 * 63, y = 4 + i / 4 * 126;
        glDepthFunc(GL_ALWAYS);
        glColor3f(0.2f, 0.3f, 0.9f);
        glBegin(GL_TRIANGLES);
        glVertex3d(x, y, -0.5), glVertex3d(x + 58, y, 0.5), glVertex3d(x + 30, y + 110, 0);
        glEnd();
        glDepthFunc(funcs[i]);
        glColor3f(1, 0.8f, 0.2f);
        glBegin(GL_TRIANGLES);
        glVertex3d(x, y, 0.5), glVertex3d(x + 58, y, -0.5), glVertex3d(x + 30, y + 110, 0);
        glColor3f(1, 0, 0);
        glVertex3d(x, y, -0.5), glVertex3d(x + 58, y, 0.5), glVertex3d(x + 30, y + 110, 0);
        glEnd();
    }
}
