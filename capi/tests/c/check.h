/* CHECK(condition): counts and names what does not hold. End main with `return failures`. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>

static int failures;
#define CHECK(condition) \
    ((condition) ? (void)0 : (void)(failures++, fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #condition)))
#define CHECK_EQUAL(got, wanted) check_equal((long)(got), (long)(wanted), #got, __FILE__, __LINE__)

static inline void check_equal(long got, long wanted, const char *what, const char *file, int line)
{
    if (got != wanted) {
        failures++;
        fprintf(stderr, "%s:%d: %s is %ld (0x%lx), not %ld (0x%lx)\n", file, line, what, got, got, wanted, wanted);
    }
}

static inline GLint integer(GLenum pname)
{
    GLint values[16] = {-12345};
    glGetIntegerv(pname, values);
    return values[0];
}

static inline GLint osmesa(GLint pname)
{
    GLint value = -12345;
    OSMesaGetIntegerv(pname, &value);
    return value;
}

static inline void clear(float r, float g, float b, float a)
{
    glClearColor(r, g, b, a);
    glClear(GL_COLOR_BUFFER_BIT);
}
