#!/usr/bin/env python3
"""GLU quadrics, a tessellated polygon and a perspective view through PyOpenGL, off screen.

Proves that a program which knows nothing of Tepui runs on it: PyOpenGL loads libOSMesa.so.8 by name, GLU (the
system's libGLU) binds to the gl* symbols of the same library.

    PYOPENGL_PLATFORM=osmesa LD_LIBRARY_PATH=<folder of Tepui's libOSMesa.so.8> glu_quadrics.py out.png
"""
import os
import struct
import sys
import zlib

os.environ.setdefault("PYOPENGL_PLATFORM", "osmesa")

from OpenGL import GL, GLU, arrays  # noqa: E402
from OpenGL.osmesa import OSMesaCreateContextExt, OSMesaDestroyContext, OSMesaMakeCurrent, OSMESA_RGBA  # noqa: E402

WIDTH, HEIGHT = 640, 480


def material(red, green, blue):
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_AMBIENT_AND_DIFFUSE, (red, green, blue, 1.0))
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_SPECULAR, (0.5, 0.5, 0.5, 1.0))
    GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, 32.0)


def star(tess):
    """A five-pointed star with a hole: two contours under the odd winding rule."""
    import math

    GLU.gluTessProperty(tess, GLU.GLU_TESS_WINDING_RULE, GLU.GLU_TESS_WINDING_ODD)
    GL.glNormal3f(0.0, 0.0, 1.0)
    GLU.gluTessBeginPolygon(tess, None)
    for radius, count, step in ((1.2, 5, 2), (0.25, 12, 1)):
        GLU.gluTessBeginContour(tess)
        for i in range(count):
            angle = 2.0 * math.pi * (i * step) / count + math.pi / 2.0
            point = (radius * math.cos(angle), radius * math.sin(angle), 0.0)
            GLU.gluTessVertex(tess, point, point)
        GLU.gluTessEndContour(tess)
    GLU.gluTessEndPolygon(tess)


def draw():
    GL.glViewport(0, 0, WIDTH, HEIGHT)
    GL.glClearColor(0.1, 0.12, 0.18, 1.0)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GLU.gluPerspective(40.0, WIDTH / HEIGHT, 1.0, 50.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GLU.gluLookAt(0.0, 3.0, 12.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)
    for capability in (GL.GL_DEPTH_TEST, GL.GL_LIGHTING, GL.GL_LIGHT0, GL.GL_NORMALIZE):
        GL.glEnable(capability)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (4.0, 6.0, 8.0, 1.0))
    GL.glLightModeli(GL.GL_LIGHT_MODEL_TWO_SIDE, GL.GL_TRUE)

    quadric = GLU.gluNewQuadric()
    GLU.gluQuadricNormals(quadric, GLU.GLU_SMOOTH)

    def place(x, y, tilt):
        GL.glPushMatrix()
        GL.glTranslatef(x, y, 0.0)
        GL.glRotatef(tilt, 1.0, 0.3, 0.0)

    place(-3.5, 1.2, 0.0)
    material(0.8, 0.2, 0.2)
    GLU.gluSphere(quadric, 1.2, 48, 32)
    GL.glPopMatrix()

    place(0.0, 1.2, -60.0)
    material(0.2, 0.7, 0.3)
    GLU.gluCylinder(quadric, 1.0, 0.4, 2.0, 40, 8)
    GL.glPopMatrix()

    place(3.5, 1.2, -35.0)
    material(0.2, 0.4, 0.9)
    GLU.gluDisk(quadric, 0.4, 1.2, 40, 4)
    GL.glPopMatrix()

    place(-3.5, -1.8, -20.0)
    material(0.9, 0.7, 0.2)
    GLU.gluQuadricDrawStyle(quadric, GLU.GLU_LINE)
    GLU.gluSphere(quadric, 1.1, 20, 14)
    GL.glPopMatrix()

    place(3.5, -1.8, -50.0)
    material(0.7, 0.3, 0.8)
    GLU.gluQuadricDrawStyle(quadric, GLU.GLU_FILL)
    GLU.gluQuadricOrientation(quadric, GLU.GLU_INSIDE)
    GLU.gluPartialDisk(quadric, 0.3, 1.2, 32, 3, 30.0, 270.0)
    GL.glPopMatrix()
    GLU.gluDeleteQuadric(quadric)

    tess = GLU.gluNewTess()
    GLU.gluTessCallback(tess, GLU.GLU_TESS_BEGIN, GL.glBegin)
    GLU.gluTessCallback(tess, GLU.GLU_TESS_VERTEX, GL.glVertex3dv)
    GLU.gluTessCallback(tess, GLU.GLU_TESS_END, GL.glEnd)
    GLU.gluTessCallback(tess, GLU.GLU_TESS_COMBINE, lambda coords, vertices, weights: coords)
    place(0.0, -1.8, -15.0)
    material(0.9, 0.9, 0.8)
    star(tess)
    GL.glPopMatrix()
    GLU.gluDeleteTess(tess)
    GL.glFinish()


def write_png(path, width, height, rgba_bottom_first):
    rows = [b"\0" + rgba_bottom_first[y * width * 4:(y + 1) * width * 4] for y in reversed(range(height))]
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))  # noqa: E731
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)))
        out.write(chunk(b"IDAT", zlib.compress(b"".join(rows))) + chunk(b"IEND", b""))


def main():
    context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, None)
    pixels = arrays.GLubyteArray.zeros((HEIGHT, WIDTH, 4))
    assert OSMesaMakeCurrent(context, pixels, GL.GL_UNSIGNED_BYTE, WIDTH, HEIGHT)
    draw()
    print("renderer:", GL.glGetString(GL.GL_RENDERER).decode(), "| version:", GL.glGetString(GL.GL_VERSION).decode())
    error = GL.glGetError()
    assert error == GL.GL_NO_ERROR, f"GL error {error:#x}"
    write_png(sys.argv[1], WIDTH, HEIGHT, bytes(pixels))
    OSMesaDestroyContext(context)


if __name__ == "__main__":
    main()
