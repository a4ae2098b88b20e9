/* The Utah teapot, lit and textured, by two-dimensional evaluators: teapot.png.
 *
 * Martin Newell's control points of 1975. The pot, its rim, lid and bottom are profiles turned around the z axis, so they
 * are given as profiles (radius, height) and swept over four quarter circles; handle and spout are half patches that are
 * mirrored. Normals come from GL_AUTO_NORMAL. */
#include "offscreen.h"

static const double profiles[6][4][2] = {
    {{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}, /* rim */
    {{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}},               /* body */
    {{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}},
    {{0, 3.15}, {0.8, 3.15}, {0, 2.7}, {0.2, 2.7}},                 /* lid */
    {{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}},
    {{1.5, 0.15}, {1.5, 0.075}, {1.425, 0}, {0, 0}},                /* bottom */
};

/* Four rows of an inner and an outer point (x, z) and the half widths at both: y runs 0, -w, -w, 0 across a row. */
static const double sides[4][4][6] = {
    {{-1.6, 2.025, 0.3, -1.5, 2.25, 0.3}, {-2.3, 2.025, 0.3, -2.5, 2.25, 0.3}, {-2.7, 2.025, 0.3, -3, 2.25, 0.3}, {-2.7, 1.8, 0.3, -3, 1.8, 0.3}}, /* handle */
    {{-2.7, 1.8, 0.3, -3, 1.8, 0.3}, {-2.7, 1.575, 0.3, -3, 1.35, 0.3}, {-2.5, 1.125, 0.3, -2.65, 0.9375, 0.3}, {-2, 0.9, 0.3, -1.9, 0.6, 0.3}},
    {{1.7, 1.425, 0.66, 1.7, 0.6, 0.66}, {2.6, 1.425, 0.66, 3.1, 0.825, 0.66}, {2.3, 2.1, 0.25, 2.4, 2.025, 0.25}, {2.7, 2.4, 0.25, 3.3, 2.4, 0.25}}, /* spout */
    {{2.7, 2.4, 0.25, 3.3, 2.4, 0.25}, {2.8, 2.475, 0.25, 3.525, 2.49375, 0.25}, {2.9, 2.475, 0.15, 3.45, 2.5125, 0.15}, {2.8, 2.4, 0.15, 3.2, 2.4, 0.15}},
};

static void patch(GLdouble point[4][4][3])
{
    static const GLdouble coords[2][2][2] = {{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}};
    glMap2d(GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4, &point[0][0][0]);
    glMap2d(GL_MAP2_TEXTURE_COORD_2, 0, 1, 2, 2, 0, 1, 4, 2, &coords[0][0][0]);
    glMapGrid2d(14, 0, 1, 14, 0, 1);
    glEvalMesh2(GL_FILL, 0, 14, 0, 14);
}

static void teapot(void)
{
    static const double circle[4][2] = {{1, 0}, {1, 0.56}, {0.56, 1}, {0, 1}};
    GLdouble point[4][4][3];
    for (int p = 0; p < 6; p++)
        for (int quarter = 0; quarter < 4; quarter++) {
            double c = quarter % 2 ? 0 : 1 - quarter, s = quarter % 2 ? 2 - quarter : 0;
            for (int i = 0; i < 4; i++)
                for (int j = 0; j < 4; j++) {
                    double r = profiles[p][i][0];
                    point[i][j][0] = r * (circle[j][0] * c - circle[j][1] * s);
                    point[i][j][1] = r * (circle[j][0] * s + circle[j][1] * c);
                    point[i][j][2] = profiles[p][i][1];
                }
            patch(point);
        }
    for (int p = 0; p < 4; p++)
        for (int mirror = -1; mirror <= 1; mirror += 2) {
            for (int i = 0; i < 4; i++)
                for (int j = 0; j < 4; j++) {
                    const double *row = sides[p][mirror < 0 ? i : 3 - i];
                    int outer = j >= 2;
                    point[i][j][0] = row[outer * 3], point[i][j][2] = row[outer * 3 + 1];
                    point[i][j][1] = j == 0 || j == 3 ? 0 : mirror * row[outer * 3 + 2];
                }
            patch(point);
        }
}

static void marble(void)
{
    static GLubyte image[128][128][3];
    for (int y = 0; y < 128; y++)
        for (int x = 0; x < 128; x++) {
            double u = x * 2 * M_PI / 128, w = y * 2 * M_PI / 128, v = 0.5 + 0.5 * sin(4 * u + 3 * sin(2 * w) + 1.5 * sin(u + 4 * w));
            image[y][x][0] = (GLubyte)(190 + 60 * v), image[y][x][1] = (GLubyte)(150 + 80 * v), image[y][x][2] = (GLubyte)(110 + 90 * v);
        }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 128, 128, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
}

int main(void)
{
    GLfloat light[] = {3, 6, 5, 1}, shine[] = {0.8f, 0.8f, 0.8f, 1};
    offscreen_open(800, 600);
    glClearColor(0.16f, 0.2f, 0.26f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    camera(32, 1, 40, 2.5, 4.2, 9);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    material(0.9f, 0.9f, 0.9f);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 60);
    marble();
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_AUTO_NORMAL);
    glEnable(GL_NORMALIZE);
    glEnable(GL_MAP2_VERTEX_3);
    glEnable(GL_MAP2_TEXTURE_COORD_2);
    glFrontFace(GL_CW); /* evaluator meshes of these patches turn the other way */
    glRotated(-90, 1, 0, 0);
    glRotated(20, 0, 0, 1);
    glTranslated(0, 0, -1.5);
    teapot();
    offscreen_save("teapot.png");
    offscreen_close();
    return 0;
}
