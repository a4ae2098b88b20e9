/* Proves: glDrawElements with all three index types, several primitive types, shared vertices and strides. */
#include "../scene.h"


SCENE(arrays_draw_elements, EXACT, 256, 256, 0, "glDrawElements with all index types and strided arrays")
{
    static struct { GLfloat p[3]; GLubyte c[4]; GLint pad; } v[25];
    static const GLubyte ub[] = {0, 1, 6, 5, 6, 2, 7, 11};
    static const GLushort us[] = {10, 11, 15, 16, 20, 21};
    static const GLuint ui[] = {13, 8, 14, 18, 12, 8};
    pixels(width, height);
    for (int i = 0; i < 25; i++) {
        v[i].p[0] = 10 + (GLfloat)(i % 5) * 58, v[i].p[1] = 10 + (GLfloat)(i / 5) * 57, v[i].p[2] = 0;
        v[i].c[0] = (GLubyte)(i * 10), v[i].c[1] = (GLubyte)(255 - i * 7), v[i].c[2] = (GLubyte)(i * 71), v[i].c[3] = 255;
    }
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof v[0], v[0].p);
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof v[0], v[0].c);
    glShadeModel(GL_FLAT);
    glDrawElements(GL_QUADS, 8, GL_UNSIGNED_BYTE, ub);
    glShadeModel(GL_SMOOTH);
    glDrawElements(GL_TRIANGLE_STRIP, 6, GL_UNSIGNED_SHORT, us);
    glDrawElements(GL_TRIANGLE_FAN, 6, GL_UNSIGNED_INT, ui);
}
