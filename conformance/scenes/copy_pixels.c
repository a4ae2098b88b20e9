/* Proves: glCopyPixels of colour, depth and stencil, overlapping source and destination among them. */
#include "../scene.h"


SCENE(copy_pixels, OTHER, 256, 256, 0, "copies of colour, depth and stencil within the window")
{
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 5, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    seed(50);
    for (int i = 0; i < 20; i++) glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1)), quad(uniform(0, 80), uniform(0, 80), uniform(20, 100), uniform(20, 100), uniform(-1, 1));
    glDisable(GL_STENCIL_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_FALSE);
    glRasterPos2i(120, 10);
    glCopyPixels(0, 0, 100, 100, GL_COLOR);
    glRasterPos2i(30, 120);
    glCopyPixels(0, 0, 60, 60, GL_COLOR);
    glRasterPos2i(50, 140);
    glCopyPixels(30, 120, 60, 60, GL_COLOR); /* overlaps itself */
    glDepthMask(GL_TRUE);
    glColorMask(0, 0, 0, 0);
    glRasterPos2i(120, 120);
    glCopyPixels(0, 0, 100, 100, GL_DEPTH);
    glColorMask(1, 1, 1, 1);
    glRasterPos2i(130, 130);
    glCopyPixels(0, 0, 100, 100, GL_STENCIL);
    glDepthFunc(GL_LESS);
}
