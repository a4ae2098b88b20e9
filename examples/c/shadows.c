/* Planar shadows: everything is drawn a second time, flattened onto the floor by a matrix that projects from the light,
 * and the stencil buffer keeps the shadow from darkening any pixel twice. Writes shadows.png. */
#include "offscreen.h"

static const GLfloat light[4] = {2.5f, 5, 2, 1};

static void things(int lit)
{
    for (int i = 0; i < 3; i++) {
        glPushMatrix();
        glTranslated(i * 1.5 - 1.5, 0.9 + 0.2 * i, 0.4 * i);
        glRotated(40 + 35 * i, 1, 0.5 * i, 0.3);
        if (lit) material(i == 0 ? 0.9f : 0.3f, i == 1 ? 0.8f : 0.3f, i == 2 ? 0.9f : 0.3f);
        if (i == 0) solid_torus(0.2, 0.5, 20, 36);
        else if (i == 1) solid_box(0.9, 0.9, 0.9);
        else solid_sphere(0.5, 32, 20);
        glPopMatrix();
    }
}

int main(void)
{
    offscreen_open(640, 480);
    glClearColor(0.5f, 0.6f, 0.75f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    camera(40, 1, 30, -2, 4, 6);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_NORMALIZE);

    material(0.8f, 0.75f, 0.6f);
    glNormal3d(0, 1, 0);
    for (int i = -10; i < 10; i++) { /* a tessellated floor, so that the light fades over it */
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = -10; j <= 10; j++) glVertex3d(i * 0.4, 0, j * 0.4), glVertex3d((i + 1) * 0.4, 0, j * 0.4);
        glEnd();
    }

    /* projects from the light onto y = 0 */
    GLfloat flatten[16] = {light[1], 0, 0, 0, -light[0], 0, -light[2], -1, 0, 0, light[1], 0, 0, 0, 0, light[1]};
    glPushMatrix();
    glMultMatrixf(flatten);
    glDisable(GL_LIGHTING);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-2, -2);
    glColor4f(0, 0, 0.1f, 0.55f);
    things(0);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glPopMatrix();

    glEnable(GL_LIGHTING);
    things(1);
    offscreen_save("shadows.png");
    offscreen_close();
    return 0;
}
