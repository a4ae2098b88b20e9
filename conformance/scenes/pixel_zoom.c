/* Proves: pixel zoom, fractional and negative, for drawing and copying. */
#include "../scene.h"


SCENE(pixel_zoom, OTHER, 256, 256, 0, "pixel zooms, fractional and negative")
{
    static const GLfloat zooms[][2] = {{1, 1}, {2, 3}, {0.5f, 0.7f}, {-1, 1}, {1.5f, -2}, {-2.3f, -1.2f}, {3.7f, 0.3f}};
    unsigned char *image = checker(16, 16, 4);
    pixels(width, height);
    for (int i = 0; i < 7; i++) {
        glPixelZoom(zooms[i][0], zooms[i][1]);
        glRasterPos2i(40 + i % 3 * 80, 45 + i / 3 * 75);
        glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, image);
    }
    glPixelZoom(2, 2);
    glRasterPos2i(200, 200);
    glCopyPixels(40, 45, 20, 20, GL_COLOR);
    glPixelZoom(1, 1);
    free(image);
}
