/* Bits, attribute lists, queries. */
#include "check.h"

static unsigned char a[64 * 64 * 4];

static void bits(int depth, int stencil, int accum, int got_depth, int got_stencil, int got_accum)
{
    OSMesaContext c = OSMesaCreateContextExt(OSMESA_RGBA, depth, stencil, accum, NULL);
    CHECK(c != NULL);
    CHECK_EQUAL(OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, 64, 64), GL_TRUE);
    CHECK_EQUAL(integer(GL_DEPTH_BITS), got_depth);
    CHECK_EQUAL(integer(GL_STENCIL_BITS), got_stencil);
    CHECK_EQUAL(integer(GL_ACCUM_RED_BITS), got_accum);
    CHECK_EQUAL(integer(GL_ACCUM_ALPHA_BITS), got_accum);
    OSMesaDestroyContext(c);
}

static void depth(int depth_bits, int stencil_bits, int bytes, unsigned quarter)
{
    OSMesaContext c = OSMesaCreateContextExt(OSMESA_RGBA, depth_bits, stencil_bits, 0, NULL);
    GLint w = -1, h = -1, b = -1;
    void *p = NULL, *again = NULL;
    int up;
    CHECK_EQUAL(OSMesaGetDepthBuffer(c, &w, &h, &b, &p), GL_FALSE); /* not bound yet */
    CHECK(w == 0 && h == 0 && p == NULL);
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, 64, 48);
    for (up = 0; up < 2; up++) {
        OSMesaPixelStore(OSMESA_Y_UP, up);
        glDisable(GL_SCISSOR_TEST);
        glClearDepth(0.25);
        glClearStencil(0x7f);
        glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 1, 1);
        glClearDepth(1);
        glClear(GL_DEPTH_BUFFER_BIT);
        CHECK_EQUAL(OSMesaGetDepthBuffer(c, &w, &h, &b, &p), bytes > 0);
        if (bytes == 0)
            continue;
        CHECK_EQUAL(w, 64);
        CHECK_EQUAL(h, 48);
        CHECK_EQUAL(b, bytes);
        /* the bottom row comes first, whichever way the picture goes */
        if (bytes == 2) {
            CHECK_EQUAL(((unsigned short *)p)[0], 0xffff);
            CHECK_EQUAL(((unsigned short *)p)[64], quarter);
        } else {
            CHECK_EQUAL(((unsigned *)p)[0], quarter | 0xffffff);
            CHECK_EQUAL(((unsigned *)p)[64], quarter);
        }
    }
    if (bytes == 4) {
        glDisable(GL_SCISSOR_TEST);
        glClearDepth(0);
        glClear(GL_DEPTH_BUFFER_BIT);
        CHECK_EQUAL(((unsigned *)p)[64], quarter);
        glFinish(); /* renews the copy */
        CHECK_EQUAL(((unsigned *)p)[64], quarter & 0xff000000);
        OSMesaGetDepthBuffer(c, NULL, NULL, NULL, &again);
        CHECK(again == p);
    }
    OSMesaDestroyContext(c);
}

static int list(int a0, int v0, int a1, int v1, int a2, int v2)
{
    int attributes[7], made;
    OSMesaContext c;
    attributes[0] = a0, attributes[1] = v0, attributes[2] = a1, attributes[3] = v1, attributes[4] = a2, attributes[5] = v2;
    attributes[6] = 0;
    c = OSMesaCreateContextAttribs(attributes, NULL);
    made = c != NULL;
    OSMesaDestroyContext(c);
    return made;
}

static void lists(void)
{
    int full[] = {OSMESA_FORMAT, OSMESA_BGRA, OSMESA_DEPTH_BITS, 24, OSMESA_STENCIL_BITS, 8, OSMESA_ACCUM_BITS, 16,
                  OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, 2, OSMESA_CONTEXT_MINOR_VERSION, 1, 0};
    int none[] = {0};
    OSMesaContext c = OSMesaCreateContextAttribs(full, NULL);
    CHECK(c != NULL);
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, 64, 64);
    CHECK_EQUAL(osmesa(OSMESA_FORMAT), OSMESA_BGRA);
    CHECK_EQUAL(integer(GL_DEPTH_BITS), 24);
    CHECK_EQUAL(integer(GL_STENCIL_BITS), 8);
    CHECK_EQUAL(integer(GL_ACCUM_RED_BITS), 16);
    OSMesaDestroyContext(c);
    c = OSMesaCreateContextAttribs(none, NULL);
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, 64, 64);
    CHECK_EQUAL(osmesa(OSMESA_FORMAT), OSMESA_RGBA);
    CHECK_EQUAL(integer(GL_DEPTH_BITS), 0);
    CHECK_EQUAL(integer(GL_STENCIL_BITS), 0);
    CHECK_EQUAL(integer(GL_ACCUM_RED_BITS), 0);
    OSMesaDestroyContext(c);
    CHECK(list(OSMESA_CONTEXT_MAJOR_VERSION, 1, OSMESA_CONTEXT_MINOR_VERSION, 4, 0, 0));
    CHECK(list(OSMESA_CONTEXT_MAJOR_VERSION, 2, OSMESA_CONTEXT_MINOR_VERSION, 1, OSMESA_PROFILE, OSMESA_CORE_PROFILE));
    CHECK(!list(OSMESA_CONTEXT_MAJOR_VERSION, 2, OSMESA_CONTEXT_MINOR_VERSION, 2, 0, 0));
    CHECK(!list(OSMESA_CONTEXT_MAJOR_VERSION, 3, 0, 0, 0, 0));
    CHECK(!list(OSMESA_CONTEXT_MAJOR_VERSION, 0, 0, 0, 0, 0));
    CHECK(!list(OSMESA_CONTEXT_MAJOR_VERSION, -1, 0, 0, 0, 0));
    CHECK(!list(OSMESA_CONTEXT_MINOR_VERSION, -1, 0, 0, 0, 0));
    CHECK(!list(OSMESA_PROFILE, 7, 0, 0, 0, 0));
    CHECK(!list(OSMESA_FORMAT, 0x999, 0, 0, 0, 0));
    CHECK(!list(OSMESA_DEPTH_BITS, -1, 0, 0, 0, 0));
    CHECK(!list(OSMESA_STENCIL_BITS, -1, 0, 0, 0, 0));
    CHECK(!list(OSMESA_ACCUM_BITS, -1, 0, 0, 0, 0));
    CHECK(!list(OSMESA_WIDTH, 64, 0, 0, 0, 0));
    CHECK(!list(0x999, 1, 0, 0, 0, 0));
}

static void queries(void)
{
    OSMesaContext c = OSMesaCreateContext(OSMESA_RGBA, NULL);
    GLint w = -1, h = -1, f = -1;
    void *p = &w;
    CHECK_EQUAL(OSMesaGetColorBuffer(c, &w, &h, &f, &p), GL_FALSE);
    CHECK(w == 0 && h == 0 && f == 0 && p == NULL);
    CHECK_EQUAL(osmesa(OSMESA_WIDTH), -12345); /* without a context nothing is written */
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, 64, 32);
    CHECK_EQUAL(osmesa(OSMESA_WIDTH), 64);
    CHECK_EQUAL(osmesa(OSMESA_HEIGHT), 32);
    CHECK_EQUAL(osmesa(OSMESA_TYPE), GL_UNSIGNED_BYTE);
    CHECK_EQUAL(osmesa(OSMESA_ROW_LENGTH), 0);
    CHECK_EQUAL(osmesa(OSMESA_Y_UP), 1);
    CHECK_EQUAL(osmesa(OSMESA_MAX_WIDTH), 16384);
    CHECK_EQUAL(osmesa(OSMESA_MAX_HEIGHT), 16384);
    CHECK_EQUAL(osmesa(0x999), -12345);
    OSMesaPixelStore(0x999, 1);
    CHECK_EQUAL(glGetError(), 0);
    CHECK_EQUAL(OSMesaGetColorBuffer(c, &w, &h, &f, &p), GL_TRUE);
    CHECK(w == 64 && h == 32 && f == OSMESA_RGBA && p == a);
    CHECK_EQUAL(OSMesaGetColorBuffer(c, NULL, NULL, NULL, NULL), GL_TRUE);
    CHECK_EQUAL(OSMesaGetColorBuffer(NULL, &w, &h, &f, &p), GL_FALSE);
    OSMesaColorClamp(GL_TRUE);
    OSMesaPostprocess(c, "pp_jimenezmlaa", 8);
    CHECK_EQUAL(integer(GL_DOUBLEBUFFER), 0);
    CHECK_EQUAL(integer(GL_DRAW_BUFFER), GL_FRONT);
    CHECK_EQUAL(glGetError(), 0);
    OSMesaDestroyContext(c);
}

static void addresses(void)
{
    static const char *known[] = {"glBegin", "glDrawRangeElements", "glActiveTextureARB", "glBindFramebufferEXT", "glBlitFramebuffer",
                                  "glLockArraysEXT", "OSMesaMakeCurrent", "OSMesaPostprocess", "OSMesaGetProcAddress"};
    static const char *unknown[] = {"", "gl", "glBegi", "glBeginX", "glDispatchCompute", "OSMesaFoo", "main", "malloc"};
    size_t i;
    for (i = 0; i < sizeof known / sizeof *known; i++)
        CHECK(OSMesaGetProcAddress(known[i]) != NULL);
    for (i = 0; i < sizeof unknown / sizeof *unknown; i++)
        CHECK(OSMesaGetProcAddress(unknown[i]) == NULL);
    CHECK(OSMesaGetProcAddress(NULL) == NULL);
    CHECK(OSMesaGetProcAddress("glClear") == (OSMESAproc)glClear);
    CHECK(OSMesaGetProcAddress("OSMesaMakeCurrent") == (OSMESAproc)OSMesaMakeCurrent);
}

int main(void)
{
    bits(0, 0, 0, 0, 0, 0);
    bits(16, 0, 0, 16, 0, 0);
    bits(24, 0, 0, 24, 0, 0);
    bits(32, 0, 0, 24, 0, 0);
    bits(24, 8, 0, 24, 8, 0);
    bits(16, 8, 0, 24, 8, 0);
    bits(0, 8, 0, 0, 8, 0);
    bits(24, 1, 1, 24, 8, 16);
    bits(64, 64, 64, 24, 8, 16);
    CHECK(OSMesaCreateContextExt(OSMESA_RGBA, -1, 0, 0, NULL) == NULL);
    CHECK(OSMesaCreateContextExt(OSMESA_RGBA, 0, -1, 0, NULL) == NULL);
    CHECK(OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, -1, NULL) == NULL);
    depth(24, 8, 4, 0x7f400000);
    depth(24, 0, 4, 0x00400000);
    depth(16, 0, 2, 0x4000);
    depth(0, 8, 0, 0);
    depth(0, 0, 0, 0);
    lists();
    queries();
    addresses();
    return failures;
}
