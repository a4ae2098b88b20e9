/* Proves: vertices and fragments of OpenGL 1.2 to 1.4: separate specular, rescaled normals, secondary colour, fog coordinates, point parameters,
 * blending, stencil wrap, window positions, ranges and many arrays. */
#define GL_GLEXT_PROTOTYPES
#include "../scene.h"
#include <GL/glext.h>


SCENE(later_lighting, SHADED, 256, 128, 0, "separate specular colour over a texture, rescaled normals, colour sum")
{
    perspective(40, (double)width / height, 1, 20);
    glTranslatef(0, 0, -4);
    glLightfv(GL_LIGHT0, GL_POSITION, (const GLfloat[4]){1, 2, 3, 0});
    glEnable(GL_LIGHTING), glEnable(GL_LIGHT0), glEnable(GL_DEPTH_TEST), glEnable(GL_RESCALE_NORMAL), glEnable(GL_TEXTURE_2D);
    checker_texture(16, 4, GL_NEAREST, GL_NEAREST);
    glMaterialfv(GL_FRONT, GL_SPECULAR, (const GLfloat[4]){1, 1, 1, 1}), glMaterialf(GL_FRONT, GL_SHININESS, 20);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glPushMatrix(), glTranslatef(-1.3f, 0, 0), glScalef(2, 2, 2), sphere(0.5, 24, 16), glPopMatrix();
    glDisable(GL_LIGHTING), glEnable(GL_COLOR_SUM);
    glColor3f(0.2f, 0.5f, 0.2f);
    glBegin(GL_TRIANGLES);
    glSecondaryColor3f(0.5f, 0, 0), glTexCoord2f(0, 0), glVertex2f(0.3f, -1), glSecondaryColor3f(0, 0, 0.9f), glTexCoord2f(1, 0), glVertex2f(2.3f, -1), glSecondaryColor3ub(0, 200, 0), glTexCoord2f(0, 1), glVertex2f(1.3f, 1);
    glEnd();
    glDisable(GL_COLOR_SUM), glDisable(GL_TEXTURE_2D);
}

SCENE(later_fog_coordinate, SHADED, 128, 128, 0, "fog by coordinate")
{
    pixels(width, height);
    glEnable(GL_FOG), glFogi(GL_FOG_MODE, GL_LINEAR), glFogf(GL_FOG_START, 1), glFogf(GL_FOG_END, 3), glFogfv(GL_FOG_COLOR, (const GLfloat[4]){1, 1, 0, 1});
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    glBegin(GL_TRIANGLES);
    glFogCoordf(0), glVertex2i(8, 8), glFogCoordf(4), glVertex2i(120, 8), glFogCoordd(2), glVertex2i(64, 120);
    glEnd();
    glDisable(GL_FOG);
}

SCENE(later_points, EXACT, 128, 128, 0, "point sizes by distance, with limits")
{
    perspective(60, (double)width / height, 1, 20);
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (const GLfloat[3]){0, 0, 0.04f});
    glPointParameterf(GL_POINT_SIZE_MIN, 3), glPointParameterf(GL_POINT_SIZE_MAX, 12);
    glPointSize(8);
    glBegin(GL_POINTS);
    for (int k = 0; k < 8; k++) glColor3f(1, (GLfloat)k / 8, 0), glVertex3f((GLfloat)k * 0.6f - 2.1f, (GLfloat)k * 0.4f - 1.37f, -2 - (GLfloat)k);
    glEnd();
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (const GLfloat[3]){1, 0, 0});
    glPointSize(1);
}

SCENE(later_fragments, EXACT, 128, 128, 0, "separate blend functions, constant colour, equations, stencil wrap, window positions")
{
    static const GLubyte bits[8] = {0x3c, 0x42, 0x81, 0xa5, 0x81, 0x99, 0x42, 0x3c};
    static const GLenum equation[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    pixels(width, height);
    glEnable(GL_BLEND), glBlendColor(0.25f, 0.5f, 0.75f, 0.5f);
    for (int k = 0; k < 5; k++) {
        glBlendEquation(GL_FUNC_ADD), glBlendFuncSeparate(GL_ONE, GL_ZERO, GL_ZERO, GL_ONE);
        glColor4f(0.6f, 0.3f, 0.1f, 0.2f), quad(4 + 24 * k, 4, 24 + 24 * k, 60, 0);
        glBlendEquation(equation[k]), glBlendFuncSeparate(GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA, GL_SRC_COLOR, GL_ONE);
        glColor4f(0.9f, 0.8f, 0.3f, 0.7f), quad(4 + 24 * k, 30, 24 + 24 * k, 80, 0);
    }
    glDisable(GL_BLEND), glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 0, 255), glStencilOp(GL_KEEP, GL_KEEP, GL_DECR_WRAP), quad(4, 84, 60, 100, 0);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR_WRAP), quad(40, 84, 100, 120, 0);
    glDisable(GL_STENCIL_TEST);
    glColor3f(1, 1, 1);
    glWindowPos2i(110, 100), glBitmap(8, 8, 0, 0, 0, 0, bits);
    glWindowPos3f(10.5f, 110, 0.5f), glBitmap(8, 8, 0, 0, 0, 0, bits);
}

SCENE(later_arrays, EXACT, 128, 128, 0, "DrawRangeElements, MultiDrawArrays, MultiDrawElements, packed pixels")
{
    static const GLint first[] = {0, 3}, count[] = {3, 3};
    static const GLfloat vertices[][2] = {{4, 4}, {60, 4}, {30, 60}, {64, 4}, {124, 4}, {90, 60}, {4, 64}, {60, 64}, {30, 124}};
    static const GLubyte colors[][3] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}, {0, 255, 255}, {255, 0, 255}, {9, 99, 199}, {250, 100, 0}, {0, 0, 0}};
    static const GLushort indices[] = {6, 7, 8}, image[] = {0xf800, 0x07e0, 0x001f, 0xffff};
    pixels(width, height);
    glEnableClientState(GL_VERTEX_ARRAY), glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, vertices), glColorPointer(3, GL_UNSIGNED_BYTE, 0, colors);
    glMultiDrawArrays(GL_TRIANGLES, first, count, 2);
    glDrawRangeElements(GL_TRIANGLES, 6, 8, 3, GL_UNSIGNED_SHORT, indices);
    glDisableClientState(GL_VERTEX_ARRAY), glDisableClientState(GL_COLOR_ARRAY);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glRasterPos2i(80, 80), glPixelZoom(8, 8), glDrawPixels(2, 2, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, image);
    glRasterPos2i(100, 80), glDrawPixels(1, 2, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, (const GLuint[2]){0xff8040c0, 0xff00ff80}), glPixelZoom(1, 1);
}
