// Bindings of the visible path, for opaque triangles with a depth test and writes (LESS or LEQUAL), which need no lists and no order of
// execution. Every covered sample offers a key of 64 bits, depth first, then the primitive's place in the order; the least key
// wins. Its fragment is the one that would have been left had all been drawn in order, and it alone is shaded (a visibility buffer).
//
// Key: depth (24 bits), primitive (32), triangle of the primitive (8: 0 the primitive itself, from 1 on the fan that clipping left). LEQUAL
// wants the last of equal depth: the lower 40 bits are complemented.
//
// Where the host sets up (SET_UP), what it made stands for the primitives: triangles, which are never clipped.

@group(0) @binding(0) var<storage, read> uniforms: array<vec4<f32>>;
//#if SET_UP
// Two words a load, which on a driver that runs on a processor costs as much as one.
@group(0) @binding(1) var<storage, read> tp_triangles: array<u64>;
@group(0) @binding(2) var<storage, read> tp_planes: array<u64>;
//#else
@group(0) @binding(1) var<storage, read> tp_primitives: array<vec4<u32>>;
@group(0) @binding(2) var<storage, read> tp_front_records: array<u32>;
@group(0) @binding(3) var<storage, read_write> tp_shaded: array<vec4<f32>>;
//#endif
@group(0) @binding(4) var<storage, read> tp_records: array<u32>;
@group(0) @binding(5) var<storage, read_write> tp_color: array<u32>;
@group(0) @binding(6) var<storage, read_write> tp_depth: array<u32>;
//#if TEXEL_PAIRS
@group(0) @binding(7) var tp_texels: texture_storage_2d<rg32uint, read>;
//#else
@group(0) @binding(7) var<storage, read> tp_texels: array<u32>;
//#endif
// A key a pixel of the rows first_row to end_row, all ones between segments.
//#if RESOLVE
//#if SET_UP
@group(0) @binding(8) var<storage, read_write> tp_keys: array<u64>;
//#else
@group(0) @binding(8) var<storage, read_write> tp_keys: array<vec2<u32>>;
//#endif
@group(0) @binding(9) var<storage, read_write> tp_queue: array<u32>;
//#else
@group(0) @binding(8) var<storage, read_write> tp_keys: array<atomic<u64>>;
// Counters (zero between segments), then what they count: blocks of large triangles, primitives to clip, fans.
@group(0) @binding(9) var<storage, read_write> tp_queue: array<atomic<u32>>;
//#endif
//#if SOUP
@group(0) @binding(10) var<storage, read> tp_vertices: array<f32>;
//#endif
@group(0) @binding(11) var<uniform> tp: TpParams;
@group(0) @binding(12) var<uniform> tf: TpFront;

// Counters: blocks, primitives to clip, vec4 of the pool, triangles of fans.
const TP_BLOCKS = 0u;
const TP_TO_CLIP = 1u;
const TP_POOLED = 2u;
const TP_FANS = 3u;

fn tp_zero() -> f32 {
    return tf.zero;
}

//#if SET_UP
//#else
// A corner by its reference: one of the primitive's own (0 to 2), or a vertex of the pool (3 and its vec4).
fn tp_corner_at(p: TpPrimitive, reference: u32) -> TpCorner {
    if (reference < 3u) {
        return tp_corner(p, reference);
    }
    return tp_pool_corner(p, reference - 3u);
}
//#endif
