/* Proves: one-dimensional evaluators: points, colours, mesh and grid. */
#include "../scene.h"


SCENE(eval_curve, OTHER, 256, 256, 0, "one-dimensional evaluators: curves with colours")
{
    static const GLfloat point[4][3] = {{10, 10, 0}, {60, 250, 0}, {180, -40, 0}, {245, 240, 0}}, color[3][4] = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
    pixels(width, height);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, &point[0][0]);
    glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 3, &color[0][0]);
    glEnable(GL_MAP1_VERTEX_3);
    glEnable(GL_MAP1_COLOR_4);
    glBegin(GL_LINE_STRIP);
    for (int i = 0; i <= 40; i++) glEvalCoord1f((GLfloat)i / 40);
    glEnd();
    glTranslatef(0, 8, 0);
    glMapGrid1f(30, 0, 1);
    glEvalMesh1(GL_LINE, 0, 30);
    glPointSize(4);
    glTranslatef(0, 8, 0);
    glEvalMesh1(GL_POINT, 3, 27);
    glBegin(GL_POINTS);
    glEvalPoint1(1), glEvalPoint1(29);
    glEnd();
    glPointSize(1);
    glDisable(GL_MAP1_VERTEX_3);
    glDisable(GL_MAP1_COLOR_4);
}
