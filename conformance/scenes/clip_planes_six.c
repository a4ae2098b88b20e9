/* Proves: six user clip planes at once on triangles, lines and points, and the plane read back in eye coordinates. */
#include "../scene.h"


SCENE(clip_planes_six, OTHER, 256, 256, 0, "six user clip planes on triangles, lines and points")
{
    GLdouble back[4];
    pixels(width, height);
    for (int i = 0; i < 6; i++) {
        double a = i * M_PI / 3 + 0.2;
        GLdouble plane[4] = {-cos(a), -sin(a), 0, 90 + 128 * cos(a) + 128 * sin(a)};
        glClipPlane((GLenum)(GL_CLIP_PLANE0 + i), plane);
        glEnable((GLenum)(GL_CLIP_PLANE0 + i));
    }
    glGetClipPlane(GL_CLIP_PLANE3, back);
    text("%.4f %.4f %.4f %.4f", back[0], back[1], back[2], back[3]);
    glColor3f(0.2f, 0.4f, 0.8f);
    quad(0, 0, width, height, 0);
    glBegin(GL_LINES);
    for (int i = 0; i < 20; i++) glColor3d(1, i / 20.0, 0), glVertex2d(0, i * 13 + 0.4), glVertex2d(256, 256 - i * 13 + 0.3);
    glEnd();
    glPointSize(3);
    glBegin(GL_POINTS);
    for (int i = 0; i < 400; i++) glColor3d(0, 1, i / 400.0), glVertex2d(i % 20 * 13 + 4.5, i / 20 * 13 + 4.5);
    glEnd();
    glPointSize(1);
    for (int i = 0; i < 6; i++) glDisable((GLenum)(GL_CLIP_PLANE0 + i));
}
