/* When the program's memory is written, and what a binding keeps. */
#include "check.h"

#define N 32
static unsigned char a[N * N * 4], b[N * N * 4];

static int pixel(void)
{
    unsigned char p[4] = {1, 2, 3, 4};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p);
    return p[0];
}

static void writes(OSMesaContext c, OSMesaContext other)
{
    memset(a, 0x11, sizeof a);
    memset(b, 0x22, sizeof b);
    CHECK_EQUAL(OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, N, N), GL_TRUE);
    CHECK_EQUAL(a[0], 0x11);
    clear(1, 0, 0, 1);
    CHECK_EQUAL(a[0], 0x11); /* drawn, not flushed */
    CHECK_EQUAL(pixel(), 255);
    CHECK_EQUAL(a[0], 0x11); /* a read does not write */
    glFlush();
    CHECK_EQUAL(a[0], 0xff);
    clear(0, 0, 0, 1);
    glFinish();
    CHECK_EQUAL(a[0], 0);
    memset(a, 0x11, sizeof a);
    glFinish();
    CHECK_EQUAL(a[0], 0x11); /* nothing was drawn since: the program's own changes stay */
    clear(1, 0, 0, 1);
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    CHECK_EQUAL(a[0], 0xff); /* leaving writes */
    CHECK(OSMesaGetCurrentContext() == NULL);
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, N, N);
    clear(0, 0, 0, 1);
    CHECK_EQUAL(OSMesaMakeCurrent(other, b, GL_UNSIGNED_BYTE, N, N), GL_TRUE);
    CHECK_EQUAL(a[0], 0); /* so does another context */
    CHECK_EQUAL(b[0], 0x22);
    memset(a, 0x11, sizeof a);
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, N, N);
    clear(1, 0, 0, 1);
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, N, N);
    CHECK_EQUAL(a[0], 0x11); /* the same binding again does not */
    glBegin(GL_POINTS);
    glFlush();
    glEnd();
    CHECK_EQUAL(glGetError(), GL_INVALID_OPERATION);
}

static void keeps(OSMesaContext c)
{
    GLint viewport[4], scissor[4];
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, N, N);
    clear(1, 0, 0, 1);
    glFinish();
    CHECK_EQUAL(OSMesaMakeCurrent(c, b, GL_UNSIGNED_BYTE, N, N), GL_TRUE);
    CHECK_EQUAL(pixel(), 255); /* another buffer of the same size: the picture stays */
    glClearColor(0.5f, 0.5f, 0.5f, 1);
    CHECK_EQUAL(OSMesaMakeCurrent(c, b, GL_UNSIGNED_BYTE, N / 2, N / 2), GL_TRUE);
    CHECK_EQUAL(osmesa(OSMESA_WIDTH), N / 2);
    CHECK_EQUAL(osmesa(OSMESA_HEIGHT), N / 2);
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_SCISSOR_BOX, scissor);
    CHECK_EQUAL(viewport[2], N); /* viewport and scissor are state, set by the first binding only */
    CHECK_EQUAL(scissor[3], N);
    memset(b, 0x22, sizeof b);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    CHECK_EQUAL(b[0], 128); /* the clear colour was kept */
    CHECK_EQUAL(b[N / 2 * N / 2 * 4 - 4], 128);
    CHECK_EQUAL(b[N / 2 * N / 2 * 4], 0x22);
    /* another type */
    CHECK_EQUAL(OSMesaMakeCurrent(c, a, GL_FLOAT, N / 4, N / 4), GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    CHECK(((float *)a)[0] == 0.5f);
    CHECK_EQUAL(integer(GL_RED_BITS), 32);
}

static void refuses(OSMesaContext c)
{
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, N, N);
    CHECK_EQUAL(OSMesaMakeCurrent(c, NULL, GL_UNSIGNED_BYTE, N, N), GL_FALSE);
    CHECK_EQUAL(OSMesaMakeCurrent(c, NULL, GL_UNSIGNED_BYTE, 0, 0), GL_FALSE);
    CHECK_EQUAL(OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, 0, N), GL_FALSE);
    CHECK_EQUAL(OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, N, -1), GL_FALSE);
    CHECK_EQUAL(OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, osmesa(OSMESA_MAX_WIDTH) + 1, 1), GL_FALSE);
    CHECK_EQUAL(OSMesaMakeCurrent(c, a, GL_SHORT, N, N), GL_FALSE);
    CHECK_EQUAL(OSMesaMakeCurrent(NULL, a, GL_UNSIGNED_BYTE, N, N), GL_FALSE);
    CHECK(OSMesaGetCurrentContext() == c); /* a failure changes nothing */
    CHECK_EQUAL(osmesa(OSMESA_WIDTH), N);
}

static void ends(void)
{
    OSMesaContext c = OSMesaCreateContext(OSMESA_RGBA, NULL);
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, N, N);
    memset(a, 0x11, sizeof a);
    clear(1, 0, 0, 1);
    OSMesaDestroyContext(c);
    CHECK_EQUAL(a[0], 0x11); /* the buffer may be gone by now: it is not written */
    CHECK(OSMesaGetCurrentContext() == NULL);
    glClear(GL_COLOR_BUFFER_BIT); /* without a context nothing happens */
    CHECK_EQUAL(glGetError(), 0);
    CHECK(glGetString(GL_VERSION) == NULL);
    /* what was destroyed is no context any more */
    OSMesaDestroyContext(c);
    CHECK_EQUAL(OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, N, N), GL_FALSE);
    CHECK(OSMesaCreateContext(OSMESA_RGBA, c) == NULL);
    OSMesaDestroyContext(NULL);
}

int main(void)
{
    OSMesaContext c = OSMesaCreateContext(OSMESA_RGBA, NULL), other = OSMesaCreateContext(OSMESA_RGBA, NULL);
    writes(c, other);
    keeps(c);
    refuses(c);
    OSMesaDestroyContext(c);
    OSMesaDestroyContext(other);
    ends();
    return failures;
}
