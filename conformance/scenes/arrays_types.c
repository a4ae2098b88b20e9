/* Proves: every type of vertex, colour, normal and texture coordinate arrays, with strides, converts as it should. */
#include "../scene.h"


SCENE(arrays_types, EXACT, 256, 256, 0, "glDrawArrays with every type of vertex and colour array")
{
    static const GLshort s[6] = {0, 0, 50, 4, 20, 50};
    static const GLint i[6] = {0, 0, 50, 4, 20, 50};
    static const GLfloat f[6] = {0, 0, 50.3f, 4.1f, 20.7f, 50.9f};
    static const GLdouble d[12] = {0, 0, 0, 1, 50.3, 4.1, 0, 1, 20.7, 50.9, 0, 1};
    static const GLbyte cb[9] = {127, 0, -50, 0, 127, 64, 20, 30, 127};
    static const GLubyte cub[12] = {255, 0, 50, 255, 0, 255, 64, 255, 20, 30, 255, 255};
    static const GLshort cs[9] = {32767, 0, 5000, 0, 32767, 9000, 100, 8000, 32767};
    static const GLushort cus[9] = {65535, 0, 5000, 0, 65535, 9000, 100, 8000, 65535};
    static const GLint ci[9] = {2147483647, 0, 50000000, 0, 2147483647, 90000000, 100, 800000000, 2147483647};
    static const GLuint cui[9] = {4294967295u, 0, 50000000, 0, 4294967295u, 90000000, 100, 800000000, 4294967295u};
    static const GLfloat cf[9] = {1, 0, 0.3f, 0, 1, 0.4f, 0.1f, 0.2f, 1};
    static const GLdouble cd[9] = {1, 0, 0.3, 0, 1, 0.4, 0.1, 0.2, 1};
    static const struct { GLint size; GLenum type; const void *data; } v[4] = {{2, GL_SHORT, s}, {2, GL_INT, i}, {2, GL_FLOAT, f}, {4, GL_DOUBLE, d}};
    static const struct { GLint size; GLenum type; const void *data; } c[8] = {{3, GL_BYTE, cb}, {4, GL_UNSIGNED_BYTE, cub}, {3, GL_SHORT, cs},
        {3, GL_UNSIGNED_SHORT, cus}, {3, GL_INT, ci}, {3, GL_UNSIGNED_INT, cui}, {3, GL_FLOAT, cf}, {3, GL_DOUBLE, cd}};
    pixels(width, height);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    for (int n = 0; n < 16; n++) {
        glLoadIdentity();
        glTranslatef(5 + (GLfloat)(n % 4) * 63, 5 + (GLfloat)(n / 4) * 63, 0);
        glVertexPointer(v[(n + n / 4) % 4].size, v[(n + n / 4) % 4].type, 0, v[(n + n / 4) % 4].data);
        glColorPointer(c[n % 8].size, c[n % 8].type, 0, c[n % 8].data);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}
