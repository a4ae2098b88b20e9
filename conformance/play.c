/* See play.h. One function of the table is one GL command; `a` holds its arguments, each as the integer and as the float
 * that the text says. */
#include "play.h"
#include "scene.h"

#define MAX_ARGUMENTS 40

struct argument {
    GLint i;
    GLfloat f;
};

static GLfloat *floats(const struct argument *a, int n)
{
    static GLfloat values[MAX_ARGUMENTS];
    for (int k = 0; k < n; k++) values[k] = a[k].f;
    return values;
}

static void play_enable(const struct argument *a) { glEnable((GLenum)a[0].i); }
static void play_disable(const struct argument *a) { glDisable((GLenum)a[0].i); }
static void play_viewport(const struct argument *a) { glViewport(a[0].i, a[1].i, a[2].i, a[3].i); }
static void play_scissor(const struct argument *a) { glScissor(a[0].i, a[1].i, a[2].i, a[3].i); }
static void play_depth_range(const struct argument *a) { glDepthRange(a[0].f, a[1].f); }
static void play_depth_func(const struct argument *a) { glDepthFunc((GLenum)a[0].i); }
static void play_depth_mask(const struct argument *a) { glDepthMask((GLboolean)a[0].i); }
static void play_blend_func(const struct argument *a) { glBlendFunc((GLenum)a[0].i, (GLenum)a[1].i); }
static void play_blend_equation(const struct argument *a) { glBlendEquation((GLenum)a[0].i); }
static void play_alpha_func(const struct argument *a) { glAlphaFunc((GLenum)a[0].i, a[1].f); }
static void play_logic_op(const struct argument *a) { glLogicOp((GLenum)a[0].i); }
static void play_shade_model(const struct argument *a) { glShadeModel((GLenum)a[0].i); }
static void play_clear_color(const struct argument *a) { glClearColor(a[0].f, a[1].f, a[2].f, a[3].f); }
static void play_clear(const struct argument *a) { glClear((GLbitfield)a[0].i); }
static void play_clear_stencil(const struct argument *a) { glClearStencil(a[0].i); }
static void play_color(const struct argument *a) { glColor4fv(floats(a, 4)); }
static void play_normal(const struct argument *a) { glNormal3fv(floats(a, 3)); }
static void play_polygon_offset(const struct argument *a) { glPolygonOffset(a[0].f, a[1].f); }
static void play_point_size(const struct argument *a) { glPointSize(a[0].f); }
static void play_line_width(const struct argument *a) { glLineWidth(a[0].f); }
static void play_hint(const struct argument *a) { glHint((GLenum)a[0].i, (GLenum)a[1].i); }
static void play_fog(const struct argument *a) { glFogfv((GLenum)a[0].i, floats(a + 1, 4)); }
static void play_fog_mode(const struct argument *a) { glFogi(GL_FOG_MODE, a[0].i); }
static void play_light(const struct argument *a) { glLightfv((GLenum)a[0].i, (GLenum)a[1].i, floats(a + 2, 4)); }
static void play_light_model(const struct argument *a) { glLightModelfv((GLenum)a[0].i, floats(a + 1, 4)); }
static void play_material(const struct argument *a) { glMaterialfv((GLenum)a[0].i, (GLenum)a[1].i, floats(a + 2, 4)); }
static void play_tex_env(const struct argument *a) { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, a[0].i); }
static void play_tex_env_f(const struct argument *a) { glTexEnvf((GLenum)a[0].i, (GLenum)a[1].i, a[2].f); }
static void play_tex_parameter(const struct argument *a) { glTexParameteri(GL_TEXTURE_2D, (GLenum)a[0].i, a[1].i); }

static void play_matrix(const struct argument *a)
{
    glMatrixMode((GLenum)a[0].i);
    glLoadMatrixf(floats(a + 1, 16));
    glMatrixMode(GL_MODELVIEW);
}

static void play_clip_plane(const struct argument *a)
{
    GLdouble plane[4] = {a[1].f, a[2].f, a[3].f, a[4].f};
    glClipPlane(GL_CLIP_PLANE0 + (GLenum)a[0].i, plane);
}

static void play_stencil(const struct argument *a)
{
    glStencilFunc((GLenum)a[0].i, a[1].i, (GLuint)a[2].i);
    glStencilOp((GLenum)a[3].i, (GLenum)a[4].i, (GLenum)a[5].i);
}

static void play_polygon_stipple(const struct argument *a)
{
    GLubyte mask[128];
    for (int row = 0; row < 32; row++)
        for (int byte = 0; byte < 4; byte++) mask[row * 4 + byte] = (GLubyte)((GLuint)a[row].i >> (24 - 8 * byte));
    glPolygonStipple(mask);
}

/* The framebuffer that `multisample` draws into: made once a context, so that only the first frame pays for it. */
static struct {
    GLuint framebuffer;
    int width, height;
} several;

/* Why what a recording asks for is not there. */
static char refusal[64];

static void several_storage(GLenum attachment, GLenum format, const struct argument *a)
{
    GLuint buffer;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, a[0].i, format, a[1].i, a[2].i);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

static void play_multisample(const struct argument *a)
{
    GLint most = 0, samples = 0;
    if (!several.framebuffer) {
        glGetIntegerv(GL_MAX_SAMPLES, &most);
        if (a[0].i > most) {
            snprintf(refusal, sizeof refusal, NOT_THERE "%d samples a pixel, at most %d", a[0].i, most);
            return;
        }
        glGenFramebuffers(1, &several.framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, several.framebuffer);
        several_storage(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, a);
        several_storage(GL_COLOR_ATTACHMENT0, GL_RGBA8, a);
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &samples);
        if (samples != a[0].i) snprintf(refusal, sizeof refusal, NOT_THERE "%d samples a pixel, but %d", a[0].i, samples);
        several.width = a[1].i, several.height = a[2].i;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, several.framebuffer);
}

static void play_resolve(const struct argument *a)
{
    GLint w = several.width, h = several.height;
    (void)a;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

static void play_grid(const struct argument *a)
{
    glMapGrid2f(a[0].i, 0, 1, a[0].i, 0, 1);
    glEvalMesh2(GL_FILL, 0, a[0].i, 0, a[0].i);
}

static const struct {
    const char *name;
    int arguments;
    void (*play)(const struct argument *);
} commands[] = {
    {"enable", 1, play_enable},
    {"disable", 1, play_disable},
    {"viewport", 4, play_viewport},
    {"scissor", 4, play_scissor},
    {"depth_range", 2, play_depth_range},
    {"depth_func", 1, play_depth_func},
    {"depth_mask", 1, play_depth_mask},
    {"blend_func", 2, play_blend_func},
    {"blend_equation", 1, play_blend_equation},
    {"alpha_func", 2, play_alpha_func},
    {"logic_op", 1, play_logic_op},
    {"shade_model", 1, play_shade_model},
    {"clear_color", 4, play_clear_color},
    {"clear", 1, play_clear},
    {"clear_stencil", 1, play_clear_stencil},
    {"color", 4, play_color},
    {"normal", 3, play_normal},
    {"polygon_offset", 2, play_polygon_offset},
    {"point_size", 1, play_point_size},
    {"line_width", 1, play_line_width},
    {"hint", 2, play_hint},
    {"fog", 5, play_fog},
    {"fog_mode", 1, play_fog_mode},
    {"light", 6, play_light},
    {"light_model", 5, play_light_model},
    {"material", 6, play_material},
    {"tex_env", 1, play_tex_env},
    {"tex_env_f", 3, play_tex_env_f},
    {"tex_parameter", 2, play_tex_parameter},
    {"matrix", 17, play_matrix},
    {"clip_plane", 5, play_clip_plane},
    {"stencil", 6, play_stencil},
    {"polygon_stipple", 32, play_polygon_stipple},
    {"grid", 1, play_grid},
    {"multisample", 3, play_multisample},
    {"resolve", 0, play_resolve},
};

/* draw <mode> <what a vertex has> <count> <immediate>: vertices of a position (4 floats), then a colour (4) where bit 0 is
 * set, a normal (3) for bit 1, texture coordinates (4) for bit 2. Returns the bytes of data. */
static size_t draw(const struct argument *a, const char *data)
{
    int has = a[1].i, count = a[2].i;
    size_t floats = 4 + (has & 1 ? 4u : 0) + (has & 2 ? 3u : 0) + (has & 4 ? 4u : 0);
    const GLfloat *at = (const GLfloat *)data, *color = at + 4, *normal = color + (has & 1 ? 4 : 0), *coordinate = normal + (has & 2 ? 3 : 0);
    GLsizei stride = (GLsizei)(floats * sizeof(GLfloat));
    if (a[3].i) {
        glBegin((GLenum)a[0].i);
        for (int i = 0; i < count; i++, at += floats, color += floats, normal += floats, coordinate += floats) {
            if (has & 1) glColor4fv(color);
            if (has & 2) glNormal3fv(normal);
            if (has & 4) glTexCoord4fv(coordinate);
            glVertex4fv(at);
        }
        glEnd();
    } else {
        glVertexPointer(4, GL_FLOAT, stride, at);
        glColorPointer(4, GL_FLOAT, stride, color);
        glNormalPointer(GL_FLOAT, stride, normal);
        glTexCoordPointer(4, GL_FLOAT, stride, coordinate);
        glEnableClientState(GL_VERTEX_ARRAY);
        (has & 1 ? glEnableClientState : glDisableClientState)(GL_COLOR_ARRAY);
        (has & 2 ? glEnableClientState : glDisableClientState)(GL_NORMAL_ARRAY);
        (has & 4 ? glEnableClientState : glDisableClientState)(GL_TEXTURE_COORD_ARRAY);
        glDrawArrays((GLenum)a[0].i, 0, count);
    }
    return (size_t)count * floats * sizeof(GLfloat);
}

/* texture <level> <width> <height>: an RGBA8 image of the bound texture object. */
static size_t texture(const struct argument *a, const char *data)
{
    glTexImage2D(GL_TEXTURE_2D, a[0].i, GL_RGBA8, a[1].i, a[2].i, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
    return (size_t)a[1].i * (size_t)a[2].i * 4;
}

/* surface <order>: control points of GL_MAP2_VERTEX_3, order x order. */
static size_t surface(const struct argument *a, const char *data)
{
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, a[0].i, 0, 1, 3 * a[0].i, a[0].i, (const GLfloat *)data);
    glEnable(GL_MAP2_VERTEX_3);
    return (size_t)a[0].i * (size_t)a[0].i * 12;
}

/* Splits one line into its name and arguments; returns where the next line begins, NULL where there is none. */
static const char *parse(const char *at, const char *end, char *name, struct argument *a, int *count)
{
    const char *stop = memchr(at, '\n', (size_t)(end - at));
    int used = 0;
    if (!stop || sscanf(at, "%31s%n", name, &used) != 1) return NULL;
    at += used;
    for (*count = 0; *count < MAX_ARGUMENTS; ++*count) {
        while (at < stop && *at == ' ') at++;
        if (at >= stop) break;
        char *after;
        if (*at == 'x') {
            uint32_t bits = (uint32_t)strtoul(at + 1, &after, 16);
            memcpy(&a[*count].f, &bits, 4);
            a[*count].i = 0;
        } else {
            a[*count].i = (GLint)strtoll(at, &after, 10);
            a[*count].f = (GLfloat)a[*count].i;
        }
        if (after == at) return NULL;
        at = after;
    }
    return stop + 1;
}

const char *recording_load(struct recording *r, const char *path)
{
    FILE *f = fopen(path, "rb");
    memset(r, 0, sizeof *r);
    memset(&several, 0, sizeof several);
    refusal[0] = 0;
    if (!f) return "cannot open the recording";
    fseek(f, 0, SEEK_END);
    r->size = (size_t)ftell(f);
    rewind(f);
    r->data = malloc(r->size + 1);
    size_t got = r->data ? fread(r->data, 1, r->size, f) : 0;
    fclose(f);
    if (got != r->size) return "cannot read the recording";
    r->data[r->size] = 0;
    char name[32];
    int count = 0;
    struct argument a[MAX_ARGUMENTS];
    const char *body = parse(r->data, r->data + r->size, name, a, &count);
    if (!body || strcmp(name, "target") || count != 3) return "a recording begins with: target <width> <height> <depth bits>";
    r->width = a[0].i, r->height = a[1].i, r->depth_bits = a[2].i;
    r->body = (size_t)(body - r->data);
    return NULL;
}

void recording_free(struct recording *r)
{
    free(r->data);
    memset(r, 0, sizeof *r);
}

const char *recording_play(const struct recording *r)
{
    static char unknown[64];
    const char *at = r->data + r->body, *end = r->data + r->size;
    while (at < end) {
        char name[32] = "";
        int count = 0;
        struct argument a[MAX_ARGUMENTS];
        const char *data = parse(at, end, name, a, &count);
        size_t k, known = sizeof commands / sizeof *commands;
        if (data && !strcmp(name, "draw") && count == 4) {
            data += draw(a, data);
        } else if (data && !strcmp(name, "texture") && count == 3) {
            data += texture(a, data);
        } else if (data && !strcmp(name, "surface") && count == 1) {
            data += surface(a, data);
        } else {
            for (k = 0; data && k < known && strcmp(commands[k].name, name); k++) continue;
            if (!data || k == known || commands[k].arguments != count) {
                snprintf(unknown, sizeof unknown, "cannot play \"%s\" with %d arguments", name, count);
                return unknown;
            }
            commands[k].play(a);
            if (refusal[0]) return refusal;
        }
        at = data;
    }
    return NULL;
}
