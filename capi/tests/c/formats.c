/* Every format and type: what lies where in memory, and what is refused. */
#include "check.h"

#define W 5
#define H 3
#define GUARD 64

static unsigned char memory[GUARD + 16 * 16 * 16 + GUARD];
static unsigned char *const buffer = memory + GUARD;

/* The surroundings of `size` bytes are untouched. */
static int intact(size_t size)
{
    size_t i;
    for (i = 0; i < sizeof memory; i++)
        if ((i < GUARD || i >= GUARD + size) && memory[i] != 0x5a)
            return 0;
    return 1;
}

static void expect(GLenum format, GLenum type, const void *pixel, size_t bytes)
{
    OSMesaContext context = OSMesaCreateContextExt(format, 0, 0, 0, NULL);
    size_t i;
    CHECK(context != NULL);
    memset(memory, 0x5a, sizeof memory);
    CHECK_EQUAL(OSMesaMakeCurrent(context, buffer, type, W, H), GL_TRUE);
    clear(0.2f, 0.4f, 0.6f, 0.8f);
    CHECK(intact(0));
    glFinish();
    for (i = 0; i < W * H; i++)
        if (memcmp(buffer + i * bytes, pixel, bytes) != 0) {
            failures++;
            fprintf(stderr, "format %#x, type %#x: pixel %d is wrong: %02x %02x %02x %02x\n", format, type, (int)i, buffer[i * bytes],
                    buffer[i * bytes + 1], buffer[i * bytes + 2], buffer[i * bytes + 3]);
            break;
        }
    CHECK(intact(W * H * bytes));
    CHECK_EQUAL(osmesa(OSMESA_FORMAT), format);
    CHECK_EQUAL(osmesa(OSMESA_TYPE), type);
    OSMesaDestroyContext(context);
}

static void refuse(GLenum format, GLenum type)
{
    OSMesaContext context = OSMesaCreateContextExt(format, 0, 0, 0, NULL);
    CHECK(context != NULL);
    CHECK_EQUAL(OSMesaMakeCurrent(context, buffer, type, W, H), GL_FALSE);
    CHECK(OSMesaGetCurrentContext() == NULL);
    OSMesaDestroyContext(context);
}

static void rows(void)
{
    OSMesaContext context = OSMesaCreateContext(OSMESA_RGB, NULL);
    int x, y, up;
    for (up = 0; up < 2; up++) {
        memset(memory, 0x5a, sizeof memory);
        CHECK_EQUAL(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, W, H), GL_TRUE);
        OSMesaPixelStore(OSMESA_ROW_LENGTH, W + 2);
        OSMesaPixelStore(OSMESA_Y_UP, up);
        glDisable(GL_SCISSOR_TEST);
        clear(0, 0, 0, 0);
        glEnable(GL_SCISSOR_TEST);
        glScissor(1, 0, 1, 1);
        clear(1, 1, 1, 1);
        glFinish();
        for (y = 0; y < H; y++)
            for (x = 0; x < W + 2; x++) {
                int bottom = up ? y == 0 : y == H - 1;
                int wanted = x >= W ? 0x5a : bottom && x == 1 ? 255 : 0;
                CHECK_EQUAL(buffer[(y * (W + 2) + x) * 3], wanted);
            }
        CHECK_EQUAL(osmesa(OSMESA_ROW_LENGTH), W + 2);
        CHECK_EQUAL(osmesa(OSMESA_Y_UP), up);
    }
    OSMesaDestroyContext(context);
}

int main(void)
{
    static const unsigned char rgba[] = {51, 102, 153, 204}, bgra[] = {153, 102, 51, 204}, argb[] = {204, 51, 102, 153};
    static const unsigned char bgr[] = {153, 102, 51};
    static const unsigned short shorts[] = {13107, 26214, 39321, 52428}, packed[] = {6 << 11 | 25 << 5 | 19};
    static const float floats[] = {0.2f, 0.4f, 0.6f, 0.8f};
    int i;

    expect(OSMESA_RGBA, GL_UNSIGNED_BYTE, rgba, 4);
    expect(OSMESA_BGRA, GL_UNSIGNED_BYTE, bgra, 4);
    expect(OSMESA_ARGB, GL_UNSIGNED_BYTE, argb, 4);
    expect(OSMESA_RGB, GL_UNSIGNED_BYTE, rgba, 3);
    expect(OSMESA_BGR, GL_UNSIGNED_BYTE, bgr, 3);
    /* As Mesa has it, the order is always RGBA for the wide types. */
    expect(OSMESA_RGBA, GL_UNSIGNED_SHORT, shorts, 8);
    expect(OSMESA_BGRA, GL_UNSIGNED_SHORT, shorts, 8);
    expect(OSMESA_ARGB, GL_UNSIGNED_SHORT, shorts, 8);
    expect(OSMESA_RGB, GL_UNSIGNED_SHORT, shorts, 6);
    expect(OSMESA_RGBA, GL_FLOAT, floats, 16);
    expect(OSMESA_BGRA, GL_FLOAT, floats, 16);
    expect(OSMESA_ARGB, GL_FLOAT, floats, 16);
    expect(OSMESA_RGB, GL_FLOAT, floats, 12);
    expect(OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5, packed, 2);

    refuse(OSMESA_COLOR_INDEX, GL_UNSIGNED_BYTE);
    refuse(OSMESA_RGB_565, GL_UNSIGNED_BYTE);
    refuse(OSMESA_RGB_565, GL_UNSIGNED_SHORT);
    refuse(OSMESA_RGBA, GL_UNSIGNED_SHORT_5_6_5);
    refuse(OSMESA_RGBA, GL_BYTE);
    refuse(OSMESA_RGBA, GL_UNSIGNED_INT);
    refuse(OSMESA_RGBA, 0);
    for (i = 0; i < 0x2000; i++)
        if (i != OSMESA_COLOR_INDEX && i != OSMESA_RGBA && i != OSMESA_RGB && i != 1 && i != 2 && i != 4 && i != 5)
            CHECK(OSMesaCreateContext(i, NULL) == NULL);
    rows();
    return failures;
}
