//! Handles: what C calls `OSMesaContext`.

use std::collections::HashMap;
use std::ffi::c_void;
use std::sync::{Arc, Mutex, MutexGuard};

use crate::current::Holder;

/// `OSMesaContext`
pub type Handle = *mut c_void;

/// Every living handle, so that a stale one is an error and not a crash.
static HANDLES: Mutex<Option<HashMap<usize, Arc<Holder>>>> = Mutex::new(None);

fn all() -> MutexGuard<'static, Option<HashMap<usize, Arc<Holder>>>> {
    HANDLES.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}

/// The handle of a holder.
pub fn of(holder: &Arc<Holder>) -> Handle {
    Arc::as_ptr(holder) as Handle
}

/// A handle for a new context.
pub fn insert(holder: Holder) -> Handle {
    let holder = Arc::new(holder);
    let handle = of(&holder);
    all().get_or_insert_default().insert(handle as usize, holder);
    handle
}

/// What a handle stands for.
pub fn get(handle: Handle) -> Option<Arc<Holder>> {
    all().as_ref()?.get(&(handle as usize)).cloned()
}

/// Forgets a handle.
pub fn remove(handle: Handle) -> Option<Arc<Holder>> {
    all().as_mut()?.remove(&(handle as usize))
}
