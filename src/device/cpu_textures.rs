//! Textures that the CPU executor keeps unpacked ([`Cells`]): small ones, from the second batch on that filters them, so that what is
//! drawn once is not unpacked for it.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use crate::draw::Batch;
use crate::raster::cells::{Cells, serves};

/// Most memory of all cells of a device, in bytes.
const MOST: usize = 16 << 20;
/// What no batch in so many has used is forgotten.
const MEMORY: u64 = 64;

/// Unpacked textures of a device.
#[derive(Default)]
pub struct Unpacked(Mutex<Known>);

#[derive(Default)]
struct Known {
    images: HashMap<u64, Entry>,
    /// Bytes of all cells.
    bytes: usize,
    /// Batches with textures so far.
    batches: u64,
}

struct Entry {
    /// The number of the last batch that used it.
    last: u64,
    cells: Option<Arc<Cells>>,
}

impl Unpacked {
    /// Of a batch's textures, those that are unpacked.
    pub fn of(&self, batch: &Batch) -> Vec<Option<Arc<Cells>>> {
        if !batch.textures.iter().any(|t| serves(&t.image, &t.sampler)) {
            return Vec::new();
        }
        let mut known = self.0.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        let Known { images, bytes, batches } = &mut *known;
        *batches += 1;
        let now = *batches;
        if now % MEMORY == 0 {
            images.retain(|_, entry| entry.last + MEMORY > now);
            *bytes = images.values().filter_map(|entry| entry.cells.as_ref()).map(|cells| cells.bytes()).sum();
        }
        let mut cells = |t: &crate::draw::texture::TextureBinding| {
            if !serves(&t.image, &t.sampler) {
                return None;
            }
            let entry = images.entry(t.image.id).or_insert(Entry { last: now, cells: None });
            let before = std::mem::replace(&mut entry.last, now);
            if entry.cells.is_none() && before < now && *bytes < MOST {
                entry.cells = t.image.levels.first().and_then(Cells::new).map(Arc::new);
                *bytes += entry.cells.as_ref().map_or(0, |cells| cells.bytes());
            }
            entry.cells.clone()
        };
        batch.textures.iter().map(&mut cells).collect()
    }
}
