/* Proves: glBlitFramebuffer copies between window and framebuffer object, flips, scales with either filter and obeys the scissor. */
#include "../scene.h"

SCENE(fbo_blit, SHADED, 256, 256, 0, "blits between the window and a renderbuffer")
{
    GLuint color, framebuffer;
    pixels(width, height);
    seed(11);
    for (int i = 0; i < 40; i++) glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1)), quad(uniform(0, 64), uniform(0, 64), uniform(0, 64), uniform(0, 64), 0);
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 64, 64);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    glBlitFramebuffer(0, 0, 64, 64, 0, 0, 64, 64, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 64, 64, 70, 0, 134, 64, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBlitFramebuffer(0, 0, 64, 64, 204, 0, 140, 64, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBlitFramebuffer(0, 0, 64, 64, 0, 134, 64, 70, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBlitFramebuffer(5, 3, 45, 43, 70, 70, 190, 150, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(10, 160, 100, 80);
    glBlitFramebuffer(0, 0, 64, 64, 0, 150, 128, 278, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, 32, 32, 128, 160, 224, 256, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &color);
    text_error("at the end");
}
