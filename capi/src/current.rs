//! Which context is current on which thread.
//!
//! A context belongs to one thread at a time. A thread that makes it current takes it from the thread that had it, whose commands
//! then do nothing; so one `Context` is never reached from two threads, however a program mixes them up, unless it calls
//! at the very moment of the change, which no GL allows.

use std::cell::{Cell, RefCell, UnsafeCell};
use std::ptr;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use tepui::gl::Context;

/// A context with its owner. Lives until the last thread that had it current has let go.
pub struct Holder {
    /// Mark of the thread that has it current, 0 for none.
    owner: AtomicUsize,
    /// `None` once it was destroyed.
    content: UnsafeCell<Option<Content>>,
}

/// What a handle stands for.
pub struct Content {
    /// The GL context.
    pub context: Context,
    /// The buffer that it draws for.
    pub target: crate::osmesa::Target,
}

// SAFETY: `content` is reached only by the thread that `owner` names, or, by `OSMesa*` functions, under the lock of all handles.
unsafe impl Sync for Holder {}
// SAFETY: as above; the addresses in it are the application's, which promises that they outlive the binding.
unsafe impl Send for Holder {}

thread_local! {
    /// What `enter` looks at: plain, without a destructor, so that the access is cheap.
    static CURRENT: Cell<*const Holder> = const { Cell::new(ptr::null()) };
    /// Keeps the holder of `CURRENT` alive and releases it when the thread ends.
    static KEEP: RefCell<Keep> = const { RefCell::new(Keep(None)) };
}

struct Keep(Option<Arc<Holder>>);

impl Drop for Keep {
    fn drop(&mut self) {
        if let Some(holder) = self.0.take() {
            holder.release(mark());
        }
    }
}

/// A number that no other living thread has.
fn mark() -> usize {
    CURRENT.with(|c| c.as_ptr() as usize)
}

impl Holder {
    /// Holds a new context that is current nowhere.
    pub fn new(content: Content) -> Holder {
        Holder { owner: AtomicUsize::new(0), content: UnsafeCell::new(Some(content)) }
    }

    fn release(&self, mark: usize) {
        let _ = self.owner.compare_exchange(mark, 0, Ordering::AcqRel, Ordering::Relaxed);
    }

    /// What it holds.
    ///
    /// # Safety
    /// The caller's thread owns the context, or no thread is inside a command on it.
    #[allow(clippy::mut_from_ref)]
    pub unsafe fn content(&self) -> Option<&mut Content> {
        // SAFETY: the caller's promise.
        unsafe { (*self.content.get()).as_mut() }
    }

    /// Drops the context; what still points here finds nothing.
    ///
    /// # Safety
    /// As for `content`.
    pub unsafe fn destroy(&self) {
        self.owner.store(0, Ordering::Release);
        // SAFETY: the caller's promise.
        drop(unsafe { (*self.content.get()).take() });
    }
}

/// Makes a context current on this thread, or none.
pub fn set(holder: Option<Arc<Holder>>) {
    let mark = mark();
    if let Some(new) = &holder {
        new.owner.store(mark, Ordering::Release);
    }
    CURRENT.with(|c| c.set(holder.as_ref().map_or(ptr::null(), Arc::as_ptr)));
    let old = KEEP.with(|k| k.try_borrow_mut().ok().and_then(|mut k| std::mem::replace(&mut k.0, holder.clone())));
    if let Some(old) = old
        && holder.is_none_or(|new| !Arc::ptr_eq(&old, &new))
    {
        old.release(mark);
    }
}

/// The holder that is current on this thread, if this thread still owns it.
pub fn holder() -> Option<Arc<Holder>> {
    let owned = KEEP.with(|k| k.try_borrow().ok().and_then(|k| k.0.clone()));
    owned.filter(|h| h.owner.load(Ordering::Acquire) == mark())
}

/// What is current on this thread. The pointer is good until the thread makes another call of the library.
#[inline]
pub fn content() -> Option<*mut Content> {
    CURRENT.with(|c| {
        let holder = c.get();
        if holder.is_null() {
            return None;
        }
        // SAFETY: `KEEP` holds the allocation as long as `CURRENT` names it.
        let holder = unsafe { &*holder };
        if holder.owner.load(Ordering::Relaxed) != c.as_ptr() as usize {
            return None;
        }
        // SAFETY: this thread owns it.
        unsafe { holder.content() }.map(ptr::from_mut)
    })
}
