//! Fixed function as a generator of programs: a compact key, which holds only what is enabled, becomes a WGSL text and so
//! a naga module. Programs are cached by key for the whole process.
//!
//! Every program lists the [`Slot`]s of its uniform block: the derived state fills them in that order.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Arc, LazyLock, Mutex};

use super::Program;

mod environment;
mod fragment;
mod lighting;
mod slots;
#[cfg(test)]
mod tests;
mod texgen;
mod text;
mod vertex;
mod window;

pub use environment::{Argument, Base, Combine, CombineSource, Function, Mode};
pub use fragment::{Fog, FragmentKey, Smooth, Source, UnitKey};
pub use lighting::{LightingKey, light, tracks};
pub use slots::Slot;
pub use texgen::{Generate, TexCoordKey};
pub use vertex::{FogCoord, Normal, VertexKey};
pub use window::{IMAGE_COORDINATES, window_program};

/// A program and the meaning of its uniform block.
pub struct FixedProgram {
    /// The program.
    pub program: Arc<Program>,
    /// What each vec4 of the block holds.
    pub slots: Vec<Slot>,
}

type Cache<K> = LazyLock<Mutex<HashMap<K, Arc<FixedProgram>>>>;

/// The vertex program of a key.
pub fn vertex_program(key: &VertexKey) -> Arc<FixedProgram> {
    static CACHE: Cache<VertexKey> = LazyLock::new(Default::default);
    cached(&CACHE, key, vertex::generate)
}

/// The fragment program of a key.
pub fn fragment_program(key: &FragmentKey) -> Arc<FixedProgram> {
    static CACHE: Cache<FragmentKey> = LazyLock::new(Default::default);
    cached(&CACHE, key, fragment::generate)
}

fn cached<K: Copy + Eq + Hash>(cache: &Cache<K>, key: &K, generate: fn(&K) -> FixedProgram) -> Arc<FixedProgram> {
    let mut map = cache.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    map.entry(*key).or_insert_with(|| Arc::new(generate(key))).clone()
}
