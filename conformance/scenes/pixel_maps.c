/* Proves: component maps and index-to-component maps, and the maps read back. */
#include "../scene.h"


SCENE(pixel_maps, OTHER, 256, 256, 0, "pixel maps: component to component, index to component")
{
    GLfloat curve[16], back[16];
    unsigned char *image = checker(60, 60, 12), index[60 * 60];
    GLint size;
    pixels(width, height);
    for (int i = 0; i < 16; i++) curve[i] = (GLfloat)((15 - i) * (15 - i)) / 225;
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 16, curve);
    glPixelMapfv(GL_PIXEL_MAP_G_TO_G, 4, curve);
    glPixelMapfv(GL_PIXEL_MAP_B_TO_B, 8, curve);
    glPixelMapfv(GL_PIXEL_MAP_A_TO_A, 2, curve);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 16, curve);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_G, 8, curve);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_B, 4, curve + 3);
    glGetIntegerv(GL_PIXEL_MAP_R_TO_R_SIZE, &size);
    glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, back);
    text("%d %.4f %.4f", size, back[0], back[7]);
    glPixelMapfv(GL_PIXEL_MAP_S_TO_S, 3, curve);
    text_error("an index map of three");
    glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
    glRasterPos2i(10, 10);
    glDrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, image);
    for (int i = 0; i < 3600; i++) index[i] = (GLubyte)(i / 60);
    glRasterPos2i(100, 10);
    glDrawPixels(60, 60, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, index);
    glPixelTransferi(GL_MAP_COLOR, GL_FALSE);
    glRasterPos2i(180, 10);
    glDrawPixels(60, 60, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, index);
    free(image);
}
