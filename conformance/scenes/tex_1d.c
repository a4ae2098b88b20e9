/* Proves: one-dimensional textures with filters, wraps and sub-images. */
#include "../scene.h"


SCENE(tex_1d, SHADED, 256, 256, 0, "one-dimensional textures")
{
    GLubyte image[32 * 3], patch[4 * 3];
    pixels(width, height);
    for (int i = 0; i < 32; i++) image[3 * i] = (GLubyte)(i * 8), image[3 * i + 1] = (GLubyte)(i & 1 ? 255 : 0), image[3 * i + 2] = (GLubyte)(255 - i * 8);
    memset(patch, 255, sizeof patch);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
    glTexSubImage1D(GL_TEXTURE_1D, 0, 10, 4, GL_RGB, GL_UNSIGNED_BYTE, patch);
    glEnable(GL_TEXTURE_1D);
    for (int i = 0; i < 4; i++) {
        glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, i & 1 ? GL_LINEAR : GL_NEAREST);
        glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, i & 1 ? GL_LINEAR : GL_NEAREST);
        glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, i & 2 ? GL_CLAMP : GL_REPEAT);
        glBegin(GL_TRIANGLE_STRIP);
        glTexCoord1f(-0.2f), glVertex2f(5, 5 + 63 * (GLfloat)i), glTexCoord1f(1.5f), glVertex2f(250, 5 + 63 * (GLfloat)i);
        glTexCoord1f(0), glVertex2f(5, 60 + 63 * (GLfloat)i), glTexCoord1f(1.1f), glVertex2f(250, 60 + 63 * (GLfloat)i);
        glEnd();
    }
}
