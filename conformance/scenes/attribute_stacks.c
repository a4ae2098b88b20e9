/* Proves: each attribute group is saved and restored by glPushAttrib, and client groups by glPushClientAttrib. */
#include "../scene.h"


static void show_some(const char *when)
{
    static const struct { GLenum name; int count; const char *label; } list[] = {{GL_CURRENT_COLOR, 4, "color"}, {GL_LINE_WIDTH, 1, "line width"}, {GL_POINT_SIZE, 1, "point size"},
        {GL_POLYGON_MODE, 2, "polygon mode"}, {GL_SHADE_MODEL, 1, "shade model"}, {GL_FOG_DENSITY, 1, "fog density"}, {GL_DEPTH_FUNC, 1, "depth func"}, {GL_STENCIL_REF, 1, "stencil ref"},
        {GL_VIEWPORT, 4, "viewport"}, {GL_MATRIX_MODE, 1, "matrix mode"}, {GL_BLEND_SRC, 1, "blend"}, {GL_ALPHA_TEST_REF, 1, "alpha"}, {GL_LIST_BASE, 1, "list base"},
        {GL_SCISSOR_BOX, 4, "scissor"}, {GL_ZOOM_X, 1, "zoom"}, {GL_FOG_HINT, 1, "hint"}, {GL_LIGHT_MODEL_TWO_SIDE, 1, "two side"}, {GL_COLOR_CLEAR_VALUE, 4, "clear color"},
        {GL_TEXTURE_BINDING_2D, 1, "texture"}, {GL_MAP1_GRID_SEGMENTS, 1, "grid"}, {GL_ACCUM_CLEAR_VALUE, 4, "accum clear"}, {GL_UNPACK_ROW_LENGTH, 1, "row length"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        GLfloat v[4] = {0};
        glGetFloatv(list[i].name, v);
        text("%s %s: %.4g %.4g %.4g %.4g", when, list[i].label, v[0], v[1], v[2], v[3]);
    }
    text("%s: blend %d fog %d lighting %d vertex array %d", when, glIsEnabled(GL_BLEND), glIsEnabled(GL_FOG), glIsEnabled(GL_LIGHTING), glIsEnabled(GL_VERTEX_ARRAY));
}

static void set(int on)
{
    (on ? glEnable : glDisable)(GL_BLEND), (on ? glEnable : glDisable)(GL_FOG), (on ? glEnable : glDisable)(GL_LIGHTING);
    (on ? glEnableClientState : glDisableClientState)(GL_VERTEX_ARRAY);
    glColor4f(on ? 0.2f : 1, on ? 0.4f : 1, on ? 0.6f : 1, on ? 0.8f : 1), glLineWidth(on ? 3 : 1), glPointSize(on ? 4 : 1);
    glPolygonMode(GL_FRONT, on ? GL_LINE : GL_FILL), glShadeModel(on ? GL_FLAT : GL_SMOOTH), glFogf(GL_FOG_DENSITY, on ? 0.3f : 1);
    glDepthFunc(on ? GL_GREATER : GL_LESS), glStencilFunc(on ? GL_LESS : GL_ALWAYS, on ? 7 : 0, 3), glViewport(on, 2 * on, 64 - 30 * on, 64);
    glMatrixMode(on ? GL_TEXTURE : GL_MODELVIEW), glBlendFunc(on ? GL_DST_COLOR : GL_ONE, on ? GL_ONE : GL_ZERO), glAlphaFunc(GL_LESS, on ? 0.25f : 0);
    glListBase(on ? 12 : 0), glScissor(3 * on, 4 * on, 64, 64), glPixelZoom(1 + (GLfloat)on, 1 + 2 * (GLfloat)on), glHint(GL_FOG_HINT, on ? GL_NICEST : GL_DONT_CARE);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, on), glClearColor(0.1f, 0.2f, 0.3f, on ? 0.4f : 1), glBindTexture(GL_TEXTURE_2D, on ? 3 : 0), glMapGrid1f(on ? 7 : 1, 0, 1);
    glClearAccum(0.1f, 0.2f, 0.3f, on ? 0.4f : 0), glPixelStorei(GL_UNPACK_ROW_LENGTH, on ? 5 : 0);
}

SCENE(attribute_stacks, EXACT, 64, 64, TEXT_ONLY, "attribute stacks: every group saved and restored")
{
    static const GLbitfield groups[] = {GL_CURRENT_BIT, GL_POINT_BIT, GL_LINE_BIT, GL_POLYGON_BIT, GL_LIGHTING_BIT, GL_FOG_BIT, GL_DEPTH_BUFFER_BIT, GL_ACCUM_BUFFER_BIT, GL_STENCIL_BUFFER_BIT,
        GL_VIEWPORT_BIT, GL_TRANSFORM_BIT, GL_ENABLE_BIT, GL_COLOR_BUFFER_BIT, GL_HINT_BIT, GL_EVAL_BIT, GL_LIST_BIT, GL_TEXTURE_BIT, GL_SCISSOR_BIT, GL_PIXEL_MODE_BIT, GL_ALL_ATTRIB_BITS};
    UNUSED_SIZE;
    for (size_t g = 0; g < sizeof groups / sizeof *groups; g++) {
        char when[32];
        set(0);
        glPushClientAttrib(g & 1 ? GL_CLIENT_ALL_ATTRIB_BITS : GL_CLIENT_PIXEL_STORE_BIT);
        glPushAttrib(groups[g]);
        set(1);
        glPopAttrib();
        snprintf(when, sizeof when, "%05x", groups[g]);
        show_some(when);
        glPopClientAttrib();
        snprintf(when, sizeof when, "%05x client", groups[g]);
        show_some(when);
    }
    set(0);
    for (int i = 0; i < 20; i++) glPushAttrib(GL_LINE_BIT);
    text_error("twenty pushes");
    GLint depth;
    glGetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
    text("depth %d", depth);
    for (int i = 0; i < 20; i++) glPopAttrib();
    text_error("twenty pops");
}
