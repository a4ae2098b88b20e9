/* Proves: multiply, load, translate, rotate, scale, push and pop on the model-view and projection stacks; the matrices read back. */
#include "../scene.h"


static void show(const char *what, GLenum name)
{
    GLfloat m[16];
    glGetFloatv(name, m);
    for (int i = 0; i < 16; i += 4) text("%s %.4f %.4f %.4f %.4f", what, m[i] + 0.0, m[i + 1] + 0.0, m[i + 2] + 0.0, m[i + 3] + 0.0);
}

SCENE(matrix_stacks, EXACT, 256, 256, 0, "matrix stacks: a tree of transforms, and the matrices read back")
{
    GLint depth;
    static const GLfloat shear[16] = {1, 0, 0, 0, 0.3f, 1, 0, 0, 0, 0, 1, 0, 4, 2, 0, 1};
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, width, 0, height, -50, 50);
    glPushMatrix();
    glFrustum(-1, 1, -1, 1, 2, 9);
    show("projection", GL_PROJECTION_MATRIX);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(128, 10, 0);
    for (int i = 0; i < 7; i++) {
        glPushMatrix();
        glRotatef(15.0f * (GLfloat)i, 0, 0, 1);
        glTranslatef(0, 30 + 10 * (GLfloat)i, 0);
        glScalef(1 + (GLfloat)i * 0.1f, 1.5f, 1);
        glRotated(20, 0.3, 1, 0.2);
        if (i & 1) glMultMatrixf(shear);
        glColor3f((GLfloat)i / 7, 1, 0.5f);
        glBegin(GL_TRIANGLES);
        glVertex2f(-15, 0), glVertex2f(15, 0), glVertex2f(0, 25);
        glEnd();
        if (i == 3) show("modelview", GL_MODELVIEW_MATRIX);
        glGetIntegerv(GL_MODELVIEW_STACK_DEPTH, &depth);
        text("depth %d", depth);
        if (i != 2) glPopMatrix();
    }
    glPopMatrix();
    glPopMatrix();
    text_error("one pop too many");
    for (int i = 0; i < 40; i++) glPushMatrix();
    glGetIntegerv(GL_MODELVIEW_STACK_DEPTH, &depth);
    text("after 40 pushes %d", depth);
    text_error("forty pushes");
    for (int i = 0; i < 40; i++) glPopMatrix();
    glGetError();
}
