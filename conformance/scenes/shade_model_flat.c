/* Proves: which vertex colours a flat primitive, for all polygon types. */
#include "../scene.h"


SCENE(shade_model_flat, EXACT, 256, 256, 0, "flat shading: the provoking vertex of each polygon type")
{
    static const GLenum modes[6] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON};
    pixels(width, height);
    glShadeModel(GL_FLAT);
    for (int m = 0; m < 6; m++) {
        double cx = 45 + m % 3 * 84, cy = 64 + m / 3 * 128;
        int strip = modes[m] == GL_TRIANGLE_STRIP || modes[m] == GL_QUAD_STRIP;
        glBegin(modes[m]);
        for (int i = 0; i < 12; i++) {
            glColor3d(i % 3 / 2.0, i % 4 / 3.0, i / 11.0);
            if (strip) glVertex2d(cx - 36 + 13.3 * (i / 2), cy + (i & 1 ? 40 : -40));
            else glVertex2d(cx + 38 * cos(i * M_PI / 6), cy + 50 * sin(i * M_PI / 6));
        }
        glEnd();
    }
    glShadeModel(GL_SMOOTH);
}
