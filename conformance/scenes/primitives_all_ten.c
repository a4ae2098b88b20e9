/* Proves: all ten primitive types assemble the right vertices, incomplete ones dropped, with interpolated colours. */
#include "../scene.h"


SCENE(primitives_all_ten, OTHER, 320, 256, 0, "all ten primitive types, with leftover vertices")
{
    static const GLenum modes[10] = {GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON};
    pixels(width, height);
    for (int m = 0; m < 10; m++) {
        double cx = 32 + m % 5 * 64, cy = 64 + m / 5 * 128;
        int strip = modes[m] == GL_TRIANGLE_STRIP || modes[m] == GL_QUAD_STRIP;
        glBegin(modes[m]);
        for (int i = 0; i < 11; i++) {
            double a = i * 2 * M_PI / 11;
            glColor3d(0.5 + 0.5 * cos(a), 0.5 + 0.5 * sin(a), i / 11.0);
            if (strip) glVertex2d(cx - 28 + 10.3 * (i / 2), cy + (i & 1 ? 40.2 : -40.7));
            else glVertex2d(cx + 29.3 * cos(a), cy + 55.1 * sin(a));
        }
        glEnd();
    }
}
