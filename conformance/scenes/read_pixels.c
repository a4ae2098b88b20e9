/* Proves: glReadPixels in every format and type that a C program asks for. */
#include "../scene.h"


SCENE(read_pixels, EXACT, 64, 64, 0, "glReadPixels in all formats and types, as text")
{
    static const struct { GLenum value; const char *name; } formats[] = {{GL_RED, "RED"}, {GL_GREEN, "GREEN"}, {GL_BLUE, "BLUE"}, {GL_ALPHA, "ALPHA"}, {GL_RGB, "RGB"}, {GL_RGBA, "RGBA"},
        {GL_BGR, "BGR"}, {GL_BGRA, "BGRA"}, {GL_LUMINANCE, "LUMINANCE"}, {GL_LUMINANCE_ALPHA, "LUMINANCE_ALPHA"}, {GL_DEPTH_COMPONENT, "DEPTH"}, {GL_STENCIL_INDEX, "STENCIL"}};
    static const struct { GLenum value; const char *name; } types[] = {{GL_UNSIGNED_BYTE, "ub"}, {GL_BYTE, "b"}, {GL_UNSIGNED_SHORT, "us"}, {GL_SHORT, "s"}, {GL_UNSIGNED_INT, "ui"}, {GL_INT, "i"}, {GL_FLOAT, "f"}};
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    glBegin(GL_TRIANGLES);
    glColor4f(1, 0.2f, 0.1f, 0.5f), glVertex3f(0, 0, -0.7f), glColor4f(0.3f, 0.9f, 0.2f, 0.8f), glVertex3f(64, 0, 0.3f), glColor4f(0.2f, 0.4f, 1, 1), glVertex3f(30, 64, 0.6f);
    glEnd();
    for (int f = 0; f < 12; f++)
        for (int t = 0; t < 7; t++) {
            union { GLubyte ub[64]; GLbyte b[64]; GLushort us[32]; GLshort s[32]; GLuint ui[16]; GLint i[16]; GLfloat f[16]; } p;
            char line[512];
            int integer = types[t].value == GL_UNSIGNED_INT || types[t].value == GL_INT;
            if (integer && (formats[f].value == GL_LUMINANCE || formats[f].value == GL_LUMINANCE_ALPHA)) continue; /* the reference overflows */
            if (formats[f].value == GL_DEPTH_COMPONENT && (t & 1)) continue;                                      /* the reference truncates signed depth */
            int at = snprintf(line, sizeof line, "%s %s:", formats[f].name, types[t].name);
            memset(&p, 0, sizeof p);
            glReadPixels(20, 15, 2, 1, formats[f].value, types[t].value, &p);
            for (int k = 0; k < 8; k++) {
                switch (types[t].value) {
                case GL_UNSIGNED_BYTE: at += snprintf(line + at, sizeof line - (size_t)at, " %u", p.ub[k]); break;
                case GL_BYTE: at += snprintf(line + at, sizeof line - (size_t)at, " %d", p.b[k]); break;
                case GL_UNSIGNED_SHORT: at += snprintf(line + at, sizeof line - (size_t)at, " %u", p.us[k]); break;
                case GL_SHORT: at += snprintf(line + at, sizeof line - (size_t)at, " %d", p.s[k]); break;
                case GL_UNSIGNED_INT: at += snprintf(line + at, sizeof line - (size_t)at, " %u", p.ui[k]); break;
                case GL_INT: at += snprintf(line + at, sizeof line - (size_t)at, " %d", p.i[k]); break;
                default: at += snprintf(line + at, sizeof line - (size_t)at, " %.6f", p.f[k]); break;
                }
            }
            text("%s", line);
        }
}
