/* Fountains of blended, textured particles: additive sparks over an opaque ground, depth tested but not written.
 * Writes particles-0.png to particles-3.png. */
#include "offscreen.h"

enum { COUNT = 4000 };

static GLuint spark(void)
{
    GLuint name;
    GLubyte image[32][32];
    for (int y = 0; y < 32; y++)
        for (int x = 0; x < 32; x++) {
            double r = hypot(x - 15.5, y - 15.5) / 15.5;
            image[y][x] = (GLubyte)(r < 1 ? 255 * (1 - r) * (1 - r) : 0);
        }
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_INTENSITY, 32, 32, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, image);
    return name;
}

int main(void)
{
    static struct { double speed, angle, lift, birth; float color[3]; } particle[COUNT];
    offscreen_open(640, 480);
    for (int i = 0; i < COUNT; i++) {
        particle[i].speed = chance(0.2, 1.1), particle[i].angle = chance(0, 2 * M_PI), particle[i].lift = chance(2.5, 4.5), particle[i].birth = chance(0, 1);
        particle[i].color[0] = (float)chance(0.6, 1), particle[i].color[1] = (float)chance(0.2, 0.6), particle[i].color[2] = (float)chance(0, 0.3);
    }
    GLuint texture = spark();
    for (int frame = 0; frame < 4; frame++) {
        char name[32];
        glClearColor(0.02f, 0.02f, 0.06f, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        camera(45, 0.5, 50, 3, 2.6, 6);
        glEnable(GL_DEPTH_TEST);
        glDisable(GL_TEXTURE_2D);
        glColor3f(0.1f, 0.12f, 0.18f);
        glBegin(GL_QUADS);
        glVertex3d(-4, -1, 4), glVertex3d(4, -1, 4), glVertex3d(4, -1, -4), glVertex3d(-4, -1, -4);
        glEnd();
        GLfloat view[16];
        glGetFloatv(GL_MODELVIEW_MATRIX, view);
        glEnable(GL_TEXTURE_2D);
        glBindTexture(GL_TEXTURE_2D, texture);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        glDepthMask(GL_FALSE);
        glBegin(GL_QUADS);
        for (int i = 0; i < COUNT; i++) {
            double t = fmod(particle[i].birth + frame * 0.07, 1) * 1.6, fade = 1 - t / 1.6, size = 0.09;
            double x = particle[i].speed * t * cos(particle[i].angle), z = particle[i].speed * t * sin(particle[i].angle), y = -1 + particle[i].lift * t - 2.6 * t * t;
            if (y < -1) continue;
            glColor3f(particle[i].color[0] * (float)fade, particle[i].color[1] * (float)fade, particle[i].color[2] * (float)fade);
            for (int c = 0; c < 4; c++) { /* a square that faces the viewer */
                double u = c == 1 || c == 2 ? size : -size, v = c >= 2 ? size : -size;
                glTexCoord2i(u > 0, v > 0);
                glVertex3d(x + u * view[0] + v * view[1], y + u * view[4] + v * view[5], z + u * view[8] + v * view[9]);
            }
        }
        glEnd();
        glDepthMask(GL_TRUE);
        glDisable(GL_BLEND);
        snprintf(name, sizeof name, "particles-%d.png", frame);
        offscreen_save(name);
    }
    offscreen_close();
    return 0;
}
