/* Proves: a lit, mipmapped mesh of 57,600 triangles by glDrawElements: the everyday fixed-function frame. Also a timing scene. */
#include "../scene.h"


SCENE(mesh_lit_textured, SHADED, 1024, 768, TIMED, "a lit, textured, mipmapped mesh of 57,600 triangles")
{
    enum { N = 120, M = 240 };
    static GLfloat data[(N + 1) * (M + 1)][8]; /* T2F_N3F_V3F */
    static GLuint index[N * M * 6];
    static int made;
    GLuint texture;
    if (!made) {
        GLuint *out = index;
        for (int i = 0; i <= M; i++)
            for (int j = 0; j <= N; j++) {
                double a = i * 2 * M_PI / M, b = j * 2 * M_PI / N, ripple = 0.6 + 0.03 * sin(12 * a) * sin(8 * b);
                GLfloat *v = data[i * (N + 1) + j];
                v[0] = (GLfloat)(6.0 * i / M), v[1] = (GLfloat)(3.0 * j / N);
                v[2] = (GLfloat)(cos(a) * cos(b)), v[3] = (GLfloat)(sin(a) * cos(b)), v[4] = (GLfloat)sin(b);
                v[5] = (GLfloat)((1.3 + ripple * cos(b)) * cos(a)), v[6] = (GLfloat)((1.3 + ripple * cos(b)) * sin(a)), v[7] = (GLfloat)(ripple * sin(b));
                if (i < M && j < N) {
                    GLuint p = (GLuint)(i * (N + 1) + j), q = p + N + 1;
                    *out++ = p, *out++ = q, *out++ = q + 1, *out++ = p, *out++ = q + 1, *out++ = p + 1;
                }
            }
        made = 1;
    }
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    for (int level = 0, size = 128; size; level++, size /= 2) {
        unsigned char *image = checker(size, size, size >= 8 ? size / 8 : 1);
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
        free(image);
    }
    perspective(45, (double)width / height, 1, 20);
    look_at(1.5, 2.2, 4.4, 0, 0, 0);
    GLfloat position[] = {2, 4, 5, 1}, white[] = {1, 1, 1, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, white);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 24);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glInterleavedArrays(GL_T2F_N3F_V3F, 0, data);
    glDrawElements(GL_TRIANGLES, N * M * 6, GL_UNSIGNED_INT, index);
    glDeleteTextures(1, &texture);
}
