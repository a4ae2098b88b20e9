/* Proves: every form of glColor, glNormal, glTexCoord and glVertex converts as the specification says. */
#include "../scene.h"


SCENE(current_attributes, EXACT, 256, 256, 0, "all forms of glColor and glVertex")
{
    static const GLubyte ub[] = {200, 100, 50, 255};
    static const GLshort s[] = {30000, 100, -50, 32767};
    GLfloat f[4];
    pixels(width, height);
    for (int i = 0; i < 16; i++) {
        switch (i) {
        case 0: glColor3b(127, 0, -128); break;
        case 1: glColor3s(32767, 16000, -5); break;
        case 2: glColor3i(2147483647, 1000000000, -5); break;
        case 3: glColor3ub(255, 128, 1); break;
        case 4: glColor3us(65535, 32768, 1); break;
        case 5: glColor3ui(4294967295u, 2147483648u, 1); break;
        case 6: glColor3f(0.1f, 1.7f, -0.4f); break;
        case 7: glColor3d(0.9, 0.8, 0.7); break;
        case 8: glColor4b(1, 2, 3, 127); break;
        case 9: glColor4ubv(ub); break;
        case 10: glColor4sv(s); break;
        case 11: glColor4f(0.2f, 0.4f, 0.6f, 0.5f); break;
        case 12: glColor4us(1000, 2000, 60000, 30000); break;
        case 13: glColor4ui(1u << 31, 1u << 30, 1u << 29, 0); break;
        case 14: glColor4d(1, 1, 0.5, 0.25); break;
        default: glColor4i(1 << 30, 1 << 29, 1 << 28, 2147483647); break;
        }
        glGetFloatv(GL_CURRENT_COLOR, f);
        text("color %d: %.6f %.6f %.6f %.6f", i, f[0], f[1], f[2], f[3]);
        GLfloat x = (GLfloat)(i % 4) * 64, y = (GLfloat)(i / 4) * 64;
        glBegin(GL_TRIANGLES);
        if (i & 1) glVertex2s((GLshort)(x + 3), (GLshort)(y + 3)), glVertex3i((GLint)x + 60, (GLint)y + 6, 0), glVertex4d(2 * x + 50, 2 * y + 120, 0, 2);
        else glVertex2d(x + 3.25, y + 3.75), glVertex3s((GLshort)(x + 60), (GLshort)(y + 6), 0), glVertex4f(0.5f * x + 12, 0.5f * y + 30, 0, 0.5f);
        glEnd();
    }
    glNormal3b(127, 0, -128), glGetFloatv(GL_CURRENT_NORMAL, f), text("normal %.5f %.5f %.5f", f[0], f[1], f[2]);
    glTexCoord1s(5), glGetFloatv(GL_CURRENT_TEXTURE_COORDS, f), text("coords %g %g %g %g", f[0], f[1], f[2], f[3]);
    glTexCoord3i(5, 6, 7), glGetFloatv(GL_CURRENT_TEXTURE_COORDS, f), text("coords %g %g %g %g", f[0], f[1], f[2], f[3]);
    glTexCoord1s(0), glNormal3f(0, 0, 1);
}
