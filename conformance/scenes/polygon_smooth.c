/* Proves: polygon smoothing as the reference does it, with the blending that the red book uses. */
#include "../scene.h"


SCENE(polygon_smooth, OTHER, 256, 256, 0, "polygon smoothing with saturate blending")
{
    pixels(width, height);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_POLYGON_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA_SATURATE, GL_ONE);
    seed(35);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 12; i++) {
        glColor4d(uniform(0, 1), uniform(0, 1), uniform(0, 1), 0.8);
        for (int k = 0; k < 3; k++) glVertex2d(uniform(5, 250), uniform(5, 250));
    }
    glEnd();
}
