/* What the examples share: an off-screen window and a PNG writer. Plain C and the OSMesa interface, so every example
 * builds against Mesa's OSMesa as well as against Tepui. */
#ifndef OFFSCREEN_H
#define OFFSCREEN_H

#include <GL/gl.h>
#include <GL/osmesa.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif

static struct {
    OSMesaContext context;
    unsigned char *pixels;
    int width, height;
} offscreen;

/* A context with 24 bits of depth and 8 of stencil, current on a window of width x height pixels. */
static inline void offscreen_open(int width, int height)
{
    offscreen.width = width;
    offscreen.height = height;
    offscreen.pixels = calloc((size_t)width * (size_t)height, 4);
    offscreen.context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    if (!offscreen.pixels || !offscreen.context || !OSMesaMakeCurrent(offscreen.context, offscreen.pixels, GL_UNSIGNED_BYTE, width, height)) {
        fprintf(stderr, "cannot make an OSMesa context\n");
        exit(1);
    }
    printf("%s, %s\n", (const char *)glGetString(GL_RENDERER), (const char *)glGetString(GL_VERSION));
}

static inline void offscreen_close(void)
{
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    OSMesaDestroyContext(offscreen.context);
    free(offscreen.pixels);
}

static inline void png_word(unsigned char *p, unsigned v)
{
    p[0] = (unsigned char)(v >> 24), p[1] = (unsigned char)(v >> 16), p[2] = (unsigned char)(v >> 8), p[3] = (unsigned char)v;
}

static inline void png_chunk(FILE *f, const char *kind, const unsigned char *data, unsigned size)
{
    unsigned char word[4];
    unsigned crc = ~0u;
    png_word(word, size), fwrite(word, 1, 4, f);
    fwrite(kind, 1, 4, f), fwrite(data, 1, size, f);
    for (unsigned i = 0; i < 4 + size; i++) {
        crc ^= i < 4 ? (unsigned char)kind[i] : data[i - 4];
        for (int k = 0; k < 8; k++) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
    }
    png_word(word, ~crc), fwrite(word, 1, 4, f);
}

/* Finishes the frame and writes it as an opaque PNG (stored, not compressed: no library is needed). */
static inline void offscreen_save(const char *path)
{
    unsigned row = 1 + 3 * (unsigned)offscreen.width, rows = (unsigned)offscreen.height, a = 1, b = 0;
    unsigned char header[13] = {0}, *data = malloc((size_t)(row + 5) * rows + 6), *p = data;
    FILE *f = fopen(path, "wb");
    if (!f || !data) {
        fprintf(stderr, "cannot write %s\n", path);
        exit(1);
    }
    glFinish();
    *p++ = 0x78, *p++ = 1; /* zlib: deflate, 32K window */
    for (unsigned y = 0; y < rows; y++) { /* a stored block a row, top row first */
        const unsigned char *source = offscreen.pixels + (size_t)(rows - 1 - y) * (size_t)offscreen.width * 4;
        *p++ = y + 1 == rows, *p++ = (unsigned char)row, *p++ = (unsigned char)(row >> 8), *p++ = (unsigned char)~row, *p++ = (unsigned char)(~row >> 8);
        unsigned char *start = p;
        *p++ = 0; /* no filter */
        for (int x = 0; x < offscreen.width; x++, source += 4) *p++ = source[0], *p++ = source[1], *p++ = source[2];
        for (; start < p; start++) a = (a + *start) % 65521, b = (b + a) % 65521;
    }
    png_word(p, b << 16 | a), p += 4;
    png_word(header, (unsigned)offscreen.width), png_word(header + 4, rows), header[8] = 8, header[9] = 2;
    fwrite("\x89PNG\r\n\x1a\n", 1, 8, f);
    png_chunk(f, "IHDR", header, 13);
    png_chunk(f, "IDAT", data, (unsigned)(p - data));
    png_chunk(f, "IEND", header, 0);
    if (fclose(f) != 0) fprintf(stderr, "cannot write %s\n", path);
    free(data);
    printf("%s\n", path);
}

/* gluPerspective and gluLookAt, without GLU. */
static inline void camera(double fovy, double near, double far, double ex, double ey, double ez)
{
    double aspect = (double)offscreen.width / offscreen.height, top = near * tan(fovy * M_PI / 360);
    double n = sqrt(ex * ex + ey * ey + ez * ez), fx = -ex / n, fy = -ey / n, fz = -ez / n, s = sqrt(fx * fx + fz * fz);
    double sx = -fz / s, sz = fx / s;
    GLdouble m[16] = {sx, 0, -fx, 0, 0, 0, -fy, 0, sz, 0, -fz, 0, 0, 0, 0, 1};
    /* up = side x forward */
    m[1] = -sz * fy, m[5] = sz * fx - sx * fz, m[9] = sx * fy;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-top * aspect, top * aspect, -top, top, near, far);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glMultMatrixd(m);
    glTranslated(-ex, -ey, -ez);
}

/* The numbers of a little generator, low <= x < high, the same on every machine. */
static inline double chance(double low, double high)
{
    static unsigned long long state = 88172645463325252ull;
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return low + (high - low) * (double)(state >> 11) / 9007199254740992.0;
}

/* A sphere, a torus and a box with normals. */
static inline void solid_sphere(double radius, int slices, int stacks)
{
    for (int i = 0; i < stacks; i++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j <= slices; j++)
            for (int k = 1; k >= 0; k--) {
                double a = M_PI * ((double)(i + k) / stacks - 0.5), b = 2 * M_PI * j / slices;
                double x = cos(a) * cos(b), y = sin(a), z = -cos(a) * sin(b);
                glNormal3d(x, y, z);
                glVertex3d(radius * x, radius * y, radius * z);
            }
        glEnd();
    }
}

static inline void solid_torus(double inner, double outer, int sides, int rings)
{
    for (int i = 0; i < rings; i++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j <= sides; j++)
            for (int k = 1; k >= 0; k--) {
                double a = 2 * M_PI * (i + k) / rings, b = 2 * M_PI * j / sides;
                glNormal3d(cos(a) * cos(b), sin(a) * cos(b), sin(b));
                glVertex3d((outer + inner * cos(b)) * cos(a), (outer + inner * cos(b)) * sin(a), inner * sin(b));
            }
        glEnd();
    }
}

static inline void solid_box(double sx, double sy, double sz)
{
    glBegin(GL_QUADS);
    for (int axis = 0; axis < 3; axis++)
        for (int side = -1; side <= 1; side += 2) {
            double n[3] = {0}, size[3] = {sx / 2, sy / 2, sz / 2};
            int u = (axis + 1) % 3, v = (axis + 2) % 3;
            n[axis] = side;
            glNormal3dv(n);
            for (int c = 0; c < 4; c++) {
                double p[3];
                p[axis] = side * size[axis];
                p[u] = side * (c == 1 || c == 2 ? size[u] : -size[u]);
                p[v] = c >= 2 ? size[v] : -size[v];
                glVertex3dv(p);
            }
        }
    glEnd();
}

static inline void material(float r, float g, float b)
{
    GLfloat color[] = {r, g, b, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color);
}

#endif
