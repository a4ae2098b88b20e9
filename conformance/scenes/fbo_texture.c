/* Proves: what is drawn into a texture through a framebuffer object, with depth and stencil of its own, is sampled as it was drawn. */
#include "../scene.h"

SCENE(fbo_texture, SHADED, 256, 256, 0, "drawing into a texture, then with it")
{
    GLuint texture, depth, framebuffer;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 128, 100, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 128, 100);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth);
    text("%#x", glCheckFramebufferStatus(GL_FRAMEBUFFER));
    glViewport(0, 0, 128, 100);
    pixels(128, 100);
    glClearColor(0.2f, 0.3f, 0.1f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glStencilFunc(GL_GEQUAL, 3, 255);
    seed(7);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 90; i++) glColor4d(uniform(0, 1), uniform(0, 1), uniform(0, 1), 1), glVertex3d(uniform(0, 128), uniform(0, 100), uniform(-0.9, 0.9));
    glEnd();
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(10, 70, 30, 20);
    glClearColor(1, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glColor3f(1, 0, 0);
    glLineWidth(1);
    glBegin(GL_LINES);
    for (int i = 0; i < 20; i++) glVertex2d(uniform(0, 128), uniform(0, 100));
    glEnd();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    pixels(width, height);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    quad_textured(0, 0, 128, 100, 0);
    quad_textured(140, 110, 250, 250, 0);
    glDisable(GL_TEXTURE_2D);
    /* And read as it is. */
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glRasterPos2i(0, 120);
    glCopyPixels(0, 0, 128, 100, GL_COLOR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &depth);
    glDeleteTextures(1, &texture);
    text_error("at the end");
}
