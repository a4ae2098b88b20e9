/* Proves: a mesh of triangles that share edges, drawn additively, covers every pixel exactly once: no hole, no double hit. */
#include "../scene.h"


SCENE(shared_edges, EXACT, 256, 256, 0, "a fan and a jittered grid drawn additively: every pixel exactly once")
{
    pixels(width, height);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glColor4f(0.25f, 0.25f, 0.25f, 0.25f);
    double px[17][17], py[17][17];
    seed(19);
    for (int i = 0; i < 17; i++)
        for (int j = 0; j < 17; j++) {
            px[i][j] = 8 + i * 15 + uniform(-5, 5);
            py[i][j] = 8 + j * 15 + uniform(-5, 5);
        }
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 16; i++)
        for (int j = 0; j < 16; j++) {
            glVertex2d(px[i][j], py[i][j]), glVertex2d(px[i + 1][j], py[i + 1][j]), glVertex2d(px[i + 1][j + 1], py[i + 1][j + 1]);
            glVertex2d(px[i][j], py[i][j]), glVertex2d(px[i + 1][j + 1], py[i + 1][j + 1]), glVertex2d(px[i][j + 1], py[i][j + 1]);
        }
    glEnd();
    glColor4f(0.2f, 0, 0.1f, 0);
    glBegin(GL_TRIANGLE_FAN);
    glVertex2d(127.3, 128.7);
    for (int i = 0; i <= 90; i++) glVertex2d(127.3 + 110 * cos(i % 90 * M_PI / 45), 128.7 + 110 * sin(i % 90 * M_PI / 45));
    glEnd();
}
