/* Proves: eye-linear coordinates: the planes are turned by the model-view matrix of the moment they were given. */
#include "../scene.h"


SCENE(texgen_eye_linear, SHADED, 256, 256, 0, "eye-linear texture coordinates of all four components")
{
    static const GLfloat s[] = {1, 0, 0, 0}, t[] = {0, 1, 0, 0}, q[] = {0, 0, 0.2f, 1.5f}, r[] = {0, 0, 1, 0};
    GLfloat back[4];
    perspective(45, (double)width / height, 1, 20);
    glTranslatef(0, 0, -4.2f);
    glRotatef(30, 0, 0, 1);
    checker_texture(32, 4, GL_NEAREST, GL_NEAREST);
    static const GLenum coords[] = {GL_S, GL_T, GL_R, GL_Q};
    const GLfloat *planes[] = {s, t, r, q};
    for (int i = 0; i < 4; i++) {
        glTexGeni(coords[i], GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR), glTexGenfv(coords[i], GL_EYE_PLANE, planes[i]), glEnable((GLenum)(GL_TEXTURE_GEN_S + i));
        glGetTexGenfv(coords[i], GL_EYE_PLANE, back);
        text("%.4f %.4f %.4f %.4f", back[0] + 0.0, back[1] + 0.0, back[2] + 0.0, back[3] + 0.0);
    }
    glRotatef(50, 1, 0, 0);
    glEnable(GL_TEXTURE_2D), glEnable(GL_DEPTH_TEST);
    torus(0.5, 1.1, 24, 40);
}
