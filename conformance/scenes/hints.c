/* Proves: hints change nothing that can be compared. */
#include "../scene.h"


SCENE(hints, SHADED, 256, 256, 0, "hints: fastest and nicest of each kind")
{
    pixels(width, height);
    checker_texture(32, 4, GL_LINEAR, GL_LINEAR);
    for (int i = 0; i < 2; i++) {
        GLenum wish = i ? GL_FASTEST : GL_NICEST;
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, wish), glHint(GL_POINT_SMOOTH_HINT, wish), glHint(GL_LINE_SMOOTH_HINT, wish), glHint(GL_POLYGON_SMOOTH_HINT, wish), glHint(GL_FOG_HINT, wish);
        glEnable(GL_TEXTURE_2D);
        glBegin(GL_TRIANGLES);
        glTexCoord4f(0, 0, 0, 1), glVertex4f(10, 10 + 120 * (GLfloat)i, 0, 1), glTexCoord2f(3, 0), glVertex4f(480, 20 + 240 * (GLfloat)i, 0, 2), glTexCoord2f(1, 3), glVertex2f(120, 120 + 120 * (GLfloat)i);
        glEnd();
        glDisable(GL_TEXTURE_2D);
    }
}
