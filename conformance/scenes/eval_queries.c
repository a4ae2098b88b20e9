/* Proves: glGetMap of orders, domains and coefficients, and the errors of map definitions. */
#include "../scene.h"


SCENE(eval_queries, EXACT, 64, 64, TEXT_ONLY, "evaluator queries and errors")
{
    static const GLfloat f[12] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    GLfloat c[16], d[4];
    GLint order[2];
    UNUSED_SIZE;
    glMap1f(GL_MAP1_VERTEX_3, 0.5f, 2, 4, 3, f);
    glGetMapiv(GL_MAP1_VERTEX_3, GL_ORDER, order), glGetMapfv(GL_MAP1_VERTEX_3, GL_DOMAIN, d), glGetMapfv(GL_MAP1_VERTEX_3, GL_COEFF, c);
    text("order %d domain %g %g coefficients %g %g %g %g", order[0], d[0], d[1], c[0], c[2], c[3], c[8]);
    glGetMapiv(GL_MAP2_COLOR_4, GL_ORDER, order), glGetMapfv(GL_MAP2_COLOR_4, GL_COEFF, c);
    text("default order %d %d coefficients %g %g %g %g", order[0], order[1], c[0], c[1], c[2], c[3]);
    glMap1f(GL_MAP1_VERTEX_3, 1, 1, 3, 3, f), text_error("u1 equals u2");
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 3, f), text_error("too small a stride");
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, f), text_error("order 0");
    glMap1f(GL_MAP2_VERTEX_3, 0, 1, 3, 3, f), text_error("a 2D target");
    glMapGrid1f(0, 0, 1), text_error("a grid of none");
    glEvalMesh1(GL_FILL, 0, 1), text_error("a filled curve");
    glGetMapiv(GL_MAP1_VERTEX_3, GL_LINE, order), text_error("a bad query");
}
