//! The states of the fixed stages, as the pipeline wants them: [`RasterState`] and [`FragmentState`] from the GL state.

use super::Context;
use super::enums::*;
use super::state::{MultisampleState, PolygonState, StencilSide};
use crate::device::DepthFormat;
use crate::raster::layout::*;

fn set(flags: &mut u32, on: bool, flag: u32) {
    if on {
        *flags |= flag;
    }
}

/// A comparison function, checked when it was set.
fn compare_func(func: GLenum) -> u32 {
    func.wrapping_sub(GL_NEVER) & 7
}

fn blend_factor_of(factor: GLenum) -> u32 {
    match factor {
        GL_ZERO => blend_factor::ZERO,
        GL_SRC_COLOR => blend_factor::SRC_COLOR,
        GL_ONE_MINUS_SRC_COLOR => blend_factor::ONE_MINUS_SRC_COLOR,
        GL_SRC_ALPHA => blend_factor::SRC_ALPHA,
        GL_ONE_MINUS_SRC_ALPHA => blend_factor::ONE_MINUS_SRC_ALPHA,
        GL_DST_ALPHA => blend_factor::DST_ALPHA,
        GL_ONE_MINUS_DST_ALPHA => blend_factor::ONE_MINUS_DST_ALPHA,
        GL_DST_COLOR => blend_factor::DST_COLOR,
        GL_ONE_MINUS_DST_COLOR => blend_factor::ONE_MINUS_DST_COLOR,
        GL_SRC_ALPHA_SATURATE => blend_factor::SRC_ALPHA_SATURATE,
        GL_CONSTANT_COLOR => blend_factor::CONSTANT_COLOR,
        GL_ONE_MINUS_CONSTANT_COLOR => blend_factor::ONE_MINUS_CONSTANT_COLOR,
        GL_CONSTANT_ALPHA => blend_factor::CONSTANT_ALPHA,
        GL_ONE_MINUS_CONSTANT_ALPHA => blend_factor::ONE_MINUS_CONSTANT_ALPHA,
        _ => blend_factor::ONE,
    }
}

fn blend_equation_of(equation: GLenum) -> u32 {
    match equation {
        GL_FUNC_SUBTRACT => blend_equation::SUBTRACT,
        GL_FUNC_REVERSE_SUBTRACT => blend_equation::REVERSE_SUBTRACT,
        GL_MIN => blend_equation::MIN,
        GL_MAX => blend_equation::MAX,
        _ => blend_equation::ADD,
    }
}

fn stencil_op_of(op: GLenum) -> u32 {
    match op {
        GL_ZERO => stencil_op::ZERO,
        GL_REPLACE => stencil_op::REPLACE,
        GL_INCR => stencil_op::INCR,
        GL_DECR => stencil_op::DECR,
        GL_INVERT => stencil_op::INVERT,
        GL_INCR_WRAP => stencil_op::INCR_WRAP,
        GL_DECR_WRAP => stencil_op::DECR_WRAP,
        _ => stencil_op::KEEP,
    }
}

fn stencil_face(side: &StencilSide) -> StencilFace {
    StencilFace {
        func: compare_func(side.func),
        reference: side.reference.clamp(0, 255) as u32,
        read_mask: side.value_mask & 255,
        write_mask: side.write_mask & 255,
        ops: [stencil_op_of(side.fail), stencil_op_of(side.depth_fail), stencil_op_of(side.depth_pass)],
        reserved: 0,
    }
}

fn polygon_mode_of(mode: GLenum) -> u32 {
    match mode {
        GL_POINT => topology::POINTS,
        GL_LINE => topology::LINES,
        _ => topology::TRIANGLES,
    }
}

fn cull_flags(polygon: &PolygonState) -> u32 {
    match (polygon.cull, polygon.cull_mode) {
        (false, _) => 0,
        (true, GL_FRONT) => raster_flags::CULL_FRONT,
        (true, GL_FRONT_AND_BACK) => raster_flags::CULL_FRONT | raster_flags::CULL_BACK,
        (true, _) => raster_flags::CULL_BACK,
    }
}

/// The samples of `count` that the sample coverage leaves out (4.1.3): the first ones are kept, as many as the value says, rounded
/// down as in Mesa.
fn dropped_samples(state: &MultisampleState, count: u32) -> u32 {
    let all = (1 << count) - 1;
    let kept = (1 << (state.coverage_value * count as f32) as u32) - 1;
    if state.coverage_invert { kept } else { all & !kept }
}

impl Context {
    /// Columns and rows that may be written, in raster space: the surface, and the scissor where it is on.
    pub(crate) fn drawable_rectangle(&self) -> ([i32; 2], [i32; 2]) {
        let [width, height] = self.draw_size().map(|size| size as i32);
        let scissor = &self.state.scissor;
        if !scissor.test {
            return ([0, 0], [width, height]);
        }
        let (x0, x1) = (scissor.x, scissor.x.saturating_add(scissor.width));
        let (y0, y1) = (scissor.y, scissor.y.saturating_add(scissor.height));
        let (x0, x1, y0, y1) = (x0.clamp(0, width), x1.clamp(0, width), y0.clamp(0, height), y1.clamp(0, height));
        // Rows of a window surface run downwards.
        if self.draw_format().top_first { ([x0, height - y1], [x1, height - y0]) } else { ([x0, y0], [x1, y1]) }
    }

    /// Samples are looked at one by one (3.2.1).
    fn multisamples(&self) -> bool {
        self.state.multisample.enabled && self.draw_format().samples > 1
    }

    /// State of the stages from clipping to set-up. The recorder fills in the polygon stipple.
    pub(crate) fn raster_state(&self) -> RasterState {
        let state = &self.state;
        let (polygon, viewport) = (&state.polygon, &state.viewport);
        let mut flags = cull_flags(polygon);
        set(&mut flags, polygon.front_face == GL_CCW, raster_flags::FRONT_CCW);
        set(&mut flags, polygon.offset_point, raster_flags::OFFSET_POINT);
        set(&mut flags, polygon.offset_line, raster_flags::OFFSET_LINE);
        set(&mut flags, polygon.offset_fill, raster_flags::OFFSET_FILL);
        set(&mut flags, state.point.smooth, raster_flags::POINT_SMOOTH);
        set(&mut flags, state.line.smooth, raster_flags::LINE_SMOOTH);
        set(&mut flags, state.line.stipple, raster_flags::LINE_STIPPLE);
        set(&mut flags, self.multisamples(), raster_flags::MULTISAMPLE);
        set(&mut flags, self.draw_format().depth.is_float(), raster_flags::FLOAT_DEPTH);
        // In single precision, as Mesa keeps them.
        let (near, far) = (viewport.near as f32, viewport.far as f32);
        let (depth_scale, depth_middle) = (0.5 * (far - near), 0.5 * (near + far));
        let (half_width, half_height) = (0.5 * viewport.width as f32, 0.5 * viewport.height as f32);
        let middle = half_height + viewport.y as f32;
        let (scissor_min, scissor_max) = self.drawable_rectangle();
        // A unit of offset is twice the step of the depth format, as llvmpipe has it; of floating-point depths it is the polygon's.
        let format = self.draw_format();
        let unit = match format.depth {
            DepthFormat::D16 => 2.0 / 65535.0,
            DepthFormat::F32 => 1.0,
            _ => 2.0 / 16777215.0,
        };
        RasterState {
            flags,
            polygon_mode: polygon.mode.map(polygon_mode_of),
            line_stipple: u32::from(state.line.stipple_pattern) | (state.line.stipple_factor.clamp(1, 256) as u32) << 16,
            viewport_scale: [half_width, if format.top_first { -half_height } else { half_height }, depth_scale],
            viewport_translate: [
                half_width + viewport.x as f32,
                if format.top_first { self.draw_size()[1] as f32 - middle } else { middle },
                depth_middle,
            ],
            scissor_min,
            scissor_max,
            offset_factor: polygon.offset_factor,
            offset_units: polygon.offset_units * unit,
            line_width: state.line.width.clamp(1.0, 255.0),
            point_size: state.point.size.clamp(state.point.size_min.max(1.0), state.point.size_max.min(255.0).max(1.0)),
            // What llvmpipe clamps to: what the transform makes of the planes, a rounding beside the range that was asked for.
            depth_range: [depth_middle - depth_scale.abs(), depth_middle + depth_scale.abs()].map(|z| z.clamp(0.0, 1.0)),
            polygon_stipple: NONE,
            reserved: 0,
        }
    }

    /// State of the per-fragment operations (4.1). What would change nothing is off.
    pub(crate) fn fragment_state(&self) -> FragmentState {
        let state = &self.state;
        let (color, format) = (&state.color_buffer, self.draw_format());
        let depth_test = state.depth.test && format.depth != DepthFormat::None;
        let blends = color.blend && !color.color_logic_op;
        let mut flags = 0;
        set(&mut flags, depth_test, fragment_flags::DEPTH_TEST);
        set(&mut flags, depth_test && state.depth.write, fragment_flags::DEPTH_WRITE);
        set(&mut flags, state.stencil.test && format.stencil, fragment_flags::STENCIL_TEST);
        set(&mut flags, color.alpha_test && color.alpha_func != GL_ALWAYS, fragment_flags::ALPHA_TEST);
        set(&mut flags, blends, fragment_flags::BLEND);
        set(&mut flags, color.color_logic_op, fragment_flags::LOGIC_OP);
        let (multisamples, samples) = (self.multisamples(), &state.multisample);
        set(&mut flags, multisamples && samples.alpha_to_coverage, fragment_flags::ALPHA_TO_COVERAGE);
        set(&mut flags, multisamples && samples.alpha_to_one, fragment_flags::ALPHA_TO_ONE);
        let covers = multisamples && samples.sample_coverage;
        FragmentState {
            flags,
            depth_func: compare_func(state.depth.func),
            alpha_func: compare_func(color.alpha_func),
            alpha_ref: color.alpha_ref,
            stencil: [stencil_face(&state.stencil.sides[0]), stencil_face(&state.stencil.sides[1])],
            blend_factors: color.blend_func.map(blend_factor_of),
            blend_equations: color.blend_equation.map(blend_equation_of),
            logic_op: color.logic_op.wrapping_sub(GL_CLEAR) & 15,
            color_mask: self.color_write_mask(),
            blend_color: color.blend_color,
            dropped_samples: if covers { dropped_samples(samples, format.samples) } else { 0 },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sample_coverage_keeps_as_many_samples_as_it_says() {
        let state = |coverage_value, coverage_invert| MultisampleState {
            enabled: true,
            alpha_to_coverage: false,
            alpha_to_one: false,
            sample_coverage: true,
            coverage_value,
            coverage_invert,
        };
        assert_eq!(dropped_samples(&state(1.0, false), 4), 0);
        assert_eq!(dropped_samples(&state(0.5, false), 4), 0b1100);
        assert_eq!(dropped_samples(&state(0.5, true), 4), 0b0011);
        assert_eq!(dropped_samples(&state(0.0, false), 2), 0b11);
        assert_eq!(dropped_samples(&state(1.0, true), 16), 0xffff);
    }
}
