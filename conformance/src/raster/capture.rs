//! The batches that the GL state machine makes of a scene's calls: a device that keeps what it is given.

use std::sync::{Arc, Mutex, PoisonError};

use tepui::device::cpu::CpuDevice;
use tepui::device::{Device, PlaneFormat, SharedPlane, Surface, Target};
use tepui::draw::Batch;
use tepui::gl::enums::*;
use tepui::gl::{Context, ContextConfig};

use super::scenes::{Change, Mode, Scene};

type Kept = Arc<Mutex<Vec<Batch>>>;

struct Keeper(Kept);

struct KeepingSurface {
    kept: Kept,
    target: Target,
}

impl Device for Keeper {
    fn name(&self) -> String {
        "keeps batches".into()
    }

    fn plane(&self, size: [u32; 2], samples: u32, format: PlaneFormat) -> SharedPlane {
        CpuDevice::new().plane(size, samples, format)
    }

    fn surface_on(&self, target: Target) -> Box<dyn Surface> {
        Box::new(KeepingSurface { kept: self.0.clone(), target })
    }
}

impl Surface for KeepingSurface {
    fn target(&self) -> &Target {
        &self.target
    }

    fn retarget(&mut self, target: Target) {
        self.target = target;
    }

    fn execute(&mut self, batch: Batch) {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner).push(batch);
    }

    fn resolved(&mut self) -> &SharedPlane {
        &self.target.color
    }
}

/// The batches of a frame of a scene without a texture, drawn by the calls that `client.rs` makes; the frame before it has found the sizes.
pub fn batches(scene: &Scene) -> Vec<Batch> {
    let kept = Kept::default();
    let mut cx = Context::new(ContextConfig::default(), None);
    cx.device = Arc::new(Keeper(kept.clone()));
    cx.attach_window(scene.size[0], scene.size[1]);
    if scene.mode.depth() {
        cx.enable(GL_DEPTH_TEST);
    }
    cx.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if scene.mode == Mode::Blend {
        cx.enable(GL_BLEND);
    }
    if scene.cull {
        cx.enable(GL_CULL_FACE);
    }
    if scene.change == Change::Tint {
        cx.enable(GL_COLOR_MATERIAL);
        cx.enable(GL_LIGHTING);
    }
    // SAFETY: the scene outlives the context's last draw.
    unsafe {
        cx.vertex_pointer(4, GL_FLOAT, 0, scene.positions.as_ptr().cast());
        cx.color_pointer(4, GL_UNSIGNED_BYTE, 0, scene.colors.as_ptr().cast());
    }
    cx.enable_client_state(GL_VERTEX_ARRAY);
    cx.enable_client_state(GL_COLOR_ARRAY);
    for _ in 0..2 {
        kept.lock().unwrap_or_else(PoisonError::into_inner).clear();
        cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw(&mut cx, scene);
        cx.flush_batch();
    }
    std::mem::take(&mut *kept.lock().unwrap_or_else(PoisonError::into_inner))
}

fn draw(cx: &mut Context, scene: &Scene) {
    let each = scene.indices.len() / scene.draws as usize;
    for (k, indices) in scene.indices.chunks(each).enumerate() {
        match scene.change {
            Change::None => {}
            Change::Tint => {
                let t = 1.0 - (k & 7) as f32 / 16.0;
                cx.light_model(GL_LIGHT_MODEL_AMBIENT, &[t, t, t, 1.0]);
            }
            Change::Blend if (k & 1 == 1) != (scene.mode == Mode::Blend) => cx.enable(GL_BLEND),
            Change::Blend => cx.disable(GL_BLEND),
        }
        // SAFETY: the arrays hold every vertex that the indices name.
        unsafe { cx.draw_elements(GL_TRIANGLES, indices.len() as i32, GL_UNSIGNED_INT, indices.as_ptr().cast()) };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::batch::batch;
    use crate::raster::bench::{difference, reference};

    #[test]
    fn what_the_state_machine_makes_is_the_batch_that_is_measured() {
        for name in ["S4", "S3"] {
            let size = [320, 200];
            let scene = Scene::named(name, size).expect("a scene");
            let kept = batches(&scene);
            assert_eq!(kept.len(), 1, "{name}");
            let made = reference(&kept[0], size).expect("a picture");
            let [coverage, _, color, depth] = difference(&made, &reference(&batch(&scene).expect("a batch"), size).expect("a picture"));
            // The state machine scales bytes by a rounded 1/255, and hundreds of blended layers carry that on; glClear clears depth always.
            assert!(coverage == 0 && color <= 2 && (depth == 0 || !scene.mode.depth()), "{name}: {coverage}, {color}, {depth}");
        }
    }

    #[test]
    fn a_change_of_state_makes_draws_and_none_does_not() {
        let count = |name: &str| batches(&Scene::named(name, [320, 200]).expect("a scene")).iter().map(|b| b.draws.len()).sum::<usize>();
        assert_eq!(count("draws/100/none"), 1, "neighbours with equal state are one draw");
        assert_eq!(count("draws/100/blend"), 100);
    }
}
