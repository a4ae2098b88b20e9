//! Making and destroying contexts.

use std::ffi::c_int;

use tepui::device::samples;
use tepui::gl::enums::{GL_UNSIGNED_BYTE, GLenum};
use tepui::gl::{Context, ContextConfig, Parity};

use super::format::Format;
use super::handle::{self, Handle};
use super::{Target, guard};
use crate::current::{Content, Holder};

const FORMAT: c_int = 0x22;
const DEPTH_BITS: c_int = 0x30;
const STENCIL_BITS: c_int = 0x31;
const ACCUM_BITS: c_int = 0x32;
const PROFILE: c_int = 0x33;
const CORE_PROFILE: c_int = 0x34;
const COMPAT_PROFILE: c_int = 0x35;
const MAJOR_VERSION: c_int = 0x36;
const MINOR_VERSION: c_int = 0x37;
/// Tepui's own: see GL/osmesa.h.
const SAMPLES: c_int = 0x7e01;

/// What a context is asked for.
struct Request {
    format: GLenum,
    depth: c_int,
    stencil: c_int,
    accum: c_int,
    samples: c_int,
}

fn create(request: &Request, share: Handle) -> Option<Handle> {
    crate::logging::set_up();
    let format = Format::from_enum(request.format)?;
    if request.depth < 0 || request.stencil < 0 || request.accum < 0 {
        return None;
    }
    let samples = u32::try_from(request.samples).ok().and_then(samples::supported)?;
    let config = ContextConfig {
        samples,
        depth_bits: match request.depth {
            0 => 0,
            // Depth with stencil is always 24 bits, as with Mesa.
            1..=16 if request.stencil == 0 => 16,
            _ => 24,
        },
        stencil_bits: if request.stencil > 0 { 8 } else { 0 },
        accum_bits: if request.accum > 0 { 16 } else { 0 },
        parity: Parity::from_environment(),
        ..ContextConfig::default()
    };
    let shared = if share.is_null() { None } else { Some(handle::get(share)?) };
    // SAFETY: the program may not use the shared context in another thread during this call.
    let shared = shared.as_ref().and_then(|holder| unsafe { holder.content() });
    let context = Context::new(config, shared.map(|content| &content.context));
    let target = Target { format, kind: GL_UNSIGNED_BYTE, address: 0, width: 0, height: 0, row_length: 0, y_up: true, depth: Vec::new() };
    Some(handle::insert(Holder::new(Content { context, target })))
}

/// A context with 24 bits of depth, 8 of stencil and no accumulation buffer. NULL on a bad format.
///
/// # Safety
/// A function of the C ABI: see GL/osmesa.h.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaCreateContext(format: GLenum, sharelist: Handle) -> Handle {
    let request = Request { format, depth: 24, stencil: 8, accum: 0, samples: 0 };
    guard("OSMesaCreateContext", None, || create(&request, sharelist)).unwrap_or(std::ptr::null_mut())
}

/// A context with at least these bits of depth (at most 24), stencil (8) and accumulation (16).
///
/// # Safety
/// A function of the C ABI: see GL/osmesa.h.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaCreateContextExt(format: GLenum, depth: c_int, stencil: c_int, accum: c_int, sharelist: Handle) -> Handle {
    let request = Request { format, depth, stencil, accum, samples: 0 };
    guard("OSMesaCreateContextExt", None, || create(&request, sharelist)).unwrap_or(std::ptr::null_mut())
}

/// Versions that there are, up to ours.
fn is_version(major: c_int, minor: c_int) -> bool {
    // A minor number that 1.x never had is no error with Mesa.
    major == 1 && minor >= 0 || major == 2 && (0..=1).contains(&minor)
}

fn create_from_list(list: &[(c_int, c_int)], sharelist: Handle) -> Option<Handle> {
    let mut request = Request { format: 0x1908, depth: 0, stencil: 0, accum: 0, samples: 0 };
    let (mut major, mut minor) = (1, 0);
    for &(attribute, value) in list {
        match attribute {
            FORMAT => request.format = value as GLenum,
            DEPTH_BITS => request.depth = value,
            STENCIL_BITS => request.stencil = value,
            ACCUM_BITS => request.accum = value,
            SAMPLES => request.samples = value,
            PROFILE if value == CORE_PROFILE || value == COMPAT_PROFILE => {}
            PROFILE => return None,
            MAJOR_VERSION => major = value,
            MINOR_VERSION => minor = value,
            _ => {
                crate::logging::set_up();
                log::warn!(target: "tepui", "OSMesaCreateContextAttribs: unknown attribute {attribute:#x}");
                return None;
            }
        }
    }
    // The core profile begins with 3.2: up to 2.1 there is but one profile, and both names mean it.
    is_version(major, minor).then(|| create(&request, sharelist)).flatten()
}

/// A context from a list of attributes and values that ends with 0. NULL on what is unknown or not supported.
///
/// # Safety
/// `attributes` is NULL or such a list.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaCreateContextAttribs(attributes: *const c_int, sharelist: Handle) -> Handle {
    let mut list = Vec::new();
    let mut at = attributes;
    // No attribute but 0 ends a list; a longer one than this has none.
    while !at.is_null() && list.len() < 64 {
        // SAFETY: the caller's promise.
        let attribute = unsafe { *at };
        if attribute == 0 {
            break;
        }
        // SAFETY: a value follows each attribute.
        list.push((attribute, unsafe { *at.add(1) }));
        // SAFETY: within the list, as its end was not seen yet.
        at = unsafe { at.add(2) };
    }
    guard("OSMesaCreateContextAttribs", None, || create_from_list(&list, sharelist)).unwrap_or(std::ptr::null_mut())
}

/// Destroys a context; if it is current, no context is current then. What was drawn and not flushed is lost, as with Mesa.
///
/// # Safety
/// No other thread is inside a command on the context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaDestroyContext(context: Handle) {
    guard("OSMesaDestroyContext", (), || {
        let Some(holder) = handle::remove(context) else { return };
        if crate::current::holder().is_some_and(|current| std::sync::Arc::ptr_eq(&current, &holder)) {
            crate::current::set(None);
        }
        // SAFETY: the caller's promise.
        unsafe { holder.destroy() };
    });
}
