/* Proves: depth is drawn into a depth texture without any colour, copied into one from the window, and sampled in each of its modes. */
#include "../scene.h"

SCENE(fbo_depth_texture, SHADED, 256, 256, 0, "depth textures, drawn, copied and sampled")
{
    static const GLenum modes[3] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA};
    GLuint textures[2], framebuffer;
    glGenTextures(2, textures);
    for (int k = 0; k < 2; k++) {
        glBindTexture(GL_TEXTURE_2D, textures[k]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 64, 64, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, NULL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, textures[0], 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    text("%#x", glCheckFramebufferStatus(GL_FRAMEBUFFER));
    glViewport(0, 0, 64, 64);
    pixels(64, 64);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    seed(9);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 30; i++) glVertex3d(uniform(0, 64), uniform(0, 64), uniform(-0.9, 0.9));
    glEnd();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    pixels(width, height);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 12; i++) glVertex3d(uniform(0, 64), uniform(0, 64), uniform(-0.9, 0.9));
    glEnd();
    glBindTexture(GL_TEXTURE_2D, textures[1]);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 64, 64);
    glDisable(GL_DEPTH_TEST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    for (int k = 0; k < 2; k++) {
        glBindTexture(GL_TEXTURE_2D, textures[k]);
        for (int mode = 0; mode < 3; mode++) {
            glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, modes[mode]);
            quad_textured(70 * mode, 70 + 80 * k, 70 * mode + 64, 134 + 80 * k, 0);
        }
    }
    glDisable(GL_TEXTURE_2D);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(2, textures);
    text_error("at the end");
}
