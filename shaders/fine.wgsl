// A workgroup a tile of 8 x 8 pixels: walks the tile's triangles in order and runs the per-fragment operations on each
// covered pixel. Colour and depth stay in registers from the first triangle to the last.
//
// Where a segment has few triangles there are no lists (DIRECT): every tile looks at all of them, 32 at a time, a lane each. That takes less
// time than the five dispatches that make lists, and no memory.
//
// Kernel shape: 64 lanes, a pixel each, or 32 lanes, two pixels each. Drivers that run on a processor have fine_column.wgsl.

const TP_ROWS = i32(64u / TP_LANES);
const TP_ROW_STEP = i32(TP_LANES / 8u);

// A pixel's samples one after the other.
var<private> tp_pixels: array<TpPixel, TP_ROWS * i32(TP_SAMPLES)>;
//#if REJECTS
// The greatest depth of each pixel's samples.
var<private> tp_furthest: array<u32, TP_ROWS>;
//#endif
//#if DEPTH_BUFFER
var<private> tp_depths: array<u32, TP_ROWS * i32(TP_SAMPLES)>;
//#endif

//#if DIRECT
@group(1) @binding(0) var<storage, read_write> tp_indirect: array<u32>;

// 32 triangles as the tile stage would leave them, and those of them that touch the tile.
var<workgroup> tp_entries: array<vec4<u32>, 96>;
//#if BALLOT
//#else
var<workgroup> tp_touching: array<u32, 32>;
//#endif

// Block `block` of 32 triangles: which of them touch the tile? Their entries are in tp_entries.
fn tp_touch(block: u32, tile: u32, origin: vec2<i32>, lane: u32) -> u32 {
    let index = block * 32u + lane;
    // Until all lanes have done with the entries of the block before.
    workgroupBarrier();
    var touches = false;
    if (lane < 32u) {
        let base = (tp_first_triangle() + index) * TP_TRIANGLE_WORDS;
        let corner = vec2<i32>(vec2<u32>(tile & 7u, tile >> 3u));
        if (index < tp_triangle_count()) {
            let box = tp_box_in_bin(base, origin);
            if (all((box.low >> vec2<u32>(3u)) <= corner) && all((box.high >> vec2<u32>(3u)) >= corner)) {
                let t = tp_in_bin(base, origin, box);
                let e = t.most + t.a * (8 * corner.x) + t.b * (8 * corner.y);
                touches = (e.x | e.y | e.z) >= 0;
                tp_entries[lane * 3u] = bitcast<vec4<u32>>(vec4<i32>(t.c, t.a.x));
                tp_entries[lane * 3u + 1u] = bitcast<vec4<u32>>(vec4<i32>(t.a.yz, t.b.xy));
                tp_entries[lane * 3u + 2u] = vec4<u32>(bitcast<u32>(t.b.z), t.box, t.planes, t.draw_and_flags);
            }
        }
//#if BALLOT
//#else
        tp_touching[lane] = select(0u, 1u << lane, touches);
//#endif
    }
//#if BALLOT
    let bits = subgroupBallot(touches).x;
    workgroupBarrier();
    return bits;
//#else
    workgroupBarrier();
    var bits = 0u;
    for (var k = 0u; k < 32u; k++) {
        bits |= tp_touching[k];
    }
    return bits;
//#endif
}
//#else
// A word of the lists.
fn tp_list(at: u32) -> u32 {
    return tp_lists[at >> 2u][at & 3u];
}
//#endif

@compute @workgroup_size(TP_LANES)
//#if BALLOT
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(subgroup_invocation_id) lane: u32) {
//#else
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
//#endif
    // Where the clear before the segment is the segment's to do, all tiles are drawn; else those that have any triangle.
    let clears = (tp.fresh & TP_FRESH_CLEARS) != 0u;
    let slot = group.x + group.y * 32768u;
//#if DIRECT
    if (slot >= tp.bins.x * tp.bins.y * 64u || tp_indirect[TP_FAILED] != 0u) {
        return;
    }
    let work = slot;
//#else
    if (slot >= tp_list(2u)) {
        return;
    }
    var work = slot;
    if (!clears) {
        work = tp_list(tp.work_base + slot);
    }
//#endif
    let bin = work >> 6u;
    let tile = work & 63u;
    let origin = vec2<u32>((bin % tp.bins.x) * 64u + (tile & 7u) * 8u, (bin / tp.bins.x) * 64u + (tile >> 3u) * 8u);
//#if DIRECT
    let bin_origin = vec2<i32>(vec2<u32>(bin % tp.bins.x, bin / tp.bins.x) * 64u);
    let blocks = tp_blocks();
//#else
    let first_block = tp_list(tp.bin_base + bin * 2u);
    let blocks = (tp_list(tp.bin_base + bin * 2u + 1u) + 31u) / 32u;
//#endif
    // The first triangle.
    var block = 0u;
    var bits = 0u;
    loop {
        if (bits != 0u || block >= blocks) {
            break;
        }
        //#include next_block
    }
//#if DIRECT
    if (bits == 0u && !clears) {
        return;
    }
//#endif

    let column = lane & 7u;
    let first_row = i32(lane >> 3u);
    let px = origin.x + column;
    let column_x = f32(i32(px));
    let local_x = i32((tile & 7u) * 8u + column);
    let local_top = i32((tile >> 3u) * 8u);
    // From a sample to the next one of the same pixel.
    let plane = tp.size.x * tp.size.y;
    var dirty = 0u;
    {
        var r = 0;
        loop {
            let row = origin.y + u32(first_row + r * TP_ROW_STEP);
            let at = min(row, tp.size.y - 1u) * tp.size.x + min(px, tp.size.x - 1u);
            dirty |= select(0u, 1u << u32(r), clears && row < tp.size.y && px < tp.size.x);
//#each $
            tp_pixels[r * i32(TP_SAMPLES) + $] = tp_first_pixel(at + $u * plane, tp.fresh);
//#if DEPTH_BUFFER
            tp_depths[r * i32(TP_SAMPLES) + $] = tp_first_depth(at + $u * plane, tp.fresh);
//#endif
//#end
//#if REJECTS
            tp_furthest[r] = 0u;
//#each $
            tp_furthest[r] = max(tp_furthest[r], tp_depths[r * i32(TP_SAMPLES) + $] & TP_DEPTH_MASK);
//#end
//#endif
            continuing {
                r++;
                break if r >= TP_ROWS;
            }
        }
    }

    var more = bits != 0u;
    if (more) {
        // The next entry is loaded while this one is drawn.
        var next_0: vec4<u32>;
        var next_1: vec4<u32>;
        var next_2: vec4<u32>;
        {
            //#include next_entry
        }
        loop {
            let te_0 = next_0;
            let te_1 = next_1;
            let te_2 = next_2;
            // To the next triangle of this tile.
            bits &= bits - 1u;
            loop {
                if (bits != 0u || block >= blocks) {
                    break;
                }
                //#include next_block
            }
            more = bits != 0u;
            if (more) {
                //#include next_entry
            }
            let draw_and_flags = WORD(te, 11);
            let flags = draw_and_flags >> 24u;
            // The draw's states.
            let draw = tp.draws + (draw_and_flags & 0xffffffu) * TP_DRAW_WORDS;
            //#load sa tp_records draw
//#if STATE_SECOND
            //#load sb tp_records draw + 8u
//#endif
//#if STENCIL_TEST
            //#load sc tp_records draw + select(24u, 16u, (flags & TP_FRONT) != 0u)
//#endif
            //#include entry
            let e0 = c + a * local_x + b * (local_top + first_row);
            // A constant number of rounds: pixels stay in registers.
            for (var r = 0; r < TP_ROWS; r++) {
                let row = first_row + r * TP_ROW_STEP;
                let e = e0 + b * (r * TP_ROW_STEP);
                let py = i32(origin.y) + row;
                var allowed = true;
//#if CUT
                allowed = in_columns && row >= low && row <= high;
//#endif
//#if STIPPLE
                allowed = allowed && tp_stipple(state, flags, px, u32(py));
//#endif
//#if SAMPLES
                //#include samples
//#else
                let inside = allowed && (e.x | e.y | e.z) >= 0;
                //#include fragment
//#endif
            }
            continuing {
                break if !more;
            }
        }
    }

//#if DEPTH_CHANGES
//#else
    let clears_depth = clears && (tp.fresh & TP_FRESH_DEPTH) != 0u;
//#endif
    {
        var r = 0;
        loop {
            let py = origin.y + u32(first_row + r * TP_ROW_STEP);
            if ((dirty & (1u << u32(r))) != 0u) {
                let at = py * tp.size.x + px;
//#each $
                tp_store_pixel(at + $u * plane, tp_pixels[r * i32(TP_SAMPLES) + $]);
//#if DEPTH_CHANGES
                tp_depth[at + $u * plane] = tp_depths[r * i32(TP_SAMPLES) + $];
//#else
                if (clears_depth) {
                    tp_depth[at + $u * plane] = tp.clear_depth;
                }
//#endif
//#end
            }
            continuing {
                r++;
                break if r >= TP_ROWS;
            }
        }
    }
}
