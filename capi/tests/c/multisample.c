/* A window with samples: what is drawn arrives resolved in the program's buffer, and what is read back is the same. */
#include "check.h"

static unsigned char pixels[64 * 64 * 4], read_back[64 * 64 * 4];

static OSMesaContext with_samples(int samples)
{
    int attributes[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_SAMPLES_TEPUI, 0, 0};
    attributes[5] = samples;
    return OSMesaCreateContextAttribs(attributes, NULL);
}

/* Half of the window, its border a diagonal. Counts the pixels that are neither black nor white. */
static int grey_pixels(void)
{
    int grey = 0;
    clear(0, 0, 0, 1);
    glColor3f(1, 1, 1);
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, -1), glVertex2f(1, -1), glVertex2f(1, 0.9f);
    glEnd();
    glFinish();
    for (int k = 0; k < 64 * 64; k++) {
        CHECK_EQUAL(pixels[4 * k + 3], 255);
        grey += pixels[4 * k] != 0 && pixels[4 * k] != 255;
    }
    return grey;
}

int main(void)
{
    static const int samples[] = {0, 1, 2, 3, 4, 8, 16}, given[] = {0, 0, 2, 4, 4, 8, 16};
    for (int k = 0; k < 7; k++) {
        OSMesaContext c = with_samples(samples[k]);
        int grey;
        CHECK(OSMesaMakeCurrent(c, pixels, GL_UNSIGNED_BYTE, 64, 64));
        CHECK_EQUAL(integer(GL_SAMPLES), given[k]);
        CHECK_EQUAL(integer(GL_SAMPLE_BUFFERS), given[k] > 0);
        CHECK(glIsEnabled(GL_MULTISAMPLE));
        grey = grey_pixels();
        if (given[k]) CHECK(grey > 20);
        else CHECK_EQUAL(grey, 0);
        glReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, read_back);
        CHECK(memcmp(pixels, read_back, sizeof pixels) == 0);
        /* All samples of a pixel are its centre's. */
        glDisable(GL_MULTISAMPLE);
        CHECK_EQUAL(grey_pixels(), 0);
        glEnable(GL_MULTISAMPLE);
        /* A pixel rectangle and a clear reach every sample. */
        glRasterPos2f(-1, -1);
        glDrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, read_back);
        glFinish();
        CHECK(memcmp(pixels, read_back, sizeof pixels) == 0);
        CHECK_EQUAL(glGetError(), GL_NO_ERROR);
        OSMesaDestroyContext(c);
    }
    CHECK(with_samples(17) == NULL);
    CHECK(with_samples(-1) == NULL);
    return failures;
}
