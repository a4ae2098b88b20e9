/* What lies under a pixel? Twice: by colour (draw each thing in a colour of its own and read the pixel back) and by
 * GL_SELECT. Writes picking.png with what was found marked, and picking-colors.png, the picture the colours came from. */
#include "offscreen.h"

enum { SIDE = 5 };

static void thing(int i)
{
    glPushMatrix();
    glTranslated(i % SIDE * 1.1 - 2.2, 0, i / SIDE * 1.1 - 2.2);
    glRotated(i * 23, 0.3, 1, 0.2);
    if (i % 3 == 0) solid_box(0.7, 0.7, 0.7);
    else if (i % 3 == 1) solid_sphere(0.42, 24, 16);
    else solid_torus(0.15, 0.32, 12, 24);
    glPopMatrix();
}

static int by_color(int x, int y)
{
    GLubyte pixel[4];
    glDisable(GL_LIGHTING);
    glDisable(GL_DITHER);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    camera(35, 1, 30, 2, 5, 6);
    for (int i = 0; i < SIDE * SIDE; i++) {
        glColor3ub((GLubyte)((i + 1) * 10), (GLubyte)(255 - (i + 1) * 7), 0);
        thing(i);
    }
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    return pixel[0] / 10 - 1;
}

static int by_selection(int x, int y)
{
    GLuint buffer[512], nearest = ~0u;
    GLint viewport[4];
    int found = -1;
    glSelectBuffer(512, buffer);
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(0);
    camera(35, 1, 30, 2, 5, 6);
    GLdouble projection[16];
    glGetDoublev(GL_PROJECTION_MATRIX, projection);
    glGetIntegerv(GL_VIEWPORT, viewport);
    glMatrixMode(GL_PROJECTION); /* gluPickMatrix of one pixel */
    glLoadIdentity();
    glTranslated(viewport[2] - 2.0 * (x + 0.5), viewport[3] - 2.0 * (y + 0.5), 0);
    glScaled(viewport[2], viewport[3], 1);
    glMultMatrixd(projection);
    glMatrixMode(GL_MODELVIEW);
    for (int i = 0; i < SIDE * SIDE; i++) glLoadName((GLuint)i), thing(i);
    int hits = glRenderMode(GL_RENDER);
    for (GLuint *p = buffer; hits > 0; hits--, p += 3 + p[0])
        if (p[1] < nearest) nearest = p[1], found = (int)p[3];
    return found;
}

int main(void)
{
    static const int at[][2] = {{320, 200}, {210, 260}, {430, 150}, {20, 20}};
    int marked[4], agree = 1;
    GLfloat light[] = {3, 6, 4, 1};
    offscreen_open(640, 400);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_NORMALIZE);
    for (int k = 0; k < 4; k++) {
        int color = by_color(at[k][0], at[k][1]), select = by_selection(at[k][0], at[k][1]);
        printf("pixel %d, %d: by colour %d, by selection %d\n", at[k][0], at[k][1], color, select);
        agree &= color == select;
        marked[k] = color;
    }
    by_color(0, 0);
    offscreen_save("picking-colors.png");
    glClearColor(0.2f, 0.22f, 0.25f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    camera(35, 1, 30, 2, 5, 6);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    for (int i = 0; i < SIDE * SIDE; i++) {
        int hit = 0;
        for (int k = 0; k < 4; k++) hit |= marked[k] == i;
        material(hit ? 1 : 0.4f, hit ? 0.7f : 0.4f, hit ? 0.1f : 0.5f);
        thing(i);
    }
    offscreen_save("picking.png");
    offscreen_close();
    return agree ? 0 : 1;
}
