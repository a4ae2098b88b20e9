/* What a scene program sees: GL, its own registration, and a handful of helpers.
 *
 * A scene is one idea. It starts from a fresh context whose viewport covers the window and whose buffers are cleared to
 * (0.1, 0.1, 0.15, 1), depth 1, stencil 0; it draws one frame and returns. The same scene may be drawn many times in
 * one context (timing), so it sets what it depends on. Only plain C, GL 1.1 and the OSMesa header are used. */
#ifndef TEPUI_SCENE_H
#define TEPUI_SCENE_H

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif

/* How closely an implementation must follow the reference. */
enum scene_class {
    EXACT,  /* inside the frustum; constant, interpolated or blended colour: everything equal */
    SHADED, /* lit or textured: coverage, depth and stencil equal, colour within 1/255 */
    OTHER   /* at most 0.1 % of the pixels differ, with the cause written down */
};

/* Buffers and treatment beyond the default RGBA8 + 24 bit depth + 8 bit stencil. */
enum scene_flags {
    ACCUM = 1,    /* needs an accumulation buffer */
    TIMED = 2,    /* one of the timing scenes of `bench` */
    DEPTH16 = 4,  /* 16 bit depth buffer */
    TEXT_ONLY = 8, /* its result is text, the picture does not matter */
    /* Drawn into the window, then, without text, into a framebuffer object with a floating-point depth buffer: colour and depth are
     * taken from there. Binds no framebuffer. */
    FLOAT_DEPTH = 16
};

struct scene {
    const char *name;
    enum scene_class klass;
    int width, height;
    unsigned flags;
    const char *proves;
    void (*draw)(int width, int height);
    struct scene *next;
};

void scene_register(struct scene *scene);

/* SCENE(name, class, width, height, flags, "what it proves") { ...body using width and height... } */
#define SCENE(id, klass, w, h, flags, proves)                                                                        \
    static void draw_##id(int width, int height);                                                                   \
    static struct scene scene_##id = {#id, klass, w, h, flags, proves, draw_##id, 0};                               \
    __attribute__((constructor)) static void register_##id(void) { scene_register(&scene_##id); }                   \
    static void draw_##id(int width, int height)

#define UNUSED_SIZE (void)width, (void)height

/* Adds a line to the scene's text result, which is compared as well. */
void text(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Names of GL errors, and a line "what: GL_..." for the oldest recorded error. */
const char *error_name(GLenum error);
void text_error(const char *what);

/* Projections. `pixels` maps (0,0)-(width,height) to the window's corners, depth -1..1. */
void pixels(int width, int height);
void perspective(double fovy, double aspect, double near, double far);
void look_at(double ex, double ey, double ez, double cx, double cy, double cz);

/* The same numbers everywhere: splitmix64, 24 bits. */
void seed(uint64_t value);
double uniform(double low, double high);

/* Shapes with normals and texture coordinates in immediate mode. */
void torus(double inner, double outer, int sides, int rings);
void sphere(double radius, int slices, int stacks);
void quad(double x0, double y0, double x1, double y1, double z);       /* colour as it is */
void quad_textured(double x0, double y0, double x1, double y1, double z); /* texture coordinates 0..1 */

/* Images: RGBA bytes, `size` a power of two; a checker with a gradient, and soft noise. */
unsigned char *checker(int w, int h, int cell);
unsigned char *noise(int w, int h);

/* A small texture object that is bound with `filter` and REPEAT, filled by checker(). Delete it yourself or not at all. */
GLuint checker_texture(int size, int cell, GLenum min, GLenum mag);

#endif
