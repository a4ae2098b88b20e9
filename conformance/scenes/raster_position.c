/* Proves: raster positions are transformed, lit, clipped and read back; invalid ones draw nothing. */
#include "../scene.h"


SCENE(raster_position, OTHER, 256, 256, 0, "raster positions: transformed, lit, clipped, queried")
{
    GLfloat v[4], light[] = {0, 0, 1, 0};
    GLboolean valid;
    static const GLubyte block[] = {0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff};
    static const GLfloat at[][3] = {{0, 0, -3}, {1, 0.5f, -4}, {5, 0, -3}, {0, 0, 3}, {-1, -1, -5}};
    perspective(60, (double)width / height, 1, 20);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int i = 0; i < 10; i++) {
        if (i == 5) glLightfv(GL_LIGHT0, GL_POSITION, light), glNormal3f(0.3f, 0, 0.9f), glEnable(GL_LIGHTING), glEnable(GL_LIGHT0);
        glColor3d(1, i / 10.0, 0);
        glTexCoord2d(i, i * 2);
        glRasterPos3f(at[i % 5][0] + (i > 4 ? 0.3f : 0), at[i % 5][1], at[i % 5][2]);
        glGetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
        text("valid %d", valid);
        if (!valid) continue;
        glGetFloatv(GL_CURRENT_RASTER_POSITION, v);
        text("position %.3f %.3f %.5f %.4f", v[0], v[1], v[2], v[3]);
        glGetFloatv(GL_CURRENT_RASTER_COLOR, v);
        text("color %.3f %.3f %.3f %.3f", v[0], v[1], v[2], v[3]);
        glGetFloatv(GL_CURRENT_RASTER_DISTANCE, v);
        text("distance %.4f", v[0]);
        glGetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, v);
        text("coords %.3f %.3f %.3f %.3f", v[0], v[1], v[2], v[3]);
        glBitmap(8, 8, 4, 4, 0, 0, block);
    }
    glDisable(GL_LIGHTING);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}
