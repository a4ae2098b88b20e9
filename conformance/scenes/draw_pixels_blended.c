/* Proves: pixel rectangles pass through fragment operations: blending, depth, stencil, scissor, fog and texture of the raster position. */
#include "../scene.h"


SCENE(draw_pixels_blended, OTHER, 256, 256, 0, "pixel rectangles through blending, depth, alpha and stencil tests")
{
    unsigned char *image = checker(60, 60, 12);
    pixels(width, height);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0), glVertex2f(0, 0), glColor3f(0, 1, 0), glVertex2f(250, 0), glColor3f(0, 0, 1), glVertex2f(128, 250);
    glEnd();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glRasterPos2i(10, 10);
    glDrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glDisable(GL_BLEND);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    glRasterPos2i(90, 10);
    glDrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glDisable(GL_ALPHA_TEST);
    glEnable(GL_DEPTH_TEST);
    glRasterPos3f(170, 10, 0.3f);
    glDrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glRasterPos3f(190, 30, -0.3f);
    glDrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_XOR);
    glRasterPos2i(10, 100);
    glDrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glDisable(GL_COLOR_LOGIC_OP);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 9, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glRasterPos2i(100, 110);
    glDrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glDisable(GL_STENCIL_TEST);
    free(image);
}
