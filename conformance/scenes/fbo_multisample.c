/* Proves: edges drawn into a renderbuffer with four samples a pixel, depth included, and resolved by a blit; depths of samples to the last bit. */
#include "../scene.h"

/* A framebuffer object with four samples a pixel, bound and cleared. */
static void multisampled(int width, int height, GLuint *framebuffer, GLuint buffers[2])
{
    glGenRenderbuffers(2, buffers);
    glGenFramebuffers(1, framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, *framebuffer);
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
}

/* Shows its colours and deletes it. */
static void resolve(int width, int height, GLuint framebuffer, GLuint buffers[2])
{
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, buffers);
    text_error("at the end");
}

SCENE(fbo_multisample, EXACT, 256, 256, 0, "four samples a pixel, resolved")
{
    GLuint buffers[2], framebuffer;
    multisampled(width, height, &framebuffer, buffers);
    seed(5);
    for (int i = 0; i < 25; i++) {
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        glBegin(GL_TRIANGLES);
        for (int k = 0; k < 3; k++) glVertex3d(uniform(0, width), uniform(0, height), uniform(-0.9, 0.9));
        glEnd();
    }
    resolve(width, height, framebuffer, buffers);
}

/* A unit of depth decides which of many nearly coplanar triangles each sample shows. */
SCENE(fbo_multisample_depth, EXACT, 256, 256, 0, "four samples a pixel of 600 triangles within a few units of depth, in perspective")
{
    GLuint buffers[2], framebuffer;
    multisampled(width, height, &framebuffer, buffers);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    seed(6);
    for (int i = 0; i < 600; i++) {
        double x = uniform(-0.8, 0.8), y = uniform(-0.8, 0.8);
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        glBegin(GL_TRIANGLES);
        for (int k = 0; k < 3; k++) {
            double w = uniform(1, 3), px = x + uniform(-0.19, 0.19), py = y + uniform(-0.19, 0.19);
            glVertex4d(px * w, py * w, (0.3 * px - 0.2 * py + uniform(-2e-7, 2e-7)) * w, w);
        }
        glEnd();
    }
    resolve(width, height, framebuffer, buffers);
}
