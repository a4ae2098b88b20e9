/* Proves: what queries say of floating-point depth; depths are cleared, drawn, copied, blitted, read and kept in textures as numbers; samples
 * have depths of their own. */
#include "../scene.h"

static GLuint renderbuffer(GLenum attachment, GLenum format, int samples, int width, int height)
{
    GLuint buffer;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    return buffer;
}

static void depths(const char *what, int x, int y, int count)
{
    GLfloat values[8];
    GLuint bits[8];
    glReadPixels(x, y, count, 1, GL_DEPTH_COMPONENT, GL_FLOAT, values);
    memcpy(bits, values, sizeof bits);
    for (int k = 0; k < count; k++) text("%s %d: %08x", what, k, bits[k]);
}

static void texels(const char *what, int level, int count)
{
    GLfloat values[64 * 64];
    GLuint bits[4];
    glGetTexImage(GL_TEXTURE_2D, level, GL_DEPTH_COMPONENT, GL_FLOAT, values);
    memcpy(bits, values, sizeof bits);
    for (int k = 0; k < count; k++) text("%s %d: %08x", what, k, bits[k]);
}

static void queries(void)
{
    static const GLenum names[] = {GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE};
    GLint value = -1;
    text("%#x", glCheckFramebufferStatus(GL_FRAMEBUFFER));
    for (int i = 0; i < 3; i++) glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, names[i], &value), text("%#x: %#x", names[i], value);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &value), text("%d", value);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &value), text("%#x", value);
    glGetIntegerv(GL_DEPTH_BITS, &value), text("%d", value);
}

SCENE(fbo_depth_float_images, SHADED, 256, 256, 0, "floating-point depth: queries, pixel rectangles, copies, textures, samples")
{
    static const double cleared[] = {0.1, 1e-30, 1e-40, 2, -1};
    static const GLfloat drawn[] = {0.1f, 1.5f, -0.5f, 1e-40f, 3e-20f};
    static const GLenum modes[3] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA};
    GLuint framebuffers[3], textures[2], buffers[6];
    glGenFramebuffers(3, framebuffers);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
    buffers[0] = renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, 0, 64, 64);
    buffers[1] = renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, 0, 64, 64);
    queries();
    for (int i = 0; i < 5; i++) glClearDepth(cleared[i]), glClear(GL_DEPTH_BUFFER_BIT), depths("cleared", 9, 9, 1);
    glClearDepth(1);
    glViewport(0, 0, 64, 64);
    pixels(64, 64);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 3; i++) {
        glColorMask(i > 0, i > 0, i > 0, GL_TRUE);
        glDepthFunc(i < 2 ? GL_ALWAYS : GL_LESS);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glRasterPos2i(0, 0);
        glDrawPixels(5, 1, GL_DEPTH_COMPONENT, GL_FLOAT, drawn);
        depths("drawn", 0, 0, 5);
    }
    glDepthFunc(GL_ALWAYS);
    glRasterPos2i(10, 10);
    glCopyPixels(0, 0, 5, 1, GL_DEPTH);
    depths("copied", 10, 10, 5);
    glPixelTransferf(GL_DEPTH_SCALE, 0.25f);
    glPixelTransferf(GL_DEPTH_BIAS, 0.125f);
    depths("transferred", 10, 10, 5);
    glPixelTransferf(GL_DEPTH_SCALE, 1);
    glPixelTransferf(GL_DEPTH_BIAS, 0);
    /* Into another one, and not into 24 bits. */
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[1]);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[1]);
    buffers[2] = renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, 0, 64, 64);
    buffers[3] = renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, 0, 64, 64);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[0]);
    glBlitFramebuffer(10, 10, 15, 11, 0, 0, 5, 1, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[1]);
    depths("blitted", 0, 0, 5);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 5, 1, 0, 0, 5, 1, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    text_error("to 24 bits");
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[1]);
    /* Textures: given, halved, drawn to, copied. */
    glGenTextures(2, textures);
    for (int k = 0; k < 2; k++) {
        static const GLfloat given[4] = {0.1f, 2, -1, 3e-30f};
        glBindTexture(GL_TEXTURE_2D, textures[k]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, 2, 2, 0, GL_DEPTH_COMPONENT, GL_FLOAT, given);
        texels("given", 0, 4);
        glGenerateMipmap(GL_TEXTURE_2D);
        texels("halved", 1, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, 64, 64, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, textures[0], 0);
    text("%#x", glCheckFramebufferStatus(GL_FRAMEBUFFER));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDepthFunc(GL_LESS);
    seed(9);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 30; i++) glVertex3d(uniform(0, 64), uniform(0, 64), uniform(-0.9, 0.9));
    glEnd();
    glBindTexture(GL_TEXTURE_2D, textures[1]);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 16, 16, 48, 48);
    /* Four samples. */
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[2]);
    buffers[4] = renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, 4, width, height);
    buffers[5] = renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, 4, width, height);
    text("%#x", glCheckFramebufferStatus(GL_FRAMEBUFFER));
    glViewport(0, 0, width, height);
    pixels(width, height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < 25; i++) {
        glColor3d(uniform(0, 1), uniform(0, 1), uniform(0, 1));
        glBegin(GL_TRIANGLES);
        for (int k = 0; k < 3; k++) glVertex3d(uniform(0, width), uniform(0, height), uniform(-0.9, 0.9));
        glEnd();
    }
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
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
    glDeleteFramebuffers(3, framebuffers);
    glDeleteRenderbuffers(6, buffers);
    glDeleteTextures(2, textures);
    text_error("at the end");
}
