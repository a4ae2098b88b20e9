/* Proves: polygons drawn as outlines, front and back differently, with edge flags. */
#include "../scene.h"


SCENE(polygon_mode_line, OTHER, 256, 256, 0, "GL_LINE polygon mode, edge flags, different for back faces")
{
    pixels(width, height);
    glPolygonMode(GL_FRONT, GL_LINE);
    glPolygonMode(GL_BACK, GL_FILL);
    glColor3f(1, 0.8f, 0.2f);
    quad(10.2, 10.3, 100.7, 100.1, 0);
    glColor3f(0.2f, 0.8f, 1);
    quad(220.2, 10.3, 120.7, 100.1, 0);
    glBegin(GL_TRIANGLES);
    glEdgeFlag(GL_TRUE), glVertex2f(20, 130), glEdgeFlag(GL_FALSE), glVertex2f(110, 140), glEdgeFlag(GL_TRUE), glVertex2f(60, 240);
    glEnd();
    glBegin(GL_POLYGON);
    for (int i = 0; i < 9; i++) glEdgeFlag((GLboolean)(i % 3 != 0)), glVertex2d(180 + 60 * cos(i * M_PI / 4.5), 185 + 60 * sin(i * M_PI / 4.5));
    glEnd();
    glEdgeFlag(GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}
