/* Proves: culling of front, back and both faces under both front-face conventions. */
#include "../scene.h"


SCENE(cull_face, EXACT, 256, 256, 0, "culling under both windings")
{
    pixels(width, height);
    for (int i = 0; i < 16; i++) {
        static const GLenum faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK, GL_BACK};
        double x = 4 + i % 4 * 63, y = 4 + i / 4 * 63;
        if (i % 4 == 3) glDisable(GL_CULL_FACE);
        else glEnable(GL_CULL_FACE);
        glCullFace(faces[i % 4]);
        glFrontFace(i & 4 ? GL_CW : GL_CCW);
        glColor3d(i / 16.0, 1, 0.4);
        glBegin(GL_TRIANGLES);
        if (i & 8) glVertex2d(x, y), glVertex2d(x + 20, y + 56), glVertex2d(x + 58, y + 3);
        else glVertex2d(x, y), glVertex2d(x + 58, y + 3), glVertex2d(x + 20, y + 56);
        glEnd();
    }
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
}
