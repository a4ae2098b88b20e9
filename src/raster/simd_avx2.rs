//! The AVX2 spelling of [`Simd`](super::simd::Simd).

use super::simd::{Level, MASKS, MOVES, SET_LANES, Simd};

/// AVX2 and FMA.
#[derive(Clone, Copy)]
pub struct Avx2;

/// Spells an operation as one intrinsic.
macro_rules! op {
    ($name:ident($($a:ident: $t:ty),*) -> $r:ty, $e:expr) => {
        #[inline(always)]
        fn $name($($a: $t),*) -> $r {
            // SAFETY: only reached from functions that enable avx2,fma, and those only after detection.
            unsafe { $e }
        }
    };
}

/// Lane k becomes lane `from[k]`.
///
/// # Safety
/// The machine has AVX2.
#[inline(always)]
unsafe fn permute(a: std::arch::x86_64::__m256, from: &[u8; 8]) -> std::arch::x86_64::__m256 {
    use std::arch::x86_64::*;
    // SAFETY: the caller's promise; the load reads the eight bytes.
    unsafe { _mm256_permutevar8x32_ps(a, _mm256_cvtepu8_epi32(_mm_loadl_epi64(from.as_ptr().cast()))) }
}

/// By the signs of the mask, a or b: the instruction itself. The intrinsic is a comparison and a selection to the compiler, which
/// makes masked stores of selections that are stored (they take ten times as long on some processors) and keeps masks as bits that
/// it packs and unpacks from branch to branch.
///
/// # Safety
/// The machine has AVX2.
#[target_feature(enable = "avx2")]
#[inline]
unsafe fn select(
    mask: std::arch::x86_64::__m256i,
    a: std::arch::x86_64::__m256i,
    b: std::arch::x86_64::__m256i,
) -> std::arch::x86_64::__m256i {
    let result;
    // SAFETY: registers to a register.
    unsafe {
        std::arch::asm!(
            "vblendvps {result}, {b}, {a}, {mask}",
            result = lateout(ymm_reg) result,
            a = in(ymm_reg) a,
            b = in(ymm_reg) b,
            mask = in(ymm_reg) mask,
            options(pure, nomem, nostack, preserves_flags)
        );
    }
    result
}

impl Simd for Avx2 {
    type F = std::arch::x86_64::__m256;
    type I = std::arch::x86_64::__m256i;
    const LEVEL: Level = Level::Avx2;
    op!(f(v: f32) -> Self::F, std::arch::x86_64::_mm256_set1_ps(v));
    op!(i(v: i32) -> Self::I, std::arch::x86_64::_mm256_set1_epi32(v));
    op!(load(v: &[f32; 8]) -> Self::F, std::arch::x86_64::_mm256_loadu_ps(v.as_ptr()));
    op!(store(v: Self::F, to: &mut [f32; 8]) -> (), std::arch::x86_64::_mm256_storeu_ps(to.as_mut_ptr(), v));
    op!(load_u(v: &[u32; 8]) -> Self::I, std::arch::x86_64::_mm256_loadu_si256(v.as_ptr().cast()));
    op!(store_u(v: Self::I, to: &mut [u32; 8]) -> (), std::arch::x86_64::_mm256_storeu_si256(to.as_mut_ptr().cast(), v));
    op!(add(a: Self::F, b: Self::F) -> Self::F, std::arch::x86_64::_mm256_add_ps(a, b));
    op!(sub(a: Self::F, b: Self::F) -> Self::F, std::arch::x86_64::_mm256_sub_ps(a, b));
    op!(mul(a: Self::F, b: Self::F) -> Self::F, std::arch::x86_64::_mm256_mul_ps(a, b));
    op!(div(a: Self::F, b: Self::F) -> Self::F, std::arch::x86_64::_mm256_div_ps(a, b));
    op!(fma(a: Self::F, b: Self::F, c: Self::F) -> Self::F, std::arch::x86_64::_mm256_fmadd_ps(a, b, c));
    // max and min return their second operand where one is NaN.
    op!(clamp(a: Self::F, low: Self::F, high: Self::F) -> Self::F, {
        std::arch::x86_64::_mm256_min_ps(std::arch::x86_64::_mm256_max_ps(a, low), high)
    });
    op!(at_most(a: Self::F, high: Self::F) -> Self::F, std::arch::x86_64::_mm256_min_ps(high, a));
    op!(round(a: Self::F) -> Self::I, std::arch::x86_64::_mm256_cvtps_epi32(a));
    op!(to_f(a: Self::I) -> Self::F, std::arch::x86_64::_mm256_cvtepi32_ps(a));
    op!(lt(a: Self::F, b: Self::F) -> Self::I, {
        std::arch::x86_64::_mm256_castps_si256(std::arch::x86_64::_mm256_cmp_ps::<{ std::arch::x86_64::_CMP_LT_OQ }>(a, b))
    });
    op!(bits(a: Self::F) -> Self::I, std::arch::x86_64::_mm256_castps_si256(a));
    op!(from_bits(a: Self::I) -> Self::F, std::arch::x86_64::_mm256_castsi256_ps(a));
    op!(iadd(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_add_epi32(a, b));
    op!(isub(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_sub_epi32(a, b));
    op!(imul(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_mullo_epi32(a, b));
    op!(permute(a: Self::I, from: &[u8; 8]) -> Self::I, {
        std::arch::x86_64::_mm256_castps_si256(permute(std::arch::x86_64::_mm256_castsi256_ps(a), from))
    });
    op!(and(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_and_si256(a, b));
    op!(or(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_or_si256(a, b));
    op!(xor(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_xor_si256(a, b));
    op!(andnot(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_andnot_si256(a, b));
    op!(gt(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_cmpgt_epi32(a, b));
    op!(imax(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_max_epi32(a, b));
    op!(eq(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_cmpeq_epi32(a, b));
    #[inline(always)]
    fn shl<const N: i32>(a: Self::I) -> Self::I {
        // SAFETY: see `op!`.
        unsafe { std::arch::x86_64::_mm256_slli_epi32::<N>(a) }
    }
    #[inline(always)]
    fn shr<const N: i32>(a: Self::I) -> Self::I {
        // SAFETY: see `op!`.
        unsafe { std::arch::x86_64::_mm256_srli_epi32::<N>(a) }
    }
    #[inline(always)]
    fn sar<const N: i32>(a: Self::I) -> Self::I {
        // SAFETY: see `op!`.
        unsafe { std::arch::x86_64::_mm256_srai_epi32::<N>(a) }
    }
    op!(select(mask: Self::I, a: Self::I, b: Self::I) -> Self::I, {
        select(mask, a, b)
    });
    op!(signs(a: Self::I) -> u32, {
        std::arch::x86_64::_mm256_movemask_ps(std::arch::x86_64::_mm256_castsi256_ps(a)) as u32
    });
    op!(mul16(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_mullo_epi16(a, b));
    op!(add16(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_add_epi16(a, b));
    op!(sub16(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_sub_epi16(a, b));
    #[inline(always)]
    fn shr16<const N: i32>(a: Self::I) -> Self::I {
        // SAFETY: see `op!`.
        unsafe { std::arch::x86_64::_mm256_srli_epi16::<N>(a) }
    }
    op!(bytes(c: [Self::I; 4]) -> Self::I, {
        use std::arch::x86_64::*;
        // Packs work within each half of the register: four bytes of each component, which the shuffle deals out to the pixels.
        let four = _mm256_packus_epi16(_mm256_packs_epi32(c[0], c[1]), _mm256_packs_epi32(c[2], c[3]));
        let deal = _mm_setr_epi8(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
        _mm256_shuffle_epi8(four, _mm256_broadcastsi128_si256(deal))
    });
    op!(two(a: &[f32; 4], b: &[f32; 4]) -> Self::F, std::arch::x86_64::_mm256_loadu2_m128(b.as_ptr(), a.as_ptr()));
    op!(halves(a: f32, b: f32) -> Self::F, {
        use std::arch::x86_64::*;
        _mm256_set_m128(_mm_set1_ps(b), _mm_set1_ps(a))
    });
    op!(spread(a: Self::F, k: usize) -> Self::F, {
        use std::arch::x86_64::*;
        match k & 3 {
            0 => _mm256_permute_ps::<0x00>(a),
            1 => _mm256_permute_ps::<0x55>(a),
            2 => _mm256_permute_ps::<0xaa>(a),
            _ => _mm256_permute_ps::<0xff>(a),
        }
    });
    op!(bytes_of_twos(c: [Self::I; 4]) -> Self::I, {
        use std::arch::x86_64::*;
        _mm256_packus_epi16(_mm256_packs_epi32(c[0], c[1]), _mm256_packs_epi32(c[2], c[3]))
    });
    op!(mask(bits: u32) -> Self::I, {
        std::arch::x86_64::_mm256_cvtepi8_epi32(std::arch::x86_64::_mm_loadl_epi64(MASKS[bits as usize & 255].as_ptr().cast()))
    });
    op!(set_lanes(bits: u32) -> Self::I, {
        std::arch::x86_64::_mm256_cvtepu8_epi32(std::arch::x86_64::_mm_loadl_epi64(SET_LANES[bits as usize & 255].as_ptr().cast()))
    });
    op!(ranks(bits: u32) -> Self::I, {
        std::arch::x86_64::_mm256_cvtepu8_epi32(std::arch::x86_64::_mm_loadl_epi64(MOVES[bits as usize & 255].as_ptr().cast()))
    });
    #[inline(always)]
    fn pack(a: Self::I, bits: u32) -> Self::I {
        Self::permute(a, &SET_LANES[bits as usize & 255])
    }
    op!(min16(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_min_epi16(a, b));
    op!(planes(planes: &[[f32; 4]; 3], x: &[f32; 8], y: f32, count: usize, to: &mut [[f32; 4]; 8]) -> (), {
        use std::arch::x86_64::*;
        let (a, dx, dy) = (_mm_loadu_ps(planes[0].as_ptr()), _mm_loadu_ps(planes[1].as_ptr()), _mm_loadu_ps(planes[2].as_ptr()));
        let (a, dx, dy) = (_mm256_set_m128(a, a), _mm256_set_m128(dx, dx), _mm256_set_m128(dy, dy));
        let y = _mm256_set1_ps(y);
        // Two places at a time.
        for k in 0..4 {
            if 2 * k >= count {
                break;
            }
            let x = _mm256_blend_ps::<0xf0>(_mm256_set1_ps(x[2 * k]), _mm256_set1_ps(x[2 * k + 1]));
            _mm256_storeu_ps(to[2 * k..2 * k + 2].as_mut_ptr().cast(), _mm256_fmadd_ps(y, dy, _mm256_fmadd_ps(x, dx, a)));
        }
    });
    op!(columns(rows: [&[f32; 4]; 8]) -> [Self::F; 4], {
        use std::arch::x86_64::*;
        let [a, b, c, d] = [
            _mm256_loadu2_m128(rows[4].as_ptr(), rows[0].as_ptr()),
            _mm256_loadu2_m128(rows[5].as_ptr(), rows[1].as_ptr()),
            _mm256_loadu2_m128(rows[6].as_ptr(), rows[2].as_ptr()),
            _mm256_loadu2_m128(rows[7].as_ptr(), rows[3].as_ptr()),
        ];
        let (ab, cd) = (_mm256_unpacklo_ps(a, b), _mm256_unpacklo_ps(c, d));
        let (ab_high, cd_high) = (_mm256_unpackhi_ps(a, b), _mm256_unpackhi_ps(c, d));
        [
            _mm256_shuffle_ps::<0x44>(ab, cd),
            _mm256_shuffle_ps::<0xee>(ab, cd),
            _mm256_shuffle_ps::<0x44>(ab_high, cd_high),
            _mm256_shuffle_ps::<0xee>(ab_high, cd_high),
        ]
    });
    op!(rows(columns: [Self::F; 4]) -> [[f32; 4]; 8], {
        use std::arch::x86_64::*;
        let [x, y, z, w] = columns;
        let (xy, zw) = (_mm256_unpacklo_ps(x, y), _mm256_unpacklo_ps(z, w));
        let (xy_high, zw_high) = (_mm256_unpackhi_ps(x, y), _mm256_unpackhi_ps(z, w));
        // Rows k and k + 4.
        let pairs = [
            _mm256_shuffle_ps::<0x44>(xy, zw),
            _mm256_shuffle_ps::<0xee>(xy, zw),
            _mm256_shuffle_ps::<0x44>(xy_high, zw_high),
            _mm256_shuffle_ps::<0xee>(xy_high, zw_high),
        ];
        let mut rows = [[0.0; 4]; 8];
        for k in 0..4 {
            _mm_storeu_ps(rows[k].as_mut_ptr(), _mm256_castps256_ps128(pairs[k]));
            _mm_storeu_ps(rows[k + 4].as_mut_ptr(), _mm256_extractf128_ps::<1>(pairs[k]));
        }
        rows
    });
    op!(extend(v: &[u8; 8]) -> Self::I, std::arch::x86_64::_mm256_cvtepu8_epi32(std::arch::x86_64::_mm_loadl_epi64(v.as_ptr().cast())));
    #[inline(always)]
    fn expand(a: Self::I, bits: u32) -> Self::I {
        Self::permute(a, &MOVES[bits as usize & 255])
    }
    op!(max16(a: Self::I, b: Self::I) -> Self::I, std::arch::x86_64::_mm256_max_epi16(a, b));
}
