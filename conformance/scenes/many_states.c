/* Proves: batches with hundreds of different states keep their order and their states. */
#include "../scene.h"


SCENE(many_states, EXACT, 256, 256, 0, "400 triangles, each with blending, stipple, scissor, masks and depth of its own")
{
    GLubyte pattern[128];
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    seed(60);
    for (int i = 0; i < 400; i++) {
        static const GLenum factors[] = {GL_ONE, GL_ZERO, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA};
        for (int k = 0; k < 128; k++) pattern[k] = (GLubyte)(i * k);
        (i & 1 ? glEnable : glDisable)(GL_BLEND);
        (i & 2 ? glEnable : glDisable)(GL_SCISSOR_TEST);
        (i % 5 ? glDisable : glEnable)(GL_POLYGON_STIPPLE);
        (i % 7 ? glDisable : glEnable)(GL_ALPHA_TEST);
        glPolygonStipple(pattern);
        glAlphaFunc(GL_GREATER, 0.4f);
        glBlendFunc(factors[i % 5], factors[i / 5 % 5]);
        glScissor((GLint)uniform(0, 100), (GLint)uniform(0, 100), 150, 150);
        glColorMask(1, i % 3 != 0, 1, i % 11 != 0);
        glDepthFunc(i % 4 ? GL_LEQUAL : GL_ALWAYS);
        glDepthMask((GLboolean)(i % 6 != 0));
        glShadeModel(i % 9 ? GL_SMOOTH : GL_FLAT);
        glBegin(GL_TRIANGLES);
        for (int k = 0; k < 3; k++) glColor4d(uniform(0, 1), uniform(0, 1), uniform(0, 1), uniform(0, 1)), glVertex3d(uniform(0, 256), uniform(0, 256), uniform(-1, 1));
        glEnd();
    }
    glDisable(GL_BLEND), glDisable(GL_SCISSOR_TEST), glDisable(GL_POLYGON_STIPPLE), glDisable(GL_ALPHA_TEST), glColorMask(1, 1, 1, 1), glDepthMask(1), glShadeModel(GL_SMOOTH);
}
