/* Proves: 102,400 small triangles of a torus drawn by glDrawElements, interpolated colours, depth tested, everything inside
 * the frustum: colour and depth equal in every pixel. Also a timing scene. */
#include "../scene.h"


SCENE(torus_102400, EXACT, 1024, 768, TIMED, "a torus of 102,400 triangles: equal colour and depth in all 786,432 pixels")
{
    enum { SIDES = 160, RINGS = 320 };
    static GLfloat vertex[(SIDES * RINGS)][3];
    static GLubyte color[(SIDES * RINGS)][4];
    static GLuint index[SIDES * RINGS * 6];
    static int made;
    if (!made) {
        GLuint *out = index;
        for (int i = 0; i < RINGS; i++)
            for (int j = 0; j < SIDES; j++) {
                double a = i * 2 * M_PI / RINGS, b = j * 2 * M_PI / SIDES;
                int v = i * SIDES + j, right = (i + 1) % RINGS * SIDES, up = (j + 1) % SIDES;
                vertex[v][0] = (GLfloat)((1.2 + 0.55 * cos(b)) * cos(a));
                vertex[v][1] = (GLfloat)((1.2 + 0.55 * cos(b)) * sin(a));
                vertex[v][2] = (GLfloat)(0.55 * sin(b));
                color[v][0] = (GLubyte)(127 + 127 * cos(a) * cos(b));
                color[v][1] = (GLubyte)(127 + 127 * sin(a) * cos(b));
                color[v][2] = (GLubyte)(127 + 127 * sin(b * 3));
                color[v][3] = 255;
                GLuint a0 = (GLuint)v, a1 = (GLuint)(right + j), a2 = (GLuint)(right + up), a3 = (GLuint)(i * SIDES + up);
                *out++ = a0, *out++ = a1, *out++ = a2, *out++ = a0, *out++ = a2, *out++ = a3;
            }
        made = 1;
    }
    perspective(45, (double)width / height, 1, 20);
    look_at(1.5, 1.8, 4.2, 0, 0, 0);
    glEnable(GL_DEPTH_TEST);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, vertex);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
    glDrawElements(GL_TRIANGLES, SIDES * RINGS * 6, GL_UNSIGNED_INT, index);
}
