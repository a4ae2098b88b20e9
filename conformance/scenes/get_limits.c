/* Proves: limits and implementation-dependent values of GL 1.1 to 1.4, and state that later versions added, in all four types. */
#include "../scene.h"
#include <GL/glext.h>


static void show(const char *label, GLenum name, int count)
{
    GLdouble d[16] = {0};
    GLfloat f[16] = {0};
    GLint n[16] = {0};
    GLboolean b[16] = {0};
    glGetDoublev(name, d), glGetFloatv(name, f), glGetIntegerv(name, n), glGetBooleanv(name, b);
    for (int k = 0; k < count; k++) text("%s[%d] %.17g %.9g %d %d", label, k, d[k], f[k], n[k], b[k]);
    text_error(label);
}

#define N(name) show(#name, name, 1)
#define V(name, count) show(#name, name, count)

SCENE(get_limits, EXACT, 64, 64, TEXT_ONLY, "limits, and the state of 1.2 to 1.4")
{
    UNUSED_SIZE;
    N(GL_POINT_SIZE_GRANULARITY), N(GL_LINE_WIDTH_GRANULARITY), V(GL_ALIASED_POINT_SIZE_RANGE, 2), V(GL_ALIASED_LINE_WIDTH_RANGE, 2);
    N(GL_MAX_TEXTURE_UNITS), N(GL_MAX_3D_TEXTURE_SIZE), N(GL_MAX_CUBE_MAP_TEXTURE_SIZE), N(GL_MAX_TEXTURE_LOD_BIAS);
    N(GL_ACCUM_RED_BITS), N(GL_ACCUM_ALPHA_BITS), N(GL_SAMPLE_BUFFERS), N(GL_SAMPLES);
    V(GL_MODELVIEW_MATRIX, 16), V(GL_PROJECTION_MATRIX, 16), V(GL_TEXTURE_MATRIX, 16), V(GL_TRANSPOSE_MODELVIEW_MATRIX, 16);
    N(GL_STENCIL_VALUE_MASK), N(GL_STENCIL_WRITEMASK), N(GL_INDEX_WRITEMASK), V(GL_COLOR_CLEAR_VALUE, 4);
    N(GL_GENERATE_MIPMAP_HINT), N(GL_TEXTURE_COMPRESSION_HINT), N(GL_LIGHT_MODEL_COLOR_CONTROL), N(GL_RESCALE_NORMAL), N(GL_COLOR_SUM);
    N(GL_POINT_SIZE_MIN), N(GL_POINT_SIZE_MAX), N(GL_POINT_FADE_THRESHOLD_SIZE), V(GL_POINT_DISTANCE_ATTENUATION, 3);
    N(GL_FOG_COORDINATE_SOURCE), N(GL_CURRENT_FOG_COORDINATE), V(GL_CURRENT_SECONDARY_COLOR, 4), V(GL_CURRENT_RASTER_TEXTURE_COORDS, 4);
    N(GL_ACTIVE_TEXTURE), N(GL_CLIENT_ACTIVE_TEXTURE), N(GL_TEXTURE_BINDING_3D), N(GL_TEXTURE_BINDING_CUBE_MAP);
    N(GL_BLEND_SRC_RGB), N(GL_BLEND_DST_RGB), N(GL_BLEND_SRC_ALPHA), N(GL_BLEND_DST_ALPHA), N(GL_BLEND_EQUATION), V(GL_BLEND_COLOR, 4);
    N(GL_SAMPLE_COVERAGE_VALUE), N(GL_SAMPLE_COVERAGE_INVERT), N(GL_MULTISAMPLE), N(GL_SAMPLE_ALPHA_TO_COVERAGE);
    N(GL_UNPACK_SKIP_IMAGES), N(GL_UNPACK_IMAGE_HEIGHT), N(GL_PACK_SKIP_IMAGES), N(GL_PACK_IMAGE_HEIGHT);
    N(GL_FEEDBACK_BUFFER_SIZE), N(GL_FEEDBACK_BUFFER_TYPE), N(GL_SELECTION_BUFFER_SIZE);
    N(GL_VERTEX_ARRAY), N(GL_EDGE_FLAG_ARRAY_STRIDE), N(GL_INDEX_ARRAY_TYPE), N(GL_INDEX_ARRAY_STRIDE), N(GL_TEXTURE_COORD_ARRAY_STRIDE);
    for (GLenum map = GL_PIXEL_MAP_I_TO_I_SIZE; map <= GL_PIXEL_MAP_A_TO_A_SIZE; map++) show("pixel map size", map, 1);
}

SCENE(get_conversions, EXACT, 64, 64, TEXT_ONLY, "values that were set, read back in all four types")
{
    UNUSED_SIZE;
    glColor4f(0.2f, 1.5f, -0.25f, 0.5f), V(GL_CURRENT_COLOR, 4);
    glColor4ub(1, 128, 254, 255), V(GL_CURRENT_COLOR, 4);
    glColor3i(2147483647, -2147483647, 1 << 30), V(GL_CURRENT_COLOR, 4);
    glNormal3b(127, -127, 0), V(GL_CURRENT_NORMAL, 3);
    glNormal3f(0.5f, -0.5f, 3), V(GL_CURRENT_NORMAL, 3);
    glTexCoord4f(1.5f, 2.5f, -2.5f, 0.25f), V(GL_CURRENT_TEXTURE_COORDS, 4);
    glClearColor(0.3f, 0.6f, 0.9f, 1), V(GL_COLOR_CLEAR_VALUE, 4);
    glClearAccum(-1, -0.5f, 0.5f, 1), V(GL_ACCUM_CLEAR_VALUE, 4);
    glClearDepth(0.75), N(GL_DEPTH_CLEAR_VALUE);
    glDepthRange(0.25, 2), V(GL_DEPTH_RANGE, 2);
    glAlphaFunc(GL_LESS, 0.7f), N(GL_ALPHA_TEST_REF);
    glPointSize(2.5f), N(GL_POINT_SIZE);
    glLineWidth(3.49f), N(GL_LINE_WIDTH);
    glPolygonOffset(-1.5f, 2.5f), N(GL_POLYGON_OFFSET_FACTOR), N(GL_POLYGON_OFFSET_UNITS);
    glFogf(GL_FOG_DENSITY, 0.4f), N(GL_FOG_DENSITY);
    glFogi(GL_FOG_INDEX, 7), N(GL_FOG_INDEX);
    glFogiv(GL_FOG_COLOR, (const GLint[4]){2147483647, 0, -2147483647 - 1, 1 << 30}), V(GL_FOG_COLOR, 4);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (const GLfloat[4]){0.1f, 2, -3, 1}), V(GL_LIGHT_MODEL_AMBIENT, 4);
    glClearIndex(3.5f), N(GL_INDEX_CLEAR_VALUE);
    glPixelTransferf(GL_GREEN_SCALE, 1.25f), N(GL_GREEN_SCALE);
    glPixelZoom(-0.5f, 3), N(GL_ZOOM_X);
    glMapGrid1f(5, -0.5f, 2.5f), V(GL_MAP1_GRID_DOMAIN, 2);
    glMatrixMode(GL_MODELVIEW), glLoadIdentity(), glTranslatef(0.5f, 1.5f, -2.5f), V(GL_MODELVIEW_MATRIX, 16);
    glStencilMask(0x80000001u), N(GL_STENCIL_WRITEMASK);
    glLineStipple(300, 0xf0f0), N(GL_LINE_STIPPLE_REPEAT), N(GL_LINE_STIPPLE_PATTERN);
    GLint n[4];
    GLfloat f[4];
    glLightiv(GL_LIGHT2, GL_DIFFUSE, (const GLint[4]){2147483647, 0, -2147483647 - 1, 1 << 30});
    glLightiv(GL_LIGHT2, GL_POSITION, (const GLint[4]){3, -2, 1, 1});
    glLighti(GL_LIGHT2, GL_SPOT_CUTOFF, 45);
    for (GLenum p = GL_AMBIENT; p <= GL_SPOT_CUTOFF; p++) {
        memset(n, 0, sizeof n), memset(f, 0, sizeof f);
        glGetLightiv(GL_LIGHT2, p, n), glGetLightfv(GL_LIGHT2, p, f);
        text("light %x: %d %d %d %d / %g %g %g %g", p, n[0], n[1], n[2], n[3], f[0], f[1], f[2], f[3]);
    }
    glTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, (const GLint[4]){2147483647, 0, 1 << 29, 1 << 30});
    glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, n), text("environment %d %d %d %d", n[0], n[1], n[2], n[3]);
    glTexGeniv(GL_S, GL_EYE_PLANE, (const GLint[4]){1, 2, 3, 4});
    glGetTexGenfv(GL_S, GL_EYE_PLANE, f), text("eye plane %g %g %g %g", f[0], f[1], f[2], f[3]);
    glClipPlane(GL_CLIP_PLANE1, (const GLdouble[4]){1, 2, 3, 4});
    GLdouble plane[4];
    glGetClipPlane(GL_CLIP_PLANE1, plane), text("clip plane %g %g %g %g", plane[0], plane[1], plane[2], plane[3]);
}
