// One pixel of one sample, if the triangle covers it (`inside`): the per-fragment operations (src/raster/fine.rs) around the program. Where a row is
// one of many by a variable (SELECTS_ROW), it is read and kept through functions of the kernel, outside of the `if`.
//#if SELECTS_ROW
var covered = false;
var colored = false;
var pixel: TpPixel;
var depth_word = 0u;
//#endif
if (inside) {
    let y = f32(py);
//#if DEPTH_BUFFER
//#if SELECTS_ROW
    let old_depth = tp_depth_at(r);
//#else
    let old_depth = tp_depths[r];
//#endif
//#endif
    //#insert DEPTH
    // Tests that read nothing of the program come before it; nothing is written yet.
//#if STENCIL_TEST
    let stencil_pass = tp_stencil_test(state, old_depth >> 24u);
//#endif
//#if DEPTH_TEST
//#if WRITES_DEPTH
    const tp_visible = true;
//#else
    let depth_pass = tp_depth_test(state, depth, old_depth & TP_DEPTH_MASK);
//#if NEEDS_KILL_FIRST
    const tp_visible = true;
//#else
//#if STENCIL_TEST
    let tp_visible = depth_pass && stencil_pass;
//#else
    let tp_visible = depth_pass;
//#endif
//#endif
//#endif
//#else
//#if STENCIL_TEST
//#if NEEDS_KILL_FIRST
    const tp_visible = true;
//#else
    let tp_visible = stencil_pass;
//#endif
//#else
    const tp_visible = true;
//#endif
//#endif
    var keep = true;
    var color = vec4<f32>(0.0);
//#if WRITES_DEPTH
    var program_depth = 0.0;
//#endif
//#if SHADES
    if (tp_visible) {
        //#insert SHADE
    }
//#endif
//#if ALPHA_TEST
    keep = keep && tp_alpha_test(state, color.w);
//#endif
//#if WRITES_DEPTH
    let depth = tp_quantise(state, program_depth);
    let depth_pass = tp_depth_test(state, depth, old_depth & TP_DEPTH_MASK);
//#endif
//#if STENCIL_TEST
//#if DEPTH_TEST
    let passes = keep && stencil_pass && depth_pass;
    let stencil = tp_stencil_update(state, old_depth >> 24u, stencil_pass, depth_pass);
//#else
    let passes = keep && stencil_pass;
    let stencil = tp_stencil_update(state, old_depth >> 24u, stencil_pass, true);
//#endif
    var new_depth = (old_depth & 0xffffffu) | (select(old_depth >> 24u, stencil, keep) << 24u);
//#else
//#if DEPTH_TEST
    let passes = keep && depth_pass;
//#else
    let passes = keep;
//#endif
//#if DEPTH_BUFFER
    var new_depth = old_depth;
//#endif
//#endif
//#if DEPTH_WRITE
    if (passes && (state.flags & TP_DEPTH_WRITE_ON) == TP_DEPTH_WRITE_ON) {
        new_depth = (new_depth & ~TP_DEPTH_MASK) | depth;
    }
//#endif
//#if SELECTS_ROW
//#if DEPTH_BUFFER
    depth_word = new_depth;
//#endif
//#if COLOR_WRITE
    if (passes) {
        pixel = tp_merge(state, tp_pixel_at(r), color);
        colored = true;
    }
//#endif
    covered = true;
}
tp_keep(r, covered, depth_word, colored, pixel);
dirty |= select(0u, 1u << u32(r), covered);
colored_rows |= select(0u, 1u << u32(r), colored);
//#else
//#if DEPTH_CHANGES
    tp_depths[r] = new_depth;
//#endif
//#if COLOR_WRITE
    if (passes) {
        tp_pixels[r] = tp_merge(state, tp_pixels[r], color);
//#if TALL
        colored_rows |= 1u << u32(r);
//#endif
    }
//#endif
    dirty |= 1u << u32(r);
}
//#endif
