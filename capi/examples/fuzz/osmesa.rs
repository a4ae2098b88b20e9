//! The OSMesa functions among the calls: contexts come and go, and change buffers.

use std::ffi::{c_int, c_void};
use std::mem::transmute;

use crate::draw::Draw;

type Handle = *mut c_void;

/// The functions, and the contexts that live or have lived.
pub struct Osmesa {
    create: unsafe extern "C" fn(u32, c_int, c_int, c_int, Handle) -> Handle,
    destroy: unsafe extern "C" fn(Handle),
    make_current: unsafe extern "C" fn(Handle, *mut c_void, u32, c_int, c_int) -> u8,
    pixel_store: unsafe extern "C" fn(c_int, c_int),
    depth_buffer: unsafe extern "C" fn(Handle, *mut c_int, *mut c_int, *mut c_int, *mut *mut c_void) -> u8,
    handles: Vec<Handle>,
    buffer: Vec<u64>,
}

impl Osmesa {
    /// Finds the functions in the library.
    pub fn new(find: impl Fn(&str) -> *const c_void) -> Osmesa {
        // SAFETY: the addresses are those of the functions that GL/osmesa.h declares.
        unsafe {
            Osmesa {
                create: transmute::<*const c_void, _>(find("OSMesaCreateContextExt")),
                destroy: transmute::<*const c_void, _>(find("OSMesaDestroyContext")),
                make_current: transmute::<*const c_void, _>(find("OSMesaMakeCurrent")),
                pixel_store: transmute::<*const c_void, _>(find("OSMesaPixelStore")),
                depth_buffer: transmute::<*const c_void, _>(find("OSMesaGetDepthBuffer")),
                handles: Vec::new(),
                buffer: vec![0; 64 * 64 * 2 + 512],
            }
        }
    }

    fn any(&mut self, g: &mut Draw) -> Handle {
        match self.handles.len() {
            0 => std::ptr::null_mut(),
            n => self.handles[g.below(n)],
        }
    }

    /// Makes some context current on a buffer of some size.
    pub fn bind(&mut self, g: &mut Draw) {
        const PAIRS: [(u32, u32); 8] =
            [(0x1908, 0x1401), (0x1908, 0x1401), (1, 0x1401), (2, 0x1406), (0x1907, 0x1401), (0x1908, 0x1403), (5, 0x8363), (4, 0x1401)];
        let (format, kind) = PAIRS[g.below(8)];
        // Half of them share nothing, and a handle that is destroyed below makes none at all.
        let share = if g.one_in(2) { self.any(g) } else { std::ptr::null_mut() };
        let size = [1 + g.below(64) as c_int, 1 + g.below(64) as c_int];
        let bits = [[24, 8, 16], [24, 8, 0], [16, 0, 0], [0, 0, 0]][g.below(4)];
        g.start(&format!("OSMesaCreateContextExt and MakeCurrent {format:#x} {kind:#x} {size:?} {bits:?}"));
        g.ready();
        // SAFETY: the buffer has room for 64 x 64 pixels of 16 bytes; row lengths go to 64.
        unsafe {
            if self.handles.len() > 5 {
                (self.destroy)(self.handles.remove(0));
            }
            let mut handle = (self.create)(format, bits[0], bits[1], bits[2], share);
            if handle.is_null() {
                handle = (self.create)(format, bits[0], bits[1], bits[2], std::ptr::null_mut());
            }
            (self.make_current)(handle, self.buffer.as_mut_ptr().cast(), kind, size[0], size[1]);
            self.handles.push(handle);
        }
    }

    /// One of the smaller functions.
    pub fn other(&mut self, g: &mut Draw) {
        let which = g.below(5);
        let handle = self.any(g);
        let (size, value) = ([1 + g.below(64) as c_int, 1 + g.below(64) as c_int], g.below(68) as c_int - 3);
        g.start(&format!("OSMesa: other {which} {size:?} {value}"));
        g.ready();
        // SAFETY: as above; a handle that was destroyed is refused.
        unsafe {
            match which {
                0 => (self.pixel_store)(0x10, value.min(64)),
                1 => (self.pixel_store)(0x11, value & 1),
                2 => {
                    let (mut ints, mut pointer) = ([0; 3], std::ptr::null_mut());
                    let [w, h, b] = &mut ints;
                    (self.depth_buffer)(handle, w, h, b, &mut pointer);
                }
                3 => {
                    (self.make_current)(handle, self.buffer.as_mut_ptr().cast(), 0x1401, size[0], size[1]);
                }
                _ if g.one_in(8) => {
                    (self.make_current)(std::ptr::null_mut(), std::ptr::null_mut(), 0, 0, 0);
                }
                _ => {}
            }
        }
    }
}
