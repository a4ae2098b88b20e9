// A triangle as the tile stage left it: edge functions, the part of the tile that its rectangle covers, the draw's states, planes. Expects
// the loads `te` (its record) and `sa`, `sb`, `sc` (the draw's words) and `flags`.
//#include edges
let fragment_uniforms = WORD(sa, 0);
//#if TEXTURES
let textures = WORD(sa, 1);
//#insert TEXTURES
//#endif
var state: TpState;
//#include state
// Where planes are evaluated for the pixel's centre (setup.rs, to_centre).
//#if SAMPLES
//#if CENTRES
let several = (flags & TP_MULTISAMPLE) != 0u;
let to_centre = select(0.0, 0.5, several);
//#else
const to_centre = 0.5;
//#endif
let x = column_x + to_centre;
//#else
let x = column_x;
//#endif
// Planes of this triangle.
//#insert PLANES
//#if SAMPLES
// From the centres to the samples: edge functions, and the place where depth is evaluated.
let free = WORD(te, 9);
let low_bits = vec3<i32>(vec3<u32>(
    ((free >> 6u) & 3u) | (((free >> 14u) & 3u) << 2u),
    ((free >> 22u) & 3u) | ((free >> 30u) << 2u),
    (WORD(te, 10) & 3u) | ((draw_and_flags >> 30u) << 2u)));
//#each $
//#if CENTRES
let edge_$ = select(vec3<i32>(0), (low_bits + a * TP_SAMPLE_X$ + b * TP_SAMPLE_Y$) >> vec3<u32>(4u), several);
//#else
let edge_$ = (low_bits + a * TP_SAMPLE_X$ + b * TP_SAMPLE_Y$) >> vec3<u32>(4u);
//#endif
//#end
//#if REJECTS
// How far the depth of any sample may lie below its pixel's, with all roundings.
let depth_slack = (abs(p1) + abs(p2)) * 0.5 + (abs(p0) + abs(p1) * x + abs(p2) * f32(origin.y + 8u)) * 0x1p-20 + 0x1p-21;
//#endif
//#if SAMPLE_DEPTH
//#each $
//#if CENTRES
let zx_$ = tp_fma(x + select(0.0, f32(TP_SAMPLE_X$) / 16.0, several), p1, p0);
let zy_$ = select(0.0, f32(TP_SAMPLE_Y$) / 16.0, several);
//#else
let zx_$ = tp_fma(x + f32(TP_SAMPLE_X$) / 16.0, p1, p0);
const zy_$ = f32(TP_SAMPLE_Y$) / 16.0;
//#endif
//#end
//#endif
//#endif
