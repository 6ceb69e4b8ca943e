// Strategy 3, exact: the pair of a slot in closed form, without a table, right for every slot of every n from 2 to
// 65536. Comes after CirclePhysV2.cl, whose detect_pair and resolve_pair it uses.

// The pair of slot c. Counted from the end of the triangle, k = potential_collisions - 1 - c, rows have 1, 2, 3, ..
// slots: row n-2-t holds the k with t(t+1)/2 <= k < (t+1)(t+2)/2, so t is the whole part of x = sqrt(2k + 1/4) - 1/2.
//
// In single precision the estimate of x is less than 1/16 off, so that its whole part is at most one off, and one step
// down or up, decided in integers, makes it exact. Bound: rounding k to float and adding 1/4 each err by at most 2^-24
// of the value, or 2^-23 where a device rounds toward zero; the root halves that; sqrt adds 3 ulp, at most 3 * 2^-23
// (OpenCL's bound for single precision); the subtraction errs by at most 2^-23 of a value that is not larger. Together
// less than 6 * 2^-23 of the root, which is below 2^16 as k < 2^31: 6 * 2^-7 < 1/16. The estimate of k = 0 is no less
// than -1/16 and becomes 0. The true t is at most 65534, its estimate at most 65535, so that t(t+1) fits a uint.
HELPER int2 collision_map_exact(uint c, int potential_collisions, int circles) {
    const uint k = (uint)potential_collisions - 1 - c;
    uint t = (uint)(int)(sqrt(2.0f * (float)(int)k + 0.25f) - 0.5f);
    uint first = t * (t + 1) / 2;
    const uint down = first > k;
    first -= down ? t : 0;
    t -= down;
    const uint up = k - first > t;
    first += up ? t + 1 : 0;
    t += up;
    return (int2)(circles - 2 - (int)t, circles - 1 - (int)(k - first));
}

// The MTV of every pair. One work-item a slot: a square root for the pair and one for its distance.
__kernel void detect_collisions_exact(
    __global const float4 *circle, __global float2 *collision, int potential_collisions, int circles) {
    FOR_EACH_SLOT(c, potential_collisions) {
        detect_pair(circle, collision, c, collision_map_exact((uint)c, potential_collisions, circles));
    }
}

// The response of every overlapping pair, as resolve_collisions. One work-item a slot: a read where the slot is empty.
__kernel void resolve_collisions_exact(
    __global float4 *circle,
    __global const float2 *collision,
    __global float2 *velocities,
    int potential_collisions,
    int circles,
    float restitution) {
    FOR_EACH_GROUP(first, potential_collisions) {
        float2 mtvs[GROUP];
        read_group(mtvs, collision, first, potential_collisions);
#pragma unroll
        for (int k = 0; k < GROUP; k++) {
            if (has_mtv(mtvs[k])) {
                const size_t c = slot_of_group(first, k);
                resolve_pair(circle, velocities, mtvs[k], collision_map_exact((uint)c, potential_collisions, circles), restitution);
            }
        }
    }
}
