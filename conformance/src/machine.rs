//! What a report says about where it was made.

use std::process::Command;

use crate::build::root;

fn first_line(program: &str, arguments: &[&str]) -> String {
    let mut command = Command::new(program);
    // The program may have been carried to a machine without its sources.
    if root().is_dir() {
        command.current_dir(root());
    }
    let output = command.args(arguments).output();
    let text = output.map(|o| String::from_utf8_lossy(&o.stdout).into_owned()).unwrap_or_default();
    text.lines().next().map_or_else(|| "unknown".into(), str::to_owned)
}

/// Processor, cores, system, compiler, commit: name and value.
pub fn machine() -> Vec<(&'static str, String)> {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = cpu.lines().find_map(|l| l.strip_prefix("model name")?.split_once(':')).map_or("unknown", |(_, name)| name.trim());
    let cores = std::thread::available_parallelism().map_or(0, usize::from);
    let changed = if first_line("git", &["status", "--porcelain", "--untracked-files=no"]) == "unknown" { "" } else { ", changed" };
    vec![
        ("Processor", format!("{model}, {cores} cores")),
        ("System", first_line("uname", &["-srm"])),
        ("Compiler", first_line("rustc", &["--version"])),
        ("Commit", format!("{}{changed}", first_line("git", &["rev-parse", "--short", "HEAD"]))),
        ("Date", first_line("date", &["-u", "+%Y-%m-%d %H:%M UTC"])),
    ]
}
