/* Proves: strict primitive order. 10,000 overlapping blended triangles give the same bits only when each pixel blends them in
 * the order in which they were drawn. */
#include "../scene.h"


SCENE(blend_10000_triangles, EXACT, 256, 256, 0, "10,000 overlapping blended triangles in order")
{
    pixels(width, height);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    seed(15);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 10000; i++) {
        double cx = uniform(40, width - 40), cy = uniform(40, height - 40);
        glColor4d(uniform(0, 1), uniform(0, 1), uniform(0, 1), uniform(0.05, 0.95));
        for (int k = 0; k < 3; k++) glVertex2d(cx + uniform(-39, 39), cy + uniform(-39, 39));
    }
    glEnd();
}
