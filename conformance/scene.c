/* Helpers that scenes share; see scene.h. */
#include "scene.h"

void pixels(int width, int height)
{
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, width, 0, height, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

void perspective(double fovy, double aspect, double near, double far)
{
    double top = near * tan(fovy * M_PI / 360.0);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-top * aspect, top * aspect, -top, top, near, far);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

void look_at(double ex, double ey, double ez, double cx, double cy, double cz)
{
    double f[3] = {cx - ex, cy - ey, cz - ez}, n = sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    for (int i = 0; i < 3; i++) f[i] /= n;
    double s[3] = {-f[2], 0, f[0]}; /* f x (0,1,0) */
    n = sqrt(s[0] * s[0] + s[2] * s[2]);
    s[0] /= n, s[2] /= n;
    double u[3] = {s[1] * f[2] - s[2] * f[1], s[2] * f[0] - s[0] * f[2], s[0] * f[1] - s[1] * f[0]};
    GLdouble m[16] = {s[0], u[0], -f[0], 0, s[1], u[1], -f[1], 0, s[2], u[2], -f[2], 0, 0, 0, 0, 1};
    glMultMatrixd(m);
    glTranslated(-ex, -ey, -ez);
}

static uint64_t random_state;

void seed(uint64_t value) { random_state = value; }

double uniform(double low, double high)
{
    uint64_t z = (random_state += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    z ^= z >> 31;
    return low + (high - low) * ((double)(z >> 40) / 16777216.0);
}

void torus(double inner, double outer, int sides, int rings)
{
    for (int i = 0; i < rings; i++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j <= sides; j++) {
            for (int k = 1; k >= 0; k--) {
                double a = (double)(i + k) / rings * 2 * M_PI, b = (double)j / sides * 2 * M_PI;
                glNormal3d(cos(a) * cos(b), sin(a) * cos(b), sin(b));
                glTexCoord2d((double)(i + k) / rings * 4, (double)j / sides * 2);
                glVertex3d((outer + inner * cos(b)) * cos(a), (outer + inner * cos(b)) * sin(a), inner * sin(b));
            }
        }
        glEnd();
    }
}

void sphere(double radius, int slices, int stacks)
{
    for (int i = 0; i < stacks; i++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j <= slices; j++) {
            for (int k = 1; k >= 0; k--) {
                double a = M_PI * ((double)(i + k) / stacks - 0.5), b = (double)j / slices * 2 * M_PI;
                double x = cos(a) * cos(b), y = sin(a), z = -cos(a) * sin(b);
                glNormal3d(x, y, z);
                glTexCoord2d((double)j / slices * 4, (double)(i + k) / stacks * 2);
                glVertex3d(radius * x, radius * y, radius * z);
            }
        }
        glEnd();
    }
}

void quad(double x0, double y0, double x1, double y1, double z)
{
    glBegin(GL_QUADS);
    glVertex3d(x0, y0, z), glVertex3d(x1, y0, z), glVertex3d(x1, y1, z), glVertex3d(x0, y1, z);
    glEnd();
}

void quad_textured(double x0, double y0, double x1, double y1, double z)
{
    glBegin(GL_QUADS);
    glTexCoord2i(0, 0), glVertex3d(x0, y0, z);
    glTexCoord2i(1, 0), glVertex3d(x1, y0, z);
    glTexCoord2i(1, 1), glVertex3d(x1, y1, z);
    glTexCoord2i(0, 1), glVertex3d(x0, y1, z);
    glEnd();
}

unsigned char *checker(int w, int h, int cell)
{
    unsigned char *image = malloc((size_t)w * h * 4), *p = image;
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++, p += 4) {
            int on = (x / cell + y / cell) & 1;
            p[0] = on ? 230 : 40;
            p[1] = (unsigned char)(255 * x / w);
            p[2] = (unsigned char)(255 * y / h);
            p[3] = on ? 255 : 96;
        }
    return image;
}

unsigned char *noise(int w, int h)
{
    unsigned char *image = malloc((size_t)w * h * 4);
    seed(7);
    for (int i = 0; i < w * h * 4; i++) image[i] = (unsigned char)uniform(0, 256);
    return image;
}

GLuint checker_texture(int size, int cell, GLenum min, GLenum mag)
{
    GLuint name;
    unsigned char *image = checker(size, size, cell);
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (GLint)min);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, (GLint)mag);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    free(image);
    return name;
}

const char *error_name(GLenum error)
{
    switch (error) {
    case GL_NO_ERROR: return "GL_NO_ERROR";
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_STACK_OVERFLOW: return "GL_STACK_OVERFLOW";
    case GL_STACK_UNDERFLOW: return "GL_STACK_UNDERFLOW";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    default: return "an unknown error";
    }
}

void text_error(const char *what) { text("%s: %s", what, error_name(glGetError())); }
