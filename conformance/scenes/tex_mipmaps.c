/* Proves: which levels the four mipmap filters take and mix; every level has a colour of its own. */
#include "../scene.h"


SCENE(tex_mipmaps, SHADED, 256, 256, 0, "the four mipmap filters on a receding floor")
{
    static const GLenum filters[] = {GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR};
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    for (int level = 0, size = 64; size; level++, size /= 2) {
        unsigned char *image = malloc((size_t)size * size * 4);
        for (int i = 0; i < size * size; i++) {
            int on = (i % size / 2 + i / size / 2) & 1;
            image[4 * i] = (unsigned char)(level & 1 ? 255 : 60 + 100 * on);
            image[4 * i + 1] = (unsigned char)(level & 2 ? 255 : 60 + 100 * on);
            image[4 * i + 2] = (unsigned char)(level & 4 ? 255 : 60 + 100 * on);
            image[4 * i + 3] = 255;
        }
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
        free(image);
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for (int i = 0; i < 4; i++) {
        glViewport(i % 2 * width / 2, i / 2 * height / 2, width / 2, height / 2);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (GLint)filters[i]);
        perspective(60, 1, 0.5, 40);
        glTranslatef(0, -0.6f, 0);
        glBegin(GL_TRIANGLES);
        glTexCoord2f(0, 0), glVertex3f(-0.6f, 0.1f, -1.6f);
        glTexCoord2f(4, 0), glVertex3f(0.7f, 0.15f, -1.7f);
        glTexCoord2f(1, 30), glVertex3f(0, 2, -24);
        glEnd();
    }
    glViewport(0, 0, width, height);
    glDeleteTextures(1, &name);
}
