// To the next triangle of this tile.
bits &= bits - 1u;
loop {
    if (bits != 0u || block >= blocks) {
        break;
    }
    bits = tp_list(masks + block * 64u, lane);
    block++;
}
more = bits != 0u;
entry = (first_block + block - 1u) * 32u + countTrailingZeros(bits);
