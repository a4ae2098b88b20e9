// One lane: what did not fit its queue stops the batch, and the counters are ready for the next segment.

@group(1) @binding(0) var<storage, read_write> tp_indirect: array<u32>;

@compute @workgroup_size(1)
fn tp_main() {
    let items = atomicExchange(&tp_queue[TP_BLOCKS], 0u);
    let to_clip = atomicExchange(&tp_queue[TP_TO_CLIP], 0u);
    let pooled = atomicExchange(&tp_queue[TP_POOLED], 0u);
    let fans = atomicExchange(&tp_queue[TP_FANS], 0u);
    let fits = items <= tf.item_capacity && to_clip <= tf.queue_capacity && pooled <= tf.pool_capacity && fans <= tf.fan_capacity;
    if (!fits && tp_indirect[TP_FAILED] == 0u) {
        tp_indirect[TP_FAILED] = tp.action + 1u;
        tp_indirect[TP_FAILED + 3u] = pooled;
        tp_indirect[TP_FAILED + 4u] = max(to_clip, fans);
        tp_indirect[TP_FAILED + 7u] = items;
    }
}
