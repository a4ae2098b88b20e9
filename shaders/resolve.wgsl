// A lane a pixel: the mean of its samples, rounded to nearest, halves up. The samples lie in tp_color; the means go to tp_depth's place.

fn tp_sum(at: u32) -> vec4<u32> {
    var sum = vec4<u32>(tp.samples / 2u);
    for (var sample = 0u; sample < tp.samples; sample++) {
        sum += tp_unpack(tp_load_pixel(at + sample * tp.size.x * tp.size.y));
    }
    return sum / tp.samples;
}

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let at = id.x + id.y * groups.x * TP_LANES;
    if (at >= tp.size.x * tp.size.y) {
        return;
    }
//#if COLOR_RGBA32F
    var sum = vec4<f32>(0.0);
    for (var sample = 0u; sample < tp.samples; sample++) {
        sum += bitcast<vec4<f32>>(tp_load_pixel(at + sample * tp.size.x * tp.size.y));
    }
    let mean = bitcast<vec4<u32>>(sum / f32(tp.samples));
//#else
    let mean = tp_pack(tp_sum(at));
//#endif
//#if COLOR_WORDS_1
    tp_depth[at] = mean;
//#endif
//#if COLOR_WORDS_2
    tp_depth[at * 2u] = mean.x;
    tp_depth[at * 2u + 1u] = mean.y;
//#endif
//#if COLOR_WORDS_4
    tp_depth[at * 4u] = mean.x;
    tp_depth[at * 4u + 1u] = mean.y;
    tp_depth[at * 4u + 2u] = mean.z;
    tp_depth[at * 4u + 3u] = mean.w;
//#endif
}
