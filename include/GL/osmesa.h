/* OSMesa: OpenGL into a buffer in memory. The API of Mesa 11.2.
 * SPDX-License-Identifier: MIT OR Apache-2.0 */
#ifndef OSMESA_H
#define OSMESA_H

#include <GL/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

#define OSMESA_MAJOR_VERSION 11
#define OSMESA_MINOR_VERSION 2
#define OSMESA_PATCH_VERSION 0

/* Formats of OSMesaCreateContext: the order of the components in memory. */
#define OSMESA_COLOR_INDEX GL_COLOR_INDEX
#define OSMESA_RGBA GL_RGBA
#define OSMESA_BGRA 0x1
#define OSMESA_ARGB 0x2
#define OSMESA_RGB GL_RGB
#define OSMESA_BGR 0x4
#define OSMESA_RGB_565 0x5

/* OSMesaPixelStore */
#define OSMESA_ROW_LENGTH 0x10 /* pixels from row to row, 0: the width */
#define OSMESA_Y_UP 0x11       /* non-zero (initially): the bottom row comes first */

/* OSMesaGetIntegerv */
#define OSMESA_WIDTH 0x20
#define OSMESA_HEIGHT 0x21
#define OSMESA_FORMAT 0x22 /* also of OSMesaCreateContextAttribs */
#define OSMESA_TYPE 0x23
#define OSMESA_MAX_WIDTH 0x24
#define OSMESA_MAX_HEIGHT 0x25

/* OSMesaCreateContextAttribs */
#define OSMESA_DEPTH_BITS 0x30
#define OSMESA_STENCIL_BITS 0x31
#define OSMESA_ACCUM_BITS 0x32
#define OSMESA_PROFILE 0x33
#define OSMESA_CORE_PROFILE 0x34
#define OSMESA_COMPAT_PROFILE 0x35
#define OSMESA_CONTEXT_MAJOR_VERSION 0x36
#define OSMESA_CONTEXT_MINOR_VERSION 0x37
/* Tepui only: samples of a pixel, 0 to 16 (rounded up to 1, 2, 4, 8 or 16); the program's buffer gets them resolved. */
#define OSMESA_SAMPLES_TEPUI 0x7E01

typedef struct osmesa_context *OSMesaContext;
typedef void (*OSMESAproc)();

/* A context with 24 bits of depth and 8 of stencil. sharelist: a context to share objects with, or NULL. NULL on a bad format. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContext(GLenum format, OSMesaContext sharelist);

/* The same with the bits that are asked for, or more: depth 0, 16 or 24, stencil 0 or 8, accumulation 0 or 16. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextExt(GLenum format, GLint depthBits, GLint stencilBits, GLint accumBits,
                                                      OSMesaContext sharelist);

/* The same from a list of attributes and values that ends with 0; NULL where a value cannot be had. Without an attribute: OSMESA_RGBA,
 * no depth, no stencil, no accumulation, compatibility profile, version 1.0 or later. */
GLAPI OSMesaContext GLAPIENTRY OSMesaCreateContextAttribs(const int *attribList, OSMesaContext sharelist);

GLAPI void GLAPIENTRY OSMesaDestroyContext(OSMesaContext ctx);

/* Makes a context current on this thread. It draws for a buffer of height rows of width pixels, with components of a type:
 * GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT, or GL_UNSIGNED_SHORT_5_6_5 for OSMESA_RGB_565. The buffer is written by glFlush and
 * glFinish, and when the context is made current elsewhere. With NULL and NULL, no context is current. */
GLAPI GLboolean GLAPIENTRY OSMesaMakeCurrent(OSMesaContext ctx, void *buffer, GLenum type, GLsizei width, GLsizei height);

GLAPI OSMesaContext GLAPIENTRY OSMesaGetCurrentContext(void);

GLAPI void GLAPIENTRY OSMesaPixelStore(GLint pname, GLint value);

GLAPI void GLAPIENTRY OSMesaGetIntegerv(GLint pname, GLint *value);

/* A copy of the depth buffer, bottom row first: 2 bytes a value of a 16-bit buffer, else 4, with depth in the low 24 bits and
 * stencil above. It is renewed by glFlush and glFinish. GL_FALSE where there is none. */
GLAPI GLboolean GLAPIENTRY OSMesaGetDepthBuffer(OSMesaContext c, GLint *width, GLint *height, GLint *bytesPerValue, void **buffer);

/* The buffer that a context draws for. GL_FALSE before the first OSMesaMakeCurrent. */
GLAPI GLboolean GLAPIENTRY OSMesaGetColorBuffer(OSMesaContext c, GLint *width, GLint *height, GLint *format, void **buffer);

/* The address of a gl* or OSMesa* function, NULL for what there is not. */
GLAPI OSMESAproc GLAPIENTRY OSMesaGetProcAddress(const char *funcName);

GLAPI void GLAPIENTRY OSMesaColorClamp(GLboolean enable);

GLAPI void GLAPIENTRY OSMesaPostprocess(OSMesaContext osmesa, const char *filter, unsigned enable_value);

#ifdef __cplusplus
}
#endif

#endif
