/* Proves: GL_NONE and the front buffer as draw buffers; drawing to none still writes depth. */
#include "../scene.h"


SCENE(draw_buffer, EXACT, 256, 256, 0, "draw buffers: none and front")
{
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    glDrawBuffer(GL_NONE);
    glColor3f(1, 0, 0);
    quad(10, 10, 150, 150, -0.5);
    glDrawBuffer(GL_FRONT);
    text_error("the front buffer");
    glColor3f(0, 1, 0);
    quad(100, 100, 240, 240, 0);
}
