/* Proves: two-dimensional evaluators with automatic normals, lit, filled and as a grid of lines. */
#include "../scene.h"


SCENE(eval_surface, SHADED, 256, 256, 0, "two-dimensional evaluators with automatic normals, lit")
{
    GLfloat point[4][4][3], light[] = {0.5f, 1, 2, 0}, red[] = {0.9f, 0.4f, 0.3f, 1};
    perspective(50, (double)width / height, 1, 20);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glTranslatef(0, 0.3f, -5);
    glRotatef(-50, 1, 0.2f, 0.3f);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) point[i][j][0] = (GLfloat)j - 1.5f, point[i][j][1] = (GLfloat)i - 1.5f, point[i][j][2] = (i == 1 || i == 2) && (j == 1 || j == 2) ? 2.5f : (GLfloat)(i * j % 3) * 0.3f;
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4, &point[0][0][0]);
    glEnable(GL_MAP2_VERTEX_3);
    glEnable(GL_AUTO_NORMAL);
    glEnable(GL_NORMALIZE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, red);
    glMapGrid2f(20, 0, 1, 20, 0, 1);
    glEvalMesh2(GL_FILL, 0, 20, 0, 20);
    glDisable(GL_LIGHTING);
    glDisable(GL_MAP2_VERTEX_3);
    glDisable(GL_AUTO_NORMAL);
}
