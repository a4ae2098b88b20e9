/* A framebuffer object with 32 bits of floating-point depth: numbers that 24 bits take for one are told apart and read back. */
#include "check.h"
#include <GL/glext.h>
#include <math.h>

static unsigned char pixels[64 * 64 * 4];

static float depth_at(int x, int y)
{
    GLfloat depth = -1;
    glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    return depth;
}

static GLuint attach(GLenum attachment, GLenum format, int samples)
{
    GLuint buffer;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, 64, 64);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    return buffer;
}

static void square(float z, float red)
{
    glColor3f(red, 0, 1);
    glBegin(GL_QUADS);
    glVertex3f(-1, -1, z), glVertex3f(1, -1, z), glVertex3f(1, 1, z), glVertex3f(-1, 1, z);
    glEnd();
}

int main(void)
{
    OSMesaContext c = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    static const int samples[] = {2, 4, 8, 16};
    GLuint framebuffers[2];
    GLint type = 0, size = 0;
    unsigned char color[4];
    CHECK(OSMesaMakeCurrent(c, pixels, GL_UNSIGNED_BYTE, 64, 64));
    CHECK(!strstr((const char *)glGetString(GL_EXTENSIONS), "GL_ARB_depth_buffer_float"));
    glGenFramebuffers(2, framebuffers);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
    attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, 0);
    attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, 0);
    CHECK_EQUAL(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    CHECK_EQUAL(integer(GL_DEPTH_BITS), 32);
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    CHECK_EQUAL(type, GL_FLOAT);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &size);
    CHECK_EQUAL(size, 32);

    /* Cleared to a number that is no multiple of 2^-24; the square nearest to the eye stays. */
    glClearDepth(1e-7);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    CHECK(depth_at(5, 5) == 1e-7f);
    glEnable(GL_DEPTH_TEST);
    glDepthRange(0, 1e-7);
    square(0, 0.2f);
    square(-0.5f, 1);
    square(-0.25f, 0.4f);
    CHECK(fabsf(depth_at(9, 60) - 0.25e-7f) < 1e-14f);
    glReadPixels(9, 60, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color);
    CHECK_EQUAL(color[0], 255);
    glDepthRange(0, 1);

    /* The same of every number of samples, resolved by a blit. */
    for (int k = 0; k < 4; k++) {
        GLuint buffers[2];
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[1]);
        buffers[0] = attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, samples[k]);
        buffers[1] = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, samples[k]);
        CHECK_EQUAL(integer(GL_SAMPLES), samples[k]);
        glClearDepth(1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        square(0.5f, 0);
        square(0.2f, 1);
        square(0.3f, 0);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[0]);
        glBlitFramebuffer(0, 0, 64, 64, 0, 0, 64, 64, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
        CHECK(depth_at(31, 8) == 0.6f);
        glReadPixels(31, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color);
        CHECK_EQUAL(color[0], 255);
        glDeleteRenderbuffers(2, buffers);
    }
    CHECK_EQUAL(glGetError(), GL_NO_ERROR);

    /* Without the format that has stencil as well. */
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH32F_STENCIL8, 4, 4);
    CHECK_EQUAL(glGetError(), GL_INVALID_ENUM);
    OSMesaDestroyContext(c);
    return failures;
}
