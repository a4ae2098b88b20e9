// A workgroup a tile of 8 x 8 pixels: walks the tile's triangles in order and runs the per-fragment operations on each
// covered pixel. Colour and depth stay in registers from the first triangle to the last.
//
// Kernel shape: 64 lanes, a pixel each, for GPUs; 8 lanes, a column of 8 pixels each, for lavapipe, where a loop runs
// its body once more than needed unless it ends with `break if`, an `if` skips nothing, and a load of one address by
// all lanes costs eight: hence the loads lane by lane with a broadcast (SUBGROUP8).
// The order of operations is that of src/raster/fine.rs.

const TP_ROWS = 64u / TP_LANES;
const TP_ROW_STEP = TP_LANES / 8u;

var<private> tp_pixels: array<TpPixel, TP_ROWS>;
//#if DEPTH_BUFFER
var<private> tp_depths: array<u32, TP_ROWS>;
//#endif

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let slot = group.y + group.z * 32768u;
    if (slot >= tp_lists[1]) {
        return;
    }
    let bin = tp_lists[tp.active_base + slot];
    let tile = group.x;
    let origin = vec2<u32>((bin % tp.bins.x) * 64u + (tile & 7u) * 8u, (bin / tp.bins.x) * 64u + (tile >> 3u) * 8u);
    let first_block = tp_lists[tp.bin_base + bin * 2u];
    let blocks = (tp_lists[tp.bin_base + bin * 2u + 1u] + 31u) / 32u;
    // The first triangle.
    var block = 0u;
    var bits = 0u;
    loop {
        bits = tp_lists[tp.tile_base + (first_block + block) * 64u + tile];
        continuing {
            block++;
            break if bits != 0u || block >= blocks;
        }
    }
    if (bits == 0u) {
        return;
    }

    let column = lane & 7u;
    let first_row = lane >> 3u;
    let px = origin.x + column;
    let x = f32(px);
    var dirty = 0u;
    {
        var r = 0u;
        loop {
            let py = min(origin.y + first_row + r * TP_ROW_STEP, tp.size.y - 1u);
            let at = py * tp.size.x + min(px, tp.size.x - 1u);
            tp_pixels[r] = tp_load_pixel(at);
//#if DEPTH_BUFFER
            tp_depths[r] = tp_depth[at];
//#endif
            continuing {
                r++;
                break if r >= TP_ROWS;
            }
        }
    }

    loop {
        let entry = (first_block + block - 1u) * 32u + countTrailingZeros(bits);
        bits &= bits - 1u;
        let triangle = tp_lists[tp.list_base + entry];
        let base = triangle * TP_TRIANGLE_WORDS;
//#if SUBGROUP8
        let head = tp_triangles[base + 4u + column];
        let draw_index = subgroupBroadcast(head, 2u);
        let flags = subgroupBroadcast(head, 3u);
        let columns = subgroupBroadcast(head, 4u);
        let rows = subgroupBroadcast(head, 5u);
        let planes = subgroupBroadcast(head, 6u) * 4u;
        // Lanes 0, 1 and 2 work out one edge each.
        let e = min(column, 2u);
        let f = select(e + 1u, 0u, e == 2u);
        let ex = bitcast<i32>(tp_triangles[base + e]);
        let ey = bitcast<i32>(tp_triangles[base + 3u + e]);
        let edx = ex - bitcast<i32>(tp_triangles[base + f]);
        let edy = ey - bitcast<i32>(tp_triangles[base + 3u + f]);
        let ec = tp_edge_floor(edx, i32(origin.y) * 256 - ey, edy, i32(origin.x) * 256 - ex, tp_edge_bias(edx, edy), 8u);
        let dx = vec3<i32>(subgroupBroadcast(edx, 0u), subgroupBroadcast(edx, 1u), subgroupBroadcast(edx, 2u));
        let dy = vec3<i32>(subgroupBroadcast(edy, 0u), subgroupBroadcast(edy, 1u), subgroupBroadcast(edy, 2u));
        let c = vec3<i32>(subgroupBroadcast(ec, 0u), subgroupBroadcast(ec, 1u), subgroupBroadcast(ec, 2u));
//#else
        let draw_index = tp_triangles[base + TP_TRIANGLE_DRAW];
        let flags = tp_triangles[base + TP_TRIANGLE_FLAGS];
        let columns = tp_triangles[base + TP_TRIANGLE_COLUMNS];
        let rows = tp_triangles[base + TP_TRIANGLE_ROWS];
        let planes = tp_triangles[base + TP_TRIANGLE_PLANES] * 4u;
        let tx = vec3<i32>(bitcast<i32>(tp_triangles[base]), bitcast<i32>(tp_triangles[base + 1u]), bitcast<i32>(tp_triangles[base + 2u]));
        let ty = vec3<i32>(bitcast<i32>(tp_triangles[base + 3u]), bitcast<i32>(tp_triangles[base + 4u]), bitcast<i32>(tp_triangles[base + 5u]));
        let dx = tx - tx.yzx;
        let dy = ty - ty.yzx;
        let qx = i32(origin.x) * 256 - tx;
        let qy = i32(origin.y) * 256 - ty;
        let c = vec3<i32>(
            tp_edge_floor(dx.x, qy.x, dy.x, qx.x, tp_edge_bias(dx.x, dy.x), 8u),
            tp_edge_floor(dx.y, qy.y, dy.y, qx.y, tp_edge_bias(dx.y, dy.y), 8u),
            tp_edge_floor(dx.z, qy.z, dy.z, qx.z, tp_edge_bias(dx.z, dy.z), 8u));
//#endif
        // The draw's states.
        let draw = tp.draws + draw_index * TP_DRAW_WORDS;
        let fragment_uniforms = tp_records[draw + TP_DRAW_FRAGMENT_UNIFORMS];
        let state = tp_load_state(draw, column, flags);
        // Planes of this triangle.
        //#insert PLANES
        let in_columns = px >= (columns & 0xffffu) && px <= (columns >> 16u);
        let low = max(rows & 0xffffu, origin.y) - origin.y;
        let high = min(rows >> 16u, origin.y + 7u) - origin.y;
        let at_column = c - dy * i32(column);
        var row = first_row + (low / TP_ROW_STEP) * TP_ROW_STEP;
        loop {
            let e = at_column + dx * i32(row);
            var covered = (e.x | e.y | e.z) >= 0 && in_columns && row >= low && row <= high;
            let py = origin.y + row;
//#if STIPPLE
            covered = covered && tp_stipple(state, flags, px, py);
//#endif
            if (covered) {
                let y = f32(py);
                let r = row / TP_ROW_STEP;
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
                let depth_pass = tp_depth_test(state, depth, old_depth & 0xffffffu);
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
                let depth_pass = tp_depth_test(state, depth, old_depth & 0xffffffu);
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
                    new_depth = (new_depth & 0xff000000u) | depth;
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
                dirty |= 1u << r;
            }
            continuing {
                row += TP_ROW_STEP;
                break if row > high;
            }
        }
        // To the next block that holds a triangle of this tile.
        loop {
            if (bits != 0u || block >= blocks) {
                break;
            }
            bits = tp_lists[tp.tile_base + (first_block + block) * 64u + tile];
            block++;
        }
        continuing {
            break if bits == 0u;
        }
    }

    {
        var r = 0u;
        loop {
            let py = origin.y + first_row + r * TP_ROW_STEP;
            if ((dirty & (1u << r)) != 0u) {
                let at = py * tp.size.x + px;
                tp_store_pixel(at, tp_pixels[r]);
//#if DEPTH_BUFFER
                tp_depth[at] = tp_depths[r];
//#endif
            }
            continuing {
                r++;
                break if r >= TP_ROWS;
            }
        }
    }
}
