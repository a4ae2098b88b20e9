//! Fog (3.10).

use super::checks::{Params, clamp01, enum_from, put, vec4};
use super::enums::*;
use super::{Context, dirty};

impl Context {
    /// glFog{if}[v]. A slice of one is the scalar form. The colour is clamped to [0, 1].
    pub fn fog(&mut self, pname: GLenum, params: &[f32]) {
        let given = Params::new(params);
        if self.compile(move |cx| cx.fog(pname, given.as_slice())) || self.inside_begin_end() {
            return;
        }
        let Some(scalar) = params.first().copied() else { return };
        let fog = &mut self.state.fog;
        match (pname, vec4(params)) {
            (GL_FOG_COLOR, Some(color)) => put(&mut fog.color, color.map(clamp01), &mut self.dirty, dirty::FOG),
            (GL_FOG_MODE, _) if matches!(enum_from(scalar), GL_LINEAR | GL_EXP | GL_EXP2) => {
                put(&mut fog.mode, enum_from(scalar), &mut self.dirty, dirty::FOG);
            }
            (GL_FOG_COORD_SRC, _) if matches!(enum_from(scalar), GL_FRAGMENT_DEPTH | GL_FOG_COORD) => {
                put(&mut fog.coord_source, enum_from(scalar), &mut self.dirty, dirty::FOG);
            }
            (GL_FOG_DENSITY, _) => {
                if scalar.is_nan() || scalar < 0.0 {
                    return self.set_error(GL_INVALID_VALUE, "glFog(GL_FOG_DENSITY)");
                }
                put(&mut fog.density, scalar, &mut self.dirty, dirty::FOG);
            }
            (GL_FOG_START, _) => put(&mut fog.start, scalar, &mut self.dirty, dirty::FOG),
            (GL_FOG_END, _) => put(&mut fog.end, scalar, &mut self.dirty, dirty::FOG),
            (GL_FOG_INDEX, _) => fog.index = scalar,
            _ => self.set_error(GL_INVALID_ENUM, "glFog"),
        }
    }
}
