//! Builds the library once, compiles C programs against it and the headers, and runs them.

// Each test program uses a part of this.
#![allow(dead_code)]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The repository's root.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Runs a command and insists that it succeeds.
pub fn succeed(command: &mut Command) -> Output {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{command:?}: {}\n{out}{err}", output.status);
    output
}

/// A folder with libOSMesa.so and libOSMesa.so.8, as `make install` lays them out. Cargo does not promise that a cdylib is built for the
/// tests of its package, so it is built here, with the profile of this test.
pub fn library() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let test = std::env::current_exe().expect("a test knows where it lies");
        // target/<profile>/deps/<test>
        let profile = test.ancestors().nth(2).expect("a test lies in target/<profile>/deps").to_path_buf();
        let mut cargo = Command::new(env!("CARGO"));
        cargo.current_dir(root()).args(["build", "--quiet", "-p", "tepui-capi"]);
        if profile.ends_with("release") {
            cargo.arg("--release");
        }
        succeed(cargo.arg("--target-dir").arg(profile.parent().expect("a profile lies in target")));
        let folder = profile.join("c-tests").join(test.file_stem().expect("a test has a name"));
        std::fs::create_dir_all(&folder).expect("target can be written");
        for name in ["libOSMesa.so", "libOSMesa.so.8"] {
            let link = folder.join(name);
            let _ = std::fs::remove_file(&link);
            std::os::unix::fs::symlink(profile.join("libOSMesa.so"), link).expect("target can be written");
        }
        folder
    })
}

/// Compiles `capi/tests/c/<name>.c` and runs it.
pub fn run(name: &str, flags: &[&str]) -> Output {
    let folder = library();
    let program = folder.join(name);
    let source = root().join("capi/tests/c").join(name).with_extension("c");
    let mut cc = Command::new("cc");
    cc.args(["-std=gnu99", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function", "-Wno-cast-function-type", "-O1", "-I"])
        .arg(root().join("include"))
        .arg(source);
    cc.arg("-o").arg(&program).args(flags).arg("-L").arg(folder).arg("-lOSMesa").arg(format!("-Wl,-rpath,{}", folder.display()));
    succeed(&mut cc);
    succeed(Command::new(program).env("TEPUI_LOG", "error"))
}
