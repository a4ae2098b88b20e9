// The next block of 32 triangles: which of them touch the tile?
//#if DIRECT
bits = tp_touch(block, tile, bin_origin, lane);
//#else
bits = tp_list(tp.tile_base + (first_block + block) * 64u + tile);
//#endif
block++;
