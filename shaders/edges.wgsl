// A triangle's edge functions in this bin, the part of the tile that its rectangle covers, and where its planes lie. Expects the load `te`, its record
// as the tile stage left it.
//#if SAMPLES
// Low bits of the edge functions lie where others leave room: see tile.wgsl.
let box = WORD(te, 9) & 0x3f3f3f3fu;
let planes = WORD(te, 10) & 0xfffffffcu;
//#else
let box = WORD(te, 9);
let planes = WORD(te, 10);
//#endif
let c = bitcast<vec3<i32>>(vec3<u32>(WORD(te, 0), WORD(te, 1), WORD(te, 2)));
let a = bitcast<vec3<i32>>(vec3<u32>(WORD(te, 3), WORD(te, 4), WORD(te, 5)));
let b = bitcast<vec3<i32>>(vec3<u32>(WORD(te, 6), WORD(te, 7), WORD(te, 8)));
//#if CUT
let in_columns = local_x >= i32(box & 255u) && local_x <= i32((box >> 8u) & 255u);
//#endif
let low = max(i32((box >> 16u) & 255u), local_top) - local_top;
let high = min(i32(box >> 24u), local_top + 7) - local_top;
