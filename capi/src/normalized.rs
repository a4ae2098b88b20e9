//! Integers as components of colours and normals (table 2.9 of the specification).

/// c / (2^8 - 1)
#[inline]
pub fn u8(c: u8) -> f32 {
    f32::from(c) / 255.0
}

/// c / (2^16 - 1)
#[inline]
pub fn u16(c: u16) -> f32 {
    f32::from(c) / 65535.0
}

/// c / (2^32 - 1)
#[inline]
pub fn u32(c: u32) -> f32 {
    (f64::from(c) / 4294967295.0) as f32
}

/// (2c + 1) / (2^8 - 1)
#[inline]
pub fn i8(c: i8) -> f32 {
    (2.0 * f32::from(c) + 1.0) / 255.0
}

/// (2c + 1) / (2^16 - 1)
#[inline]
pub fn i16(c: i16) -> f32 {
    (2.0 * f32::from(c) + 1.0) / 65535.0
}

/// (2c + 1) / (2^32 - 1)
#[inline]
pub fn i32(c: i32) -> f32 {
    ((2.0 * f64::from(c) + 1.0) / 4294967295.0) as f32
}
