// Counts the slots that strategy 0 maps wrongly. Comes after CirclePhysV2.cl. Needs no collision buffer, so it reaches
// every n.

// Whether the pair belongs to slot c, by the definition of the slots and not by the way the pair was found:
// 0 <= i < j < n, and the i(n-1) - i(i-1)/2 slots of the rows before i and the j-i-1 slots of its row before j come
// before c.
HELPER int slot_holds_pair(uint c, int2 pair, int circles) {
    const uint i = (uint)pair.x;
    const uint j = (uint)pair.y;
    const uint slot = i * (uint)(circles - 1) - i * (i - 1) / 2 + j - i - 1;
    return pair.x >= 0 && pair.x < pair.y && pair.y < circles && slot == c;
}

// Adds the number of wrong slots to wrong[0]. One work-item a slot: a square root, and an atomic addition where it is
// wrong, which few are.
__kernel void count_wrong_slots(__global uint *wrong, int potential_collisions, int circles) {
    const uint c = (uint)get_global_id(0);
    if (c < (uint)potential_collisions && !slot_holds_pair(c, collision_map_s1(c, circles), circles)) {
        atomic_inc(wrong);
    }
}
