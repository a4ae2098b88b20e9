//! Enable, Disable, IsEnabled: every server-side capability (the state tables of 6.2). EnableClientState is with the
//! vertex arrays.

use super::checks::put;
use super::enums::*;
use super::state::{MAX_CLIP_PLANES, MAX_LIGHTS};
use super::{Context, dirty};

impl Context {
    /// glEnable.
    pub fn enable(&mut self, cap: GLenum) {
        if self.compile(move |cx| cx.enable(cap)) || self.inside_begin_end() {
            return;
        }
        self.set_capability(cap, true);
    }

    /// glDisable.
    pub fn disable(&mut self, cap: GLenum) {
        if self.compile(move |cx| cx.disable(cap)) || self.inside_begin_end() {
            return;
        }
        self.set_capability(cap, false);
    }

    /// glIsEnabled. GL_FALSE and GL_INVALID_ENUM for what is no capability.
    pub fn is_enabled(&mut self, cap: GLenum) -> bool {
        if self.inside_begin_end() {
            return false;
        }
        match self.capability(cap).map(|(slot, _)| *slot).or_else(|| self.arrays.is_enabled(cap)) {
            Some(on) => on,
            None => {
                self.set_error(GL_INVALID_ENUM, "glIsEnabled");
                false
            }
        }
    }

    /// The value of a capability, for queries; `None` for what is no capability.
    pub(crate) fn capability_value(&mut self, cap: GLenum) -> Option<bool> {
        self.capability(cap).map(|(slot, _)| *slot)
    }

    fn set_capability(&mut self, cap: GLenum, on: bool) {
        if cap == GL_COLOR_MATERIAL {
            // Before it is switched off the material still follows the colour, and from the moment it is on.
            self.sync_color_material();
        }
        let mut changed = 0;
        match self.capability(cap) {
            Some((slot, group)) => put(slot, on, &mut changed, group),
            None => self.set_error(GL_INVALID_ENUM, if on { "glEnable" } else { "glDisable" }),
        }
        self.dirty |= changed;
        if cap == GL_COLOR_MATERIAL {
            self.sync_color_material();
        }
    }

    /// Where a capability is kept and which group it belongs to.
    pub(crate) fn capability(&mut self, cap: GLenum) -> Option<(&mut bool, u32)> {
        let s = &mut self.state;
        let unit = &mut s.texture.units[s.texture.active];
        Some(match cap {
            GL_LIGHTING => (&mut s.lighting.enabled, dirty::LIGHTING),
            GL_COLOR_MATERIAL => (&mut s.lighting.color_material, dirty::LIGHTING),
            GL_COLOR_SUM => (&mut s.lighting.color_sum, dirty::LIGHTING),
            GL_NORMALIZE => (&mut s.transform.normalize, dirty::LIGHTING),
            GL_RESCALE_NORMAL => (&mut s.transform.rescale_normal, dirty::LIGHTING),
            GL_FOG => (&mut s.fog.enabled, dirty::FOG),
            GL_POINT_SMOOTH => (&mut s.point.smooth, dirty::RASTER),
            GL_POINT_SPRITE => (&mut s.point.sprite, dirty::RASTER | dirty::TEXTURE),
            GL_LINE_SMOOTH => (&mut s.line.smooth, dirty::RASTER),
            GL_LINE_STIPPLE => (&mut s.line.stipple, dirty::RASTER),
            GL_CULL_FACE => (&mut s.polygon.cull, dirty::RASTER),
            GL_POLYGON_SMOOTH => (&mut s.polygon.smooth, dirty::RASTER),
            GL_POLYGON_STIPPLE => (&mut s.polygon.stipple, dirty::RASTER),
            GL_POLYGON_OFFSET_POINT => (&mut s.polygon.offset_point, dirty::RASTER),
            GL_POLYGON_OFFSET_LINE => (&mut s.polygon.offset_line, dirty::RASTER),
            GL_POLYGON_OFFSET_FILL => (&mut s.polygon.offset_fill, dirty::RASTER),
            GL_SCISSOR_TEST => (&mut s.scissor.test, dirty::RASTER),
            GL_ALPHA_TEST => (&mut s.color_buffer.alpha_test, dirty::FRAGMENT),
            GL_BLEND => (&mut s.color_buffer.blend, dirty::FRAGMENT),
            GL_DITHER => (&mut s.color_buffer.dither, dirty::FRAGMENT),
            GL_INDEX_LOGIC_OP => (&mut s.color_buffer.index_logic_op, dirty::FRAGMENT),
            GL_COLOR_LOGIC_OP => (&mut s.color_buffer.color_logic_op, dirty::FRAGMENT),
            GL_DEPTH_TEST => (&mut s.depth.test, dirty::FRAGMENT),
            GL_STENCIL_TEST => (&mut s.stencil.test, dirty::FRAGMENT),
            GL_MULTISAMPLE => (&mut s.multisample.enabled, dirty::FRAGMENT | dirty::RASTER),
            GL_SAMPLE_ALPHA_TO_COVERAGE => (&mut s.multisample.alpha_to_coverage, dirty::FRAGMENT),
            GL_SAMPLE_ALPHA_TO_ONE => (&mut s.multisample.alpha_to_one, dirty::FRAGMENT),
            GL_SAMPLE_COVERAGE => (&mut s.multisample.sample_coverage, dirty::FRAGMENT),
            GL_TEXTURE_1D => (&mut unit.enabled[0], dirty::TEXTURE),
            GL_TEXTURE_2D => (&mut unit.enabled[1], dirty::TEXTURE),
            GL_TEXTURE_3D => (&mut unit.enabled[2], dirty::TEXTURE),
            GL_TEXTURE_CUBE_MAP => (&mut unit.enabled[3], dirty::TEXTURE),
            GL_TEXTURE_GEN_S..=GL_TEXTURE_GEN_Q => (&mut unit.texgen[(cap - GL_TEXTURE_GEN_S) as usize].enabled, dirty::TEXTURE),
            // The evaluators' enables are read where they run.
            GL_AUTO_NORMAL => (&mut s.eval.auto_normal, 0),
            GL_MAP1_COLOR_4..=GL_MAP1_VERTEX_4 => (&mut s.eval.map1[(cap - GL_MAP1_COLOR_4) as usize], 0),
            GL_MAP2_COLOR_4..=GL_MAP2_VERTEX_4 => (&mut s.eval.map2[(cap - GL_MAP2_COLOR_4) as usize], 0),
            _ => {
                if let Some(light) = index_below(cap, GL_LIGHT0, MAX_LIGHTS) {
                    (&mut s.lighting.lights[light].enabled, dirty::LIGHTING)
                } else {
                    let plane = index_below(cap, GL_CLIP_PLANE0, MAX_CLIP_PLANES)?;
                    (&mut s.transform.clip_enabled[plane], dirty::RASTER)
                }
            }
        })
    }
}

/// `name - first` where that is below `count`.
pub(crate) fn index_below(name: GLenum, first: GLenum, count: usize) -> Option<usize> {
    let index = name.checked_sub(first)? as usize;
    (index < count).then_some(index)
}
