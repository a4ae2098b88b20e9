/* Contexts of one share group see each other's lists and textures; others do not. */
#include "check.h"

#define N 16
static unsigned char a[N * N * 4];

int main(void)
{
    OSMesaContext first = OSMesaCreateContext(OSMESA_RGBA, NULL), second = OSMesaCreateContext(OSMESA_RGBA, first);
    OSMesaContext stranger = OSMesaCreateContext(OSMESA_RGBA, NULL);
    static const unsigned char red[] = {255, 0, 0, 255};
    unsigned char back[4] = {0};
    GLuint list, texture = 0;

    OSMesaMakeCurrent(first, a, GL_UNSIGNED_BYTE, N, N);
    list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEndList();
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, red);
    CHECK_EQUAL(glGetError(), 0);

    OSMesaMakeCurrent(stranger, a, GL_UNSIGNED_BYTE, N, N);
    CHECK(!glIsList(list));
    CHECK(!glIsTexture(texture));

    /* what is shared outlives the context that made it */
    OSMesaDestroyContext(first);
    OSMesaMakeCurrent(second, a, GL_UNSIGNED_BYTE, N, N);
    CHECK(glIsList(list));
    CHECK(glIsTexture(texture));
    clear(0, 0, 0, 0);
    glCallList(list);
    glFinish();
    CHECK_EQUAL(a[1], 255);
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, back);
    CHECK_EQUAL(back[0], 255);
    CHECK_EQUAL(back[1], 0);
    CHECK_EQUAL(glGetError(), 0);
    OSMesaDestroyContext(second);
    OSMesaDestroyContext(stranger);
    return failures;
}
