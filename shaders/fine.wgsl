// A workgroup a tile of 8 x 8 pixels: walks the tile's triangles in order and runs the per-fragment operations on each
// covered pixel. Colour and depth stay in registers from the first triangle to the last.
//
// Kernel shape: 64 lanes, a pixel each, for GPUs; 8 lanes, a column of 8 pixels each, for lavapipe, where a loop runs
// its body once more than needed unless it ends with `break if`, an `if` skips nothing, and a load of one address by
// all lanes costs eight: hence the loads lane by lane with a broadcast (SUBGROUP8).
// The order of operations is that of src/raster/fine.rs.

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

// A word of the lists.
fn tp_list(at: u32) -> u32 {
//#if VECTORS
    return tp_lists[at >> 2u][at & 3u];
//#else
    return tp_lists[at];
//#endif
}

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let slot = group.x + group.y * 32768u;
    if (slot >= tp_list(2u)) {
        return;
    }
    let work = tp_list(tp.work_base + slot);
    let bin = work >> 6u;
    let tile = work & 63u;
    let origin = vec2<u32>((bin % tp.bins.x) * 64u + (tile & 7u) * 8u, (bin / tp.bins.x) * 64u + (tile >> 3u) * 8u);
    let first_block = tp_list(tp.bin_base + bin * 2u);
    let blocks = (tp_list(tp.bin_base + bin * 2u + 1u) + 31u) / 32u;
    // The first triangle.
    var block = 0u;
    var bits = 0u;
    loop {
        bits = tp_list(tp.tile_base + (first_block + block) * 64u + tile);
        continuing {
            block++;
            break if bits != 0u || block >= blocks;
        }
    }
    if (bits == 0u) {
        return;
    }

    let column = lane & 7u;
    let first_row = i32(lane >> 3u);
    let px = origin.x + column;
    let x = f32(i32(px));
    let local_x = i32((tile & 7u) * 8u + column);
    let local_top = i32((tile >> 3u) * 8u);
    // From a sample to the next one of the same pixel.
    let plane = tp.size.x * tp.size.y;
    var dirty = 0u;
    {
        var r = 0;
        loop {
            let py = min(origin.y + u32(first_row + r * TP_ROW_STEP), tp.size.y - 1u);
            let at = py * tp.size.x + min(px, tp.size.x - 1u);
//#each $
            tp_pixels[r * i32(TP_SAMPLES) + $] = tp_load_pixel(at + $u * plane);
//#if DEPTH_BUFFER
            tp_depths[r * i32(TP_SAMPLES) + $] = tp_depth[at + $u * plane];
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

    var entry = (first_block + block - 1u) * 32u + countTrailingZeros(bits);
    var more = true;
//#if VECTORS
    // The next entry is loaded while this one is drawn.
    var next_0 = tp_lists[(tp.entry_base + entry * TP_ENTRY_WORDS) >> 2u];
    var next_1 = tp_lists[((tp.entry_base + entry * TP_ENTRY_WORDS) >> 2u) + 1u];
    var next_2 = tp_lists[((tp.entry_base + entry * TP_ENTRY_WORDS) >> 2u) + 2u];
//#endif
    loop {
//#if VECTORS
        let ta_0 = next_0;
        let ta_1 = next_1;
        let tb_0 = next_1;
        let tb_1 = next_2;
//#else
        //#load ta tp_lists tp.entry_base + entry * TP_ENTRY_WORDS
        //#load tb tp_lists tp.entry_base + entry * TP_ENTRY_WORDS + 4u
//#endif
        // To the next triangle of this tile.
        bits &= bits - 1u;
        loop {
            if (bits != 0u || block >= blocks) {
                break;
            }
            bits = tp_list(tp.tile_base + (first_block + block) * 64u + tile);
            block++;
        }
        more = bits != 0u;
        entry = (first_block + block - 1u) * 32u + countTrailingZeros(bits);
//#if VECTORS
        if (more) {
            next_0 = tp_lists[(tp.entry_base + entry * TP_ENTRY_WORDS) >> 2u];
            next_1 = tp_lists[((tp.entry_base + entry * TP_ENTRY_WORDS) >> 2u) + 1u];
            next_2 = tp_lists[((tp.entry_base + entry * TP_ENTRY_WORDS) >> 2u) + 2u];
        }
//#endif
//#if SAMPLES
        // Low bits of the edge functions lie where others leave room: see tile.wgsl.
        let box = WORD(tb, 5) & 0x3f3f3f3fu;
        let planes = WORD(tb, 6) & 0xfffffffcu;
//#else
        let box = WORD(tb, 5);
        let planes = WORD(tb, 6);
//#endif
        let draw_and_flags = WORD(tb, 7);
        let flags = draw_and_flags >> 24u;
        let c = bitcast<vec3<i32>>(vec3<u32>(WORD(ta, 0), WORD(ta, 1), WORD(ta, 2)));
        let a = bitcast<vec3<i32>>(vec3<u32>(WORD(ta, 3), WORD(ta, 4), WORD(ta, 5)));
        let b = bitcast<vec3<i32>>(vec3<u32>(WORD(ta, 6), WORD(ta, 7), WORD(tb, 4)));
        // The draw's states.
        let draw = tp.draws + (draw_and_flags & 0xffffffu) * TP_DRAW_WORDS;
        //#load sa tp_records draw
//#if STATE_SECOND
        //#load sb tp_records draw + 8u
//#endif
//#if STENCIL_TEST
        //#load sc tp_records draw + select(24u, 16u, (flags & TP_FRONT) != 0u)
//#endif
        let fragment_uniforms = WORD(sa, 0);
//#if TEXTURES
        let textures = WORD(sa, 1);
        //#insert TEXTURES
//#endif
        var state: TpState;
        //#state
        // Planes of this triangle.
        //#insert PLANES
//#if SAMPLES
        // From the centres to the samples: edge functions, and the place where depth is evaluated.
        let several = (flags & TP_MULTISAMPLE) != 0u;
        let free = WORD(tb, 5);
        let low_bits = vec3<i32>(vec3<u32>(
            ((free >> 6u) & 3u) | (((free >> 14u) & 3u) << 2u),
            ((free >> 22u) & 3u) | ((free >> 30u) << 2u),
            (WORD(tb, 6) & 3u) | ((draw_and_flags >> 30u) << 2u)));
//#each $
        let edge_$ = select(vec3<i32>(0), (low_bits + a * TP_SAMPLE_X$ + b * TP_SAMPLE_Y$) >> vec3<u32>(4u), several);
//#end
//#if REJECTS
        var edge_most = edge_0;
//#each $
        edge_most = max(edge_most, edge_$);
//#end
        // How far the depth of any sample may lie below its pixel's, with all roundings.
        let depth_slack = (abs(p1) + abs(p2)) * 0.5 + (abs(p0) + abs(p1) * x + abs(p2) * f32(origin.y + 8u)) * 0x1p-20 + 0x1p-21;
//#endif
//#if SAMPLE_DEPTH
//#each $
        let zx_$ = tp_fma(x + select(0.0, f32(TP_SAMPLE_X$) / 16.0, several), p1, p0);
        let zy_$ = select(0.0, f32(TP_SAMPLE_Y$) / 16.0, several);
//#end
//#endif
//#endif
//#if CUT
        let in_columns = local_x >= i32(box & 255u) && local_x <= i32((box >> 8u) & 255u);
//#endif
        let low = max(i32((box >> 16u) & 255u), local_top) - local_top;
        let high = min(i32(box >> 24u), local_top + 7) - local_top;
//#if VECTORS
        let e0 = c + a * local_x + b * (local_top + first_row);
        // A constant number of rounds: pixels stay in registers.
        for (var r = 0; r < TP_ROWS; r++) {
            let row = first_row + r * TP_ROW_STEP;
            let e = e0 + b * (r * TP_ROW_STEP);
//#else
        var row = first_row + (low / TP_ROW_STEP) * TP_ROW_STEP;
        var e = c + a * local_x + b * (local_top + row);
        loop {
            let r = row / TP_ROW_STEP;
//#endif
            let py = i32(origin.y) + row;
            var allowed = true;
//#if CUT
            allowed = in_columns && row >= low && row <= high;
//#endif
//#if STIPPLE
            allowed = allowed && tp_stipple(state, flags, px, u32(py));
//#endif
//#if SAMPLES
            //#samples
//#else
            if (allowed && (e.x | e.y | e.z) >= 0) {
                let y = f32(py);
//#if DEPTH_BUFFER
                let old_depth = tp_depths[r];
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
//#if DEPTH_BUFFER
                tp_depths[r] = new_depth;
//#endif
//#if COLOR_WRITE
                if (passes) {
                    tp_pixels[r] = tp_merge(state, tp_pixels[r], color);
                }
//#endif
                dirty |= 1u << u32(r);
            }
//#endif
//#if VECTORS
//#else
            continuing {
                row += TP_ROW_STEP;
                e += b * TP_ROW_STEP;
                break if row > high;
            }
//#endif
        }
        continuing {
            break if !more;
        }
    }

    {
        var r = 0;
        loop {
            let py = origin.y + u32(first_row + r * TP_ROW_STEP);
            if ((dirty & (1u << u32(r))) != 0u) {
                let at = py * tp.size.x + px;
//#each $
                tp_store_pixel(at + $u * plane, tp_pixels[r * i32(TP_SAMPLES) + $]);
//#if DEPTH_BUFFER
                tp_depth[at + $u * plane] = tp_depths[r * i32(TP_SAMPLES) + $];
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
