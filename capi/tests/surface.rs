//! What C sees without running anything: headers, exported symbols, the library's name, and that generated files are fresh.

mod support;

use std::collections::BTreeSet;
use std::process::Command;

use support::{library, root, succeed};

/// A machine with a C compiler only is enough for everything else.
fn has_cpp() -> bool {
    Command::new("c++").arg("--version").output().is_ok()
}

fn compile(standard: &str, language: &str, source: &str) {
    let file = library().join(format!("{}.{}", standard.replace('+', "x"), language));
    std::fs::write(&file, source).expect("target can be written");
    let mut cc = Command::new(if language == "c" { "cc" } else { "c++" });
    cc.args(["-pedantic-errors", "-Wall", "-Wextra", "-Werror", "-c", "-o", "/dev/null", "-I"]).arg(root().join("include"));
    succeed(cc.arg(format!("-std={standard}")).arg(file));
}

#[test]
fn headers_stand_alone_in_every_standard() {
    for (standard, language) in [("c89", "c"), ("c99", "c"), ("c11", "c"), ("c++98", "cc"), ("c++17", "cc")] {
        if language == "cc" && !has_cpp() {
            eprintln!("no C++ compiler: {standard} not tried");
            continue;
        }
        for header in ["gl", "glext", "osmesa"] {
            for define in ["", "#define GL_GLEXT_PROTOTYPES\n", "#define GL_GLEXT_LEGACY\n"] {
                compile(standard, language, &format!("{define}#include <GL/{header}.h>\nGLenum used = GL_TRIANGLES;\n"));
            }
        }
    }
}

#[test]
fn glu_of_the_system_works_with_the_headers() {
    if std::path::Path::new("/usr/include/GL/glu.h").exists() {
        compile("c99", "c", "#include <GL/osmesa.h>\n#include <GL/glu.h>\nGLUquadric *make(void) { return gluNewQuadric(); }\n");
    }
}

/// Names that the headers declare.
fn declared() -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for header in ["gl.h", "glext.h", "osmesa.h"] {
        let text = std::fs::read_to_string(root().join("include/GL").join(header)).expect("a header can be read");
        for declaration in text.split("GLAPI ").skip(1) {
            let name = declaration.split('(').next().and_then(|d| d.split_whitespace().last()).unwrap_or_default();
            names.extend((name.starts_with("gl") || name.starts_with("OSMesa")).then(|| name.to_string()));
        }
    }
    names
}

#[test]
fn the_library_exports_what_the_headers_declare_and_nothing_else() {
    let output = succeed(Command::new("nm").args(["-D", "--defined-only"]).arg(library().join("libOSMesa.so")));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let exported: BTreeSet<String> = text.lines().filter_map(|line| line.split_whitespace().last()).map(str::to_string).collect();
    let declared = declared();
    assert_eq!(exported.difference(&declared).collect::<Vec<_>>(), Vec::<&String>::new(), "exported, not declared");
    assert_eq!(declared.difference(&exported).collect::<Vec<_>>(), Vec::<&String>::new(), "declared, not exported");
    assert_eq!(declared.iter().filter(|name| name.starts_with("OSMesa")).count(), 13);
}

#[test]
fn the_library_is_called_libosmesa_so_8() {
    let output = succeed(Command::new("readelf").arg("-d").arg(library().join("libOSMesa.so")));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(text.contains("soname: [libOSMesa.so.8]"), "{text}");
}

#[test]
fn generated_files_are_fresh() {
    let target = library().ancestors().nth(3).expect("target/<profile>/c-tests/<process>");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(root()).args(["run", "--quiet", "-p", "tepui-generator", "--target-dir"]).arg(target);
    if target.join("release").exists() && library().starts_with(target.join("release")) {
        cargo.arg("--release");
    }
    succeed(cargo.args(["--", "--check"]));
}

#[test]
fn an_installed_library_is_found_by_its_pkg_config_file() {
    let prefix = library().join("installed");
    let target = library().ancestors().nth(3).expect("target/<profile>/c-tests/<test>");
    let mut make = Command::new("make");
    make.current_dir(root()).args(["--silent", "install"]).arg(format!("PREFIX={}", prefix.display()));
    succeed(make.env("CARGO", env!("CARGO")).env("CARGO_TARGET_DIR", target));
    let file = std::fs::read_to_string(prefix.join("lib/pkgconfig/osmesa.pc")).expect("make install wrote it");
    let value = |key: &str| file.lines().find_map(|line| line.strip_prefix(key)).unwrap_or_default().trim().to_string();
    let expand = |text: String| text.replace("${includedir}", &value("includedir=")).replace("${libdir}", &value("libdir="));
    let program = library().join("with_pkg_config");
    let mut cc = Command::new("cc");
    cc.arg(root().join("capi/tests/c/sharing.c")).arg("-o").arg(&program);
    cc.args(expand(value("Cflags:")).split_whitespace()).args(expand(value("Libs:")).split_whitespace());
    succeed(&mut cc);
    succeed(Command::new(program).env("LD_LIBRARY_PATH", prefix.join("lib")));
}
