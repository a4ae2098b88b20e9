/* Proves: the fill rule. Vertices and edges lie exactly on pixel centres; left and bottom edges are inside. */
#include "../scene.h"


SCENE(ties_centres, EXACT, 512, 512, 0, "384 triangles with vertices on pixel centres: the fill rule")
{
    pixels(width, height);
    seed(14);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 384; i++) {
        double cx = 20 + (i % 24) * 20.0, cy = 30 + (i / 24) * 29.0;
        glColor3d(uniform(0.2, 1), uniform(0.2, 1), uniform(0.2, 1));
        for (int k = 0; k < 3; k++) glVertex2d(cx + floor(uniform(-9, 10)) + 0.5, cy + floor(uniform(-13, 14)) + 0.5);
    }
    glEnd();
}
