/* Proves: textures of OpenGL 1.2 to 1.4: units and combiners, three dimensions, cube maps, wrap modes, level of detail, automatic mipmaps. */
#define GL_GLEXT_PROTOTYPES
#include "../scene.h"
#include <GL/glext.h>


static void rectangle(double x, double y, double size, double coord)
{
    glBegin(GL_TRIANGLE_FAN);
    for (int k = 0; k < 4; k++) {
        double s = k == 1 || k == 2, t = k >= 2;
        glColor4d(s, t, 1 - s, 0.25 + 0.5 * t);
        glMultiTexCoord2d(GL_TEXTURE0, s * coord, t * coord);
        glMultiTexCoord2d(GL_TEXTURE1, t * coord, s * coord);
        glVertex2d(x + s * size, y + t * size);
    }
    glEnd();
}

static void combine(GLenum rgb, GLenum alpha)
{
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, (GLint)rgb);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, (GLint)alpha);
}

SCENE(later_combiners, SHADED, 256, 256, 0, "two texture units and every function of the combiner")
{
    static const GLenum rgb[] = {GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
    pixels(width, height);
    glActiveTexture(GL_TEXTURE0), checker_texture(16, 4, GL_NEAREST, GL_NEAREST), glEnable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE1), checker_texture(8, 1, GL_NEAREST, GL_NEAREST), glEnable(GL_TEXTURE_2D);
    for (int k = 0; k < 8; k++) {
        glActiveTexture(GL_TEXTURE1);
        combine(rgb[k], k < 6 ? rgb[k] : GL_MODULATE);
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, (const GLfloat[4]){0.25f, 0.5f, 0.75f, 0.5f});
        glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE2_RGB, k == 4 ? GL_PRIMARY_COLOR : GL_CONSTANT);
        glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, k & 1 ? GL_ONE_MINUS_SRC_COLOR : GL_SRC_COLOR);
        glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, k == 2 ? 2 : 1);
        glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, k == 7 ? GL_TEXTURE0 : GL_TEXTURE);
        rectangle(4 + k % 4 * 63, 10 + k / 4 * 126, 58, 1);
    }
    glDisable(GL_TEXTURE_2D), glActiveTexture(GL_TEXTURE0), glDisable(GL_TEXTURE_2D);
}

SCENE(later_texture_3d, SHADED, 128, 128, 0, "three-dimensional textures")
{
    static unsigned char texels[8 * 8 * 8][4];
    GLuint name;
    pixels(width, height);
    for (int i = 0; i < 512; i++) texels[i][0] = (unsigned char)(i % 8 * 36), texels[i][1] = (unsigned char)(i / 8 % 8 * 36), texels[i][2] = (unsigned char)(i / 64 * 36), texels[i][3] = 255;
    glGenTextures(1, &name), glBindTexture(GL_TEXTURE_3D, name);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST), glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_3D), glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    for (int k = 0; k < 2; k++) {
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, k ? GL_LINEAR : GL_NEAREST);
        glBegin(GL_TRIANGLE_FAN);
        glTexCoord3f(0, 0, 0.1f), glVertex2i(4, 4 + 62 * k), glTexCoord3f(1.5f, 0, 0.3f), glVertex2i(124, 4 + 62 * k), glTexCoord3f(1.5f, 1, 1.2f), glVertex2i(124, 60 + 62 * k), glTexCoord3f(0, 1, 0.9f), glVertex2i(4, 60 + 62 * k);
        glEnd();
    }
    glDisable(GL_TEXTURE_3D);
}

SCENE(later_cube_map, SHADED, 128, 128, 0, "a cube map by normals and by reflection")
{
    GLuint name;
    perspective(40, (double)width / height, 1, 20);
    glTranslatef(0, 0, -4);
    glGenTextures(1, &name), glBindTexture(GL_TEXTURE_CUBE_MAP, name);
    for (int face = 0; face < 6; face++) {
        unsigned char texels[4][4][4];
        for (int i = 0; i < 16; i++) texels[i / 4][i % 4][0] = (unsigned char)(face * 50), texels[i / 4][i % 4][1] = (unsigned char)(i * 16), texels[i / 4][i % 4][2] = (unsigned char)(i % 2 * 255), texels[i / 4][i % 4][3] = 255;
        glTexImage2D((GLenum)(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST), glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_CUBE_MAP), glEnable(GL_DEPTH_TEST), glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    for (int k = 0; k < 2; k++) {
        for (GLenum c = 0; c < 3; c++) glTexGeni(GL_S + c, GL_TEXTURE_GEN_MODE, k ? GL_REFLECTION_MAP : GL_NORMAL_MAP), glEnable(GL_TEXTURE_GEN_S + c);
        glPushMatrix(), glTranslatef(k ? 0.7f : -0.7f, 0, 0), sphere(0.65, 12, 8), glPopMatrix();
    }
    for (GLenum c = 0; c < 3; c++) glDisable(GL_TEXTURE_GEN_S + c);
    glDisable(GL_TEXTURE_CUBE_MAP);
}

SCENE(later_wrap_and_lod, SHADED, 256, 128, 0, "mirrored repeat, clamp to edge and border, bias, level ranges, generated mipmaps")
{
    static const GLint wrap[] = {GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_REPEAT};
    unsigned char *image = checker(32, 32, 8);
    GLuint name;
    pixels(width, height);
    glGenTextures(1, &name), glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, (const GLfloat[4]){1, 0, 1, 1});
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    for (int k = 0; k < 4; k++) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap[k]), glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap[k]);
        rectangle(4 + 63 * k, 4, 58, 2.5);
    }
    for (int k = 0; k < 4; k++) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, k == 1 ? 1 : 0);
        glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, k == 2 ? 2.0f : 0);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, k == 3 ? 0 : 1000);
        rectangle(4 + 63 * k, 66, 58, 4.3);
    }
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0);
    glDisable(GL_TEXTURE_2D);
    free(image);
}
