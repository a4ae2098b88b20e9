/* Proves: the time and the bits of 300 blended triangles that cover a fifth of the window each (mean), in perspective.
 * The generator is arithmetic of doubles only, so the vertices are the same everywhere; their hash is checked. */
#include "../scene.h"


typedef struct { GLfloat position[4]; } vertex4;

static uint64_t state;
static uint32_t word(void)
{
    uint64_t z = (state += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return (uint32_t)((z ^ (z >> 31)) >> 32);
}
static double range(double a, double b) { return a + (b - a) * ((double)(word() >> 8) * (1.0 / 16777216.0)); }

static uint64_t fnv(uint64_t hash, const void *data, size_t size)
{
    const uint32_t *w = data;
    for (size_t i = 0; i < size / 4; i++) hash ^= w[i], hash *= 0x100000001B3ull;
    return hash;
}

SCENE(blend_300_large, EXACT, 1024, 768, TIMED, "300 large blended triangles")
{
    static vertex4 vertex[900];
    static uint32_t color[900];
    static int made;
    if (!made) {
        double w = width, h = height;
        uint32_t index[900];
        state = 0x5EED0004ull;
        for (uint32_t t = 0; t < 300; t++) {
            double x[3], y[3], area;
            do {
                for (int k = 0; k < 3; k++) x[k] = range(0, w), y[k] = range(0, h);
                area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
            } while (fabs(area) < 2.0 * w * h / 7.0);
            double z = range(-0.9, 0.9);
            for (uint32_t k = 0; k < 3; k++) {
                double q = range(1, 4), xn = x[k] * 2.0 / w - 1.0, yn = y[k] * 2.0 / h - 1.0;
                uint32_t r = word();
                GLfloat p[4] = {(GLfloat)(xn * q), (GLfloat)(yn * q), (GLfloat)(z * q), (GLfloat)q};
                memcpy(vertex[3 * t + k].position, p, sizeof p);
                color[3 * t + k] = (r & 0xFFFFFFu) | ((64 + (r >> 24) % 128) << 24);
                index[3 * t + k] = 3 * t + k;
            }
        }
        uint64_t hash = fnv(0xCBF29CE484222325ull, vertex, sizeof vertex);
        hash = fnv(fnv(hash, color, sizeof color), index, sizeof index);
        if (hash != 0x3ba8152ee27d735full) {
            fprintf(stderr, "blend_300_large: the generator's hash is %016llx\n", (unsigned long long)hash);
            abort();
        }
        made = 1;
    }
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(4, GL_FLOAT, 0, vertex);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
    glDrawArrays(GL_TRIANGLES, 0, 900);
}
