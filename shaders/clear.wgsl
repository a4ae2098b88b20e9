// A lane a pixel of the clear's rectangle, in TP_CLEAR_ROWS rows one after the other.

@group(1) @binding(0) var<storage, read_write> tp_indirect: array<u32>;

fn tp_clear_pixel(at: u32) {
    for (var k = 0u; k < TP_COLOR_WORDS; k++) {
        let mask = tp.clear_mask[k];
        let i = at * TP_COLOR_WORDS + k;
        if (mask == 0xffffffffu) {
            tp_color[i] = tp.clear_color[k];
        } else if (mask != 0u) {
            tp_color[i] = (tp_color[i] & ~mask) | (tp.clear_color[k] & mask);
        }
    }
    if (tp.clear_depth_mask == 0xffffffffu) {
        tp_depth[at] = tp.clear_depth;
    } else if (tp.clear_depth_mask != 0u) {
        tp_depth[at] = (tp_depth[at] & ~tp.clear_depth_mask) | (tp.clear_depth & tp.clear_depth_mask);
    }
}

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>) {
    let x = i32(id.x) + tp.clear_min.x;
    if (x >= tp.clear_max.x || tp_indirect[TP_FAILED] != 0u) {
        return;
    }
    let first = i32(id.y) * TP_CLEAR_ROWS + tp.clear_min.y;
    for (var y = first; y < min(first + TP_CLEAR_ROWS, tp.clear_max.y); y++) {
        for (var sample = 0u; sample < tp.samples; sample++) {
            tp_clear_pixel((sample * tp.size.y + u32(y)) * tp.size.x + u32(x));
        }
    }
}
