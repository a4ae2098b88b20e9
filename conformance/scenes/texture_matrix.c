/* Proves: the texture matrix turns, scales and projects coordinates. */
#include "../scene.h"


SCENE(texture_matrix, SHADED, 256, 256, 0, "texture matrices: rotated, scaled, projective")
{
    pixels(width, height);
    checker_texture(32, 8, GL_LINEAR, GL_LINEAR);
    glEnable(GL_TEXTURE_2D);
    for (int i = 0; i < 4; i++) {
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        if (i == 1) glRotatef(30, 0, 0, 1);
        if (i == 2) glScalef(3, 2, 1), glTranslatef(0.25f, 0.1f, 0);
        if (i == 3) {
            static const GLfloat project[16] = {1, 0, 0, 0.5f, 0, 1, 0, 0.2f, 0, 0, 1, 0, 0, 0, 0, 1};
            glLoadMatrixf(project);
        }
        glMatrixMode(GL_MODELVIEW);
        double x = 5 + i % 2 * 126, y = 5 + i / 2 * 126;
        quad_textured(x, y, x + 118, y + 118, 0);
    }
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
}
