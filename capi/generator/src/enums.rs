//! Writes `src/gl/enums.rs`.

use crate::registry::Registry;

/// The file's text: by value, then by name.
pub fn write(registry: &Registry) -> String {
    let mut enums: Vec<(u64, &str)> = registry.enums.iter().filter_map(|(name, value)| number(value).map(|v| (v, name.as_str()))).collect();
    enums.retain(|(value, _)| *value <= u64::from(u32::MAX));
    enums.sort();
    let mut text = String::from(
        "//! GL enums up to OpenGL 2.1 and the extensions of that era. Generated from the Khronos registry by `capi/generator`; do not edit.\n\
         #![allow(missing_docs, non_upper_case_globals)]\n\npub type GLenum = u32;\n\n",
    );
    for (value, name) in enums {
        text += &format!("pub const {name}: GLenum = 0x{value:04X};\n");
    }
    text
}

fn number(text: &str) -> Option<u64> {
    match text.strip_prefix("0x") {
        Some(hex) => u64::from_str_radix(hex, 16).ok(),
        None => text.parse().ok(),
    }
}
