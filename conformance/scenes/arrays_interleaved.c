/* Proves: all 14 formats of glInterleavedArrays put the right bytes into the right arrays. */
#include "../scene.h"


SCENE(arrays_interleaved, SHADED, 256, 256, 0, "all 14 interleaved array formats")
{
    static const struct { GLenum format; int t, c, n, v; } formats[14] = {{GL_V2F, 0, 0, 0, 2}, {GL_V3F, 0, 0, 0, 3}, {GL_C4UB_V2F, 0, 1, 0, 2}, {GL_C4UB_V3F, 0, 1, 0, 3},
        {GL_C3F_V3F, 0, 3, 0, 3}, {GL_N3F_V3F, 0, 0, 3, 3}, {GL_C4F_N3F_V3F, 0, 4, 3, 3}, {GL_T2F_V3F, 2, 0, 0, 3}, {GL_T4F_V4F, 4, 0, 0, 4}, {GL_T2F_C4UB_V3F, 2, 1, 0, 3},
        {GL_T2F_C3F_V3F, 2, 3, 0, 3}, {GL_T2F_N3F_V3F, 2, 0, 3, 3}, {GL_T2F_C4F_N3F_V3F, 2, 4, 3, 3}, {GL_T4F_C4F_N3F_V4F, 4, 4, 3, 4}};
    static const GLfloat xy[3][2] = {{2, 2}, {58, 6}, {22, 58}};
    pixels(width, height);
    checker_texture(16, 4, GL_NEAREST, GL_NEAREST);
    for (int k = 0; k < 14; k++) {
        GLfloat data[3 * 16], *p = data;
        for (int i = 0; i < 3; i++) {
            GLfloat t[4] = {(GLfloat)(i & 1), (GLfloat)(i >> 1), 0, 1}, c[4] = {i == 0, i == 1, i == 2, 1}, n[3] = {0, 0, 1}, v[4] = {xy[i][0], xy[i][1], 0, 1};
            GLubyte ub[4] = {(GLubyte)(i * 100), 200, (GLubyte)(250 - i * 90), 255};
            for (int j = 0; j < formats[k].t; j++) *p++ = t[j];
            if (formats[k].c == 1) memcpy(p++, ub, 4);
            else for (int j = 0; j < formats[k].c; j++) *p++ = c[j];
            for (int j = 0; j < formats[k].n; j++) *p++ = n[j];
            for (int j = 0; j < formats[k].v; j++) *p++ = v[j];
        }
        glLoadIdentity();
        glTranslatef((GLfloat)(k % 4) * 64, (GLfloat)(k / 4) * 64, 0);
        glColor3f(1, 0.8f, 0.6f);
        if (formats[k].t) glEnable(GL_TEXTURE_2D);
        else glDisable(GL_TEXTURE_2D);
        glInterleavedArrays(formats[k].format, 0, data);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}
