/* How arguments are converted and checked. */
#include "check.h"

static unsigned char a[16 * 16 * 4];
static GLfloat got[16];

static int color_is(float r, float g, float b, float alpha)
{
    glGetFloatv(GL_CURRENT_COLOR, got);
    return got[0] == r && got[1] == g && got[2] == b && got[3] == alpha;
}

static int near(float x, float y)
{
    return x - y < 1e-6f && y - x < 1e-6f;
}

static void conversions(void)
{
    static const GLubyte ub[] = {255, 0, 51, 204};
    static const GLdouble d[] = {0.5, 0.25, 2.0, 1.0};
    static const GLshort s[] = {1, 2, 3, 4};
    GLint i[4];
    glColor3ub(255, 0, 51);
    CHECK(color_is(1, 0, 0.2f, 1));
    glColor4ubv(ub);
    CHECK(color_is(1, 0, 0.2f, 0.8f));
    glColor3dv(d);
    CHECK(color_is(0.5f, 0.25f, 2, 1));
    glColor3b(127, -128, 0);
    CHECK(color_is(1, -1, 1 / 255.0f, 1));
    glColor4us(65535, 0, 13107, 0);
    CHECK(color_is(1, 0, 0.2f, 0));
    glColor3ui(0xffffffffu, 0, 0);
    CHECK(color_is(1, 0, 0, 1));
    glColor3i(0x7fffffff, (GLint)0x80000000, 0);
    CHECK(color_is(1, -1, 0, 1) || near(got[2], 0));
    glNormal3b(127, -128, 0);
    glGetFloatv(GL_CURRENT_NORMAL, got);
    CHECK(got[0] == 1 && got[1] == -1);
    glTexCoord2sv(s);
    glGetFloatv(GL_CURRENT_TEXTURE_COORDS, got);
    CHECK(got[0] == 1 && got[1] == 2 && got[2] == 0 && got[3] == 1);
    glTexCoord1d(7);
    glGetFloatv(GL_CURRENT_TEXTURE_COORDS, got);
    CHECK(got[0] == 7 && got[1] == 0 && got[2] == 0 && got[3] == 1);
    glIndexub(9);
    CHECK_EQUAL(integer(GL_CURRENT_INDEX), 9);
    glColor4f(1, 0, -1, 0.5f);
    glGetIntegerv(GL_CURRENT_COLOR, i);
    CHECK_EQUAL(i[0], 0x7fffffff);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    CHECK_EQUAL(integer(GL_FOG_MODE), GL_LINEAR);
    CHECK_EQUAL(glGetError(), 0);
}

static void vectors(void)
{
    static const GLint most[] = {0x7fffffff, 0, 0, 0x7fffffff};
    static const GLfloat position[] = {1, 2, 3, 1};
    GLdouble plane[4] = {1, 2, 3, 4};
    GLfloat matrix[16];
    int i;
    glFogiv(GL_FOG_COLOR, most);
    glGetFloatv(GL_FOG_COLOR, got);
    CHECK(got[0] == 1 && near(got[1], 0) && got[3] == 1);
    glLightfv(GL_LIGHT1, GL_POSITION, position);
    glGetLightfv(GL_LIGHT1, GL_POSITION, got);
    CHECK(got[0] == 1 && got[2] == 3);
    glMaterialiv(GL_FRONT, GL_DIFFUSE, most);
    glGetMaterialfv(GL_FRONT, GL_DIFFUSE, got);
    CHECK(got[0] == 1);
    glClipPlane(GL_CLIP_PLANE0, plane);
    plane[3] = 0;
    glGetClipPlane(GL_CLIP_PLANE0, plane);
    CHECK(plane[3] == 4);
    for (i = 0; i < 16; i++)
        matrix[i] = (float)i;
    glLoadMatrixf(matrix);
    glGetFloatv(GL_MODELVIEW_MATRIX, got);
    CHECK(memcmp(matrix, got, sizeof matrix) == 0);
    glLoadTransposeMatrixf(matrix);
    glGetFloatv(GL_MODELVIEW_MATRIX, got);
    CHECK(got[1] == 4);
    glLoadIdentity();
    CHECK_EQUAL(glGetError(), 0);
}

static void nulls(void)
{
    glColor3fv(NULL);
    CHECK_EQUAL(glGetError(), GL_INVALID_VALUE);
    glLightfv(GL_LIGHT0, GL_POSITION, NULL);
    CHECK_EQUAL(glGetError(), GL_INVALID_VALUE);
    glLightfv(GL_LIGHT0, 0x1234, NULL);
    CHECK_EQUAL(glGetError(), GL_INVALID_ENUM);
    glLoadMatrixd(NULL);
    CHECK_EQUAL(glGetError(), GL_INVALID_VALUE);
    glGetFloatv(GL_CURRENT_COLOR, NULL);
    CHECK_EQUAL(glGetError(), GL_INVALID_VALUE);
    glGenTextures(3, NULL);
    CHECK_EQUAL(glGetError(), GL_INVALID_VALUE);
    glCallLists(3, GL_BYTE, NULL);
    CHECK_EQUAL(glGetError(), GL_INVALID_VALUE);
    glPolygonStipple(NULL);
    CHECK_EQUAL(glGetError(), GL_INVALID_VALUE);
}

static void scalars_of_vectors(void)
{
    glLightf(GL_LIGHT0, GL_POSITION, 1);
    CHECK_EQUAL(glGetError(), GL_INVALID_ENUM);
    glMaterialf(GL_FRONT, GL_DIFFUSE, 1);
    CHECK_EQUAL(glGetError(), GL_INVALID_ENUM);
    glFogf(GL_FOG_COLOR, 1);
    CHECK_EQUAL(glGetError(), GL_INVALID_ENUM);
    glTexGeni(GL_S, GL_OBJECT_PLANE, 1);
    CHECK_EQUAL(glGetError(), GL_INVALID_ENUM);
}

static void first_error_stays(void)
{
    glEnable(0xdead);
    glCallLists(-1, GL_BYTE, a);
    CHECK_EQUAL(glGetError(), GL_INVALID_ENUM);
    CHECK_EQUAL(glGetError(), 0);
    glCallLists(1, 0xdead, a);
    CHECK_EQUAL(glGetError(), GL_INVALID_ENUM);
    glBegin(GL_POINTS);
    glDisable(GL_BLEND);
    glEnd();
    CHECK_EQUAL(glGetError(), GL_INVALID_OPERATION);
}

static void lists_of_every_type(void)
{
    static const GLubyte bytes[] = {1, 2}, pairs[] = {0, 1, 0, 2}, triples[] = {0, 0, 1}, quads[] = {0, 0, 0, 2};
    static const GLfloat floats[] = {1.5f, 2};
    static const GLshort shorts[] = {-9, -8};
    glNewList(1, GL_COMPILE);
    glTranslatef(1, 0, 0);
    glEndList();
    glNewList(2, GL_COMPILE);
    glTranslatef(0, 1, 0);
    glEndList();
    glListBase(0);
    glCallLists(2, GL_UNSIGNED_BYTE, bytes);
    glCallLists(2, GL_2_BYTES, pairs);
    glCallLists(1, GL_3_BYTES, triples);
    glCallLists(1, GL_4_BYTES, quads);
    glCallLists(2, GL_FLOAT, floats);
    glListBase(10);
    glCallLists(2, GL_SHORT, shorts);
    glGetFloatv(GL_MODELVIEW_MATRIX, got);
    CHECK(got[12] == 5 && got[13] == 5);
    CHECK_EQUAL(glGetError(), 0);
}

int main(void)
{
    OSMesaContext c = OSMesaCreateContext(OSMESA_RGBA, NULL);
    OSMesaMakeCurrent(c, a, GL_UNSIGNED_BYTE, 16, 16);
    conversions();
    vectors();
    nulls();
    scalars_of_vectors();
    first_error_stays();
    lists_of_every_type();
    /* not built: an error, no crash */
    CHECK_EQUAL(glCreateShader(GL_VERTEX_SHADER), 0);
    CHECK_EQUAL(glGetError(), GL_INVALID_OPERATION);
    OSMesaDestroyContext(c);
    return failures;
}
