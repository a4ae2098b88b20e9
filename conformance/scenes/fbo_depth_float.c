/* Proves: a floating-point depth buffer tells surfaces apart, and keeps numbers, bit for bit, as the reference does: geometry through one
 * another between planes at 1 and 10^7, polygon offset in units of its own, depth ranges down to 10^-6, outlines, points. */
#include "../scene.h"

SCENE(fbo_depth_float, EXACT, 256, 256, FLOAT_DEPTH, "32 bits of floating-point depth: near to far 1 to 10^7, offset, ranges")
{
    perspective(60, (double)width / height, 1, 1e7);
    glEnable(GL_DEPTH_TEST);
    seed(61);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 300; i++) {
        double z = pow(10, uniform(0.01, 6.9));
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        for (int k = 0; k < 3; k++) {
            double at = z * pow(10, uniform(-0.2, 0.05));
            if (at < 1.001) at = 1.001;
            glVertex3d(uniform(-0.55, 0.55) * at, uniform(-0.55, 0.55) * at, -at);
        }
    }
    glEnd();
    pixels(width, height);
    /* The same plane in a corner, again and again, each time nearer by units; then farther, by the slope. */
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 80, 60);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glEnable(GL_POLYGON_OFFSET_LINE);
    glEnable(GL_POLYGON_OFFSET_POINT);
    for (int i = 0; i < 16; i++) {
        glPolygonMode(GL_FRONT_AND_BACK, i == 9 ? GL_LINE : i == 10 ? GL_POINT : GL_FILL);
        glPolygonOffset(i > 12 ? 0.75f : 0.0f, (float)(-3 * i));
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        glBegin(GL_TRIANGLES);
        glVertex3d(uniform(0, 30), uniform(0, 20), -0.9), glVertex3d(uniform(50, 80), uniform(0, 30), 0.3), glVertex3d(uniform(0, 80), 60, 0.99999);
        glEnd();
    }
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_POLYGON_OFFSET_LINE);
    glDisable(GL_POLYGON_OFFSET_POINT);
    /* Depth ranges that leave 24 bits a handful of values, or none; every function. */
    for (int i = 0; i < 24; i++) {
        static const double ranges[6][2] = {{0, 1e-6}, {1e-6, 0}, {0.1, 0.7}, {0.25, 0.2500001}, {1e-30, 2e-30}, {0, 1}};
        int x = i % 6 * 28 + 86, y = i / 6 * 28;
        glScissor(x, y, 26, 26);
        glDepthRange(ranges[i % 6][0], ranges[i % 6][1]);
        /* In place of a clear: the reference rounds those of a scissored window to steps of 2^-24. */
        glDepthFunc(GL_ALWAYS);
        glColor3d(0, 0, 0);
        quad(x, y, x + 26, y + 26, i % 6 == 5 ? 0.2 : -1);
        for (int k = 0; k < 8; k++) {
            glDepthFunc(GL_NEVER + (GLenum)(i / 6 * 2 + k % 2));
            glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
            glBegin(GL_TRIANGLES);
            for (int n = 0; n < 3; n++) glVertex3d(x + uniform(-8, 34), y + uniform(-8, 34), uniform(-1, 1));
            glEnd();
        }
    }
    glDisable(GL_SCISSOR_TEST);
    glDepthRange(0, 1);
    glDepthFunc(GL_LESS);
    glLineWidth(3);
    glPointSize(5);
    for (int i = 0; i < 40; i++) {
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        glBegin(i & 1 ? GL_LINES : GL_POINTS);
        for (int n = 0; n < 2; n++) glVertex3d(uniform(0, width), uniform(120, height), uniform(-1, 1));
        glEnd();
    }
}
