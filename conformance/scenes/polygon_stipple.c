/* Proves: the 32 x 32 stipple is anchored to the window, and its bit order. */
#include "../scene.h"


SCENE(polygon_stipple, EXACT, 256, 256, 0, "polygon stipple patterns on overlapping triangles")
{
    GLubyte pattern[128];
    pixels(width, height);
    glEnable(GL_POLYGON_STIPPLE);
    for (int p = 0; p < 4; p++) {
        for (int i = 0; i < 128; i++) pattern[i] = (GLubyte)(p == 0 ? 0x11 << (i / 4 % 4) : p == 1 ? i * 7 : p == 2 ? (i / 4 < 16 ? 0xF0 : 0x0F) : (i & 3 ? 0 : 0xFF));
        glPolygonStipple(pattern);
        glColor3d(1, p / 3.0, 1 - p / 3.0);
        glBegin(GL_TRIANGLES);
        glVertex2d(10 + p * 30, 10 + p * 7), glVertex2d(150 + p * 30, 30 + p * 10), glVertex2d(60 + p * 25, 200 + p * 15);
        glEnd();
    }
    glDisable(GL_POLYGON_STIPPLE);
}
