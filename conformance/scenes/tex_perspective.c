/* Proves: perspective-correct texture coordinates, and q coordinates of projected textures. */
#include "../scene.h"


SCENE(tex_perspective, SHADED, 256, 256, 0, "perspective-correct and projective texture coordinates")
{
    perspective(60, (double)width / height, 0.5, 40);
    glEnable(GL_TEXTURE_2D);
    checker_texture(32, 4, GL_NEAREST, GL_NEAREST);
    glBegin(GL_TRIANGLES);
    glTexCoord2f(0, 0), glVertex3f(-0.9f, -0.9f, -2);
    glTexCoord2f(2, 0), glVertex3f(0.9f, -0.9f, -2);
    glTexCoord2f(1, 6), glVertex3f(0, 3, -14);
    glTexCoord4f(0, 0, 0, 1), glVertex3f(-1, 1, -2);
    glTexCoord4f(1, 0, 0, 2), glVertex3f(-0.2f, 0.1f, -2);
    glTexCoord4f(1, 3, 0, 4), glVertex3f(-0.4f, 1.1f, -2.1f);
    glEnd();
}
