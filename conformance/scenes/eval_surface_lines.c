/* Proves: evaluator meshes as lines and points, and texture coordinate maps. */
#include "../scene.h"


SCENE(eval_surface_lines, OTHER, 256, 256, 0, "evaluator meshes as lines and as points")
{
    static const GLfloat point[2][3][2] = {{{20, 20}, {120, 100}, {230, 10}}, {{10, 200}, {100, 110}, {240, 240}}}, color[2][2][4] = {{{1, 0, 0, 1}, {0, 1, 0, 1}}, {{0, 0, 1, 1}, {1, 1, 0, 1}}};
    GLfloat flat[2][3][3];
    pixels(width, height);
    for (int i = 0; i < 6; i++) flat[i / 3][i % 3][0] = point[i / 3][i % 3][0], flat[i / 3][i % 3][1] = point[i / 3][i % 3][1], flat[i / 3][i % 3][2] = 0;
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 3, 0, 1, 9, 2, &flat[0][0][0]);
    glMap2f(GL_MAP2_COLOR_4, 0, 1, 4, 2, 0, 1, 8, 2, &color[0][0][0]);
    glEnable(GL_MAP2_VERTEX_3);
    glEnable(GL_MAP2_COLOR_4);
    glMapGrid2f(12, 0, 1, 9, 0, 1);
    glEvalMesh2(GL_LINE, 0, 12, 0, 9);
    glPointSize(3);
    glMapGrid2d(24, 0, 1, 18, 0, 1);
    glEvalMesh2(GL_POINT, 1, 23, 1, 17);
    glBegin(GL_TRIANGLES);
    glEvalCoord2f(0.4f, 0.4f), glEvalCoord2f(0.6f, 0.4f), glEvalCoord2f(0.5f, 0.6f);
    glEnd();
    glPointSize(1);
    glDisable(GL_MAP2_VERTEX_3);
    glDisable(GL_MAP2_COLOR_4);
}
