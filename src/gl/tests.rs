//! What the state machine promises: defaults, what reads back, which errors.

mod attrib_stack;
mod enables;
mod evaluators;
mod parameters;
mod picking;
mod queries;
mod setters;

use super::enums::*;
use super::{Context, ContextConfig};

fn context() -> Context {
    let mut cx = Context::new(ContextConfig::default(), None);
    cx.attach_window(64, 48);
    cx
}

/// What glGetDoublev answers, without an error.
#[track_caller]
fn get(cx: &mut Context, pname: GLenum) -> Vec<f64> {
    let value = cx.get(pname);
    assert_eq!(cx.get_error(), GL_NO_ERROR, "glGet({pname:#x})");
    value.map_or(Vec::new(), |value| value.as_f64().collect())
}

/// The error of some commands, no error before.
#[track_caller]
fn error_of(cx: &mut Context, commands: impl FnOnce(&mut Context)) -> GLenum {
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    commands(cx);
    cx.get_error()
}

/// Numbers as `f32` stores them (masks stay whole).
fn rounded(values: &[f64]) -> Vec<f64> {
    values.iter().map(|&v| if v.abs() < 1e6 { v as f32 as f64 } else { v }).collect()
}
