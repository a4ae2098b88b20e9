/* Each thread has its own current context; a context goes from thread to thread. */
#include "check.h"
#include <pthread.h>

#define N 16
#define ROUNDS 200

static void *own(void *argument)
{
    long number = (long)argument;
    unsigned char *buffer = malloc(N * N * 4);
    OSMesaContext c = OSMesaCreateContext(OSMESA_RGBA, NULL);
    long bad = 0;
    int i;
    if (OSMesaGetCurrentContext() != NULL || !OSMesaMakeCurrent(c, buffer, GL_UNSIGNED_BYTE, N, N))
        bad++;
    for (i = 0; i < ROUNDS; i++) {
        int value = (int)(number * 31 + i) & 255;
        clear(value / 255.0f, 0, 0, 1);
        glFinish();
        if (buffer[0] != value || OSMesaGetCurrentContext() != c)
            bad++;
    }
    OSMesaDestroyContext(c);
    free(buffer);
    return (void *)bad;
}

static OSMesaContext travelling;
static unsigned char a[N * N * 4], b[N * N * 4];

static void *take(void *leave)
{
    long bad = 0;
    if (!OSMesaMakeCurrent(travelling, b, GL_UNSIGNED_BYTE, N, N))
        bad++;
    clear(0, 1, 0, 1);
    glFinish();
    if (b[1] != 255)
        bad++;
    if (leave)
        OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    return (void *)bad;
}

static long in_a_thread(void *(*function)(void *), void *argument)
{
    pthread_t thread;
    void *bad;
    pthread_create(&thread, NULL, function, argument);
    pthread_join(thread, &bad);
    return (long)bad;
}

int main(void)
{
    pthread_t threads[7];
    long i;
    for (i = 0; i < 7; i++)
        pthread_create(&threads[i], NULL, own, (void *)i);
    for (i = 0; i < 7; i++) {
        void *bad;
        pthread_join(threads[i], &bad);
        CHECK_EQUAL((long)bad, 0);
    }
    travelling = OSMesaCreateContext(OSMESA_RGBA, NULL);
    OSMesaMakeCurrent(travelling, a, GL_UNSIGNED_BYTE, N, N);
    clear(1, 0, 0, 1);
    glFinish();
    /* the other thread takes it, and this one's commands do nothing then */
    CHECK_EQUAL(in_a_thread(take, NULL), 0);
    clear(0, 0, 1, 1);
    glFinish();
    CHECK_EQUAL(b[2], 0);
    CHECK(OSMesaGetCurrentContext() == NULL);
    /* that thread has ended without letting go: it is free */
    CHECK_EQUAL(OSMesaMakeCurrent(travelling, a, GL_UNSIGNED_BYTE, N, N), GL_TRUE);
    clear(0, 0, 1, 1);
    glFinish();
    CHECK_EQUAL(a[2], 255);
    CHECK_EQUAL(in_a_thread(take, &travelling), 0);
    OSMesaDestroyContext(travelling);
    return failures;
}
