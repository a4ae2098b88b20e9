//! Eight lanes at a time: the vocabulary of the CPU executor's inner loops, with two spellings that give the same bits.
//!
//! A kernel is one generic function, marked `#[inline(always)]`; [`Level`] says which spelling it is instantiated
//! with. The AVX2 spelling may only be reached through a function that enables `avx2,fma,popcnt`, which `dispatch!` makes.

use std::sync::OnceLock;

/// Operations on eight f32 or eight i32. A mask is eight i32, each 0 or -1.
#[allow(missing_docs)]
pub trait Simd: Copy + 'static {
    type F: Copy;
    type I: Copy;
    const LEVEL: Level;
    fn f(v: f32) -> Self::F;
    fn i(v: i32) -> Self::I;
    fn load(v: &[f32; 8]) -> Self::F;
    fn store(v: Self::F, to: &mut [f32; 8]);
    fn load_u(v: &[u32; 8]) -> Self::I;
    fn store_u(v: Self::I, to: &mut [u32; 8]);
    fn add(a: Self::F, b: Self::F) -> Self::F;
    fn sub(a: Self::F, b: Self::F) -> Self::F;
    fn mul(a: Self::F, b: Self::F) -> Self::F;
    fn div(a: Self::F, b: Self::F) -> Self::F;
    /// a * b + c, rounded once.
    fn fma(a: Self::F, b: Self::F, c: Self::F) -> Self::F;
    /// Clamp to low..=high; NaN becomes low.
    fn clamp(a: Self::F, low: Self::F, high: Self::F) -> Self::F;
    /// The smaller of a and high; NaN stays.
    fn at_most(a: Self::F, high: Self::F) -> Self::F;
    /// To the nearest integer, ties to even; out of range: i32::MIN.
    fn round(a: Self::F) -> Self::I;
    fn to_f(a: Self::I) -> Self::F;
    fn lt(a: Self::F, b: Self::F) -> Self::I;
    fn bits(a: Self::F) -> Self::I;
    fn from_bits(a: Self::I) -> Self::F;
    fn iadd(a: Self::I, b: Self::I) -> Self::I;
    fn isub(a: Self::I, b: Self::I) -> Self::I;
    /// Product, low half.
    fn imul(a: Self::I, b: Self::I) -> Self::I;
    fn and(a: Self::I, b: Self::I) -> Self::I;
    fn or(a: Self::I, b: Self::I) -> Self::I;
    fn xor(a: Self::I, b: Self::I) -> Self::I;
    /// !a & b
    fn andnot(a: Self::I, b: Self::I) -> Self::I;
    fn gt(a: Self::I, b: Self::I) -> Self::I;
    /// The greater.
    fn imax(a: Self::I, b: Self::I) -> Self::I;
    fn eq(a: Self::I, b: Self::I) -> Self::I;
    fn shl<const N: i32>(a: Self::I) -> Self::I;
    /// Logical shift right.
    fn shr<const N: i32>(a: Self::I) -> Self::I;
    /// Arithmetic shift right.
    fn sar<const N: i32>(a: Self::I) -> Self::I;
    /// Lane k is lane `from[k]`.
    fn permute(a: Self::I, from: &[u8; 8]) -> Self::I;
    /// mask ? a : b
    fn select(mask: Self::I, a: Self::I, b: Self::I) -> Self::I;
    /// Bit k: the sign of lane k.
    fn signs(a: Self::I) -> u32;
    /// 16-bit halves: product, low half.
    fn mul16(a: Self::I, b: Self::I) -> Self::I;
    /// 16-bit halves: sum.
    fn add16(a: Self::I, b: Self::I) -> Self::I;
    /// 16-bit halves: difference.
    fn sub16(a: Self::I, b: Self::I) -> Self::I;
    /// 16-bit halves: logical shift right.
    fn shr16<const N: i32>(a: Self::I) -> Self::I;
    /// 16-bit halves: minimum, as signed numbers.
    fn min16(a: Self::I, b: Self::I) -> Self::I;
    /// 16-bit halves: maximum, as signed numbers.
    fn max16(a: Self::I, b: Self::I) -> Self::I;
    /// Four components of a pixel to a byte each, the first lowest; below 0 becomes 0, above 255 becomes 255.
    fn bytes(c: [Self::I; 4]) -> Self::I;
    /// Two pixels of four components: those of a in the first four lanes.
    fn two(a: &[f32; 4], b: &[f32; 4]) -> Self::F;
    /// a in the first four lanes, b in the others.
    fn halves(a: f32, b: f32) -> Self::F;
    /// Lane k in the first four lanes, lane k + 4 in the others.
    fn spread(a: Self::F, k: usize) -> Self::F;
    /// Of integers in the form of `two`, pixels k and k + 4: eight pixels, clamped like [`Simd::bytes`].
    fn bytes_of_twos(c: [Self::I; 4]) -> Self::I;
    /// A mask of the lanes whose bit is set.
    fn mask(bits: u32) -> Self::I;
    /// Four planes (a0, d/dx, d/dy) at `count` places of a row: fma(y, dy, fma(x, dx, a0)). What follows them is anything.
    fn planes(planes: &[[f32; 4]; 3], x: &[f32; 8], y: f32, count: usize, to: &mut [[f32; 4]; 8]);
    /// Eight rows of four to four columns of eight.
    fn columns(rows: [&[f32; 4]; 8]) -> [Self::F; 4];
    /// Four columns of eight to eight rows of four.
    fn rows(columns: [Self::F; 4]) -> [[f32; 4]; 8];
    /// Bytes to lanes.
    fn extend(v: &[u8; 8]) -> Self::I;
    /// The first lanes spread, in their order, to those whose bit is set; the others are anything.
    fn expand(a: Self::I, bits: u32) -> Self::I;
    /// The numbers of the lanes whose bit is set, in their order, in the first lanes; the others are anything.
    fn set_lanes(bits: u32) -> Self::I;
    /// The lanes whose bit is set, in their order, in the first lanes; the others are anything.
    fn pack(a: Self::I, bits: u32) -> Self::I;
    /// Of each lane whose bit is set, how many of the lanes before it are.
    fn ranks(bits: u32) -> Self::I;
}

/// Eight columns of pixels from one on, or places in them.
#[inline(always)]
pub fn columns_from<S: Simd>(first: f32) -> S::F {
    S::add(S::f(first), S::load(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]))
}

/// Eight lanes of a column from any lane on.
#[inline(always)]
pub fn eight<T>(column: &[T], first: usize) -> &[T; 8] {
    column[first..][..8].try_into().expect("eight")
}

/// Eight lanes of a column, to write.
#[inline(always)]
pub fn eight_mut<T>(column: &mut [T], first: usize) -> &mut [T; 8] {
    (&mut column[first..][..8]).try_into().expect("eight")
}

/// For each mask of eight: the lanes whose bit is set, in their order.
pub(super) static SET_LANES: [[u8; 8]; 256] = set_lanes();

const fn set_lanes() -> [[u8; 8]; 256] {
    let mut table = [[0; 8]; 256];
    let mut bits = 0;
    while bits < 256 {
        let (mut lane, mut at) = (0, 0);
        while lane < 8 {
            if bits >> lane & 1 != 0 {
                table[bits][at] = lane as u8;
                at += 1;
            }
            lane += 1;
        }
        bits += 1;
    }
    table
}

/// For each mask of eight: which lane comes to which place, when lanes are expanded.
pub(super) static MOVES: [[u8; 8]; 256] = moves();

const fn moves() -> [[u8; 8]; 256] {
    let mut table = [[0; 8]; 256];
    let mut bits = 0;
    while bits < 256 {
        let (mut lane, mut at) = (0, 0);
        while lane < 8 {
            if bits >> lane & 1 != 0 {
                table[bits][lane] = at as u8;
                at += 1;
            }
            lane += 1;
        }
        bits += 1;
    }
    table
}

/// For each mask of eight: a byte a lane, all ones where the lane's bit is set.
pub(super) static MASKS: [[i8; 8]; 256] = masks();

const fn masks() -> [[i8; 8]; 256] {
    let mut table = [[0; 8]; 256];
    let mut bits = 0;
    while bits < 256 {
        let mut lane = 0;
        while lane < 8 {
            table[bits][lane] = -((bits >> lane & 1) as i8);
            lane += 1;
        }
        bits += 1;
    }
    table
}

/// Plain Rust, for any machine.
#[derive(Clone, Copy)]
pub struct Portable;

/// The numbers of the lanes.
const LANES: [usize; 8] = [0, 1, 2, 3, 4, 5, 6, 7];

// Written out: as loops, each of thousands that are inlined into one kernel, they take the compiler minutes.
#[inline(always)]
fn map<T: Copy, U>(a: [T; 8], f: impl Fn(T) -> U) -> [U; 8] {
    [f(a[0]), f(a[1]), f(a[2]), f(a[3]), f(a[4]), f(a[5]), f(a[6]), f(a[7])]
}
#[inline(always)]
fn zip<T: Copy, U>(a: [T; 8], b: [T; 8], f: impl Fn(T, T) -> U) -> [U; 8] {
    let lane = |k| f(a[k], b[k]);
    [lane(0), lane(1), lane(2), lane(3), lane(4), lane(5), lane(6), lane(7)]
}
#[inline(always)]
fn by_halves(a: i32, b: i32, f: impl Fn(u16, u16) -> u16) -> i32 {
    (f(a as u16, b as u16) as u32 | (f((a as u32 >> 16) as u16, (b as u32 >> 16) as u16) as u32) << 16) as i32
}

impl Simd for Portable {
    type F = [f32; 8];
    type I = [i32; 8];
    const LEVEL: Level = Level::Scalar;
    #[inline(always)]
    fn f(v: f32) -> Self::F {
        [v; 8]
    }
    #[inline(always)]
    fn i(v: i32) -> Self::I {
        [v; 8]
    }
    #[inline(always)]
    fn load(v: &[f32; 8]) -> Self::F {
        *v
    }
    #[inline(always)]
    fn store(v: Self::F, to: &mut [f32; 8]) {
        *to = v;
    }
    #[inline(always)]
    fn load_u(v: &[u32; 8]) -> Self::I {
        map(*v, |x| x as i32)
    }
    #[inline(always)]
    fn store_u(v: Self::I, to: &mut [u32; 8]) {
        *to = map(v, |x| x as u32);
    }
    #[inline(always)]
    fn add(a: Self::F, b: Self::F) -> Self::F {
        zip(a, b, |a, b| a + b)
    }
    #[inline(always)]
    fn sub(a: Self::F, b: Self::F) -> Self::F {
        zip(a, b, |a, b| a - b)
    }
    #[inline(always)]
    fn mul(a: Self::F, b: Self::F) -> Self::F {
        zip(a, b, |a, b| a * b)
    }
    #[inline(always)]
    fn div(a: Self::F, b: Self::F) -> Self::F {
        zip(a, b, |a, b| a / b)
    }
    // Without the instruction each lane is a call: one function of eight is enough code.
    #[cfg_attr(target_arch = "x86_64", inline(never))]
    #[cfg_attr(not(target_arch = "x86_64"), inline(always))]
    fn fma(a: Self::F, b: Self::F, c: Self::F) -> Self::F {
        map(LANES, |k| a[k].mul_add(b[k], c[k]))
    }
    #[inline(always)]
    fn clamp(a: Self::F, low: Self::F, high: Self::F) -> Self::F {
        zip(zip(a, low, |a, l| if a > l { a } else { l }), high, |a, h| if a < h { a } else { h })
    }
    #[inline(always)]
    fn at_most(a: Self::F, high: Self::F) -> Self::F {
        zip(a, high, |a, h| if h < a { h } else { a })
    }
    #[cfg_attr(target_arch = "x86_64", inline(never))]
    #[cfg_attr(not(target_arch = "x86_64"), inline(always))]
    fn round(a: Self::F) -> Self::I {
        map(a, |x| {
            let r = x.round_ties_even();
            if (-2147483648.0..2147483648.0).contains(&r) { r as i32 } else { i32::MIN }
        })
    }
    #[inline(always)]
    fn to_f(a: Self::I) -> Self::F {
        map(a, |x| x as f32)
    }
    #[inline(always)]
    fn lt(a: Self::F, b: Self::F) -> Self::I {
        zip(a, b, |a, b| -((a < b) as i32))
    }
    #[inline(always)]
    fn bits(a: Self::F) -> Self::I {
        map(a, |x| x.to_bits() as i32)
    }
    #[inline(always)]
    fn from_bits(a: Self::I) -> Self::F {
        map(a, |x| f32::from_bits(x as u32))
    }
    #[inline(always)]
    fn iadd(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, i32::wrapping_add)
    }
    #[inline(always)]
    fn isub(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, i32::wrapping_sub)
    }
    #[inline(always)]
    fn imul(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, i32::wrapping_mul)
    }
    #[inline(always)]
    fn and(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| a & b)
    }
    #[inline(always)]
    fn or(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| a | b)
    }
    #[inline(always)]
    fn xor(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| a ^ b)
    }
    #[inline(always)]
    fn andnot(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| !a & b)
    }
    #[inline(always)]
    fn gt(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| -((a > b) as i32))
    }
    #[inline(always)]
    fn imax(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, i32::max)
    }
    #[inline(always)]
    fn eq(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| -((a == b) as i32))
    }
    #[inline(always)]
    fn shl<const N: i32>(a: Self::I) -> Self::I {
        map(a, |x| x << N)
    }
    #[inline(always)]
    fn shr<const N: i32>(a: Self::I) -> Self::I {
        map(a, |x| (x as u32 >> N) as i32)
    }
    #[inline(always)]
    fn sar<const N: i32>(a: Self::I) -> Self::I {
        map(a, |x| x >> N)
    }
    #[inline(always)]
    fn permute(a: Self::I, from: &[u8; 8]) -> Self::I {
        map(*from, |from| a[from as usize & 7])
    }
    #[inline(always)]
    fn select(mask: Self::I, a: Self::I, b: Self::I) -> Self::I {
        map(LANES, |k| if mask[k] < 0 { a[k] } else { b[k] })
    }
    #[inline(always)]
    fn signs(a: Self::I) -> u32 {
        let sign = |k| (a[k] as u32 >> 31) << k;
        sign(0) | sign(1) | sign(2) | sign(3) | sign(4) | sign(5) | sign(6) | sign(7)
    }
    #[inline(always)]
    fn mul16(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| by_halves(a, b, u16::wrapping_mul))
    }
    #[inline(always)]
    fn add16(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| by_halves(a, b, u16::wrapping_add))
    }
    #[inline(always)]
    fn sub16(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| by_halves(a, b, u16::wrapping_sub))
    }
    #[inline(always)]
    fn shr16<const N: i32>(a: Self::I) -> Self::I {
        map(a, |a| by_halves(a, 0, |x, _| x >> N))
    }
    #[inline(always)]
    fn min16(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| by_halves(a, b, |x, y| (x as i16).min(y as i16) as u16))
    }
    #[inline(always)]
    fn max16(a: Self::I, b: Self::I) -> Self::I {
        zip(a, b, |a, b| by_halves(a, b, |x, y| (x as i16).max(y as i16) as u16))
    }
    #[inline(always)]
    fn bytes(c: [Self::I; 4]) -> Self::I {
        let byte = |c: i32| c.clamp(0, 255);
        map(LANES, |k| byte(c[0][k]) | byte(c[1][k]) << 8 | byte(c[2][k]) << 16 | byte(c[3][k]) << 24)
    }
    #[inline(always)]
    fn two(a: &[f32; 4], b: &[f32; 4]) -> Self::F {
        [a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]]
    }
    #[inline(always)]
    fn halves(a: f32, b: f32) -> Self::F {
        [a, a, a, a, b, b, b, b]
    }
    #[inline(always)]
    fn spread(a: Self::F, k: usize) -> Self::F {
        Self::halves(a[k & 3], a[k & 3 | 4])
    }
    #[inline(always)]
    fn bytes_of_twos(c: [Self::I; 4]) -> Self::I {
        let byte = |k: usize, byte: usize| c[k % 4][k / 4 * 4 + byte].clamp(0, 255) << (8 * byte);
        map(LANES, |k| byte(k, 0) | byte(k, 1) | byte(k, 2) | byte(k, 3))
    }
    #[inline(always)]
    fn mask(bits: u32) -> Self::I {
        map(MASKS[bits as usize & 255], i32::from)
    }
    #[inline(always)]
    fn planes(planes: &[[f32; 4]; 3], x: &[f32; 8], y: f32, count: usize, to: &mut [[f32; 4]; 8]) {
        for (to, x) in to.iter_mut().zip(x).take(count) {
            for c in 0..4 {
                to[c] = y.mul_add(planes[2][c], x.mul_add(planes[1][c], planes[0][c]));
            }
        }
    }
    #[inline(always)]
    fn columns(rows: [&[f32; 4]; 8]) -> [Self::F; 4] {
        let column = |c: usize| map(rows, |row| row[c]);
        [column(0), column(1), column(2), column(3)]
    }
    #[inline(always)]
    fn rows(columns: [Self::F; 4]) -> [[f32; 4]; 8] {
        map(LANES, |k| [columns[0][k], columns[1][k], columns[2][k], columns[3][k]])
    }
    #[inline(always)]
    fn extend(v: &[u8; 8]) -> Self::I {
        map(*v, i32::from)
    }
    #[inline(always)]
    fn expand(a: Self::I, bits: u32) -> Self::I {
        Self::permute(a, &MOVES[bits as usize & 255])
    }
    #[inline(always)]
    fn set_lanes(bits: u32) -> Self::I {
        map(SET_LANES[bits as usize & 255], i32::from)
    }
    #[inline(always)]
    fn pack(a: Self::I, bits: u32) -> Self::I {
        Self::permute(a, &SET_LANES[bits as usize & 255])
    }
    #[inline(always)]
    fn ranks(bits: u32) -> Self::I {
        map(MOVES[bits as usize & 255], i32::from)
    }
}

#[cfg(target_arch = "x86_64")]
pub use super::simd_avx2::Avx2;

/// Which spelling runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// [`Portable`]
    Scalar,
    /// `Avx2`
    Avx2,
}

impl Level {
    /// The best level of this machine.
    pub fn best() -> Level {
        static BEST: OnceLock<Level> = OnceLock::new();
        *BEST.get_or_init(|| {
            #[cfg(target_arch = "x86_64")]
            if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") && is_x86_feature_detected!("popcnt") {
                return Level::Avx2;
            }
            Level::Scalar
        })
    }

    /// What `TEPUI_SIMD=scalar|avx2|auto` asks for, as far as the machine has it.
    pub fn from_environment() -> Level {
        match std::env::var("TEPUI_SIMD").as_deref() {
            Ok("scalar") => Level::Scalar,
            _ => Level::best(),
        }
    }
}

/// Asks for the memory of a record that will be read soon.
#[inline(always)]
pub fn prefetch<T>(record: &T) {
    #[cfg(target_arch = "x86_64")]
    // SAFETY: SSE is part of x86-64, and a prefetch reads nothing.
    unsafe {
        std::arch::x86_64::_mm_prefetch::<{ std::arch::x86_64::_MM_HINT_T0 }>(std::ptr::from_ref(record).cast());
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = record;
}

/// Asks for memory that will be written after much else, in the second cache. The address may be any.
#[inline(always)]
pub fn prefetch_far<T>(address: *const T) {
    #[cfg(target_arch = "x86_64")]
    // SAFETY: SSE is part of x86-64, and a prefetch reads nothing and fails nowhere.
    unsafe {
        std::arch::x86_64::_mm_prefetch::<{ std::arch::x86_64::_MM_HINT_T1 }>(address.cast());
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = address;
}

/// Makes `fn name(level, args...)` of a generic `fn kernel<S: Simd>(args...)`, instantiated once a level.
#[macro_export]
#[doc(hidden)]
macro_rules! dispatch {
    ($(#[$m:meta])* $vis:vis fn $name:ident = $kernel:ident $(<$($l:lifetime),+>)? ($($a:ident: $t:ty),* $(,)?) $(-> $r:ty)?) => {
        $(#[$m])*
        $vis fn $name $(<$($l),+>)? (level: $crate::raster::simd::Level, $($a: $t),*) $(-> $r)? {
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx2,fma,popcnt")]
                fn wide $(<$($l),+>)? ($($a: $t),*) $(-> $r)? {
                    $kernel::<$crate::raster::simd::Avx2>($($a),*)
                }
                if level == $crate::raster::simd::Level::Avx2 && $crate::raster::simd::Level::best() == level {
                    // SAFETY: the features were detected just now.
                    return unsafe { wide($($a),*) };
                }
            }
            let _ = level;
            $kernel::<$crate::raster::simd::Portable>($($a),*)
        }
    };
}
