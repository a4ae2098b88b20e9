// A lane a pixel: the mean of its samples, rounded to nearest (samples.rs, mean). The samples lie in tp_color; the means go to tp_depth's place.

fn tp_mean(at: u32) -> vec4<u32> {
//#if COLOR_8BIT
    var sum = vec4<f32>(0.0);
    for (var sample = 0u; sample < tp.samples; sample++) {
        sum += tp_mul4(vec4<f32>(tp_unpack(tp_load_pixel(at + sample * tp.size.x * tp.size.y))), 1.0 / 255.0);
    }
    // A power of two, which a division need not give exactly.
    let share = bitcast<f32>(0x3f800000u - (countTrailingZeros(tp.samples) << 23u));
    let bytes = tp_mul4(tp_mul4(sum, share), 255.0);
    return vec4<u32>(tp_round(bytes.x), tp_round(bytes.y), tp_round(bytes.z), tp_round(bytes.w));
//#else
    var sum = vec4<u32>(tp.samples / 2u);
    for (var sample = 0u; sample < tp.samples; sample++) {
        sum += tp_unpack(tp_load_pixel(at + sample * tp.size.x * tp.size.y));
    }
    return sum / tp.samples;
//#endif
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
    let mean = tp_pack(tp_mean(at));
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
