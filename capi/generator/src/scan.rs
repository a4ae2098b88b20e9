//! Finds in the sources what a shim can call: hand-written shims and methods of `Context`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A function as the source spells it.
#[derive(Clone, Debug)]
pub struct Function {
    /// Argument types after `self` or `cx`, as text.
    pub args: Vec<String>,
    /// Result type, empty for none.
    pub result: String,
}

/// What was found.
pub struct Sources {
    /// Module of every `pub unsafe fn glName(cx: &mut Context, ...)` below `capi/src/commands`.
    pub shims: BTreeMap<String, String>,
    /// `pub fn name(&mut self, ...)` in `impl Context` below `src/gl`.
    pub methods: BTreeMap<String, Function>,
}

/// Every Rust file below a folder, sorted.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The text up to the bracket that closes the one before `text`, and what follows it.
fn balanced(text: &str) -> Option<(&str, &str)> {
    let mut depth = 1;
    for (at, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some((&text[..at], &text[at + 1..]));
        }
    }
    None
}

/// Splits at commas that are not inside brackets.
fn arguments(text: &str) -> Vec<String> {
    let (mut depth, mut args) = (0, vec![String::new()]);
    for c in text.chars() {
        match c {
            '(' | '[' | '<' => depth += 1,
            ')' | ']' | '>' => depth -= 1,
            _ => {}
        }
        if c == ',' && depth == 0 {
            args.push(String::new());
        } else if let Some(last) = args.last_mut() {
            last.push(c);
        }
    }
    args.iter().map(|a| a.split_whitespace().collect::<Vec<_>>().join(" ")).filter(|a| !a.is_empty()).collect()
}

/// Every `pub fn` of a file with the header of the `impl` block that it stands in (empty outside).
fn functions(source: &str) -> Vec<(String, String, Function)> {
    let mut found = Vec::new();
    let (mut block, mut offset) = (String::new(), 0);
    for line in source.split_inclusive('\n') {
        let start = offset;
        offset += line.len();
        if line.starts_with("impl") {
            block = line.trim().trim_end_matches('{').trim().to_string();
        } else if line.starts_with('}') {
            block.clear();
        }
        let trimmed = line.trim_start();
        let Some(head) = ["pub fn ", "pub unsafe fn "].iter().find(|p| trimmed.starts_with(**p)) else { continue };
        let after = &source[start + (line.len() - trimmed.len()) + head.len()..];
        let Some(open) = after.find(['(', '<']).filter(|at| after.as_bytes()[*at] == b'(') else { continue };
        let Some((inside, rest)) = balanced(&after[open + 1..]) else { continue };
        let result = rest.split('{').next().unwrap_or("").split(" where").next().unwrap_or("").trim();
        let result = result.strip_prefix("->").unwrap_or("").trim().to_string();
        found.push((block.clone(), after[..open].to_string(), Function { args: arguments(inside), result }));
    }
    found
}

/// Names of shims that a macro makes: every `glName` in a block `something! { ... }` at the left margin.
fn made_by_macros(source: &str) -> Vec<String> {
    let (mut found, mut inside) = (Vec::new(), false);
    for line in source.lines() {
        if line.ends_with("! {") && !line.starts_with(' ') {
            inside = true;
        } else if line.starts_with('}') {
            inside = false;
        } else if inside {
            let words = line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
            let is_command = |w: &&str| w.strip_prefix("gl").is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_uppercase()));
            found.extend(words.filter(is_command).map(str::to_string));
        }
    }
    found
}

/// Reads the sources below the repository's root.
pub fn scan(root: &Path) -> Sources {
    let mut sources = Sources { shims: BTreeMap::new(), methods: BTreeMap::new() };
    for path in files(&root.join("src/gl")) {
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        for (block, name, mut function) in functions(&text) {
            let on_self = function.args.first().is_some_and(|a| a == "&self" || a == "&mut self");
            if block == "impl Context" && on_self {
                function.args.remove(0);
                for arg in &mut function.args {
                    *arg = arg.split_once(':').map_or(arg.clone(), |(_, t)| t.trim().to_string());
                }
                sources.methods.insert(name, function);
            }
        }
    }
    let commands = root.join("capi/src/commands");
    for path in files(&commands) {
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let module = path.strip_prefix(&commands).unwrap_or(&path).with_extension("");
        let module = module.components().map(|c| c.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("::");
        let names = functions(&text).into_iter().map(|(_, name, _)| name).filter(|name| name.starts_with("gl"));
        for name in names.chain(made_by_macros(&text)) {
            sources.shims.insert(name, module.clone());
        }
    }
    sources
}
