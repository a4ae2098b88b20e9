/* Text by glBitmap: a 5 x 7 font compiled into display lists, called with glCallLists, at window positions and at points
 * of a turned 3D scene. Writes text.png. */
#include "offscreen.h"

/* Five columns a letter, bit 0 is the top row: space, then A to Z, then 0 to 9. */
static const unsigned char columns[37][5] = {{0, 0, 0, 0, 0}, {126, 17, 17, 17, 126}, {127, 73, 73, 73, 54}, {62, 65, 65, 65, 34}, {127, 65, 65, 34, 28}, {127, 73, 73, 73, 65}, {127, 9, 9, 9, 1},
    {62, 65, 73, 73, 122}, {127, 8, 8, 8, 127}, {0, 65, 127, 65, 0}, {32, 64, 65, 63, 1}, {127, 8, 20, 34, 65}, {127, 64, 64, 64, 64}, {127, 2, 12, 2, 127}, {127, 4, 8, 16, 127}, {62, 65, 65, 65, 62},
    {127, 9, 9, 9, 6}, {62, 65, 81, 33, 94}, {127, 9, 25, 41, 70}, {70, 73, 73, 73, 49}, {1, 1, 127, 1, 1}, {63, 64, 64, 64, 63}, {31, 32, 64, 32, 31}, {63, 64, 56, 64, 63}, {99, 20, 8, 20, 99},
    {7, 8, 112, 8, 7}, {97, 81, 73, 69, 67}, {62, 81, 73, 69, 62}, {0, 66, 127, 64, 0}, {66, 97, 81, 73, 70}, {33, 65, 69, 75, 49}, {24, 20, 18, 127, 16}, {39, 69, 69, 69, 57}, {60, 74, 73, 73, 48},
    {1, 113, 9, 5, 3}, {54, 73, 73, 73, 54}, {6, 73, 73, 41, 30}};

static int glyph(char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 1 : c >= '0' && c <= '9' ? c - '0' + 27 : 0; }

static GLuint font(int scale)
{
    GLuint base = glGenLists(128);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int c = 32; c < 128; c++) {
        GLubyte rows[7 * 4 * 3] = {0};
        int bytes = (5 * scale + 7) / 8;
        for (int y = 0; y < 7 * scale; y++)
            for (int x = 0; x < 5 * scale; x++)
                if (columns[glyph((char)c)][x / scale] >> (6 - y / scale) & 1) rows[y * bytes + x / 8] |= (GLubyte)(0x80 >> x % 8);
        glNewList(base + (GLuint)c, GL_COMPILE);
        glBitmap(5 * scale, 7 * scale, 0, 0, (GLfloat)(6 * scale), 0, rows);
        glEndList();
    }
    return base;
}

static void print(GLuint list_base, const char *words)
{
    glListBase(list_base);
    glCallLists((GLsizei)strlen(words), GL_UNSIGNED_BYTE, words);
}

int main(void)
{
    offscreen_open(640, 360);
    glClearColor(0.08f, 0.1f, 0.16f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    GLuint small = font(1), large = font(3);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, 640, 0, 360, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glColor3f(1, 0.8f, 0.3f);
    glRasterPos2i(30, 310);
    print(large, "A TEPUI IS A TABLE MOUNTAIN");
    glColor3f(0.6f, 0.8f, 1);
    for (int i = 0; i < 6; i++) {
        char words[80];
        glRasterPos2i(30, 270 - 14 * i);
        snprintf(words, sizeof words, "LINE %d OF SMALL TEXT  ABCDEFGHIJKLMNOPQRSTUVWXYZ 0123456789", i);
        print(small, words);
    }
    glViewport(320, 0, 320, 200);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-0.8, 0.8, -0.5, 0.5, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glTranslated(0, 0, -3.2);
    glRotated(30, 1, 0, 0);
    glRotated(35, 0, 1, 0);
    for (int axis = 0; axis < 3; axis++) {
        static const char *const names[] = {"X 1", "Y 1", "Z 1"};
        double p[3] = {0};
        p[axis] = 1.2;
        glColor3d(axis == 0 ? 1 : 0.3, axis == 1 ? 1 : 0.3, axis == 2 ? 1 : 0.3);
        glBegin(GL_LINES);
        glVertex3d(0, 0, 0), glVertex3dv(p);
        glEnd();
        glRasterPos3dv(p);
        print(small, names[axis]);
    }
    offscreen_save("text.png");
    offscreen_close();
    return 0;
}
