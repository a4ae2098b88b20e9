/* Proves: edges drawn into a renderbuffer with four samples a pixel, depth included, and resolved by a blit. */
#include "../scene.h"

SCENE(fbo_multisample, SHADED, 256, 256, 0, "four samples a pixel, resolved")
{
    GLuint buffers[2], framebuffer;
    glGenRenderbuffers(2, buffers);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
    text("%#x", glCheckFramebufferStatus(GL_FRAMEBUFFER));
    pixels(width, height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    seed(5);
    for (int i = 0; i < 25; i++) {
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        glBegin(GL_TRIANGLES);
        for (int k = 0; k < 3; k++) glVertex3d(uniform(0, width), uniform(0, height), uniform(-0.9, 0.9));
        glEnd();
    }
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, buffers);
    text_error("at the end");
}
