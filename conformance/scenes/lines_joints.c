/* Proves: the diamond-exit rule: a line's last pixel is not drawn, so that a loop blends each pixel once. */
#include "../scene.h"


SCENE(lines_joints, OTHER, 256, 256, 0, "blended line loops: which end pixels are drawn")
{
    pixels(width, height);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor3f(0.3f, 0.2f, 0.1f);
    for (int k = 0; k < 12; k++) {
        glBegin(GL_LINE_LOOP);
        for (int i = 0; i < 8; i++) {
            double x = 128 + (10 + k * 10) * cos(i * M_PI / 4 + k * 0.1), y = 128 + (10 + k * 10) * sin(i * M_PI / 4 + k * 0.1);
            glVertex2d(k & 1 ? floor(x) + 0.5 : x, k & 1 ? floor(y) + 0.5 : y);
        }
        glEnd();
    }
}
