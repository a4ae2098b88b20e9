/* Three meshing gears, compiled into display lists and turned a little for each frame: gears-0.png to gears-5.png.
 * The gears are the ones everyone knows; the code was written for this example. */
#include "offscreen.h"

static void ring(double radius, double z, double width, int teeth, double depth, int outer)
{
    /* the outline of a gear: four corners a tooth, at the root or at the tip */
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= teeth * 4; i++) {
        double a = i * 2 * M_PI / (teeth * 4), next = a + 2 * M_PI / (teeth * 4);
        double r = outer ? radius + ((i & 3) == 1 || (i & 3) == 2 ? depth / 2 : -depth / 2) : radius;
        if (outer) glNormal3d(cos((a + next) / 2), sin((a + next) / 2), 0);
        else glNormal3d(-cos(a), -sin(a), 0);
        glVertex3d(r * cos(a), r * sin(a), outer ? z + width / 2 : z - width / 2);
        glVertex3d(r * cos(a), r * sin(a), outer ? z - width / 2 : z + width / 2);
    }
    glEnd();
}

static void face(double inner, double outer, double z, int teeth, double depth, int front)
{
    glNormal3d(0, 0, front ? 1 : -1);
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= teeth * 4; i++) {
        double a = i * 2 * M_PI / (teeth * 4), r = outer + ((i & 3) == 1 || (i & 3) == 2 ? depth / 2 : -depth / 2);
        double first = front ? inner : r, second = front ? r : inner;
        glVertex3d(first * cos(a), first * sin(a), z);
        glVertex3d(second * cos(a), second * sin(a), z);
    }
    glEnd();
}

static GLuint gear(double inner, double outer, double width, int teeth, double depth, float r, float g, float b)
{
    GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    material(r, g, b);
    glShadeModel(GL_FLAT);
    face(inner, outer, width / 2, teeth, depth, 1);
    face(inner, outer, -width / 2, teeth, depth, 0);
    ring(outer, 0, width, teeth, depth, 1);
    glShadeModel(GL_SMOOTH);
    ring(inner, 0, width, teeth, depth, 0);
    glEndList();
    return list;
}

static void place(GLuint list, double x, double y, double angle)
{
    glPushMatrix();
    glTranslated(x, y, 0);
    glRotated(angle, 0, 0, 1);
    glCallList(list);
    glPopMatrix();
}

int main(void)
{
    GLfloat light[] = {5, 5, 10, 0};
    offscreen_open(400, 400);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_NORMALIZE);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    GLuint red = gear(1, 4, 1, 20, 0.7, 0.8f, 0.1f, 0), green = gear(0.5, 2, 2, 10, 0.7, 0, 0.8f, 0.2f), blue = gear(1.3, 2, 0.5, 10, 0.7, 0.2f, 0.2f, 1);
    for (int frame = 0; frame < 6; frame++) {
        char name[32];
        double angle = frame * 6;
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        camera(24, 5, 60, 10, 10, 28);
        place(red, -3, -2, angle);
        place(green, 3.1, -2, -2 * angle - 9);
        place(blue, -3.1, 4.2, -2 * angle - 25);
        snprintf(name, sizeof name, "gears-%d.png", frame);
        offscreen_save(name);
    }
    offscreen_close();
    return 0;
}
