/* Proves: edge flag arrays and index arrays beside the others. */
#include "../scene.h"


SCENE(arrays_edge_flags, OTHER, 256, 256, 0, "edge flag arrays with outlined polygons")
{
    static const GLfloat v[][2] = {{10, 10}, {240, 30}, {200, 240}, {40, 220}, {20, 100}};
    static const GLboolean e[] = {1, 0, 1, 1, 0};
    pixels(width, height);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_EDGE_FLAG_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, v);
    glEdgeFlagPointer(0, e);
    glDrawArrays(GL_POLYGON, 0, 5);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}
