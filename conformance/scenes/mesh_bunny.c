/* Proves: a mesh that nobody here made, 69,666 triangles, lit and textured through sphere-mapped coordinates.
 * It is the bunny of Debian's glmark2-data (apt install glmark2-data); it is read at run time and not part of this project.
 * TEPUI_BUNNY may name another place of bunny.obj. */
#include "../scene.h"


static int load(const char *path, GLfloat (**vertex)[6], int *vertices, GLuint **index, int *indices)
{
    FILE *f = fopen(path, "r");
    char line[256];
    int room_v = 0, room_i = 0;
    if (!f) return 0;
    *vertices = *indices = 0;
    while (fgets(line, sizeof line, f)) {
        GLfloat x, y, z;
        GLuint a, b, c;
        if (sscanf(line, "v %f %f %f", &x, &y, &z) == 3) {
            if (*vertices == room_v) *vertex = realloc(*vertex, (size_t)(room_v = 2 * room_v + 1024) * sizeof **vertex);
            GLfloat p[6] = {0, 0, 0, x, y, z};
            memcpy((*vertex)[(*vertices)++], p, sizeof p);
        } else if (sscanf(line, "f %u %u %u", &a, &b, &c) == 3) {
            if (*indices + 3 > room_i) *index = realloc(*index, (size_t)(room_i = 2 * room_i + 3072) * sizeof **index);
            (*index)[(*indices)++] = a - 1, (*index)[(*indices)++] = b - 1, (*index)[(*indices)++] = c - 1;
        }
    }
    fclose(f);
    for (int i = 0; i < *indices; i += 3) { /* smooth normals, weighted by area */
        GLfloat *p = (*vertex)[(*index)[i]], *q = (*vertex)[(*index)[i + 1]], *r = (*vertex)[(*index)[i + 2]];
        GLfloat u[3], v[3];
        for (int k = 0; k < 3; k++) u[k] = q[3 + k] - p[3 + k], v[k] = r[3 + k] - p[3 + k];
        GLfloat n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        for (int k = 0; k < 3; k++) p[k] += n[k], q[k] += n[k], r[k] += n[k];
    }
    return *indices > 0;
}

SCENE(mesh_bunny, SHADED, 1024, 768, 0, "a mesh that nobody here made: 69,666 triangles, lit and textured")
{
    static GLfloat(*vertex)[6];
    static GLuint *index;
    static int vertices, indices, tried;
    const char *path = getenv("TEPUI_BUNNY");
    if (!tried && !load(path ? path : "/usr/share/glmark2/models/bunny.obj", &vertex, &vertices, &index, &indices))
        fprintf(stderr, "mesh_bunny: no bunny.obj; apt install glmark2-data\n");
    tried = 1;
    text("%d vertices, %d triangles", vertices, indices / 3);
    if (!indices) return;
    double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
    for (int i = 0; i < vertices; i++)
        for (int k = 0; k < 3; k++) low[k] = fmin(low[k], vertex[i][3 + k]), high[k] = fmax(high[k], vertex[i][3 + k]);
    double size = fmax(high[0] - low[0], fmax(high[1] - low[1], high[2] - low[2]));
    GLuint texture = checker_texture(64, 8, GL_LINEAR, GL_LINEAR);
    perspective(40, (double)width / height, 1, 10);
    glTranslated(0, 0, -3.2);
    GLfloat position[] = {2, 3, 4, 0}, warm[] = {1, 0.95f, 0.85f, 1}, shine[] = {0.5f, 0.5f, 0.5f, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glRotated(20, 0, 1, 0);
    glScaled(2 / size, 2 / size, 2 / size);
    glTranslated(-(low[0] + high[0]) / 2, -(low[1] + high[1]) / 2, -(low[2] + high[2]) / 2);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, warm);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 32);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
    glInterleavedArrays(GL_N3F_V3F, 0, vertex);
    glDrawElements(GL_TRIANGLES, indices, GL_UNSIGNED_INT, index);
    glDeleteTextures(1, &texture);
}
