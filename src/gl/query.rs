//! State queries (6.1): one typed answer a query, converted as 6.1.2 says.

use super::Context;
use super::enums::*;

/// What a state value is, which decides how it is converted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Boolean: 0 or 1.
    Bool,
    /// Integer or enum.
    Int,
    /// Floating point.
    Float,
    /// A colour component, normal, depth-range or depth clear value: as an integer, [-1, 1] becomes the whole range.
    Normalized,
}

/// Most numbers that one query returns.
pub const MAX_VALUES: usize = 16;

/// The answer to a state query in its own type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    kind: Kind,
    count: usize,
    numbers: [f64; MAX_VALUES],
}

impl Value {
    /// At most [`MAX_VALUES`] numbers; more are dropped.
    pub fn new(kind: Kind, numbers: impl IntoIterator<Item = f64>) -> Value {
        let mut value = Value { kind, count: 0, numbers: [0.0; MAX_VALUES] };
        for (slot, number) in value.numbers.iter_mut().zip(numbers) {
            *slot = number;
            value.count += 1;
        }
        value
    }

    /// A boolean.
    pub fn bool(b: bool) -> Value {
        Value::new(Kind::Bool, [b as u8 as f64])
    }

    /// Booleans.
    pub fn bools(b: &[bool]) -> Value {
        Value::new(Kind::Bool, b.iter().map(|&b| b as u8 as f64))
    }

    /// An integer.
    pub fn int(i: impl Into<i64>) -> Value {
        Value::new(Kind::Int, [i.into() as f64])
    }

    /// Integers.
    pub fn ints(i: &[i32]) -> Value {
        Value::new(Kind::Int, i.iter().map(|&i| i as f64))
    }

    /// A float.
    pub fn float(f: f32) -> Value {
        Value::floats(&[f])
    }

    /// Floats.
    pub fn floats(f: &[f32]) -> Value {
        Value::new(Kind::Float, f.iter().map(|&f| f as f64))
    }

    /// Floats that integers see scaled.
    pub fn normalized(f: &[f32]) -> Value {
        Value::new(Kind::Normalized, f.iter().map(|&f| f as f64))
    }

    /// How many numbers.
    pub fn len(&self) -> usize {
        self.count
    }

    /// No numbers at all.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        self.numbers[..self.count].iter().copied()
    }

    /// As Get*dv returns it.
    pub fn as_f64(&self) -> impl Iterator<Item = f64> + '_ {
        self.numbers()
    }

    /// As Get*fv returns it.
    pub fn as_f32(&self) -> impl Iterator<Item = f32> + '_ {
        self.numbers().map(|v| v as f32)
    }

    /// As Get*iv returns it: floats are rounded, normalised values scaled to the whole range, all saturated.
    pub fn as_i32(&self) -> impl Iterator<Item = i32> + '_ {
        self.numbers().map(move |v| match self.kind {
            Kind::Bool | Kind::Int => v as i32,
            Kind::Float => v.round() as i32,
            Kind::Normalized => ((u32::MAX as f64 * v - 1.0) / 2.0).round_ties_even() as i32,
        })
    }

    /// As GetBooleanv returns it: GL_FALSE for zero.
    pub fn as_bool(&self) -> impl Iterator<Item = u8> + '_ {
        self.numbers().map(|v| (v != 0.0) as u8)
    }
}

impl Context {
    /// What glGetBooleanv, glGetIntegerv, glGetFloatv and glGetDoublev return, before conversion; nothing after an
    /// error.
    pub fn get(&mut self, pname: GLenum) -> Option<Value> {
        if self.inside_begin_end() {
            return None;
        }
        let value = self.query(pname);
        self.value_or_error(value, "glGet")
    }

    /// Passes a value on; GL_INVALID_ENUM where there is none.
    pub(crate) fn value_or_error(&mut self, value: Option<Value>, what: &str) -> Option<Value> {
        if value.is_none() {
            self.set_error(GL_INVALID_ENUM, what);
        }
        value
    }
}

/// Parameters of an integer form (glLightiv, glFogiv, glTexEnviv, ...) as floats: colours are scaled so that the whole
/// integer range becomes [-1, 1] (table 2.9), everything else keeps its number.
pub fn params_from_int(pname: GLenum, params: &[i32]) -> Vec<f32> {
    let is_color = matches!(
        pname,
        GL_AMBIENT
            | GL_DIFFUSE
            | GL_SPECULAR
            | GL_EMISSION
            | GL_AMBIENT_AND_DIFFUSE
            | GL_LIGHT_MODEL_AMBIENT
            | GL_FOG_COLOR
            | GL_TEXTURE_ENV_COLOR
            | GL_TEXTURE_BORDER_COLOR
    ) && params.len() >= 4;
    let convert = |&v: &i32| if is_color { ((2.0 * v as f64 + 1.0) / u32::MAX as f64) as f32 } else { v as f32 };
    params.iter().map(convert).collect()
}
