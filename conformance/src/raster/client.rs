//! A process that draws scenes with one implementation of OpenGL and serves them over its standard input and output, as the C scene
//! runner does: `about`, `open <scene> <width> <height> <samples>`, `frame`, `pixels <file>`, `close`.

use std::ffi::c_void;
use std::io::{BufRead, Write};
use std::time::Instant;

use clap::Args;

use super::gl::number::*;
use super::gl::{Buffers, Gl, Queries};
use super::scenes::{Change, Mode, Scene};
use super::target::{Driver, Target};
use crate::Error;

/// Options of the process.
#[derive(Args)]
pub struct Options {
    /// A library with the OSMesa interface; without it EGL is used.
    #[arg(long)]
    library: Option<String>,
}

/// A scene that is being drawn.
struct Open {
    scene: Scene,
    target: Target,
    gl: Gl,
    /// Time on the device.
    query: Option<(Queries, u32)>,
    /// Where the indices begin: in a buffer object or in memory.
    indices: *const c_void,
}

/// Milliseconds of a frame.
struct Times {
    /// Until it is finished.
    whole: f64,
    /// In the calls that draw.
    calls: f64,
    /// On the device, where it says so.
    device: Option<f64>,
}

fn open(driver: &Driver, request: &str) -> Result<Open, String> {
    let words: Vec<&str> = request.split_whitespace().collect();
    let [name, width, height, samples] = words[..] else { return Err("open <scene> <width> <height> <samples>".into()) };
    let number = |text: &str| text.parse::<u32>().map_err(|e| format!("{text}: {e}"));
    let size = [number(width)?, number(height)?];
    let scene = Scene::named(name, size)?;
    let target = driver.target(size, number(samples)?)?;
    let gl = Gl::load(&*driver.find)?;
    // Timer queries and buffer objects on EGL only: OSMesa has no device, and every OSMesa is given the same client arrays.
    let on_device = driver.is_egl();
    let query = if on_device { Queries::load(&*driver.find).ok() } else { None };
    let query = query.map(|q| {
        let mut name = 0;
        // SAFETY: a context is current.
        unsafe { (q.generate)(1, &mut name) };
        (q, name)
    });
    let buffers = if on_device { Some(Buffers::load(&*driver.find)?) } else { None };
    let mut open = Open { indices: scene.indices.as_ptr().cast(), scene, target, gl, query };
    open.arrays(buffers.as_ref());
    open.state();
    Ok(open)
}

/// 64 x 64 texels of blocks with noise, as a lit surface has them.
fn texels() -> Vec<u32> {
    let texel = |x: u32, y: u32| {
        let block = if (x / 8 + y / 8).is_multiple_of(2) { 0x40 } else { 0xb0 };
        let noise = (x.wrapping_mul(2654435761) ^ y.wrapping_mul(2246822519)) >> 27;
        let value = block + noise;
        value | value << 8 | (value / 2) << 16 | 0xff00_0000
    };
    (0..64 * 64).map(|k| texel(k % 64, k / 64)).collect()
}

impl Open {
    /// Says where the vertices are; with buffer objects they are sent to the device once.
    fn arrays(&mut self, buffers: Option<&Buffers>) {
        let Open { scene, gl, .. } = self;
        let place = |target: u32, bytes: &[u8]| -> *const c_void {
            let Some(b) = buffers else { return bytes.as_ptr().cast() };
            let mut name = 0;
            // SAFETY: a context is current, the data is as long as is said.
            unsafe {
                (b.generate)(1, &mut name);
                (b.bind)(target, name);
                (b.data)(target, bytes.len() as isize, bytes.as_ptr().cast(), STATIC_DRAW);
            }
            std::ptr::null()
        };
        // SAFETY: a context is current; the scene outlives every draw.
        unsafe {
            (gl.vertex_pointer)(4, FLOAT, 0, place(ARRAY_BUFFER, bytemuck::cast_slice(&scene.positions)));
            (gl.enable_client_state)(VERTEX_ARRAY);
            (gl.color_pointer)(4, UNSIGNED_BYTE, 0, place(ARRAY_BUFFER, bytemuck::cast_slice(&scene.colors)));
            (gl.enable_client_state)(COLOR_ARRAY);
            if !scene.coordinates.is_empty() {
                (gl.tex_coord_pointer)(2, FLOAT, 0, place(ARRAY_BUFFER, bytemuck::cast_slice(&scene.coordinates)));
                (gl.enable_client_state)(TEXTURE_COORD_ARRAY);
            } else {
                (gl.disable_client_state)(TEXTURE_COORD_ARRAY);
            }
            self.indices = place(ELEMENT_ARRAY_BUFFER, bytemuck::cast_slice(&scene.indices));
        }
    }

    /// The state of the scene; a context starts in GL's initial state.
    fn state(&self) {
        let Open { scene, gl, .. } = self;
        let switch = |on: bool, what: u32| {
            // SAFETY: a context is current, here and below.
            unsafe { if on { (gl.enable)(what) } else { (gl.disable)(what) } }
        };
        switch(scene.mode.depth(), DEPTH_TEST);
        switch(scene.mode == Mode::Blend, BLEND);
        switch(scene.cull, CULL_FACE);
        // A tint is the ambient light of the scene: what comes out of the vertex stage is colour times tint. Ambient and diffuse
        // colour follow glColor from the start.
        switch(scene.change == Change::Tint, COLOR_MATERIAL);
        switch(scene.change == Change::Tint, LIGHTING);
        switch(!scene.coordinates.is_empty(), TEXTURE_2D);
        let written = (scene.mode != Mode::DepthOnly) as u8;
        // SAFETY: see above; the texels are as many as is said.
        unsafe {
            (gl.viewport)(0, 0, scene.size[0] as i32, scene.size[1] as i32);
            (gl.depth_func)(LESS);
            (gl.blend_func)(SRC_ALPHA, ONE_MINUS_SRC_ALPHA);
            (gl.color_mask)(written, written, written, written);
            (gl.shade_model)(if scene.flat { FLAT } else { SMOOTH });
            if !scene.coordinates.is_empty() {
                (gl.tex_image)(TEXTURE_2D, 0, RGBA8 as i32, 64, 64, 0, RGBA, UNSIGNED_BYTE, texels().as_ptr().cast());
                (gl.tex_parameter)(TEXTURE_2D, TEXTURE_MIN_FILTER, LINEAR as i32);
                (gl.tex_parameter)(TEXTURE_2D, TEXTURE_MAG_FILTER, LINEAR as i32);
                (gl.tex_env)(TEXTURE_ENV, TEXTURE_ENV_MODE, MODULATE as i32);
            }
        }
    }

    /// Calls that draw; how many there are is [`calls`].
    fn draw(&self) {
        let Open { scene, gl, .. } = self;
        let each = scene.indices.len() / scene.draws as usize;
        for k in 0..scene.draws {
            // SAFETY: a context is current, and the arrays hold what the indices ask for.
            unsafe {
                match scene.change {
                    Change::None => {}
                    Change::Tint => {
                        let t = 1.0 - (k & 7) as f32 / 16.0;
                        (gl.light_model)(LIGHT_MODEL_AMBIENT, [t, t, t, 1.0].as_ptr());
                    }
                    Change::Blend => (if (k & 1 == 1) != (scene.mode == Mode::Blend) { gl.enable } else { gl.disable })(BLEND),
                }
                let at = self.indices.wrapping_byte_add(k as usize * each * 4);
                (gl.draw_elements)(TRIANGLES, each as i32, UNSIGNED_INT, at);
            }
        }
    }

    fn frame(&self) -> Times {
        let ms = |from: Instant| from.elapsed().as_secs_f64() * 1e3;
        let start = Instant::now();
        let gl = &self.gl;
        // SAFETY: a context is current.
        unsafe {
            if let Some((q, name)) = &self.query {
                (q.begin)(TIME_ELAPSED, *name);
            }
            (gl.clear_color)(0.0, 0.0, 0.0, 0.0);
            (gl.clear)(COLOR_AND_DEPTH);
            let before = Instant::now();
            self.draw();
            let calls = ms(before);
            self.target.resolve();
            let mut nanoseconds = 0;
            if let Some((q, _)) = &self.query {
                (q.end)(TIME_ELAPSED);
            }
            (gl.finish)();
            let whole = ms(start);
            if let Some((q, name)) = &self.query {
                (q.result)(*name, QUERY_RESULT, &mut nanoseconds);
            }
            Times { whole, calls, device: self.query.as_ref().map(|_| nanoseconds as f64 * 1e-6) }
        }
    }
}

/// GL calls that draw a scene: one a draw, and one a change of state.
pub fn calls(scene: &Scene) -> u32 {
    scene.draws * if scene.change == Change::None { 1 } else { 2 }
}

fn answer(driver: &Driver, open_scene: &mut Option<Open>, line: &str) -> Result<Vec<String>, String> {
    let (command, rest) = line.split_once(' ').unwrap_or((line, ""));
    match command {
        "about" => {
            let _target = driver.target([16, 16], 1)?;
            let gl = Gl::load(&*driver.find)?;
            Ok(vec![[VENDOR, RENDERER, VERSION].map(|s| gl.string(s)).join(" | ")])
        }
        "open" => {
            *open_scene = None;
            *open_scene = Some(open(driver, rest)?);
            Ok(Vec::new())
        }
        "frame" => {
            let open = open_scene.as_ref().ok_or("nothing is open")?;
            let times = open.frame();
            let calls = times.calls * 1e6 / calls(&open.scene) as f64;
            let mut lines = vec![format!("ms {}", times.whole), format!("call-ns {calls}")];
            lines.extend(times.device.map(|ms| format!("device-ms {ms}")));
            // SAFETY: a context is current.
            match unsafe { (open.gl.get_error)() } {
                0 => Ok(lines),
                error => Err(format!("GL error {error:#x}")),
            }
        }
        "pixels" => {
            let open = open_scene.as_ref().ok_or("nothing is open")?;
            std::fs::write(rest, bytemuck::cast_slice(&open.target.pixels(&open.gl))).map_err(|e| e.to_string())?;
            Ok(Vec::new())
        }
        "close" => {
            *open_scene = None;
            Ok(Vec::new())
        }
        _ => Err("unknown command".into()),
    }
}

/// Serves until its input ends.
pub fn main(options: &Options) -> Result<bool, Error> {
    let driver = match &options.library {
        Some(path) => Driver::osmesa(path),
        None => Driver::egl(),
    };
    let mut open = None;
    for line in std::io::stdin().lock().lines() {
        let outcome = driver.as_ref().map_err(String::clone).and_then(|d| answer(d, &mut open, line.as_ref().map_or("", |l| l.trim())));
        let mut out = std::io::stdout().lock();
        match outcome {
            Ok(lines) => {
                lines.iter().try_for_each(|l| writeln!(out, "{l}"))?;
                writeln!(out, "done")?;
            }
            Err(why) => writeln!(out, "error {}", why.replace('\n', " "))?,
        }
        out.flush()?;
    }
    Ok(true)
}
