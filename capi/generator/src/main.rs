//! Writes what follows from the Khronos registry: the enums, the exported commands with their table, the C headers.
//!
//! Run by hand (`cargo run -p tepui-generator`), its output is committed. `--check` says what is stale and fails;
//! `--missing` lists the commands of OpenGL 1.1 that no method answers yet, `--missing all` those of all versions.

use std::path::Path;
use std::process::ExitCode;

mod enums;
mod families;
mod fuzz;
mod headers;
mod registry;
mod scan;
mod selection;
mod shims;
mod types;

use registry::Registry;
use shims::Body;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let has = |option: &str| arguments.iter().any(|a| a == option);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let registry = Registry::read();
    let sources = scan::scan(&root);

    if has("--missing") {
        let missing =
            |name: &&str| registry.commands.get(*name).is_some_and(|c| matches!(shims::body(&registry, &sources, c), Body::Missing));
        let names: Vec<&str> = if has("all") { registry.commands.keys().map(String::as_str).collect() } else { registry.gl11() };
        let found: Vec<&str> = names.iter().copied().filter(missing).collect();
        for name in &found {
            println!("{name}");
        }
        println!("{} of {} not built", found.len(), names.len());
        return ExitCode::SUCCESS;
    }

    let outputs = [
        ("src/gl/enums.rs", enums::write(&registry)),
        ("capi/src/generated/commands.rs", shims::write(&registry, &sources)),
        ("capi/examples/fuzz/calls.rs", fuzz::write(&registry)),
        ("include/GL/gl.h", headers::gl(&registry)),
        ("include/GL/glext.h", headers::glext(&registry)),
    ];
    let mut stale = false;
    for (path, text) in outputs {
        let file = root.join(path);
        if std::fs::read_to_string(&file).is_ok_and(|old| old == text) {
            continue;
        }
        stale = true;
        if has("--check") {
            eprintln!("{path} is stale: run `cargo run -p tepui-generator`");
        } else if let Err(error) = std::fs::write(&file, text) {
            eprintln!("{path}: {error}");
            return ExitCode::FAILURE;
        } else {
            println!("wrote {path}");
        }
    }
    if has("--check") && stale { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
