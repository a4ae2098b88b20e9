/* Proves: REPEAT, CLAMP, CLAMP_TO_EDGE, CLAMP_TO_BORDER and MIRRORED_REPEAT with both filters, far outside 0..1. */
#include "../scene.h"

#ifndef GL_CLAMP_TO_EDGE
#define GL_CLAMP_TO_EDGE 0x812F
#endif
#ifndef GL_CLAMP_TO_BORDER
#define GL_CLAMP_TO_BORDER 0x812D
#endif
#ifndef GL_MIRRORED_REPEAT
#define GL_MIRRORED_REPEAT 0x8370
#endif

SCENE(tex_wrap, SHADED, 320, 256, 0, "every wrap mode with both filters, border colour included")
{
    static const GLenum modes[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
    GLfloat border[] = {1, 0.2f, 0.9f, 0.5f};
    pixels(width, height);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    checker_texture(8, 2, GL_NEAREST, GL_NEAREST);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    for (int i = 0; i < 20; i++) {
        GLint filter = i / 10 ? GL_LINEAR : GL_NEAREST;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, (GLint)modes[i % 5]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, (GLint)modes[i / 5 % 2 ? (i + 2) % 5 : i % 5]);
        double x = i % 5 * 64 + 2, y = i / 5 * 64 + 2;
        glBegin(GL_QUADS);
        glTexCoord2d(-1.3, -1.2), glVertex2d(x, y), glTexCoord2d(2.4, -1.2), glVertex2d(x + 60, y);
        glTexCoord2d(2.4, 2.3), glVertex2d(x + 60, y + 60), glTexCoord2d(-1.3, 2.3), glVertex2d(x, y + 60);
        glEnd();
    }
}
