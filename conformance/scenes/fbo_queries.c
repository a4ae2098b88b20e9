/* Proves: which framebuffers are complete, what queries of them answer, and the errors of what they do not allow. */
#include "../scene.h"

static void status(const char *what)
{
    text("%s: %#x", what, glCheckFramebufferStatus(GL_FRAMEBUFFER));
}

static void attached(GLenum point)
{
    static const GLenum names[] = {GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE,
                                   GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL};
    for (int i = 0; i < 6; i++) {
        GLint value = -1;
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, point, names[i], &value);
        text("%#x %#x: %d %s", point, names[i], value, error_name(glGetError()));
    }
}

static void bits(void)
{
    static const GLenum names[] = {GL_RED_BITS, GL_ALPHA_BITS, GL_DEPTH_BITS, GL_STENCIL_BITS, GL_SAMPLE_BUFFERS, GL_SAMPLES, GL_DRAW_BUFFER, GL_READ_BUFFER};
    for (int i = 0; i < 8; i++) {
        GLint value = -1;
        glGetIntegerv(names[i], &value);
        text("%#x: %#x %s", names[i], value, error_name(glGetError()));
    }
}

SCENE(fbo_queries, EXACT, 64, 64, TEXT_ONLY, "completeness, queries and errors of framebuffer objects")
{
    GLuint buffers[4], textures[2], framebuffer;
    unsigned char pixel[4];
    UNUSED_SIZE;
    attached(GL_DEPTH);
    attached(GL_STENCIL);
    glGenFramebuffers(1, &framebuffer);
    text("%d", glIsFramebuffer(framebuffer));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    text("%d", glIsFramebuffer(framebuffer));
    status("nothing");
    glClear(GL_COLOR_BUFFER_BIT);
    text_error("glClear");
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    text_error("glReadPixels");
    glBegin(GL_POINTS);
    text("glBegin");
    glEnd();
    text_error("glBegin");
    attached(GL_COLOR_ATTACHMENT0);
    attached(GL_FRONT_LEFT);
    glGenRenderbuffers(4, buffers);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    status("no storage");
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 16, 8);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    status("colour");
    attached(GL_COLOR_ATTACHMENT0);
    bits();
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 16, 8);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
    status("depth and stencil");
    attached(GL_DEPTH_STENCIL_ATTACHMENT);
    attached(GL_STENCIL_ATTACHMENT);
    bits();
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
    attached(GL_DEPTH_STENCIL_ATTACHMENT);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[2]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 3, GL_RGBA8, 16, 8);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[2]);
    status("samples differ");
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 0);
    status("samples");
    bits();
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    text_error("glReadPixels of samples");
    glBlitFramebuffer(0, 0, 16, 8, 0, 0, 8, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    text_error("scaled blit of samples");
    glBlitFramebuffer(0, 0, 16, 8, 0, 0, 16, 8, GL_COLOR_BUFFER_BIT, GL_LINEAR_MIPMAP_LINEAR);
    text_error("filter of a blit");
    glBlitFramebuffer(0, 0, 16, 8, 0, 0, 16, 8, GL_DEPTH_BUFFER_BIT, GL_LINEAR);
    text_error("filtered depth");
    glBlitFramebuffer(0, 0, 16, 8, 0, 0, 16, 8, 1, GL_NEAREST);
    text_error("mask of a blit");
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[3]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, 16, 8);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[3]);
    status("depth as colour");
    glGenTextures(2, textures);
    glBindTexture(GL_TEXTURE_2D, textures[0]);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[0], 0);
    text_error("a texture without images");
    status("a texture without images");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);
    status("a texture");
    attached(GL_COLOR_ATTACHMENT0);
    bits();
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[1], 0);
    text_error("a texture that was not bound");
    glFramebufferTexture1D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_1D, textures[0], 0);
    text_error("another target");
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[0], -1);
    text_error("level");
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_RGBA, GL_TEXTURE_2D, textures[0], 0);
    text_error("attachment");
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA, -1, 1);
    text_error("negative storage");
    glRenderbufferStorage(GL_RENDERBUFFER, 4, 1, 1);
    text_error("storage of no format");
    glDrawBuffer(GL_FRONT);
    text_error("glDrawBuffer");
    glReadBuffer(GL_BACK);
    text_error("glReadBuffer");
    glDeleteTextures(2, textures);
    status("deleted");
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(4, buffers);
    bits();
    text_error("at the end");
}
