/* Plays generated recordings: GL state and vertices that conformance/src/recording.rs wrote to a file, so that every
 * implementation is given exactly the same numbers, bit for bit.
 *
 * A recording is lines of text. The first is `target <width> <height> <depth bits>`, where 32 bits are floating point (FLOAT_DEPTH in
 * scene.h: it is played twice); every other one is a command of the
 * table in play.c and its arguments: integers in decimal, floats as the eight hexadecimal digits of their bits after an x.
 * `draw` and `texture` are followed by raw data, which starts at a multiple of four bytes.
 *
 * `multisample <samples> <width> <height>` binds a framebuffer object with so many samples a pixel, colour and depth; `resolve` blits it to the
 * window and binds that again. */
#ifndef TEPUI_PLAY_H
#define TEPUI_PLAY_H

#include <stddef.h>

/* How the message begins where an implementation does not have what a recording asks for. */
#define NOT_THERE "not there: "

struct recording {
    char *data;
    size_t size;
    size_t body; /* where the lines after the first begin */
    int width, height, depth_bits;
};

/* Reads a recording; NULL, or why it cannot be played. */
const char *recording_load(struct recording *r, const char *path);

/* Plays it in the current context; NULL, or the command that it does not know, or what is not there. The context is a new one after
 * recording_load, and the same until the next. */
const char *recording_play(const struct recording *r);

void recording_free(struct recording *r);

#endif
