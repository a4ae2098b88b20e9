//! Builds Tepui's library and the scene runner, once for each implementation.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Error;

/// Which OpenGL a runner is linked with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Implementation {
    /// Mesa's OSMesa, the reference.
    Reference,
    /// Tepui.
    Tepui,
}

/// The root of the repository.
pub fn root() -> PathBuf {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
    manifest.parent().unwrap_or(manifest).to_path_buf()
}

/// Where runners and results of a run are kept.
pub fn work_dir() -> PathBuf {
    root().join("target/conformance")
}

/// Directory in which Tepui's library lies under the names that programs ask for.
pub fn library_dir() -> PathBuf {
    work_dir().join("lib")
}

/// Builds the shared library and links it as `libOSMesa.so.8`; `TEPUI_LIBRARY` names a library that is built already.
pub fn build_library() -> Result<(), Error> {
    if let Some(library) = std::env::var_os("TEPUI_LIBRARY") {
        return link_library(&std::fs::canonicalize(library)?);
    }
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let status = Command::new(cargo).current_dir(root()).args(["build", "--release", "--quiet", "-p", "tepui-capi"]).status()?;
    if !status.success() {
        return Err("building the library failed".into());
    }
    link_library(&root().join("target/release/libOSMesa.so"))
}

fn link_library(library: &Path) -> Result<(), Error> {
    let dir = library_dir();
    std::fs::create_dir_all(&dir)?;
    for name in ["libOSMesa.so.8", "libOSMesa.so"] {
        let link = dir.join(name);
        let _ = std::fs::remove_file(&link);
        std::os::unix::fs::symlink(library, &link)?;
    }
    Ok(())
}

fn sources() -> Result<Vec<PathBuf>, Error> {
    let dir = root().join("conformance");
    let mut files = vec![dir.join("runner.c"), dir.join("scene.c"), dir.join("play.c")];
    let mut scenes: Vec<PathBuf> = std::fs::read_dir(dir.join("scenes"))?.filter_map(|e| e.ok().map(|e| e.path())).collect();
    scenes.retain(|p| p.extension().is_some_and(|e| e == "c"));
    scenes.sort();
    files.extend(scenes);
    Ok(files)
}

/// Compiles the runner for `implementation` unless the one that is there is newer than every source.
pub fn build_runner(implementation: Implementation) -> Result<PathBuf, Error> {
    let name = match implementation {
        Implementation::Reference => "runner-osmesa",
        Implementation::Tepui => "runner-tepui",
    };
    let objects = work_dir().join(format!("{name}.objects"));
    let binary = work_dir().join(name);
    std::fs::create_dir_all(&objects)?;
    let age = |p: &Path| std::fs::metadata(p).and_then(|m| m.modified()).ok();
    let shared = [root().join("conformance/scene.h"), root().join("conformance/play.h"), root().join("include/GL/gl.h")]
        .iter()
        .filter_map(|p| age(p))
        .max();
    let mut compiled = Vec::new();
    let mut stale = false;
    for source in sources()? {
        let object = objects.join(source.file_name().unwrap_or_default()).with_extension("o");
        let newest = age(&source).max(shared);
        if age(&object).is_none_or(|o| newest.is_some_and(|n| n > o)) {
            stale = true;
            let mut gcc = Command::new("gcc");
            gcc.args(["-std=gnu11", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-c"]).arg(&source).arg("-o").arg(&object);
            if implementation == Implementation::Tepui && root().join("include/GL/osmesa.h").exists() {
                gcc.arg("-I").arg(root().join("include"));
            }
            if !gcc.status()?.success() {
                return Err(format!("compiling {} for {name} failed", source.display()).into());
            }
        }
        compiled.push(object);
    }
    let linked = age(&binary);
    if stale || linked.is_none() || compiled.iter().filter_map(|o| age(o)).max() > linked {
        let mut gcc = Command::new("gcc");
        gcc.args(&compiled).arg("-o").arg(&binary);
        if implementation == Implementation::Tepui {
            gcc.arg("-L").arg(library_dir()).arg(format!("-Wl,-rpath,{}", library_dir().display()));
        }
        gcc.args(["-lOSMesa", "-lm"]);
        if !gcc.status()?.success() {
            return Err(format!("linking {name} failed").into());
        }
    }
    Ok(binary)
}
