/* GLFW's OSMesa path: a window whose context is GLFW_OSMESA_CONTEXT_API.
 *
 * Proves that GLFW accepts the library (it refuses one that lacks any of seven OSMesa functions), makes a context
 * current, resizes it with the window, and gets pixels back through glfwGetOSMesaColorBuffer.
 *
 *     cc glfw_osmesa.c -lglfw -o glfw_osmesa
 *     LD_LIBRARY_PATH=<folder of Tepui's libOSMesa.so.8> xvfb-run -a ./glfw_osmesa out.ppm
 *
 * gl* functions come from glfwGetProcAddress alone: the program links no GL.
 */
#define GLFW_EXPOSE_NATIVE_OSMESA
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>
#include <GL/gl.h>
#include <stdio.h>
#include <stdlib.h>

#define FUNCTIONS(X) \
    X(const GLubyte *, GetString, (GLenum)) X(void, ClearColor, (GLfloat, GLfloat, GLfloat, GLfloat)) X(void, Clear, (GLbitfield)) \
    X(void, Viewport, (GLint, GLint, GLsizei, GLsizei)) X(void, Begin, (GLenum)) X(void, End, (void)) X(void, Color3f, (GLfloat, GLfloat, GLfloat)) \
    X(void, Vertex2f, (GLfloat, GLfloat)) X(void, Finish, (void)) X(GLenum, GetError, (void))
#define DECLARE(result, name, arguments) static result(APIENTRY *p##name) arguments;
FUNCTIONS(DECLARE)

static void fail(const char *what)
{
    const char *why = NULL;
    glfwGetError(&why);
    fprintf(stderr, "glfw_osmesa: %s: %s\n", what, why ? why : "no reason given");
    exit(1);
}

int main(int argc, char **argv)
{
    int width = 0, height = 0, format = 0, x, y;
    void *buffer = NULL;
    FILE *out;
    if (argc != 2) {
        fprintf(stderr, "usage: glfw_osmesa OUT.ppm\n");
        return 2;
    }
    if (!glfwInit()) fail("glfwInit");
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_OSMESA_CONTEXT_API);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow *window = glfwCreateWindow(320, 240, "Tepui", NULL, NULL);
    if (!window) fail("glfwCreateWindow");
    glfwMakeContextCurrent(window);
#define LOAD(result, name, arguments) \
    if (!(p##name = (result(APIENTRY *) arguments)glfwGetProcAddress("gl" #name))) fail("gl" #name);
    FUNCTIONS(LOAD)
    printf("renderer: %s | version: %s\n", pGetString(GL_RENDERER), pGetString(GL_VERSION));
    glfwGetFramebufferSize(window, &width, &height);
    pViewport(0, 0, width, height);
    pClearColor(0.2f, 0.3f, 0.4f, 1.0f);
    pClear(GL_COLOR_BUFFER_BIT);
    pBegin(GL_TRIANGLES);
    pColor3f(1, 0, 0), pVertex2f(-0.8f, -0.8f);
    pColor3f(0, 1, 0), pVertex2f(0.8f, -0.8f);
    pColor3f(0, 0, 1), pVertex2f(0.0f, 0.8f);
    pEnd();
    pFinish();
    if (pGetError() != GL_NO_ERROR) fail("a GL error");
    if (!glfwGetOSMesaColorBuffer(window, &width, &height, &format, &buffer)) fail("glfwGetOSMesaColorBuffer");
    out = fopen(argv[1], "wb");
    if (!out) fail("cannot write the image");
    fprintf(out, "P6\n%d %d\n255\n", width, height);
    for (y = height - 1; y >= 0; y--)
        for (x = 0; x < width; x++) fwrite((unsigned char *)buffer + 4 * ((size_t)y * width + x), 1, 3, out);
    fclose(out);
    glfwTerminate();
    return 0;
}
