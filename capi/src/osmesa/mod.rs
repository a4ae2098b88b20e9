//! The 13 functions of OSMesa (Mesa 11.2's API), with the semantics measured on Mesa 22.3.
//!
//! - [`format`]: which formats and types there are, and how pixels are copied into the program's memory;
//! - [`handle`]: the handles that C holds;
//! - [`create`]: making and destroying contexts;
//! - [`bind`]: making them current, and when the program's memory is written;
//! - [`query`]: what a program can ask and set.

pub mod bind;
pub mod create;
pub mod format;
pub mod handle;
pub mod query;

use format::Format;
use tepui::gl::enums::GLenum;

/// Where a context's pixels go.
pub struct Target {
    /// Order of the components in memory.
    pub format: Format,
    /// Type of the components: GL_UNSIGNED_BYTE...
    pub kind: GLenum,
    /// The program's buffer, as an address; 0 before the first binding.
    pub address: usize,
    /// Columns.
    pub width: i32,
    /// Rows.
    pub height: i32,
    /// OSMESA_ROW_LENGTH: pixels from row to row, 0 for the width.
    pub row_length: i32,
    /// OSMESA_Y_UP: the first row in memory is the bottom row.
    pub y_up: bool,
    /// The copy that GetDepthBuffer hands out.
    pub depth: Vec<u8>,
}

/// Runs an `OSMesa*` function; a panic ends here.
pub fn guard<R>(name: &str, failed: R, body: impl FnOnce() -> R) -> R {
    match std::panic::catch_unwind(std::panic::AssertUnwindSafe(body)) {
        Ok(result) => result,
        Err(panic) => {
            log::error!(target: "tepui", "{name} failed inside the library: {}", crate::enter::message(&*panic));
            failed
        }
    }
}
