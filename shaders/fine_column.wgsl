// The fine stage for drivers that run on a processor: eight lanes, a column of a tile each, row by row. There an `if` skips nothing, a loop runs
// its body once more than needed unless it ends with `break if`, every lane's load or store through a buffer takes its turn, and so
// does every lane's access to an array whose index is not constant. Hence: one lane loads what all want, or each lane a word that is broadcast
// (SUBGROUP8); the words of a draw stay until the draw changes; rows are selected from variables, not indexed (one sample a pixel).

// A pixel's samples one after the other.
var<private> tp_pixels: array<TpPixel, TP_ROWS * i32(TP_SAMPLES)>;
//#if DEPTH_BUFFER
var<private> tp_depths: array<u32, TP_ROWS * i32(TP_SAMPLES)>;
//#endif

//#if SELECTS_ROW
fn tp_pixel_at(r: i32) -> TpPixel {
    var v = tp_pixels[0];
//#each $ 8
    v = select(v, tp_pixels[$], r == $);
//#end
    return v;
}

//#if DEPTH_BUFFER
fn tp_depth_at(r: i32) -> u32 {
    var v = tp_depths[0];
//#each $ 8
    v = select(v, tp_depths[$], r == $);
//#end
    return v;
}
//#endif

// What a fragment leaves in row r.
fn tp_keep(r: i32, covered: bool, depth_word: u32, colored: bool, pixel: TpPixel) {
//#if DEPTH_CHANGES
//#each $ 8
    tp_depths[$] = select(tp_depths[$], depth_word, covered && r == $);
//#end
//#endif
//#if COLOR_WRITE
//#each $ 8
    tp_pixels[$] = select(tp_pixels[$], pixel, colored && r == $);
//#end
//#endif
}
//#endif

@compute @workgroup_size(8 * TP_TEAMS)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) index_in_group: u32) {
    //#include column_start
    // From a sample to the next one of the same pixel.
    let plane = size.x * size.y;
    // Rows whose depth or stencil, and rows whose colour has changed.
    var dirty = 0u;
    var colored_rows = 0u;
//#if SAMPLES
    {
        var r = 0;
        loop {
            let py = min(origin.y + u32(r), size.y - 1u);
            let at = py * size.x + min(px, size.x - 1u);
//#each $
            tp_pixels[r * i32(TP_SAMPLES) + $] = tp_first_pixel(at + $u * plane, fresh);
//#if DEPTH_BUFFER
            tp_depths[r * i32(TP_SAMPLES) + $] = tp_first_depth(at + $u * plane, fresh);
//#endif
//#end
            continuing {
                r++;
                break if r >= TP_ROWS;
            }
        }
    }
//#else
//#each $ 8
    let at_$ = min(origin.y + $u, size.y - 1u) * size.x + min(px, size.x - 1u);
//#if READS_COLOR
    tp_pixels[$] = tp_first_pixel(at_$, fresh);
//#endif
//#if DEPTH_BUFFER
    tp_depths[$] = tp_first_depth(at_$, fresh);
//#endif
//#end
//#endif

    loop {
        //#load te tp_lists entry_base + entry * TP_ENTRY_WORDS
        //#include column_next
        let draw_and_flags = WORD(te, 11);
        let flags = draw_and_flags >> 24u;
        // The draw's states.
        let draw = draws + (draw_and_flags & 0xffffffu) * TP_DRAW_WORDS;
//#if SUBGROUP8
        // The draw's words stay while draw and facing do.
        let kept_key = draw * 2u + select(0u, 1u, (flags & TP_FRONT) != 0u);
        let tp_fresh = kept_key != tp_kept_key;
        tp_kept_key = kept_key;
//#endif
        //#load sa tp_records draw
//#if STATE_SECOND
        //#load sb tp_records draw + 8u
//#endif
//#if STENCIL_TEST
        //#load sc tp_records draw + select(24u, 16u, (flags & TP_FRONT) != 0u)
//#endif
        //#include entry
//#if SAMPLES
        var row = low;
        var e = c + a * local_x + b * (local_top + row);
        loop {
            let r = row;
            let py = i32(origin.y) + row;
            var allowed = true;
//#if CUT
            allowed = in_columns && row >= low && row <= high;
//#endif
//#if STIPPLE
            allowed = allowed && tp_stipple(state, flags, px, u32(py));
//#endif
            //#include samples
            continuing {
                row++;
                e += b;
                break if row > high;
            }
        }
//#else
//#if TALL
        // Most triangles fill most of their tiles' rows: all eight are drawn, each a text of its own.
        var e = c + a * local_x + b * local_top;
//#each $ 8
        {
            const r = $;
            const row = $;
            let py = i32(origin.y) + row;
            var inside = (e.x | e.y | e.z) >= 0;
//#if CUT
            inside = inside && in_columns && row >= low && row <= high;
//#endif
//#if STIPPLE
            inside = inside && tp_stipple(state, flags, px, u32(py));
//#endif
            //#include fragment
            e += b;
        }
//#end
//#else
        // A column meets a triangle in an interval of rows, and each lane walks its own: the rounds are those of the tallest column.
        var e = c + a * local_x + b * local_top;
        // All ones as long as nothing is covered; rows before the first that is; less 8, rows that are.
        var before = -1;
        var first = 0;
        var count = 8;
//#each $ 8
        {
            var out = (e.x | e.y | e.z) >> 31u;
//#if CUT
            out |= select(-1, 0, in_columns && $ >= low && $ <= high);
//#endif
            before &= out;
            first -= before;
            count += out;
            e += b;
        }
//#end
        var row = first;
        let end = first + count;
        loop {
            let r = row;
            let py = i32(origin.y) + row;
            var inside = row < end;
//#if STIPPLE
            inside = inside && tp_stipple(state, flags, px, u32(py));
//#endif
            //#include fragment
            continuing {
                row++;
                break if row >= end;
            }
        }
//#endif
//#endif
        continuing {
            break if !more;
        }
    }

//#if SAMPLES
    {
        var r = 0;
        loop {
            let py = origin.y + u32(r);
            if ((dirty & (1u << u32(r))) != 0u) {
                let at = py * size.x + px;
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
//#else
//#each $ 8
    if ((colored_rows & (1u << $u)) != 0u) {
        tp_store_pixel(at_$, tp_pixels[$]);
    }
//#if DEPTH_CHANGES
    if ((dirty & (1u << $u)) != 0u) {
        tp_depth[at_$] = tp_depths[$];
    }
//#endif
//#end
//#endif
}
