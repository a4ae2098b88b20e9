/* Proves: a frame as legacy programs draw it: 2,000 quads in immediate mode, each in a Begin/End of its own, and 200 changes of
 * state among them (blending, depth functions, shade model, matrices, scissor). Also a timing scene. */
#include "../scene.h"


SCENE(immediate_2000_quads, EXACT, 1024, 768, TIMED, "2,000 immediate-mode quads with 200 changes of state")
{
    pixels(width, height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    seed(16);
    for (int i = 0; i < 2000; i++) {
        if (i % 10 == 0) {
            switch (i / 10 % 8) {
            case 0: glEnable(GL_BLEND); break;
            case 1: glShadeModel(GL_FLAT); break;
            case 2: glDepthFunc(GL_ALWAYS); break;
            case 3: glDisable(GL_BLEND); break;
            case 4: glShadeModel(GL_SMOOTH); break;
            case 5: glDepthFunc(GL_LEQUAL); break;
            case 6: glEnable(GL_SCISSOR_TEST), glScissor(100, 80, width - 200, height - 160); break;
            default: glDisable(GL_SCISSOR_TEST); break;
            }
        }
        double x = uniform(5, width - 65), y = uniform(5, height - 65), w = uniform(8, 60), h = uniform(8, 60), z = uniform(-0.9, 0.9);
        glColor4d(uniform(0, 1), uniform(0, 1), uniform(0, 1), uniform(0.2, 1));
        glBegin(GL_QUADS);
        glVertex3d(x, y, z), glVertex3d(x + w, y, z), glVertex3d(x + w, y + h, z), glVertex3d(x, y + h, z);
        glEnd();
    }
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glShadeModel(GL_SMOOTH);
}
