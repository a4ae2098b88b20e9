//! C types of the registry in Rust.

use crate::registry::Command;

/// `const GLfloat *` → `*const f32`.
pub fn rust_type(ctype: &str) -> String {
    let stars = ctype.matches('*').count();
    let base = ctype.replace(['*'], " ").replace("const", " ");
    let base = base.split_whitespace().collect::<Vec<_>>().join(" ");
    let base = match base.as_str() {
        "void" | "GLvoid" => {
            if stars == 0 {
                return "()".to_string();
            }
            "c_void"
        }
        "GLenum" | "GLbitfield" | "GLuint" | "GLhandleARB" => "u32",
        "GLboolean" | "GLubyte" => "u8",
        "GLbyte" => "i8",
        "GLchar" | "GLcharARB" => "c_char",
        "GLshort" => "i16",
        "GLushort" | "GLhalfNV" | "GLhalfARB" => "u16",
        "GLint" | "GLsizei" | "GLclampx" => "i32",
        "GLfloat" | "GLclampf" => "f32",
        "GLdouble" | "GLclampd" => "f64",
        "GLintptr" | "GLsizeiptr" | "GLintptrARB" | "GLsizeiptrARB" => "isize",
        other => panic!("unknown C type {other} in {ctype}"),
    };
    let constant = ctype.starts_with("const");
    match stars {
        0 => base.to_string(),
        1 => format!("*{} {base}", if constant { "const" } else { "mut" }),
        // Outer pointers to read from: `const T *const*`, and `const GLcharARB **` of ARB_shader_objects.
        2 if constant && (ctype.contains("*const") || base == "c_char") => format!("*const *const {base}"),
        2 => format!("*mut *{} {base}", if constant { "const" } else { "mut" }),
        _ => panic!("too many stars in {ctype}"),
    }
}

/// A parameter's name, kept clear of Rust's keywords and of the context's own name.
pub fn rust_name(name: &str) -> String {
    match name {
        "type" | "ref" | "in" | "box" | "mod" | "cx" | "match" => format!("{name}_"),
        _ => name.to_string(),
    }
}

/// `op: u32, value: f32`
pub fn parameters(command: &Command) -> String {
    command.params.iter().map(|p| format!("{}: {}", rust_name(&p.name), rust_type(&p.ctype))).collect::<Vec<_>>().join(", ")
}

/// `glCopyTexSubImage2D` → `copy_tex_sub_image_2d`: digits start a word and capitals do.
pub fn snake(name: &str) -> Vec<String> {
    let name = name.strip_prefix("gl").unwrap_or(name);
    let mut plain = String::new();
    let chars: Vec<char> = name.chars().collect();
    for (i, &c) in chars.iter().enumerate() {
        let previous = if i > 0 { chars[i - 1] } else { ' ' };
        let next = chars.get(i + 1).copied().unwrap_or(' ');
        if c.is_ascii_uppercase()
            && i > 0
            && (previous.is_ascii_lowercase() || (previous.is_ascii_uppercase() && next.is_ascii_lowercase()))
        {
            plain.push('_');
        }
        plain.push(c.to_ascii_lowercase());
    }
    // `tex_image2d` and `tex_image_2d` are both in use among Rust programmers.
    let mut spaced = String::new();
    let chars: Vec<char> = plain.chars().collect();
    for (i, &c) in chars.iter().enumerate() {
        if c.is_ascii_digit() && i > 0 && chars[i - 1].is_ascii_alphabetic() {
            spaced.push('_');
        }
        spaced.push(c);
    }
    if spaced == plain { vec![plain] } else { vec![plain, spaced] }
}

/// True for types that a method may take by value.
pub fn is_scalar(t: &str) -> bool {
    matches!(
        t,
        "u8" | "i8"
            | "u16"
            | "i16"
            | "u32"
            | "i32"
            | "u64"
            | "i64"
            | "f32"
            | "f64"
            | "bool"
            | "usize"
            | "isize"
            | "GLenum"
            | "GLuint"
            | "GLint"
            | "GLsizei"
            | "GLbitfield"
            | "GLfloat"
            | "GLboolean"
    )
}

/// The Rust type behind a GL alias.
pub fn plain(t: &str) -> &str {
    match t {
        "GLenum" | "GLuint" | "GLbitfield" => "u32",
        "GLint" | "GLsizei" => "i32",
        "GLfloat" => "f32",
        "GLboolean" => "u8",
        other => other,
    }
}

/// `value` of type `from`, as an argument of type `to`.
pub fn convert(value: &str, from: &str, to: &str) -> String {
    match (plain(from), plain(to)) {
        (a, b) if a == b => value.to_string(),
        (_, "bool") => format!("{value} != 0"),
        (_, b) => format!("{value} as {b}"),
    }
}
