/* Proves: errors of list commands, recursion depth, lists that change attributes, what is not compiled. */
#include "../scene.h"


SCENE(lists_errors, EXACT, 64, 64, 0, "display list errors and what is executed at once")
{
    GLint value;
    UNUSED_SIZE;
    glNewList(0, GL_COMPILE), text_error("NewList 0");
    glNewList(5, GL_POINTS), text_error("NewList with a bad mode");
    glEndList(), text_error("EndList without NewList");
    glNewList(5, GL_COMPILE);
    glGetIntegerv(GL_LIST_INDEX, &value), text("index %d", value);
    glGetIntegerv(GL_LIST_MODE, &value), text("mode %x", (unsigned)value);
    glNewList(6, GL_COMPILE), text_error("NewList within a list");
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 9);
    glEnable(GL_FOG);
    glEnable((GLenum)0x1234);
    text_error("a bad enum compiled");
    glCallList(5);
    glEndList();
    text("fog before the call %d", glIsEnabled(GL_FOG));
    glCallList(5);
    text_error("the bad enum called");
    text("fog after the call %d", glIsEnabled(GL_FOG));
    glDisable(GL_FOG);
    glGetIntegerv(GL_UNPACK_ROW_LENGTH, &value), text("row length %d", value);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glCallList(99), text_error("an unknown list");
    glDeleteLists(5, -1), text_error("a negative count");
    glGenLists(-1), text_error("GenLists of a negative count");
    static const GLubyte n[] = {5};
    glCallLists(1, GL_DOUBLE, n), text_error("CallLists of doubles");
    glGetIntegerv(GL_MAX_LIST_NESTING, &value), text("nesting at least 64: %d", value >= 64);
    glDeleteLists(5, 1);
}
