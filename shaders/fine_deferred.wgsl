// The fine stage of fine_column.wgsl for opaque triangles with a depth test, where of a pixel's fragments only the last one that passes is seen. First
// every triangle leaves its depth and its place in the list in the pixels where it passes; then those that are left shade what they have. So a pixel is
// shaded once, however many triangles lie on top of each other: an `if` around the shading of hidden fragments would save nothing.

const TP_NO_ENTRY = 0xffffffffu;

var<private> tp_depths: array<u32, TP_ROWS>;
// Whose fragment is seen in each row, and not shaded yet.
var<private> tp_owners: array<u32, TP_ROWS>;

// The first entry in the list that has any of the tile's pixels.
fn tp_first_owner() -> u32 {
    var first = TP_NO_ENTRY;
//#each $ 8
    first = min(first, tp_owners[$]);
//#end
//#if SUBGROUP8
    // One for all lanes, because they load its words together.
    let of_lane = first;
//#each $ 8
    first = min(first, subgroupBroadcast(of_lane, $u));
//#end
//#endif
    return first;
}

@compute @workgroup_size(8 * TP_TEAMS)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) index_in_group: u32) {
    //#include column_start
    let x = column_x;
    var state: TpState;
    state.flags = 0xffffffffu;
    state.depth_func = TP_DEPTH_FUNC;
//#each $ 8
    let at_$ = (origin.y + $u) * size.x + px;
    let y_$ = f32(i32(origin.y) + $);
    tp_owners[$] = TP_NO_ENTRY;
//#end
    // What a clear has written is the same in all rows: one round is enough.
    var loaded = 0u;
    loop {
        let first = tp_first_depth(min(origin.y + loaded, size.y - 1u) * size.x + min(px, size.x - 1u), fresh);
//#each $ 8
        tp_depths[$] = select(tp_depths[$], first, loaded <= $u);
//#end
        continuing {
            loaded++;
            break if loaded >= 8u || (fresh & TP_FRESH_DEPTH) != 0u;
        }
    }

    loop {
        //#load te tp_lists entry_base + entry * TP_ENTRY_WORDS
        let this_entry = entry;
        //#include column_next
        //#include edges
        //#insert DEPTH_PLANES
        var e = c + a * local_x + b * local_top;
//#each $ 8
        {
            const row = $;
            let y = y_$;
            var inside = (e.x | e.y | e.z) >= 0;
//#if CUT
            inside = inside && in_columns && row >= low && row <= high;
//#endif
            //#insert DEPTH
            let passes = inside && tp_depth_test(state, depth, tp_depths[$] & TP_DEPTH_MASK);
            tp_depths[$] = select(tp_depths[$], (tp_depths[$] & ~TP_DEPTH_MASK) | depth, passes);
            tp_owners[$] = select(tp_owners[$], this_entry, passes);
            e += b;
        }
//#end
        continuing {
            break if !more;
        }
    }

//#each $ 8
    if (tp_owners[$] != TP_NO_ENTRY) {
        tp_depth[at_$] = tp_depths[$];
    }
//#end
    var owner = tp_first_owner();
    if (owner == TP_NO_ENTRY) {
        return;
    }
    loop {
        let at = entry_base + owner * TP_ENTRY_WORDS;
        let planes_and_draw = tp_list_pair(at + 10u, lane);
        let planes = planes_and_draw.x;
        let draw_and_flags = planes_and_draw.y;
        let flags = draw_and_flags >> 24u;
        let draw = draws + (draw_and_flags & 0xffffffu) * TP_DRAW_WORDS;
//#if SUBGROUP8
        let tp_fresh = draw != tp_kept_key;
        tp_kept_key = draw;
//#endif
        //#include resolve_state
        //#insert PLANES
        // The rows of this column that are its.
        var rows = 0u;
//#each $ 8
        rows |= select(0u, 1u << $u, tp_owners[$] == owner);
        tp_owners[$] = select(tp_owners[$], TP_NO_ENTRY, tp_owners[$] == owner);
//#end
        owner = tp_first_owner();
        var place = 0u;
        var pixel: TpPixel;
        loop {
            if (rows != 0u) {
                let py = i32(origin.y + countTrailingZeros(rows));
                let y = f32(py);
                var color = vec4<f32>(0.0);
                //#insert SHADE
                place = u32(py) * size.x + px;
                pixel = tp_merge(state, TpPixel(), color);
            }
            if (rows != 0u) {
                tp_store_pixel(place, pixel);
            }
            continuing {
                rows &= rows - 1u;
                break if rows == 0u;
            }
        }
        continuing {
            break if owner == TP_NO_ENTRY;
        }
    }
}
