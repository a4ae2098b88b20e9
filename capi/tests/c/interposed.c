/* Another glClear in the process, found before ours by the dynamic linker, is never called by the library nor handed out. */
#include "check.h"

static int called;

void glClear(GLbitfield mask)
{
    called += mask != 0;
}

int main(void)
{
    unsigned char a[4 * 4 * 4];
    void (*own)(GLbitfield) = (void (*)(GLbitfield))OSMesaGetProcAddress("glClear");
    OSMesaContext c = OSMesaCreateContext(OSMESA_RGBA, NULL);
    GLuint list;
    CHECK(own != glClear);
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, 4, 4);
    glClearColor(1, 1, 1, 1);
    list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    own(GL_COLOR_BUFFER_BIT);
    glEndList();
    glCallList(list);
    glFinish();
    CHECK_EQUAL(a[0], 255);
    CHECK_EQUAL(called, 0);
    OSMesaDestroyContext(c);
    return failures;
}
