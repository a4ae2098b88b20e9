// Queued blocks of 64 x 64 pixels of large triangles, in rounds of TP_ITEMS a workgroup: a lane sets each up for all, then 32 lanes draw it,
// patches of 8 x 4 samples.

var<workgroup> tp_item_count: u32;
var<workgroup> tp_walks: array<TpWalk, TP_ITEMS>;
// The block of the triangle, column and row; TP_NONE where there is nothing to draw.
var<workgroup> tp_walked_blocks: array<u32, TP_ITEMS>;

// Sets item `item` of the queue up; false where nothing is to be drawn of it.
fn tp_walk_item(item: u32, walk: ptr<function, TpWalk>) -> bool {
    let at = tf.item_base + item * 3u;
    let index = atomicLoad(&tp_queue[at]);
//#if SET_UP
    tp_walk_triangle(index, walk);
    return true;
//#else
    let triangle = atomicLoad(&tp_queue[at + 1u]);
    let p = tp_primitive(index);
    var corners = vec3<u32>(0u, 1u, 2u);
    if (triangle > 0u) {
        let fan = tf.fan_base + (atomicLoad(&tp_queue[tf.map_base + index - tf.first_primitive]) + triangle - 1u) * 3u;
        corners = vec3<u32>(atomicLoad(&tp_queue[fan]), atomicLoad(&tp_queue[fan + 1u]), atomicLoad(&tp_queue[fan + 2u]));
    }
    return tp_walk(p, index, triangle, tp_corner_at(p, corners.x), tp_corner_at(p, corners.y), tp_corner_at(p, corners.z), walk);
//#endif
}

// Offers the samples of a block that one of 32 lanes looks at.
fn tp_offer_block(walk: ptr<function, TpWalk>, block: u32, lane: vec2<i32>) {
    let low = (*walk).low + 64 * vec2<i32>(vec2<u32>(block & 0xffffu, block >> 16u));
    let high = min((*walk).high, low + 63);
    let dx = (*walk).x - (*walk).x.yzx;
    let dy = (*walk).y - (*walk).y.yzx;
    var row = tp_wide_edges(dx, dy, (*walk).x - low.x * 256, (*walk).y - low.y * 256) - dy * lane.x + dx * lane.y;
    for (var py = low.y + lane.y; py <= high.y; py += 4) {
        var e = row;
        for (var px = low.x + lane.x; px <= high.x; px += 8) {
            if ((e.x | e.y | e.z) >= 0) {
                tp_offer(walk, px, py, tp_fma(f32(px), (*walk).z.y, (*walk).z.x));
            }
            e -= dy * 8;
        }
        row += dx * 4;
    }
}

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>, @builtin(local_invocation_index) index_in_group: u32) {
    if (index_in_group == 0u) {
//#if SET_UP
        tp_item_count = tf.item_capacity;
//#else
        tp_item_count = min(atomicLoad(&tp_queue[TP_BLOCKS]), tf.item_capacity);
//#endif
    }
    let count = workgroupUniformLoad(&tp_item_count);
    let lane = vec2<i32>(i32(index_in_group & 7u), i32((index_in_group >> 3u) & 3u));
    var walk: TpWalk;
    for (var first = group.x * TP_ITEMS; first < count; first += groups.x * TP_ITEMS) {
        let items = min(count - first, TP_ITEMS);
        if (index_in_group < items) {
            let item = first + index_in_group;
            let draws = tp_walk_item(item, &walk);
            tp_walks[index_in_group] = walk;
            tp_walked_blocks[index_in_group] = select(TP_NONE, atomicLoad(&tp_queue[tf.item_base + item * 3u + 2u]), draws);
        }
        workgroupBarrier();
        for (var k = index_in_group / 32u; k < items; k += TP_LANES / 32u) {
            let block = tp_walked_blocks[k];
            if (block != TP_NONE) {
                walk = tp_walks[k];
                tp_offer_block(&walk, block, lane);
            }
        }
        workgroupBarrier();
    }
}
