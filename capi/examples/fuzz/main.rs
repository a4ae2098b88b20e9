//! Random calls with random arguments through the exported C symbols.
//!
//! ```text
//! cargo run --release -p tepui-capi --example fuzz -- --calls 1000000 [--seed 1]
//! cargo run --release -p tepui-capi --example fuzz -- --one 7 --calls 50000 --trace   # one seed, every call on standard output
//! ```
//! With `--stats` a seed says how often each command was called, and how often without an error.
//!
//! A seed is 50,000 calls in a process of its own, with bounded memory (4 GiB of addresses, 1 GiB resident) and time (120 seconds).
//! A crash, a hang, too much memory, and a panic that the border had to stop are failures; the seed and the last call are named.
//! The library is `libOSMesa.so` beside this program's folder, or what `TEPUI_LIBRARY` names.

mod calls;
mod draw;
mod osmesa;

use std::collections::HashMap;
use std::ffi::{CString, c_int, c_void};
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use calls::CALLS;
use draw::Draw;
use osmesa::Osmesa;

/// Calls of one seed.
const CHUNK: usize = 50_000;
const ADDRESSES: u64 = 4 << 30;
const RESIDENT_KB: u64 = 1 << 20;
const TIME: Duration = Duration::from_secs(120);

/// Drawn more often than the others, so that things get drawn: the calls that open, fill and close.
const HOT: &[&str] = &[
    "glBegin",
    "glBegin",
    "glEnd",
    "glEnd",
    "glEnd",
    "glEnd",
    "glEnd",
    "glEndList",
    "glVertex2f",
    "glVertex3f",
    "glVertex4fv",
    "glVertex2dv",
    "glColor4f",
    "glColor3ub",
    "glTexCoord2f",
    "glNormal3f",
    "glEndList",
    "glNewList",
    "glEnable",
    "glEnable",
    "glEnable",
    "glDisable",
    "glDrawArrays",
    "glDrawArrays",
    "glDrawElements",
    "glRenderMode",
    "glClear",
    "glTexImage2D",
    "glTexImage1D",
    "glTexSubImage2D",
    "glBindTexture",
    "glPushMatrix",
    "glPopMatrix",
    "glLoadIdentity",
    "glPopAttrib",
    "glPushAttrib",
    "glEnableClientState",
    "glVertexPointer",
    "glColorPointer",
    "glInterleavedArrays",
    "glFlush",
    "glDrawPixels",
    "glBitmap",
    "glReadPixels",
    "glCopyPixels",
    "glCopyTexImage2D",
    "glCopyTexSubImage2D",
    "glPixelStorei",
    "glTexParameteri",
    "glTexEnvi",
    "glRasterPos2f",
    "glViewport",
    "glCallList",
    "glEvalMesh2",
    "glMap2f",
    "glEvalCoord2f",
    "glAccum",
    "glLightfv",
    "glMaterialfv",
    "glFogf",
    "glTexGeni",
    "glClipPlane",
    "glPolygonMode",
    "glBlendFunc",
    "glStencilFunc",
    "glStencilOp",
    "glAlphaFunc",
    "glLogicOp",
    "glLineStipple",
    "glLineWidth",
    "glPointSize",
    "glPixelZoom",
    "glPixelTransferf",
    "glPixelMapfv",
    "glFeedbackBuffer",
    "glSelectBuffer",
    "glRotatef",
    "glScalef",
    "glTranslatef",
    "glFrustum",
    "glMatrixMode",
    "glDepthFunc",
    "glCullFace",
    "glShadeModel",
    "glGetTexImage",
    "glActiveTexture",
    "glBlendEquation",
    "glPolygonOffset",
    "glScissor",
    "glLightModeli",
    "glMapGrid2f",
];

/// The call that is being made, for the message of a crash.
static NOW: AtomicUsize = AtomicUsize::new(0);
static MADE: AtomicUsize = AtomicUsize::new(0);

extern "C" fn crashed(signal: c_int) {
    let name = CALLS.get(NOW.load(Ordering::Relaxed)).map_or("OSMesa", |c| c.0);
    eprintln!("signal {signal} in {name}, call {}", MADE.load(Ordering::Relaxed));
    // SAFETY: ends the process.
    unsafe { libc::_exit(3) };
}

fn library() -> PathBuf {
    std::env::var_os("TEPUI_LIBRARY").map(PathBuf::from).unwrap_or_else(|| {
        let own = std::env::current_exe().unwrap_or_default();
        own.ancestors().nth(2).unwrap_or(&own).join("libOSMesa.so")
    })
}

/// Makes the calls of one seed in this process.
fn one(seed: u64, calls: usize, trace: bool, stats: bool) {
    let path = CString::new(library().to_string_lossy().as_bytes()).unwrap_or_default();
    // SAFETY: plain use of the C library.
    let handle = unsafe {
        let limit = libc::rlimit { rlim_cur: ADDRESSES, rlim_max: ADDRESSES };
        libc::setrlimit(libc::RLIMIT_AS, &limit);
        for signal in [libc::SIGSEGV, libc::SIGBUS, libc::SIGFPE, libc::SIGILL, libc::SIGABRT] {
            libc::signal(signal, crashed as extern "C" fn(c_int) as *const () as libc::sighandler_t);
        }
        libc::dlopen(path.as_ptr(), libc::RTLD_NOW)
    };
    assert!(!handle.is_null(), "{path:?} cannot be loaded: build it with `cargo build --release -p tepui-capi`");
    let find = |name: &str| -> *const c_void {
        let name = CString::new(name).unwrap_or_default();
        // SAFETY: the handle is open.
        unsafe { libc::dlsym(handle, name.as_ptr()) }
    };
    let addresses: Vec<*const c_void> = CALLS.iter().map(|(name, _)| find(name)).collect();
    let index: HashMap<&str, usize> = CALLS.iter().enumerate().map(|(i, (name, _))| (*name, i)).collect();
    let hot: Vec<usize> = HOT.iter().map(|name| index[name]).collect();
    let mut draw = Draw::new(seed);
    draw.trace = trace;
    let g = &mut draw;
    let mut contexts = Osmesa::new(find);
    let mut counts = vec![[0u32; 2]; CALLS.len()];
    // SAFETY: glGetError takes nothing and returns an enum.
    let error = || unsafe { std::mem::transmute::<*const c_void, unsafe extern "C" fn() -> u32>(find("glGetError"))() };
    // A list that is left open would let later lists grow beyond what `Draw::list` allows.
    let (end, end_list) = (find("glEnd"), find("glEndList"));
    let close = || {
        // SAFETY: both take and return nothing.
        let call = |address| unsafe { std::mem::transmute::<*const c_void, unsafe extern "C" fn()>(address)() };
        call(end);
        call(end_list);
    };
    // Random state seldom lets anything through to the picture: now and then the way is cleared.
    let calm = || {
        close();
        // SAFETY: the types are those of the commands.
        unsafe {
            let of = |name| find(name);
            std::mem::transmute::<_, unsafe extern "C" fn(u32) -> i32>(of("glRenderMode"))(0x1c00);
            std::mem::transmute::<_, unsafe extern "C" fn(i32, i32, i32, i32)>(of("glViewport"))(0, 0, 48, 48);
            std::mem::transmute::<_, unsafe extern "C" fn(u32)>(of("glDrawBuffer"))(0x404);
            std::mem::transmute::<_, unsafe extern "C" fn(u8, u8, u8, u8)>(of("glColorMask"))(1, 1, 1, 1);
            std::mem::transmute::<_, unsafe extern "C" fn(u32)>(of("glDisable"))(0x0c11);
            for mode in [0x1701, 0x1700] {
                std::mem::transmute::<_, unsafe extern "C" fn(u32)>(of("glMatrixMode"))(mode);
                std::mem::transmute::<_, unsafe extern "C" fn()>(of("glLoadIdentity"))();
            }
        }
    };
    for made in 0..calls {
        MADE.store(made, Ordering::Relaxed);
        NOW.store(usize::MAX, Ordering::Relaxed);
        if made % 500 == 0 {
            close();
            g.compiling = None;
            contexts.bind(g);
        } else if g.one_in(200) {
            contexts.other(g);
            close();
            g.compiling = None;
        }
        if g.one_in(30) {
            calm();
            g.compiling = None;
        }
        let which = if !g.one_in(4) { hot[g.below(hot.len())] } else { g.below(CALLS.len()) };
        let (name, call) = CALLS[which];
        if g.compiling.is_some() && name == "glCallLists" {
            continue;
        }
        g.start(name);
        NOW.store(which, Ordering::Relaxed);
        call(addresses[which], g);
        if stats {
            counts[which][0] += 1;
            counts[which][1] += (error() == 0) as u32;
        }
        match name {
            // It may have failed: then this is more careful than it must be.
            "glNewList" if g.last_list == 1 => g.compiling = Some(1),
            "glNewList" => g.compiling = g.compiling.or(Some(g.last_list)),
            "glEndList" => {
                close();
                g.compiling = None;
            }
            _ => {}
        }
    }
    for (count, (name, _)) in counts.iter().zip(&CALLS).filter(|_| stats) {
        println!("{name} {} {}", count[0], count[1]);
    }
    println!("peak {} kB", resident());
}

/// Largest resident size so far.
fn resident() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:")).unwrap_or_default();
    line.split_whitespace().next().and_then(|n| n.parse().ok()).unwrap_or(0)
}

/// Runs a seed in a process of its own: what is wrong with it, and its peak size.
fn chunk(seed: u64, calls: usize) -> Result<u64, String> {
    let own = std::env::current_exe().map_err(|e| e.to_string())?;
    let mut command = Command::new(own);
    command.args(["--one", &seed.to_string(), "--calls", &calls.to_string()]).env("TEPUI_LOG", "error");
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().map_err(|e| e.to_string())?;
    let errors = child.stderr.take();
    // Read while it runs, so that a talkative child never blocks.
    let reader = std::thread::spawn(move || errors.map(std::io::read_to_string).and_then(Result::ok).unwrap_or_default());
    let start = Instant::now();
    let status = loop {
        match child.try_wait().map_err(|e| e.to_string())? {
            Some(status) => break status,
            None if start.elapsed() > TIME => {
                let _ = child.kill();
                let _ = child.wait();
                return Err("hangs".to_string());
            }
            None => std::thread::sleep(Duration::from_millis(20)),
        }
    };
    let output = child.stdout.take().map(std::io::read_to_string).and_then(Result::ok).unwrap_or_default();
    let errors = reader.join().unwrap_or_default();
    let stopped: Vec<&str> = errors.lines().filter(|l| l.contains("failed inside the library") || l.contains("panicked at")).collect();
    if !status.success() {
        return Err(format!("{status}: {}", errors.lines().rev().take(4).collect::<Vec<_>>().join(" | ")));
    }
    if !stopped.is_empty() {
        let mut distinct = stopped.clone();
        distinct.sort_unstable();
        distinct.dedup();
        return Err(format!(
            "{} lines of panics:\n    {}",
            stopped.len(),
            distinct.into_iter().take(12).collect::<Vec<_>>().join("\n    ")
        ));
    }
    let peak = output.split_whitespace().nth(1).and_then(|n| n.parse().ok()).unwrap_or(u64::MAX);
    if peak > RESIDENT_KB { Err(format!("takes {peak} kB")) } else { Ok(peak) }
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let value =
        |name: &str| arguments.iter().position(|a| a == name).and_then(|i| arguments.get(i + 1)).and_then(|v| v.parse::<u64>().ok());
    let calls = value("--calls").unwrap_or(CHUNK as u64) as usize;
    if let Some(seed) = value("--one") {
        let has = |name: &str| arguments.iter().any(|a| a == name);
        one(seed, calls, has("--trace"), has("--stats"));
        return ExitCode::SUCCESS;
    }
    let first = value("--seed").unwrap_or(1);
    let (mut failures, mut most) = (0, 0);
    for (k, done) in (0..calls).step_by(CHUNK).enumerate() {
        let seed = first + k as u64;
        match chunk(seed, CHUNK.min(calls - done)) {
            Ok(peak) => most = most.max(peak),
            Err(what) => {
                failures += 1;
                println!("seed {seed}: {what}");
            }
        }
    }
    println!("{calls} calls, {failures} seeds failed, at most {most} kB resident");
    if failures == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
