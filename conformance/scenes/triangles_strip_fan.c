/* Proves: long strips and fans, their winding under culling, and colours along them. */
#include "../scene.h"


SCENE(triangles_strip_fan, EXACT, 256, 256, 0, "long strips and fans, culled by winding")
{
    pixels(width, height);
    glEnable(GL_CULL_FACE);
    for (int s = 0; s < 8; s++) {
        glCullFace(s & 1 ? GL_FRONT : GL_BACK);
        glBegin(s & 2 ? GL_QUAD_STRIP : GL_TRIANGLE_STRIP);
        for (int i = 0; i < 40; i++) {
            glColor3d(i / 39.0, s / 7.0, 1 - i / 39.0);
            double x = 6 + i / 2 * 6.1, y = 10 + s * 15.3 + 4 * sin(i * 0.7);
            if (s & 1) glVertex2d(x, y + (i & 1 ? 13 : 0));
            else glVertex2d(x, y + (i & 1 ? 0 : 13));
        }
        glEnd();
    }
    for (int f = 0; f < 4; f++) {
        glCullFace(f & 1 ? GL_FRONT : GL_BACK);
        glFrontFace(f & 2 ? GL_CW : GL_CCW);
        glBegin(GL_TRIANGLE_FAN);
        glColor3d(1, 1, 1), glVertex2d(195, 33 + f * 62);
        for (int i = 0; i <= 20; i++) {
            double a = (f == 1 || f == 2 ? -1 : 1) * i * M_PI / 10;
            glColor3d(i / 20.0, 0.3, f / 3.0), glVertex2d(195 + 50 * cos(a), 33 + f * 62 + 28 * sin(a));
        }
        glEnd();
    }
}
