/* Proves: glGetLight, glGetMaterial, glGetTexEnv, glGetTexGen, glGetTexParameter and glGetTexLevelParameter, with conversions to integers. */
#include "../scene.h"


SCENE(get_parameters, EXACT, 64, 64, TEXT_ONLY, "queries of lights, materials, textures, environment and texgen")
{
    GLfloat f[4];
    GLint n[4];
    UNUSED_SIZE;
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    for (int l = 0; l < 2; l++)
        for (GLenum p = GL_AMBIENT; p <= GL_QUADRATIC_ATTENUATION; p++) {
            memset(f, 0, sizeof f), memset(n, 0, sizeof n);
            glGetLightfv((GLenum)(GL_LIGHT0 + l), p, f), glGetLightiv((GLenum)(GL_LIGHT0 + l), p, n);
            text("light %d %x: %g %g %g %g / %d %d %d %d", l, p, f[0], f[1], f[2], f[3], n[0], n[1], n[2], n[3]);
        }
    static const GLenum material[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES};
    for (int i = 0; i < 6; i++) {
        memset(f, 0, sizeof f), memset(n, 0, sizeof n);
        glGetMaterialfv(GL_BACK, material[i], f), glGetMaterialiv(GL_FRONT, material[i], n);
        text("material %x: %g %g %g %g / %d %d %d %d", material[i], f[0], f[1], f[2], f[3], n[0], n[1], n[2], n[3]);
    }
    static const GLenum parameter[] = {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_PRIORITY, GL_TEXTURE_BORDER_COLOR};
    for (int i = 0; i < 6; i++) {
        memset(f, 0, sizeof f);
        glGetTexParameterfv(GL_TEXTURE_2D, parameter[i], f);
        text("texture %x: %g %g %g %g", parameter[i], f[0], f[1], f[2], f[3]);
    }
    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGB5, 16, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);
    static const GLenum level[] = {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_BORDER, GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_ALPHA_SIZE};
    for (int i = 0; i < 6; i++) {
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 1, level[i], n);
        text("level %x: %d", level[i], n[0]);
    }
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 64, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, n), text("proxy %d", n[0]);
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 1 << 20, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL), text_error("a huge proxy");
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, n), text("proxy %d", n[0]);
    glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, n), text("environment %x", (unsigned)n[0]);
    glGetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, f), text("environment color %g %g %g %g", f[0], f[1], f[2], f[3]);
    for (GLenum c = GL_S; c <= GL_Q; c++) {
        glGetTexGeniv(c, GL_TEXTURE_GEN_MODE, n), glGetTexGenfv(c, GL_OBJECT_PLANE, f);
        text("texgen %x mode %x plane %g %g %g %g", c, (unsigned)n[0], f[0], f[1], f[2], f[3]);
    }
    GLubyte image[16 * 4], stipple[128];
    for (int i = 0; i < 64; i++) image[i] = (GLubyte)(i * 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    memset(image, 0, sizeof image);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_BGRA, GL_UNSIGNED_BYTE, image);
    text("image %d %d %d %d ... %d", image[0], image[1], image[2], image[3], image[63]);
    glGetPolygonStipple(stipple), text("stipple %d", stipple[77]);
}
