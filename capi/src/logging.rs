//! `TEPUI_LOG=error|warn|info|debug|trace`: what the library says, on standard error.

use std::sync::Once;

struct Stderr;

impl log::Log for Stderr {
    fn enabled(&self, metadata: &log::Metadata) -> bool {
        // wgpu and naga speak through `log` too, and more than a GL programmer wants to hear.
        metadata.target().starts_with("tepui") || metadata.level() <= log::Level::Error
    }

    fn log(&self, record: &log::Record) {
        if self.enabled(record.metadata()) {
            eprintln!("tepui {}: {}", record.level().as_str().to_lowercase(), record.args());
        }
    }

    fn flush(&self) {}
}

/// Sets the log up, once a process. A program that has a logger of its own keeps it.
pub fn set_up() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let level = match std::env::var("TEPUI_LOG").unwrap_or_default().to_lowercase().as_str() {
            "off" => log::LevelFilter::Off,
            "error" => log::LevelFilter::Error,
            "info" => log::LevelFilter::Info,
            "debug" => log::LevelFilter::Debug,
            "trace" => log::LevelFilter::Trace,
            _ => log::LevelFilter::Warn,
        };
        if log::set_logger(&Stderr).is_ok() {
            log::set_max_level(level);
        }
    });
}
