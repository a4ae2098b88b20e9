//! Writes `capi/examples/fuzz/calls.rs`: one call a command, with arguments drawn by type and name.

use std::collections::BTreeSet;

use crate::registry::{Command, Param, Registry};
use crate::types::rust_type;

/// Commands whose integers may be anything: they are values, not sizes of what is read or done.
const WILD: &[&str] = &[
    "glVertex",
    "glColor",
    "glNormal",
    "glTexCoord",
    "glMultiTexCoord",
    "glSecondaryColor",
    "glFogCoord",
    "glIndex",
    "glRasterPos",
    "glWindowPos",
    "glRect",
    "glViewport",
    "glScissor",
    "glStencil",
    "glClear",
    "glLight",
    "glMaterial",
    "glFog",
    "glTexEnv",
    "glTexGen",
    "glTexParameter",
    "glPixelTransfer",
    "glLineStipple",
    "glPointParameter",
    "glPolygon",
];

/// Commands that have array parameters of indices or names in memory of any type.
const SMALL: &[&str] = &["glDrawElements", "glDrawRangeElements", "glCallLists"];

fn argument(registry: &Registry, command: &Command, param: &Param) -> String {
    let name = command.name.as_str();
    let wild = WILD.iter().any(|prefix| name.starts_with(prefix)) && !name.contains("Pointer");
    let choice = || match param.group.as_ref().and_then(|g| registry.enum_groups.get_key_value(g)).filter(|(_, names)| !names.is_empty()) {
        Some((group, _)) => format!("g.choice({})", constant(group)),
        None => "g.choice(&[])".to_string(),
    };
    let ctype = param.ctype.as_str();
    if ctype.contains('*') {
        let stars = ctype.matches('*').count();
        let rust = rust_type(ctype);
        return match (stars, ctype.starts_with("const"), rust.as_str()) {
            (2, true, _) => "g.pointers().cast()".to_string(),
            (2, false, _) => "g.room().cast()".to_string(),
            (_, false, _) => "g.room().cast()".to_string(),
            (_, _, "*const f32") => "g.floats()".to_string(),
            (_, _, "*const f64") => "g.doubles()".to_string(),
            (_, _, "*const c_char") => "g.text()".to_string(),
            (_, _, "*const c_void") if SMALL.iter().any(|prefix| name.starts_with(prefix)) => "g.small().cast()".to_string(),
            (_, _, "*const c_void" | "*const u8") => "g.data().cast()".to_string(),
            _ => "g.small().cast()".to_string(),
        };
    }
    match ctype {
        "GLenum" => choice(),
        "GLboolean" => "g.boolean()".to_string(),
        "GLbitfield" => choice().replace("choice", "bits"),
        "GLint" if param.name.starts_with("internal") || param.name == "components" => format!("{} as i32", choice()),
        "GLint" if wild => "g.wild()".to_string(),
        // A texture that is too large is refused; of other sizes, as many bytes are read.
        "GLsizei" if name.starts_with("glTexImage") || name.starts_with("glViewport") || name.starts_with("glScissor") => {
            "g.any_size()".to_string()
        }
        "GLsizei" => "g.size()".to_string(),
        "GLint" => "g.int()".to_string(),
        "GLuint" if param.name == "list" => format!("g.list(\"{name}\")"),
        _ => match rust_type(ctype).as_str() {
            "f32" if name == "glPixelStoref" => "g.int() as f32".to_string(),
            "f32" => "g.float()".to_string(),
            "f64" => "g.double()".to_string(),
            "u32" => "g.uint()".to_string(),
            "isize" => "g.int() as isize".to_string(),
            small => format!("g.wild() as {small}"),
        },
    }
}

fn constant(group: &str) -> String {
    let mut name = String::new();
    for c in group.chars() {
        if c.is_ascii_uppercase() && !name.is_empty() && !name.ends_with(|c: char| c.is_ascii_uppercase()) {
            name.push('_');
        }
        name.push(c.to_ascii_uppercase());
    }
    name
}

/// The file's text.
pub fn write(registry: &Registry) -> String {
    let mut text = String::from(
        "//! A call of every command with drawn arguments. Generated from the Khronos registry by `capi/generator`; do not edit.\n\
         //!\n\
         //! Safety: the address is that of the command, and `Draw` hands out pointers with room for what the drawn sizes imply.\n\
         #![cfg_attr(rustfmt, rustfmt_skip)]\n\
         #![allow(clippy::all, clippy::undocumented_unsafe_blocks)]\n\n\
         use std::ffi::{c_char, c_void};\n\
         use std::mem::transmute;\n\n\
         use crate::draw::Draw;\n\n",
    );
    let used: BTreeSet<&String> = registry.commands.values().flat_map(|c| &c.params).filter_map(|p| p.group.as_ref()).collect();
    for (group, names) in registry.enum_groups.iter().filter(|(group, names)| used.contains(group) && !names.is_empty()) {
        let values: Vec<&str> = names.iter().filter_map(|n| registry.enums.get(n)).map(String::as_str).collect();
        text += &format!("#[allow(dead_code)]\nconst {}: &[u32] = &[{}];\n", constant(group), values.join(", "));
    }
    let every: BTreeSet<&String> = registry.enums.values().filter(|v| v.len() <= 10).collect();
    text += &format!(
        "\n/// Every value of an enum.\npub const EVERY: &[u32] = &[{}];\n",
        every.into_iter().map(String::as_str).collect::<Vec<_>>().join(", ")
    );
    text += "\n/// Calls the command at an address.\npub type Call = fn(*const c_void, &mut Draw);\n";
    text += &format!("\n/// Every command.\npub const CALLS: [(&str, Call); {}] = [\n", registry.commands.len());
    for command in registry.commands.values() {
        let types: Vec<String> = command.params.iter().map(|p| rust_type(&p.ctype)).collect();
        let result = rust_type(&command.result);
        let lets: String =
            command.params.iter().enumerate().map(|(i, p)| format!("let a{i} = {}; ", argument(registry, command, p))).collect();
        let names: Vec<String> = (0..types.len()).map(|i| format!("a{i}")).collect();
        text += &format!(
            "    (\"{}\", |f, g| {{ let f: unsafe extern \"C\" fn({}){} = unsafe {{ transmute(f) }}; {lets}g.ready(); unsafe {{ f({}) }}; }}),\n",
            command.name,
            types.join(", "),
            if result == "()" { String::new() } else { format!(" -> {result}") },
            names.join(", ")
        );
    }
    text + "];\n"
}
