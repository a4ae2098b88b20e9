/* Proves: display lists replay geometry, state, matrices and textures; compile-and-execute draws at once. */
#include "../scene.h"


SCENE(lists_basic, EXACT, 256, 256, 0, "display lists: geometry, state, nesting, CallLists of every type")
{
    pixels(width, height);
    GLuint base = glGenLists(20);
    text("is list %d %d", glIsList(base), glIsList(base + 30));
    for (int i = 0; i < 8; i++) {
        glNewList(base + (GLuint)i, GL_COMPILE);
        glColor3d(i / 8.0, 1, 0.5);
        glBegin(GL_TRIANGLES);
        glVertex2d(0, 0), glColor3d(1, i / 8.0, 0), glVertex2d(26, 3), glVertex2d(12, 20 + i);
        glEnd();
        glTranslatef(31, (GLfloat)i * 0.5f, 0);
        glEndList();
    }
    glNewList(base + 10, GL_COMPILE_AND_EXECUTE);
    glPushMatrix();
    glTranslatef(0, 210, 0);
    for (GLuint i = 0; i < 8; i++) glCallList(base + i);
    glPopMatrix();
    glEndList();
    glTranslatef(0, -35, 0);
    glCallList(base + 10);
    glLoadIdentity();
    glListBase(base);
    static const GLubyte ub[] = {0, 3, 1}, two[] = {0, 4, 0, 5}, three[] = {0, 0, 6}, four[] = {0, 0, 0, 7};
    static const GLbyte b[] = {2, 0};
    static const GLushort us[] = {1, 6};
    static const GLshort s[] = {5, 4};
    static const GLint in[] = {3, 2};
    static const GLuint ui[] = {0, 7};
    static const GLfloat f[] = {1, 3};
    glTranslatef(2, 2, 0), glPushMatrix(), glCallLists(3, GL_UNSIGNED_BYTE, ub), glCallLists(2, GL_BYTE, b), glCallLists(2, GL_UNSIGNED_SHORT, us), glPopMatrix();
    glTranslatef(2, 40, 0), glPushMatrix(), glCallLists(2, GL_SHORT, s), glCallLists(2, GL_INT, in), glCallLists(2, GL_UNSIGNED_INT, ui), glPopMatrix();
    glTranslatef(2, 40, 0), glPushMatrix(), glCallLists(2, GL_FLOAT, f), glCallLists(2, GL_2_BYTES, two), glCallLists(1, GL_3_BYTES, three), glCallLists(1, GL_4_BYTES, four), glPopMatrix();
    glListBase(0);
    glDeleteLists(base, 20);
    text("is list %d", glIsList(base));
}
