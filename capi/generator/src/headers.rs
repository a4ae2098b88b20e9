//! Writes `include/GL/gl.h` and `include/GL/glext.h`.

use std::collections::BTreeSet;

use crate::registry::{Command, Group, Registry};

const LICENSE: &str =
    "/* Generated from the Khronos registry by Tepui's capi/generator; do not edit.\n * SPDX-License-Identifier: MIT OR Apache-2.0 */\n";

const PLATFORM: &str = r#"
#if defined(_WIN32) && !defined(APIENTRY) && !defined(__CYGWIN__)
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN 1
#endif
#include <windows.h>
#endif
#ifndef GLAPI
#if defined(__GNUC__) && __GNUC__ >= 4
#define GLAPI __attribute__((visibility("default")))
#else
#define GLAPI extern
#endif
#endif
#ifndef APIENTRY
#define APIENTRY
#endif
#ifndef APIENTRYP
#define APIENTRYP APIENTRY *
#endif
#ifndef GLAPIENTRY
#define GLAPIENTRY APIENTRY
#endif
#ifndef GLAPIENTRYP
#define GLAPIENTRYP GLAPIENTRY *
#endif
"#;

const TYPES: &str = r#"
typedef unsigned int GLenum;
typedef unsigned char GLboolean;
typedef unsigned int GLbitfield;
typedef void GLvoid;
typedef signed char GLbyte;
typedef short GLshort;
typedef int GLint;
typedef unsigned char GLubyte;
typedef unsigned short GLushort;
typedef unsigned int GLuint;
typedef int GLsizei;
typedef float GLfloat;
typedef float GLclampf;
typedef double GLdouble;
typedef double GLclampd;
"#;

fn c_params(command: &Command) -> String {
    if command.params.is_empty() {
        return "void".to_string();
    }
    let one = |p: &crate::registry::Param| {
        if p.ctype.ends_with('*') { format!("{}{}", p.ctype, p.name) } else { format!("{} {}", p.ctype, p.name) }
    };
    command.params.iter().map(one).collect::<Vec<_>>().join(", ")
}

fn prototype(command: &Command, entry: &str) -> String {
    format!("GLAPI {} {entry} {} ({});\n", command.result, command.name, c_params(command))
}

fn enum_lines(registry: &Registry, group: &Group) -> String {
    let defined = |name: &String| registry.enums.get(name).map(|value| format!("#define {name} {value}\n"));
    group.enums.iter().filter_map(defined).collect()
}

/// Versions that gl.h holds; the rest is glext.h's. 1.2, 1.3 and ARB_multitexture are in gl.h as well, because
/// legacy programs take them for granted there.
const IN_GL_H: &[&str] = &["GL_VERSION_1_0", "GL_VERSION_1_1", "GL_VERSION_1_2", "GL_VERSION_1_3", "GL_ARB_multitexture"];

/// Text of gl.h.
pub fn gl(registry: &Registry) -> String {
    let mut text = format!("#ifndef __gl_h_\n#define __gl_h_\n{LICENSE}{PLATFORM}\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n{TYPES}");
    text += "\n#define GL_VERSION_1_1 1\n";
    let mut seen = BTreeSet::new();
    for group in registry.groups.iter().filter(|g| IN_GL_H.contains(&g.name.as_str())) {
        text += &format!("\n/* {} */\n", group.name);
        for name in group.enums.iter().filter(|name| seen.insert(name.as_str())) {
            if let Some(value) = registry.enums.get(name) {
                text += &format!("#define {name} {value}\n");
            }
        }
        for command in group.commands.iter().filter_map(|name| registry.commands.get(name)) {
            text += &prototype(command, "GLAPIENTRY");
        }
    }
    text + "\n#ifndef GL_GLEXT_LEGACY\n#include <GL/glext.h>\n#endif\n\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n"
}

/// Text of glext.h.
pub fn glext(registry: &Registry) -> String {
    let mut text = format!(
        "#ifndef __gl_glext_h_\n#define __gl_glext_h_ 1\n{LICENSE}{PLATFORM}\n#include <stddef.h>\n#ifndef __gl_h_\n#include <GL/gl.h>\n#endif\n\n\
         #ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n#define GL_GLEXT_VERSION 20190228\n\n\
         typedef char GLchar;\ntypedef char GLcharARB;\ntypedef unsigned int GLhandleARB;\ntypedef unsigned short GLhalfARB;\n\
         typedef unsigned short GLhalf;\ntypedef ptrdiff_t GLintptr;\ntypedef ptrdiff_t GLsizeiptr;\ntypedef ptrdiff_t GLintptrARB;\n\
         typedef ptrdiff_t GLsizeiptrARB;\n"
    );
    // Some commands belong to several groups; C allows a typedef once.
    let mut seen = BTreeSet::new();
    for group in registry.groups.iter().skip(2) {
        text += &format!("\n#ifndef {0}\n#define {0} 1\n", group.name);
        text += &enum_lines(registry, group);
        let commands: Vec<&Command> =
            group.commands.iter().filter(|name| seen.insert(name.as_str())).filter_map(|name| registry.commands.get(name)).collect();
        for command in &commands {
            text += &format!("typedef {} (APIENTRYP PFN{}PROC) ({});\n", command.result, command.name.to_uppercase(), c_params(command));
        }
        if !commands.is_empty() {
            text += "#ifdef GL_GLEXT_PROTOTYPES\n";
            for command in &commands {
                text += &prototype(command, "APIENTRY");
            }
            text += "#endif\n";
        }
        text += &format!("#endif /* {} */\n", group.name);
    }
    text + "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n"
}
