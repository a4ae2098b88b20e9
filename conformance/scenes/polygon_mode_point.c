/* Proves: polygons drawn as points, sized, with edge flags. */
#include "../scene.h"


SCENE(polygon_mode_point, OTHER, 256, 256, 0, "GL_POINT polygon mode")
{
    pixels(width, height);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glPointSize(5);
    for (int i = 0; i < 8; i++) {
        glBegin(i & 1 ? GL_TRIANGLE_FAN : GL_POLYGON);
        for (int k = 0; k < 7; k++) {
            glColor3d(k / 7.0, 1 - i / 8.0, 0.5);
            glEdgeFlag((GLboolean)(k != 3));
            glVertex2d(40 + i % 4 * 58 + 25 * cos(k * M_PI / 3.5), 64 + i / 4 * 128 + 40 * sin(k * M_PI / 3.5));
        }
        glEnd();
    }
    glEdgeFlag(GL_TRUE);
    glPointSize(1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}
