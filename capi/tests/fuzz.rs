//! The short form of the fuzzer (capi/examples/fuzz): no crash, no hang, no panic that the border had to stop, bounded memory.

mod support;

use std::process::Command;

use support::{library, root, succeed};

#[test]
fn random_calls_do_not_crash_hang_panic_or_grow() {
    let library = library();
    let target = library.ancestors().nth(3).expect("target/<profile>/c-tests/<test>");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(root()).args(["run", "--quiet", "-p", "tepui-capi", "--example", "fuzz", "--target-dir"]).arg(target);
    if library.starts_with(target.join("release")) {
        cargo.arg("--release");
    }
    succeed(cargo.args(["--", "--calls", "100000"]).env("TEPUI_LIBRARY", library.join("libOSMesa.so.8")).env("TEPUI_DEVICE", "cpu"));
}
