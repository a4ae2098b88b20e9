/* Proves: scale and bias of each component, in drawing, in textures and in reading back. */
#include "../scene.h"


SCENE(pixel_transfer, OTHER, 256, 256, 0, "pixel transfer: scale and bias on draws, textures and reads")
{
    unsigned char *image = checker(60, 60, 12), back[8];
    pixels(width, height);
    glPixelTransferf(GL_RED_SCALE, 0.5f), glPixelTransferf(GL_RED_BIAS, 0.3f);
    glPixelTransferf(GL_GREEN_SCALE, -1), glPixelTransferf(GL_GREEN_BIAS, 1);
    glPixelTransferf(GL_BLUE_SCALE, 2), glPixelTransferf(GL_BLUE_BIAS, -0.5f);
    glPixelTransferf(GL_ALPHA_SCALE, 0.7f), glPixelTransferf(GL_ALPHA_BIAS, 0.1f);
    glRasterPos2i(10, 10);
    glDrawPixels(60, 60, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glRasterPos2i(100, 10);
    glDrawPixels(60, 60, GL_LUMINANCE, GL_UNSIGNED_BYTE, image);
    glRasterPos2i(180, 10);
    glCopyPixels(10, 10, 60, 60, GL_COLOR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glReadPixels(20, 20, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, back);
    for (int i = 0; i < 8; i++) text("%d", back[i]);
    static const GLenum names[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
    for (int i = 0; i < 8; i++) glPixelTransferf(names[i], i < 4);
    glEnable(GL_TEXTURE_2D);
    quad_textured(10, 90, 250, 250, 0);
    free(image);
}
