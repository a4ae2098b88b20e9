/* Proves: glDrawPixels of depth and stencil. */
#include "../scene.h"


SCENE(draw_pixels_depth_stencil, OTHER, 256, 256, 0, "depth and stencil images drawn, then tested against")
{
    static GLfloat depth[64 * 64];
    static GLubyte stencil[64 * 64];
    static GLushort depth16[64 * 64];
    for (int i = 0; i < 64 * 64; i++) {
        depth[i] = (GLfloat)(i % 64) / 63;
        stencil[i] = (GLubyte)(i / 64 * 4);
        depth16[i] = (GLushort)(i * 16);
    }
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glRasterPos2i(10, 10);
    glColor3f(0.5f, 0.5f, 0);
    glDrawPixels(64, 64, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    glRasterPos2i(90, 10);
    glDrawPixels(64, 64, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, depth16);
    glRasterPos2i(10, 90);
    glDrawPixels(64, 64, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    glStencilMask(0x3C); /* index shift and offset are left out: the reference ignores them here */
    glRasterPos2i(90, 90);
    glDrawPixels(64, 64, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    glStencilMask(~0u);
    glDepthFunc(GL_LESS);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_GREATER, 100, ~0u);
    glColor3f(1, 0.5f, 0);
    quad(0, 0, 256, 256, 0);
    glDisable(GL_STENCIL_TEST);
}
