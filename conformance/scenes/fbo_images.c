/* Proves: faces of cube maps, layers of 3D textures, smaller levels and several draw buffers are images of their own; glGenerateMipmap. */
#include "../scene.h"

static void corner(GLuint framebuffer, int x, int y)
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 32, 32, x, y, x + 32, y + 32, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

static void shade(double red)
{
    glClearColor((float)red, 0.5f, 0.25f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex2f(3, 4);
    glColor3f(0, 1, 0);
    glVertex2f(29, 9);
    glColor3f(0, 0, 1);
    glVertex2f(14, 28);
    glEnd();
}

SCENE(fbo_images, SHADED, 256, 256, 0, "faces, layers, levels and draw buffers")
{
    GLuint textures[4], framebuffer;
    GLenum both[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glGenTextures(4, textures);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, 32, 32);
    pixels(32, 32);
    glBindTexture(GL_TEXTURE_CUBE_MAP, textures[0]);
    for (int face = 0; face < 6; face++) glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    for (int face = 0; face < 6; face++) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, textures[0], 0);
        shade(face / 6.0);
    }
    for (int face = 0; face < 6; face++) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, textures[0], 0);
        corner(framebuffer, face * 40, 0);
    }
    glBindTexture(GL_TEXTURE_3D, textures[1]);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB8, 32, 32, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);
    for (int layer = 0; layer < 4; layer++) {
        glFramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, textures[1], 0, layer);
        shade(layer / 4.0);
    }
    for (int layer = 0; layer < 4; layer++) {
        glFramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, textures[1], 0, layer);
        corner(framebuffer, layer * 40, 40);
    }
    for (int k = 2; k < 4; k++) {
        glBindTexture(GL_TEXTURE_2D, textures[k]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
        glFramebufferTexture2D(GL_FRAMEBUFFER, both[k - 2], GL_TEXTURE_2D, textures[k], 0);
    }
    glDrawBuffers(2, both);
    text("%#x", glCheckFramebufferStatus(GL_FRAMEBUFFER));
    glClearColor(0.7f, 0.1f, 0.2f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawBuffer(GL_COLOR_ATTACHMENT1);
    shade(0.9);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    corner(framebuffer, 0, 80);
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    corner(framebuffer, 40, 80);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    pixels(width, height);
    glColor3f(1, 1, 1);
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    /* OSMesa rounds in eight bits at each level: further down that adds up. */
    for (int level = 0; level < 2; level++) quad_textured(40 * level, 120, 40 * level + (32 >> level), 120 + (32 >> level), 0);
    glDisable(GL_TEXTURE_2D);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(4, textures);
    text_error("at the end");
}
