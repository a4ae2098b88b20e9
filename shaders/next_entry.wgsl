// The entry of the first triangle left of the block.
//#if DIRECT
let at = countTrailingZeros(bits) * 3u;
next_0 = tp_entries[at];
next_1 = tp_entries[at + 1u];
next_2 = tp_entries[at + 2u];
//#else
let at = (tp.entry_base + ((first_block + block - 1u) * 32u + countTrailingZeros(bits)) * TP_ENTRY_WORDS) >> 2u;
next_0 = tp_lists[at];
next_1 = tp_lists[at + 1u];
next_2 = tp_lists[at + 2u];
//#endif
