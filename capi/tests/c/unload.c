/* Loaded at run time, as GLFW and PyOpenGL do, used by a thread that goes on after the handle was closed. */
#include "check.h"
#include <dlfcn.h>

typedef OSMesaContext (*Create)(GLenum, OSMesaContext);
typedef GLboolean (*MakeCurrent)(OSMesaContext, void *, GLenum, GLsizei, GLsizei);
typedef OSMESAproc (*Address)(const char *);
typedef void (*Destroy)(OSMesaContext);

int main(void)
{
    static unsigned char a[256 * 256 * 4];
    int round;
    for (round = 0; round < 3; round++) {
        void *library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
        Address address;
        OSMesaContext c;
        CHECK(library != NULL);
        if (library == NULL)
            return failures;
        address = (Address)dlsym(library, "OSMesaGetProcAddress");
        c = ((Create)dlsym(library, "OSMesaCreateContext"))(OSMESA_RGBA, NULL);
        CHECK_EQUAL(((MakeCurrent)dlsym(library, "OSMesaMakeCurrent"))(c, a, GL_UNSIGNED_BYTE, 256, 256), GL_TRUE);
        memset(a, 0, sizeof a);
        ((void (*)(GLfloat, GLfloat, GLfloat, GLfloat))address("glRectf"))(-1, -1, 1, 1);
        ((void (*)(void))address("glFinish"))();
        CHECK_EQUAL(a[sizeof a - 1], 255);
        if (round > 0)
            ((Destroy)dlsym(library, "OSMesaDestroyContext"))(c);
        dlclose(library);
    }
    return failures;
}
