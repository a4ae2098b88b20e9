/* Runs scenes on whatever OpenGL it is linked with, through the OSMesa interface, and serves them over stdin/stdout.
 *
 * The same source is built against Mesa's OSMesa and against Tepui. Commands, one a line; every answer ends with a line
 * "done" or "error <why>":
 *   list                  one line a scene: name <tab> class <tab> width <tab> height <tab> flags <tab> what it proves
 *   about                 GL_VENDOR, GL_RENDERER, GL_VERSION of a small context
 *   run <scene> <prefix>  draws once; writes <prefix>.color (RGBA8, bottom row first), .depth (u32, native units),
 *                         .stencil (u8), .text, .meta (width height depth-bits clear colour clear depth error);
 *                         depth of 32 bits: the bits of floats
 *   open <scene>          makes the context of a timing
 *   frame                 draws once more in it and prints "ms <milliseconds>", drawing and glFinish
 *   close                 ends it
 *   play <frames> <recording> <prefix>  like run for a recording (play.h), every frame timed: "ms <milliseconds>" each, then
 *                         "kib <peak memory of the process>"
 * RUNNER_MEMORY_MIB bounds the address space: what wants more fails here and not on the whole machine.
 * Called with `--first-frame`, it draws one lit triangle and exits: the time to the first frame is the process's. */
#include "play.h"
#include "scene.h"
#include <GL/osmesa.h>
#include <stdarg.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

static struct scene *scenes;
static FILE *text_file;

void scene_register(struct scene *scene)
{
    struct scene **at = &scenes;
    while (*at && strcmp((*at)->name, scene->name) < 0) at = &(*at)->next;
    scene->next = *at;
    *at = scene;
}

void text(const char *format, ...)
{
    va_list args;
    if (!text_file) return;
    va_start(args, format);
    vfprintf(text_file, format, args);
    va_end(args);
    fputc('\n', text_file);
}

static double milliseconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

struct target {
    OSMesaContext context;
    unsigned char *color;
    int width, height, depth_bits;
    GLuint framebuffer; /* with floating-point depth, where the scene wants it */
};

static void attach(GLenum attachment, GLenum format, const struct target *t)
{
    GLuint buffer;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, t->width, t->height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

static const char *target_open(struct target *t, const struct scene *s)
{
    t->width = s->width;
    t->height = s->height;
    t->depth_bits = s->flags & FLOAT_DEPTH ? 32 : s->flags & DEPTH16 ? 16 : 24;
    if (s->width < 1 || s->height < 1) return "a target has at least one pixel";
    t->color = calloc((size_t)s->width * s->height, 4);
    t->context = OSMesaCreateContextExt(OSMESA_RGBA, t->depth_bits < 24 ? t->depth_bits : 24, 8, s->flags & ACCUM ? 16 : 0, NULL);
    if (!t->context) return "no context";
    if (!OSMesaMakeCurrent(t->context, t->color, GL_UNSIGNED_BYTE, s->width, s->height)) return "MakeCurrent failed";
    if (t->depth_bits == 32) {
        glGenFramebuffers(1, &t->framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
        attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, t);
        attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, t);
        int complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        if (!complete) return "no floating-point depth";
    }
    return NULL;
}

static void target_close(struct target *t)
{
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    if (t->context) OSMesaDestroyContext(t->context);
    free(t->color);
    memset(t, 0, sizeof *t);
}

static void clear_and_draw(const struct scene *s)
{
    glClearColor(0.1f, 0.1f, 0.15f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    s->draw(s->width, s->height);
}

/* In the window for its text and for hits counted in the stencil buffer; colour and depth are the framebuffer object's. */
static void draw_twice(const struct target *t, const struct scene *s)
{
    FILE *file = text_file;
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    clear_and_draw(s);
    glPopAttrib();
    text_file = NULL;
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    clear_and_draw(s);
    glPopAttrib();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, t->width, t->height, 0, 0, t->width, t->height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    text_file = file;
}

static void draw_once(const struct target *t, const struct scene *s)
{
    if (t->framebuffer) draw_twice(t, s);
    else clear_and_draw(s);
    glFinish();
}

/* A scene may leave pixel store, transfer and maps in any state. */
static void plain_reads(void)
{
    static const GLenum zero[] = {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS};
    for (int i = 0; i < 5; i++) glPixelStorei(zero[i], 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelTransferf(GL_DEPTH_SCALE, 1);
    glPixelTransferf(GL_DEPTH_BIAS, 0);
    glPixelTransferi(GL_INDEX_SHIFT, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    glPixelTransferi(GL_MAP_STENCIL, GL_FALSE);
}

static int dump(const char *prefix, const char *suffix, const void *data, size_t size)
{
    char path[4096];
    snprintf(path, sizeof path, "%s.%s", prefix, suffix);
    FILE *f = fopen(path, "wb");
    if (!f) return 0;
    size_t written = fwrite(data, 1, size, f);
    return fclose(f) == 0 && written == size;
}

/* Reads everything back from a target that `s` was drawn to, and writes the files. */
static const char *write_results(const struct target *t, const struct scene *s, const char *prefix)
{
    char meta[512];
    GLenum error = glGetError();
    size_t n = (size_t)s->width * s->height;
    GLuint *depth = calloc(n, 4);
    unsigned char *stencil = calloc(n, 1);
    plain_reads();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, t->framebuffer);
    glReadPixels(0, 0, s->width, s->height, GL_DEPTH_COMPONENT, t->framebuffer ? GL_FLOAT : GL_UNSIGNED_INT, depth);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    for (size_t i = 0; i < n; i++) depth[i] >>= 32 - t->depth_bits;
    glReadPixels(0, 0, s->width, s->height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    GLfloat c[4] = {0}, z = 1;
    glGetFloatv(GL_COLOR_CLEAR_VALUE, c);
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &z);
    snprintf(meta, sizeof meta, "%d %d %d %.9g %.9g %.9g %.9g %.9g %s\n", s->width, s->height, t->depth_bits, c[0], c[1], c[2], c[3], z,
             error_name(error));
    int ok = dump(prefix, "color", t->color, n * 4) && dump(prefix, "depth", depth, n * 4) && dump(prefix, "stencil", stencil, n) &&
             dump(prefix, "meta", meta, strlen(meta));
    free(depth);
    free(stencil);
    return ok ? NULL : "cannot write the results";
}

static const char *run(const struct scene *s, const char *prefix)
{
    struct target t = {0};
    char path[4096];
    const char *why = target_open(&t, s);
    if (why) return why;
    snprintf(path, sizeof path, "%s.text", prefix);
    text_file = fopen(path, "w");
    draw_once(&t, s);
    if (text_file) fclose(text_file);
    text_file = NULL;
    why = write_results(&t, s, prefix);
    target_close(&t);
    return why;
}

static struct recording recording;
static const char *play_error;

static void draw_recording(int width, int height)
{
    UNUSED_SIZE;
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    play_error = recording_play(&recording);
    glPopAttrib();
}

static const char *play(int frames, const char *path, const char *prefix)
{
    struct target t = {0};
    const char *why = recording_load(&recording, path);
    struct scene s = {.name = "recording", .width = recording.width, .height = recording.height,
                      .flags = recording.depth_bits == 32 ? FLOAT_DEPTH : recording.depth_bits == 16 ? DEPTH16 : 0, .draw = draw_recording};
    if (!why) why = target_open(&t, &s);
    if (!why && !dump(prefix, "text", "", 0)) why = "cannot write the results";
    for (int i = 0; i < frames && !why; i++) {
        double start = milliseconds();
        draw_once(&t, &s);
        printf("ms %.6f\n", milliseconds() - start);
        why = play_error;
        if (!why && i == 0) why = write_results(&t, &s, prefix);
    }
    target_close(&t);
    recording_free(&recording);
    struct rusage usage;
    if (!getrusage(RUSAGE_SELF, &usage)) printf("kib %ld\n", usage.ru_maxrss);
    return why;
}

static const struct scene *find(const char *name)
{
    for (const struct scene *s = scenes; s; s = s->next)
        if (!strcmp(s->name, name)) return s;
    return NULL;
}

static const char *about(void)
{
    static const struct scene small = {.name = "about", .width = 16, .height = 16};
    struct target t = {0};
    const char *why = target_open(&t, &small);
    if (why) return why;
    printf("%s | %s | %s\n", (const char *)glGetString(GL_VENDOR), (const char *)glGetString(GL_RENDERER), (const char *)glGetString(GL_VERSION));
    target_close(&t);
    return NULL;
}

/* What a program does that starts, draws one frame and shows it. */
static int first_frame(void)
{
    static const struct scene small = {.name = "first", .width = 256, .height = 256};
    struct target t = {0};
    if (target_open(&t, &small)) return 1;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glBegin(GL_TRIANGLES);
    glNormal3f(0, 0, 1);
    glVertex2f(-0.8f, -0.8f), glVertex2f(0.8f, -0.8f), glVertex2f(0, 0.8f);
    glEnd();
    glFinish();
    int drawn = t.color[(128 * 256 + 128) * 4] != 0;
    target_close(&t);
    return drawn ? 0 : 2;
}

int main(int argc, char **argv)
{
    static char line[8192];
    struct target open_target = {0};
    const struct scene *open_scene = NULL;
    if (argc > 1 && !strcmp(argv[1], "--first-frame")) return first_frame();
    const char *memory = getenv("RUNNER_MEMORY_MIB");
    if (memory) {
        rlim_t bytes = (rlim_t)strtoull(memory, NULL, 10) << 20;
        struct rlimit limit = {bytes, bytes};
        if (setrlimit(RLIMIT_AS, &limit)) return 3;
    }
    while (fgets(line, sizeof line, stdin)) {
        char *command = strtok(line, " \n"), *name = strtok(NULL, " \n");
        char *file = command && !strcmp(command, "play") ? strtok(NULL, " \n") : NULL, *prefix = strtok(NULL, "\n");
        const struct scene *s = name ? find(name) : NULL;
        const char *why = NULL;
        if (!command) continue;
        if (!strcmp(command, "list")) {
            static const char *const classes[] = {"exact", "shaded", "other"};
            for (s = scenes; s; s = s->next)
                printf("%s\t%s\t%d\t%d\t%u\t%s\n", s->name, classes[s->klass], s->width, s->height, s->flags, s->proves);
        } else if (!strcmp(command, "about")) {
            why = about();
        } else if (!strcmp(command, "run")) {
            why = !s ? "no such scene" : !prefix ? "no prefix" : run(s, prefix);
        } else if (!strcmp(command, "play")) {
            why = !prefix ? "play <frames> <recording> <prefix>" : play(atoi(name), file, prefix);
        } else if (!strcmp(command, "open")) {
            if (open_scene) target_close(&open_target);
            open_scene = s;
            why = s ? target_open(&open_target, s) : "no such scene";
        } else if (!strcmp(command, "frame")) {
            if (open_scene) {
                double start = milliseconds();
                draw_once(&open_target, open_scene);
                printf("ms %.6f\n", milliseconds() - start);
            } else {
                why = "nothing is open";
            }
        } else if (!strcmp(command, "close")) {
            if (open_scene) target_close(&open_target);
            open_scene = NULL;
        } else {
            why = "unknown command";
        }
        if (why) printf("error %s\n", why);
        else printf("done\n");
        fflush(stdout);
    }
    return 0;
}
