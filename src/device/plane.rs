//! Planes: the pixels of one buffer, colour or depth and stencil, shared by all that draw into it or read it: windows, renderbuffers,
//! levels of textures.

use std::any::Any;
use std::ops::{Deref, DerefMut};
use std::sync::{Arc, Mutex, MutexGuard};

use super::{ColorFormat, DepthFormat, SurfaceFormat};

/// What a plane stores.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PlaneFormat {
    /// Colours.
    Color(ColorFormat),
    /// Depth in the low 24 bits of a word, stencil in the high 8; floating-point depth in all of it.
    DepthStencil {
        /// Depth.
        depth: DepthFormat,
        /// 8 bits of stencil are there.
        stencil: bool,
    },
}

impl PlaneFormat {
    /// Words a sample.
    pub fn words(self) -> usize {
        match self {
            PlaneFormat::Color(color) => color.words(),
            PlaneFormat::DepthStencil { .. } => 1,
        }
    }
}

/// Where a device keeps a plane's pixels.
pub trait Storage: Send {
    /// Copies all samples to rows: all of sample 0 row by row, then all of sample 1, and so on.
    fn read(&mut self, rows: &mut [u32]);
    /// Copies all samples from rows.
    fn write(&mut self, rows: &[u32]);
    /// Itself, for its device.
    fn as_any(&mut self) -> &mut dyn Any;
}

/// Which copy of the pixels is ahead.
#[derive(Clone, Copy, PartialEq)]
enum Newer {
    Same,
    Storage,
    Rows,
}

/// The pixels of one buffer, on their device and, once somebody looks at them, in rows.
pub struct Plane {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Samples a pixel: 1, 2, 4, 8 or 16.
    pub samples: u32,
    /// What is stored.
    pub format: PlaneFormat,
    storage: Box<dyn Storage>,
    rows: Vec<u32>,
    newer: Newer,
    /// Grows with every change.
    version: u64,
    /// What the stencil of every pixel is, while that is known.
    uniform_stencil: Option<u8>,
}

/// A plane and who else holds it. Where two are locked at once, colour comes before depth.
pub type SharedPlane = Arc<Mutex<Plane>>;

impl Plane {
    /// Of zeros, as is its storage.
    pub fn new(size: [u32; 2], samples: u32, format: PlaneFormat, storage: Box<dyn Storage>) -> SharedPlane {
        Arc::new(Mutex::new(Plane {
            size,
            samples,
            format,
            storage,
            rows: Vec::new(),
            newer: Newer::Storage,
            version: 0,
            uniform_stencil: Some(0),
        }))
    }

    /// Grows whenever somebody may have changed the pixels.
    pub fn version(&self) -> u64 {
        self.version
    }

    fn changed(&mut self) {
        self.version += 1;
        self.uniform_stencil = None;
    }

    /// What the stencil of every pixel is, if that is known.
    pub fn uniform_stencil(&self) -> Option<u8> {
        self.uniform_stencil
    }

    /// Whoever changed the storage tells what is known of the stencil now.
    pub fn set_uniform_stencil(&mut self, stencil: Option<u8>) {
        self.uniform_stencil = stencil;
    }

    /// Words of all its samples.
    pub fn words(&self) -> usize {
        self.size[0] as usize * self.size[1] as usize * self.samples as usize * self.format.words()
    }

    /// The samples in rows: all of sample 0, row 0 first, then all of sample 1, and so on.
    pub fn rows(&mut self) -> &[u32] {
        if self.newer == Newer::Storage {
            let words = self.words();
            self.rows.resize(words, 0);
            self.storage.read(&mut self.rows);
            self.newer = Newer::Same;
        }
        &self.rows
    }

    /// The same, to change.
    pub fn rows_mut(&mut self) -> &mut [u32] {
        self.rows();
        self.newer = Newer::Rows;
        self.changed();
        &mut self.rows
    }

    /// Its storage, up to date; `None` on another device.
    pub fn storage<T: Any>(&mut self) -> Option<&mut T> {
        if self.newer == Newer::Rows {
            self.storage.write(&self.rows);
            self.newer = Newer::Same;
        }
        self.storage.as_any().downcast_mut()
    }

    /// Its storage, about to be changed.
    pub fn storage_mut<T: Any>(&mut self) -> Option<&mut T> {
        self.storage::<T>()?;
        self.newer = Newer::Storage;
        self.changed();
        self.storage.as_any().downcast_mut()
    }
}

/// Locks a plane; what a panic left is still pixels.
pub fn lock(plane: &SharedPlane) -> MutexGuard<'_, Plane> {
    plane.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}

/// What a surface draws into: planes of one size and number of samples.
#[derive(Clone)]
pub struct Target {
    /// Colour.
    pub color: SharedPlane,
    /// Depth and stencil.
    pub depth: Option<SharedPlane>,
    /// Columns and rows.
    pub size: [u32; 2],
    /// What it all stores.
    pub format: SurfaceFormat,
}

impl Target {
    /// Of planes of one size and number of samples.
    pub fn new(color: SharedPlane, depth: Option<SharedPlane>, top_first: bool) -> Target {
        let (size, samples, color_format) = {
            let plane = lock(&color);
            (plane.size, plane.samples, plane.format)
        };
        let color_format = match color_format {
            PlaneFormat::Color(format) => format,
            PlaneFormat::DepthStencil { .. } => unreachable!("a colour plane holds colour"),
        };
        let (depth_format, stencil) = match depth.as_ref().map(|plane| lock(plane).format) {
            Some(PlaneFormat::DepthStencil { depth, stencil }) => (depth, stencil),
            _ => (DepthFormat::None, false),
        };
        Target { color, depth, size, format: SurfaceFormat { color: color_format, depth: depth_format, stencil, top_first, samples } }
    }

    /// All pixels.
    pub fn pixels(&self) -> Pixels<'_> {
        let [width, height] = self.size;
        let colors = Pixels::of(&self.color, width, height, self.format);
        Pixels { depth_stencil: self.depth.as_ref().map_or(Rows::Nothing, Rows::of), ..colors }
    }
}

/// The colour of a target with one sample a pixel, kept until its samples change.
#[derive(Default)]
pub struct Resolved(Option<(SharedPlane, u64)>);

impl Resolved {
    /// The target's own plane where that has one sample; else one that `new` makes and `resolve` fills from the target's.
    pub fn of<'a>(
        &'a mut self,
        target: &'a Target,
        new: impl FnOnce() -> SharedPlane,
        resolve: impl FnOnce(&SharedPlane, &SharedPlane),
    ) -> &'a SharedPlane {
        if target.format.samples == 1 {
            return &target.color;
        }
        let version = lock(&target.color).version();
        // Of no version at first.
        let (plane, of) = self.0.get_or_insert_with(|| (new(), u64::MAX));
        if std::mem::replace(of, version) != version {
            resolve(&target.color, plane);
        }
        plane
    }
}

/// A locked plane's rows (see [`Plane::rows`]); whoever changes them makes them the newer copy.
pub enum Rows<'a> {
    /// There is no such plane.
    Nothing,
    /// Of a plane.
    Of(MutexGuard<'a, Plane>),
}

impl Rows<'_> {
    /// Up to date.
    fn of(plane: &SharedPlane) -> Rows<'_> {
        let mut plane = lock(plane);
        plane.rows();
        Rows::Of(plane)
    }
}

impl Deref for Rows<'_> {
    type Target = [u32];
    fn deref(&self) -> &[u32] {
        match self {
            Rows::Nothing => &[],
            Rows::Of(plane) => &plane.rows,
        }
    }
}

impl DerefMut for Rows<'_> {
    fn deref_mut(&mut self) -> &mut [u32] {
        match self {
            Rows::Nothing => &mut [],
            Rows::Of(plane) => plane.rows_mut(),
        }
    }
}

/// The pixels of a surface in host memory, row 0 first.
pub struct Pixels<'a> {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Storage.
    pub format: SurfaceFormat,
    /// `samples * width * height * format.color.words()` words, sample by sample.
    pub color: Rows<'a>,
    /// `samples * width * height` words (empty without depth and stencil): see [`DepthFormat`].
    pub depth_stencil: Rows<'a>,
}

impl Pixels<'_> {
    /// Colours without depth and stencil.
    pub(super) fn of(color: &SharedPlane, width: u32, height: u32, format: SurfaceFormat) -> Pixels<'_> {
        Pixels { width, height, format, color: Rows::of(color), depth_stencil: Rows::Nothing }
    }

    /// What has to be added to the index of a pixel for each of its samples.
    pub fn samples(&self) -> impl Iterator<Item = usize> + use<> {
        let pixels = self.width as usize * self.height as usize;
        (0..self.format.samples as usize).map(move |sample| sample * pixels)
    }
}
