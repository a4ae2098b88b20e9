/* Proves: feedback tokens and vertex data of all types. */
#include "../scene.h"


static void tokens(const GLfloat *b, int count, int per_vertex)
{
    text("values %d", count);
    for (int i = 0; i < count;) {
        GLenum token = (GLenum)b[i++];
        int vertices = 1;
        if (token == GL_PASS_THROUGH_TOKEN) {
            text("pass through %g", b[i++]);
            continue;
        }
        if (token == GL_LINE_TOKEN || token == GL_LINE_RESET_TOKEN) vertices = 2;
        if (token == GL_POLYGON_TOKEN) vertices = (int)b[i++];
        text("token %x, %d vertices", token, vertices);
        for (int v = 0; v < vertices && i + per_vertex <= count; v++, i += per_vertex) {
            char line[256];
            int at = 0;
            for (int k = 0; k < per_vertex; k++) at += snprintf(line + at, sizeof line - (size_t)at, " %.3f", b[i + k]);
            text("%s", line);
        }
    }
}

SCENE(feedback, EXACT, 64, 64, TEXT_ONLY, "feedback of points, lines, triangles and bitmaps in all types")
{
    static const struct { GLenum type; int size; } types[] = {{GL_2D, 2}, {GL_3D, 3}, {GL_3D_COLOR, 7}, {GL_3D_COLOR_TEXTURE, 11}, {GL_4D_COLOR_TEXTURE, 12}};
    static const GLubyte bits[] = {0xff};
    GLfloat buffer[512];
    pixels(width, height);
    for (int t = 0; t < 5; t++) {
        glFeedbackBuffer(512, types[t].type, buffer);
        glRenderMode(GL_FEEDBACK);
        glColor4f(0.2f, 0.4f, 0.6f, 0.8f);
        glTexCoord3f(1, 2, 3);
        glBegin(GL_POINTS), glVertex3f(10, 10, 0.5f), glVertex3f(100, 10, 0.5f), glEnd();
        glPassThrough(12.5f);
        glBegin(GL_LINE_STRIP), glVertex2f(10, 10), glColor4f(1, 0, 0, 0.8f), glVertex2f(40, 20), glVertex2f(50, 60), glEnd();
        glBegin(GL_TRIANGLES), glVertex2f(10, 10), glColor4f(0, 1, 0, 0.8f), glVertex2f(40, 20), glVertex3f(50, 60, -0.5f), glEnd();
        glRasterPos2i(20, 20);
        glBitmap(8, 1, 0, 0, 0, 0, bits);
        glDrawPixels(1, 1, GL_RED, GL_UNSIGNED_BYTE, bits);
        tokens(buffer, glRenderMode(GL_RENDER), types[t].size);
    }
    glFeedbackBuffer(4, GL_3D, buffer);
    glRenderMode(GL_FEEDBACK);
    quad(0, 0, 9, 9, 0);
    text("overflow %d", glRenderMode(GL_RENDER));
}
