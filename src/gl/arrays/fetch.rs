//! Reading client arrays: components of any type become f32 words of a vertex layout.

use std::mem::MaybeUninit;

use super::{Array, ComponentType};

/// How a component becomes an f32. Signed normalised ones map 0 to 0, as later versions of the specification have it (4.2,
/// equation 2.2) and Mesa does for arrays; table 2.9 of 2.1, which has no zero, still rules glNormal3b and its like.
trait Component: Copy {
    fn plain(self) -> f32;
    fn normalized(self) -> f32;
}

macro_rules! component {
    ($($ty:ty, $value:ident => $normalized:expr;)*) => {
        $(impl Component for $ty {
            #[inline(always)]
            fn plain(self) -> f32 {
                self as f32
            }
            #[inline(always)]
            fn normalized(self) -> f32 {
                let $value = self;
                $normalized
            }
        })*
    };
}
component! {
    i8, c => (c as f32 * (1.0 / 127.0)).max(-1.0);
    u8, c => c as f32 * (1.0 / 255.0);
    i16, c => (c as f32 * (1.0 / 32767.0)).max(-1.0);
    u16, c => c as f32 * (1.0 / 65535.0);
    i32, c => ((c as f64 * (1.0 / 2147483647.0)) as f32).max(-1.0);
    u32, c => (c as f64 * (1.0 / 4294967295.0)) as f32;
    f32, c => c;
    f64, c => c as f32;
}

/// Elements of an array to read: a range or a list.
#[derive(Clone, Copy)]
pub(super) enum Elements<'a> {
    Range { first: u32, count: u32 },
    List(&'a [u32]),
}

impl Elements<'_> {
    pub fn count(&self) -> u32 {
        match self {
            Elements::Range { count, .. } => *count,
            Elements::List(list) => list.len() as u32,
        }
    }
}

/// Reads elements of an array into `out`: element k to `out[offset + k * stride ..][..size]`, where nothing need have been before.
///
/// # Safety
/// The array's elements must be readable, as a client promises by drawing from them.
pub(super) unsafe fn fetch(array: &Array, elements: Elements, out: &mut [MaybeUninit<f32>], offset: usize, stride: usize) {
    // SAFETY: passed on.
    unsafe {
        match array.ty {
            ComponentType::Byte => by_size::<i8>(array, elements, out, offset, stride),
            ComponentType::UnsignedByte => by_size::<u8>(array, elements, out, offset, stride),
            ComponentType::Short => by_size::<i16>(array, elements, out, offset, stride),
            ComponentType::UnsignedShort => by_size::<u16>(array, elements, out, offset, stride),
            ComponentType::Int => by_size::<i32>(array, elements, out, offset, stride),
            ComponentType::UnsignedInt => by_size::<u32>(array, elements, out, offset, stride),
            ComponentType::Float => by_size::<f32>(array, elements, out, offset, stride),
            ComponentType::Double => by_size::<f64>(array, elements, out, offset, stride),
        }
    }
}

/// # Safety
/// See [`fetch`].
unsafe fn by_size<T: Component>(array: &Array, elements: Elements, out: &mut [MaybeUninit<f32>], offset: usize, stride: usize) {
    // SAFETY: passed on.
    unsafe {
        match (array.size, array.normalized) {
            (1, _) => run::<T, 1, false>(array, elements, out, offset, stride),
            (2, _) => run::<T, 2, false>(array, elements, out, offset, stride),
            (3, false) => run::<T, 3, false>(array, elements, out, offset, stride),
            (3, true) => run::<T, 3, true>(array, elements, out, offset, stride),
            (_, false) => run::<T, 4, false>(array, elements, out, offset, stride),
            (_, true) => run::<T, 4, true>(array, elements, out, offset, stride),
        }
    }
}

/// # Safety
/// See [`fetch`].
unsafe fn run<T: Component, const N: usize, const NORMALIZED: bool>(
    array: &Array,
    elements: Elements,
    out: &mut [MaybeUninit<f32>],
    offset: usize,
    stride: usize,
) {
    let step = array.step();
    let at = |index: u32| array.pointer.wrapping_add(index as usize * step);
    let read = |element: *const u8, place: &mut [MaybeUninit<f32>]| {
        // SAFETY: the client promises that the element is there; it need not be aligned.
        let values = unsafe { element.cast::<[T; N]>().read_unaligned() };
        let place = &mut place[offset..offset + N];
        for k in 0..N {
            place[k].write(if NORMALIZED { values[k].normalized() } else { values[k].plain() });
        }
    };
    let places = out.chunks_mut(stride);
    match elements {
        Elements::Range { first, count } => {
            let mut element = at(first);
            for place in places.take(count as usize) {
                read(element, place);
                element = element.wrapping_add(step);
            }
        }
        Elements::List(list) => places.zip(list).for_each(|(place, &index)| read(at(index), place)),
    }
}

/// Numbers as places to write to.
pub(super) fn places(numbers: &mut [f32]) -> &mut [MaybeUninit<f32>] {
    // SAFETY: the layout is the same, and whoever writes to such a place writes a number.
    unsafe { std::slice::from_raw_parts_mut(numbers.as_mut_ptr().cast(), numbers.len()) }
}

/// One element as an attribute: absent components read as (0, 0, 0, 1).
///
/// # Safety
/// See [`fetch`].
pub(super) unsafe fn element(array: &Array, index: u32) -> [f32; 4] {
    let mut value = [0.0, 0.0, 0.0, 1.0];
    // SAFETY: passed on.
    unsafe { fetch(array, Elements::Range { first: index, count: 1 }, places(&mut value), 0, 4) };
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strides_and_types_are_honoured() {
        let bytes: [u8; 12] = [255, 0, 51, 9, 0, 255, 102, 9, 1, 2, 3, 4];
        let array = Array { enabled: true, size: 3, ty: ComponentType::UnsignedByte, stride: 4, pointer: bytes.as_ptr(), normalized: true };
        let mut out = [7.0; 10];
        // SAFETY: two elements lie in `bytes`.
        unsafe { fetch(&array, Elements::List(&[1, 0]), places(&mut out), 1, 5) };
        // Bytes are scaled by the reciprocal, as llvmpipe fetches them: not always the float nearest to c / 255.
        let scaled = |c: f32| c * (1.0 / 255.0);
        assert_eq!(out, [7.0, 0.0, 1.0, scaled(102.0), 7.0, 7.0, 1.0, 0.0, scaled(51.0), 7.0]);
    }

    #[test]
    fn an_unaligned_double_array_is_read() {
        let mut bytes = vec![0u8];
        bytes.extend([1.5f64, -2.0].iter().flat_map(|v| v.to_ne_bytes()));
        let array = Array { enabled: true, size: 2, ty: ComponentType::Double, stride: 0, pointer: bytes[1..].as_ptr(), normalized: false };
        // SAFETY: the element lies in `bytes`.
        assert_eq!(unsafe { element(&array, 0) }, [1.5, -2.0, 0.0, 1.0]);
    }
}
