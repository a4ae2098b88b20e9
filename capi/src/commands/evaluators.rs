//! Control points of evaluators.

use tepui::gl::Context;
use tepui::gl::enums::*;
use tepui::gl::evaluators::{map1_values, map2_values};

use super::memory::{copy, put};

/// glMap1f
pub unsafe fn glMap1f(cx: &mut Context, target: GLenum, u1: f32, u2: f32, stride: i32, order: i32, points: *const f32) {
    // SAFETY: the contract of this folder.
    if let Some(points) = unsafe { copy(cx, "glMap1f", points, map1_values(target, stride, order)) } {
        cx.map1(target, u1, u2, stride, order, &points);
    }
}

/// glMap1d
pub unsafe fn glMap1d(cx: &mut Context, target: GLenum, u1: f64, u2: f64, stride: i32, order: i32, points: *const f64) {
    // SAFETY: the contract of this folder.
    if let Some(points) = unsafe { copy(cx, "glMap1d", points, map1_values(target, stride, order)) } {
        let points: Vec<f32> = points.into_iter().map(|v| v as f32).collect();
        cx.map1(target, u1 as f32, u2 as f32, stride, order, &points);
    }
}

/// glMap2f
pub unsafe fn glMap2f(
    cx: &mut Context,
    target: GLenum,
    u1: f32,
    u2: f32,
    ustride: i32,
    uorder: i32,
    v1: f32,
    v2: f32,
    vstride: i32,
    vorder: i32,
    points: *const f32,
) {
    // SAFETY: the contract of this folder.
    if let Some(points) = unsafe { copy(cx, "glMap2f", points, map2_values(target, ustride, uorder, vstride, vorder)) } {
        cx.map2(target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, &points);
    }
}

/// glMap2d
pub unsafe fn glMap2d(
    cx: &mut Context,
    target: GLenum,
    u1: f64,
    u2: f64,
    ustride: i32,
    uorder: i32,
    v1: f64,
    v2: f64,
    vstride: i32,
    vorder: i32,
    points: *const f64,
) {
    // SAFETY: the contract of this folder.
    if let Some(points) = unsafe { copy(cx, "glMap2d", points, map2_values(target, ustride, uorder, vstride, vorder)) } {
        let points: Vec<f32> = points.into_iter().map(|v| v as f32).collect();
        cx.map2(target, u1 as f32, u2 as f32, ustride, uorder, v1 as f32, v2 as f32, vstride, vorder, &points);
    }
}

/// glGetMapfv
pub unsafe fn glGetMapfv(cx: &mut Context, target: GLenum, query: GLenum, v: *mut f32) {
    let values = cx.get_map(target, query).unwrap_or_default();
    // SAFETY: the contract of this folder.
    unsafe { put(cx, "glGetMapfv", v, values) };
}

/// glGetMapdv
pub unsafe fn glGetMapdv(cx: &mut Context, target: GLenum, query: GLenum, v: *mut f64) {
    let values = cx.get_map(target, query).unwrap_or_default();
    // SAFETY: the contract of this folder.
    unsafe { put(cx, "glGetMapdv", v, values.into_iter().map(f64::from)) };
}

/// glGetMapiv: rounded.
pub unsafe fn glGetMapiv(cx: &mut Context, target: GLenum, query: GLenum, v: *mut i32) {
    let values = cx.get_map(target, query).unwrap_or_default();
    // SAFETY: the contract of this folder.
    unsafe { put(cx, "glGetMapiv", v, values.into_iter().map(|v| v.round() as i32)) };
}
