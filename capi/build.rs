//! The shared library's name, and that it binds its own symbols to itself.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libOSMesa.so.8");
    // Another libGL may be in the process: our own references to gl* must never leave the library.
    println!("cargo:rustc-cdylib-link-arg=-Wl,-Bsymbolic");
    // Threads of the pool may still be at rest in it when a program closes its handle: it stays where it is.
    println!("cargo:rustc-cdylib-link-arg=-Wl,-z,nodelete");
}
