//! Writes `capi/src/generated/commands.rs`: every exported command and the table of GetProcAddress.

use crate::families::{letter_type, member, value};
use crate::registry::{Command, Registry};
use crate::scan::{Function, Sources};
use crate::types::{convert, is_scalar, parameters, rust_name, rust_type, snake};

/// How a command is answered.
pub enum Body {
    /// An expression over `cx` and the parameters.
    Call(String),
    /// Not built yet.
    Missing,
}

/// The spellings under which an implementation is looked for: its own, then that of what it is an alias of.
fn spellings<'a>(registry: &'a Registry, command: &'a Command) -> Vec<&'a str> {
    let mut names = vec![command.name.as_str()];
    let mut current = command;
    while let Some(alias) = &current.alias {
        if names.contains(&alias.as_str()) {
            break;
        }
        names.push(alias);
        match registry.commands.get(alias) {
            Some(next) => current = next,
            None => break,
        }
    }
    // Without an <alias> in the registry although they are: the extension's text says so.
    for (own, core) in SAME {
        if *own == command.name {
            names.push(core);
        }
    }
    names
}

/// Spellings of one command that the registry does not list as aliases.
const SAME: &[(&str, &str)] = &[
    ("glAreTexturesResidentEXT", "glAreTexturesResident"),
    ("glGenTexturesEXT", "glGenTextures"),
    ("glDeleteTexturesEXT", "glDeleteTextures"),
    ("glIsTextureEXT", "glIsTexture"),
    ("glBindFramebufferEXT", "glBindFramebuffer"),
    ("glBindRenderbufferEXT", "glBindRenderbuffer"),
    ("glBlendEquationSeparateATI", "glBlendEquationSeparate"),
    ("glDeleteObjectARB", "glDeleteObjectARB"),
];

fn result(c: &str, rust: &str) -> String {
    match (c, rust) {
        ("u8", "bool") => " as u8".to_string(),
        ("()", "") => String::new(),
        ("()", _) => ";".to_string(),
        (c, "") => panic!("a command returns {c}, its method nothing"),
        (c, rust) if crate::types::plain(rust) == c => String::new(),
        (c, rust) if is_scalar(rust) => format!(" as {c}"),
        _ => String::new(),
    }
}

/// Calls a method that takes the same scalars.
fn direct(command: &Command, name: &str, method: &Function) -> Option<String> {
    if method.args.len() != command.params.len() || !method.args.iter().all(|a| is_scalar(a)) {
        return None;
    }
    let mut args = Vec::new();
    for (param, to) in command.params.iter().zip(&method.args) {
        let from = rust_type(&param.ctype);
        if !is_scalar(&from) {
            return None;
        }
        args.push(convert(&rust_name(&param.name), &from, to));
    }
    let from = rust_type(&command.result);
    if from != "()" && !is_scalar(&method.result) {
        return None;
    }
    Some(format!("cx.{name}({}){}", args.join(", "), result(&from, &method.result)))
}

/// Calls the method of a family.
fn by_family(command: &Command, sources: &Sources) -> Option<String> {
    let member = member(&command.name)?;
    sources.methods.get(member.family.method)?;
    let (lead, rest) = command.params.split_at_checked(member.family.lead)?;
    let mut args: Vec<String> = lead.iter().map(|p| rust_name(&p.name)).collect();
    let element = |i: usize| -> Option<String> {
        if member.vector {
            // glRectfv has two vectors of two.
            let (pointer, at) = if rest.len() == 2 { (&rest[i / 2], i % 2) } else { (rest.first()?, i) };
            Some(format!("{}[{at}]", rust_name(&pointer.name)))
        } else {
            Some(rust_name(&rest.get(i)?.name))
        }
    };
    for (i, fill) in member.family.fill.iter().enumerate() {
        args.push(if i < member.count { value(&element(i)?, &member.letters, member.normalized) } else { format!("{fill:?}") });
    }
    let call = format!("cx.{}({})", member.family.method, args.join(", "));
    if !member.vector {
        return Some(call);
    }
    let each = member.count / rest.len();
    let mut text = String::new();
    for pointer in rest {
        let name = rust_name(&pointer.name);
        text += &format!(
            "let Some({name}) = (unsafe {{ read::<{}, {each}>(cx, \"{}\", {name}) }}) else {{ return }}; ",
            letter_type(&member.letters),
            command.name
        );
    }
    Some(format!("{{ {text}{call} }}"))
}

/// Decides how a command is answered.
pub fn body(registry: &Registry, sources: &Sources, command: &Command) -> Body {
    let names = spellings(registry, command);
    for name in &names {
        if let Some(shim) = sources.shims.get(*name) {
            let args: Vec<String> = std::iter::once("cx".to_string()).chain(command.params.iter().map(|p| rust_name(&p.name))).collect();
            return Body::Call(format!("unsafe {{ commands::{}::{name}({}) }}", shim, args.join(", ")));
        }
    }
    for name in &names {
        // glMapGrid1d is map_grid1 where there is no map_grid1d.
        let plain = name.strip_suffix(['f', 'd', 'i', 's']).map(snake).unwrap_or_default();
        for snake in snake(name).into_iter().chain(plain) {
            if let Some(call) = sources.methods.get(&snake).and_then(|m| direct(command, &snake, m)) {
                return Body::Call(call);
            }
        }
    }
    by_family(command, sources).map_or(Body::Missing, Body::Call)
}

/// The file's text.
pub fn write(registry: &Registry, sources: &Sources) -> String {
    let mut text = String::from(
        "//! Every exported command. Generated from the Khronos registry by `capi/generator`; do not edit.\n\
         //!\n\
         //! Safety, for every `unsafe` below: a C caller passes pointers as the OpenGL specification demands; what a command does with them\n\
         //! is written at the shim that it calls.\n\
         #![allow(clippy::all, non_snake_case, unused_variables, unused_imports, unused_braces)]\n\n\
         use std::ffi::{c_char, c_void};\n\
         use std::sync::atomic::AtomicBool;\n\n\
         use crate::commands;\n\
         use crate::enter::{enter, not_built, read};\n\
         use crate::normalized;\n\
         use crate::table::Entry;\n\n",
    );
    for command in registry.commands.values() {
        let result = rust_type(&command.result);
        let arrow = if result == "()" { String::new() } else { format!(" -> {result}") };
        let call = match body(registry, sources, command) {
            Body::Call(call) => call,
            Body::Missing => format!("{{ static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, \"{}\", &SAID) }}", command.name),
        };
        text += &format!(
            "#[unsafe(no_mangle)]\npub unsafe extern \"C\" fn {name}({params}){arrow} {{\n    enter(\"{name}\", |cx| {call})\n}}\n",
            name = command.name,
            params = parameters(command),
        );
    }
    text += &format!("\n/// Every command by name, sorted.\npub static COMMANDS: [Entry; {}] = [\n", registry.commands.len());
    for name in registry.commands.keys() {
        text += &format!("    Entry(\"{name}\", {name} as *const c_void),\n");
    }
    text + "];\n"
}
