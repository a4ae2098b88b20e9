//! A window that shows Tepui's frames as they come: a lit torus that turns. winit makes the window, softbuffer puts the pixels
//! on it, Tepui draws them; nothing here is a graphics API.
//!
//! `cargo run --release --manifest-path examples/window/Cargo.toml`; with `-- 60` it closes after 60 frames.

use std::num::NonZeroU32;
use std::rc::Rc;
use std::time::Instant;

use tepui::gl::enums::*;
use tepui::gl::{Context, ContextConfig};
use winit::application::ApplicationHandler;
use winit::dpi::LogicalSize;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop};
use winit::window::{Window, WindowId};

type Surface = softbuffer::Surface<Rc<Window>, Rc<Window>>;

struct Show {
    gl: Context,
    window: Option<(Rc<Window>, Surface)>,
    frames: u32,
    limit: u32,
    start: Instant,
}

/// One frame of the turning torus into the context's window buffer.
fn draw(gl: &mut Context, width: u32, height: u32, seconds: f32) {
    let aspect = width as f64 / height as f64;
    gl.viewport(0, 0, width as i32, height as i32);
    gl.clear_color(0.13, 0.16, 0.2, 1.0);
    gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.matrix_mode(GL_PROJECTION);
    gl.load_identity();
    gl.frustum(-0.4 * aspect, 0.4 * aspect, -0.4, 0.4, 1.0, 20.0);
    gl.matrix_mode(GL_MODELVIEW);
    gl.load_identity();
    gl.light(GL_LIGHT0, GL_POSITION, &[2.0, 3.0, 4.0, 0.0]);
    gl.translate(0.0, 0.0, -5.0);
    gl.rotate(40.0 * seconds, 1.0, 0.3, 0.0);
    gl.rotate(25.0 * seconds, 0.0, 1.0, 0.0);
    for capability in [GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST, GL_COLOR_MATERIAL] {
        gl.enable(capability);
    }
    let turn = std::f32::consts::TAU;
    for i in 0..48 {
        gl.begin(GL_TRIANGLE_STRIP);
        for j in 0..=24 {
            for k in [1, 0] {
                let (sin_a, cos_a) = ((i + k) as f32 / 48.0 * turn).sin_cos();
                let (sin_b, cos_b) = (j as f32 / 24.0 * turn).sin_cos();
                gl.color(0.6 + 0.4 * cos_a, 0.5 + 0.3 * sin_b, 0.4, 1.0);
                gl.normal(cos_a * cos_b, sin_a * cos_b, sin_b);
                gl.vertex((1.1 + 0.45 * cos_b) * cos_a, (1.1 + 0.45 * cos_b) * sin_a, 0.45 * sin_b, 1.0);
            }
        }
        gl.end();
    }
    gl.finish();
}

impl Show {
    fn frame(&mut self, events: &ActiveEventLoop) -> Result<(), Box<dyn std::error::Error>> {
        let Some((window, surface)) = &mut self.window else { return Ok(()) };
        let size = window.inner_size();
        let (Some(width), Some(height)) = (NonZeroU32::new(size.width), NonZeroU32::new(size.height)) else { return Ok(()) };
        surface.resize(width, height)?;
        self.gl.attach_window(size.width, size.height);
        draw(&mut self.gl, size.width, size.height, self.start.elapsed().as_secs_f32());
        let mut shown = surface.buffer_mut()?;
        if let Some(drawn) = &mut self.gl.window {
            // Tepui stores red in the low byte, row 0 at the top; softbuffer wants blue there.
            for (to, from) in shown.iter_mut().zip(&drawn.pixels().color) {
                *to = (from & 0xff) << 16 | from & 0xff00 | (from >> 16) & 0xff;
            }
        }
        shown.present()?;
        self.frames += 1;
        if self.frames == self.limit {
            println!("{} frames in {:.2} s", self.frames, self.start.elapsed().as_secs_f32());
            events.exit();
        }
        window.request_redraw();
        Ok(())
    }
}

impl ApplicationHandler for Show {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        let attributes = Window::default_attributes().with_title("Tepui").with_inner_size(LogicalSize::new(640, 480));
        let made = events.create_window(attributes).map_err(Into::into).and_then(|window| -> Result<_, Box<dyn std::error::Error>> {
            let window = Rc::new(window);
            let context = softbuffer::Context::new(window.clone())?;
            let surface = Surface::new(&context, window.clone())?;
            Ok((window, surface))
        });
        match made {
            Ok(pair) => {
                pair.0.request_redraw();
                self.window = Some(pair);
            }
            Err(why) => {
                eprintln!("no window: {why}");
                events.exit();
            }
        }
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => events.exit(),
            WindowEvent::RedrawRequested => {
                if let Err(why) = self.frame(events) {
                    eprintln!("{why}");
                    events.exit();
                }
            }
            _ => {}
        }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let limit = std::env::args().nth(1).map_or(Ok(0), |n| n.parse())?;
    let events = EventLoop::new()?;
    events.set_control_flow(ControlFlow::Poll);
    let gl = Context::new(ContextConfig::default(), None);
    events.run_app(&mut Show { gl, window: None, frames: 0, limit, start: Instant::now() })?;
    Ok(())
}
