/* A torus and a sphere over a mirror: the floor is drawn into the stencil buffer, the scene is drawn upside down where
 * the stencil says floor, and the floor itself is blended on top. Writes reflection.png. */
#include "offscreen.h"

static void things(void)
{
    material(0.9f, 0.5f, 0.1f);
    glPushMatrix();
    glTranslated(-0.7, 1.1, 0);
    glRotated(50, 1, 0.4, 0);
    solid_torus(0.3, 0.7, 24, 48);
    glPopMatrix();
    material(0.2f, 0.5f, 0.9f);
    glPushMatrix();
    glTranslated(1, 0.7, 0.6);
    solid_sphere(0.6, 40, 24);
    glPopMatrix();
}

static void floor_quad(void)
{
    glNormal3d(0, 1, 0);
    glBegin(GL_QUADS);
    glVertex3d(-2.2, 0, 2.2), glVertex3d(2.2, 0, 2.2), glVertex3d(2.2, 0, -2.2), glVertex3d(-2.2, 0, -2.2);
    glEnd();
}

int main(void)
{
    GLfloat light[] = {2, 5, 4, 1}, shine[] = {1, 1, 1, 1};
    GLdouble above[] = {0, 1, 0, 0};
    offscreen_open(640, 480);
    glClearColor(0.15f, 0.17f, 0.2f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    camera(38, 1, 30, 1.5, 3.2, 6.5);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_NORMALIZE);

    /* where is the floor? */
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    floor_quad();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);

    /* the mirrored scene, only there and only below the floor */
    glStencilFunc(GL_EQUAL, 1, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glPushMatrix();
    glScaled(1, -1, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glClipPlane(GL_CLIP_PLANE0, above);
    glEnable(GL_CLIP_PLANE0);
    things();
    glDisable(GL_CLIP_PLANE0);
    glPopMatrix();
    glLightfv(GL_LIGHT0, GL_POSITION, light);

    /* the floor itself, half transparent */
    GLfloat glass[] = {0.5f, 0.55f, 0.6f, 0.45f};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, glass);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    floor_quad();
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    things();
    offscreen_save("reflection.png");
    offscreen_close();
    return 0;
}
