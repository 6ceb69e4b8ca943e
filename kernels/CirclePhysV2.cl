// The seven kernels of S. Young, "Memory Organization and Buffer Construction for GPGPU for 2D Physics" (honours
// thesis, Memorial University of Newfoundland, 2014): n rigid, non-rotating circles in the unit square, with one slot of
// a collision buffer for each unordered pair of circles.
//
// Buffers: circle float4[n] (x, y, radius, mass); velocities float2[n]; gravity float2[1]; collision float2[n(n-1)/2],
// the minimum translation vector (MTV) of the pair, (0, 0) when apart; indexes int2[n(n-1)/2], the (i, j) of a slot;
// rows int2[n], the first and the last slot of a row. Slots run row by row: row i holds (i, i+1), (i, i+2), .. (i, n-1).
// n is at most 65536: then a slot number fits an int, and i(i+1) and i(n-1) fit a uint.
//
// Written for one work-item at a time, with a branch where few pairs pass: on POCL (AVX-512, 780,625 slots) the branchy
// detect kernels took 0.6 to 2.8 ms; reshaped so that several work-items run in one vector register, which turns every
// read of a circle into a gather, they took 1.2 to 5.4 ms.

#define HELPER static inline __attribute__((always_inline))

// Rounds of the row search: enough for n <= 2^ROW_SEARCH_ROUNDS. The host defines the smallest that does.
#ifndef ROW_SEARCH_ROUNDS
#define ROW_SEARCH_ROUNDS 16
#endif

// The slots of a work-item: one. Where the host defines FEW_WORK_ITEMS, as it does for a GPU, it starts as many work-items
// as the device runs at once, and each goes on to further slots: to read the slots of n = 15000, an H200 needs 0.29 ms by
// a work-item each, most of it to start them, and 0.21 ms this way. On POCL such a loop costs a fifth.
#ifdef FEW_WORK_ITEMS
#define FOR_EACH_SLOT(c, slots) for (size_t c = get_global_id(0); c < (uint)(slots); c += get_global_size(0))
#else
#define FOR_EACH_SLOT(c, slots)            \
    const size_t c = get_global_id(0);     \
    if (c < (uint)(slots))
#endif

// The slots whose MTVs a work-item of the resolve kernels reads before it looks at the first of them. One read a work-item
// is too few to keep the memory of a GPU busy: at n = 15000, where an H200 resolves in 0.37 ms with a group of 1, it takes
// 0.35, 0.33 and 0.30 ms with groups of 4, 8 and 16. The slots of a group lie as far apart as there are work-items, so
// that neighbours read neighbours.
#ifdef FEW_WORK_ITEMS
#define GROUP 16
#define FOR_EACH_GROUP(first, slots) \
    for (size_t first = get_global_id(0); first < (uint)(slots); first += GROUP * get_global_size(0))
#else
#define GROUP 1
#define FOR_EACH_GROUP(first, slots) FOR_EACH_SLOT(first, slots)
#endif

// ---------------------------------------------------------------------------------------------- pair indexing

// The second circle of slot c, given that c lies in row i; exact. For 0 <= i < n - 1 and any slot c of n circles the
// value lies strictly between -2^31 and 2^31, so the sum modulo 2^32 is the sum.
HELPER int collision_column(uint c, int i, int circles) {
    const uint u = (uint)i;
    return (int)(c + u * (u + 1) / 2 - u * (uint)(circles - 1) + 1);
}

// Whether (i, j) is the pair of its slot, for a j that collision_column derived from i. Row i begins at slot
// f = i(n-1) - i(i-1)/2 and has n-1-i slots, and j = i + 1 + (c - f). Hence i < j says that c is not before row i, and
// j < n that it is not after it: both hold for the one right i and for no other. An i of n - 1 or more fails for any j.
HELPER int collision_pair_is_right(int2 pair, int circles) {
    return (pair.x >= 0) & (pair.x < pair.y) & (pair.y < circles);
}

// An int of at least 0 as a float, rounded toward zero. A GPU has an instruction for it; on POCL convert_float_rtz is many
// times slower than this.
HELPER float round_toward_zero(int value) {
#ifdef FEW_WORK_ITEMS
    return convert_float_rtz(value);
#else
    const float nearest = (float)value;
    return (int)nearest > value ? as_float(as_int(nearest) - 1) : nearest;
#endif
}

// Strategy 0, computed: the root of a quadratic in single precision, as in the thesis. Where 4m(m+1) and 8c pass 2^24,
// the difference below the root is rounded, and some slots get the row before or after their own: from n = 2050 on an
// NVIDIA H200, and for 95,474 of the 112,492,500 slots of n = 15000 on POCL 3.1, which fuses a product into the
// difference (45,125 where it may not). The caller must ask collision_pair_is_right. fmax keeps the root defined where
// rounding has made its operand negative; the row that then comes out is n - 1, which no pair has.
HELPER int2 collision_map_s1(uint c, int circles) {
    const float m = (float)(circles - 1);
    const float slot = round_toward_zero((int)c);
    const float root = native_sqrt(fmax(4.0f * m * (m + 1.0f) - 8.0f * slot - 7.0f, 0.0f));
    const float ii = (-2.0f * m - 1.0f + root) / -2.0f;
    const int whole = (int)ii;
    const int i = whole - (ii == (float)whole);
    return (int2)(i, collision_column(c, i, circles));
}

// Strategy 1, look-up table.
HELPER int2 collision_map_s2(size_t c, __global const int2 *indexes) {
    return indexes[c];
}

// Strategy 2, row search: the last row that begins at or before c. It is the row that holds c, since rows follow each
// other without a gap and only the last, row n - 1, is empty: it begins after every slot. The row is one of the `length`
// rows from i on; the lengths are the same for every slot, and the fixed number of rounds lets the compiler unroll the
// search without a branch. Rounds beyond a length of 1 change nothing.
HELPER int2 collision_map_s3(uint c, __global const int2 *rows, int circles) {
    const int slot = (int)c;
    int i = 0;
    int length = circles;
#pragma unroll
    for (int round = 0; round < ROW_SEARCH_ROUNDS; round++) {
        const int half_length = length >> 1;
        const int middle = i + half_length;
        i = rows[middle].x <= slot ? middle : i;
        length -= half_length;
    }
    return (int2)(i, collision_column(c, i, circles));
}

// ---------------------------------------------------------------------------------------------- one pair

// Writes the MTV of circles i and j, pointing from i to j, or (0, 0) when they are apart. Where the thesis divides 0 by
// 0, for coincident centres, there is no direction to part them in: no MTV.
HELPER void detect_pair(__global const float4 *circle, __global float2 *collision, size_t c, int2 pair) {
    const float4 first = circle[pair.x];
    const float4 second = circle[pair.y];
    const float2 difference = second.xy - first.xy;
    const float distance = native_sqrt(difference.x * difference.x + difference.y * difference.y);
    const float reach = first.z + second.z;
    float2 mtv = (float2)(0.0f, 0.0f);
    if (distance < reach && distance > 0.0f) {
        mtv = (reach - distance) * (difference / distance);
    }
    collision[c] = mtv;
}

// Parts an overlapping pair and exchanges its impulse. Two work-items may hold slots that share a circle, and these are
// plain reads, sums and writes: a data race by design of the thesis, which this file keeps. An MTV whose square is zero
// counts as none.
HELPER void resolve_pair(
    __global float4 *circle, __global float2 *velocities, float2 mtv, int2 pair, float restitution) {
    // All reads first: one round trip to memory instead of three.
    const float4 first = circle[pair.x];
    const float4 second = circle[pair.y];
    const float2 velocity_i = velocities[pair.x];
    const float2 velocity_j = velocities[pair.y];

    *(__global float2 *)(circle + pair.x) = first.xy - 0.5f * mtv;
    *(__global float2 *)(circle + pair.y) = second.xy + 0.5f * mtv;

    const float2 normal = mtv / native_sqrt(mtv.x * mtv.x + mtv.y * mtv.y);
    const float approach = dot(velocity_i - velocity_j, normal);
    const float impulse = -(1.0f + restitution) * approach / (1.0f / first.w + 1.0f / second.w);
    velocities[pair.x] = velocity_i + impulse / first.w * normal;
    velocities[pair.y] = velocity_j - impulse / second.w * normal;
}

HELPER int has_mtv(float2 mtv) {
    return mtv.x * mtv.x + mtv.y * mtv.y > 0.0f;
}

// Slot k of the group that begins at slot `first`.
HELPER size_t slot_of_group(size_t first, int k) {
    return first + k * get_global_size(0);
}

// Reads the MTVs of a group; those of slots that there are not are none.
HELPER void read_group(float2 *mtvs, __global const float2 *collision, size_t first, int slots) {
#pragma unroll
    for (int k = 0; k < GROUP; k++) {
        const size_t c = slot_of_group(first, k);
        mtvs[k] = c < (uint)slots ? collision[c] : (float2)(0.0f, 0.0f);
    }
}

// ---------------------------------------------------------------------------------------------- the kernels

// Moves a circle by one time step and reflects it at the walls of [0,1]^2. One work-item a circle: a few operations.
__kernel void update_position(
    __global float4 *circle,
    __global float2 *velocities,
    __global const float2 *gravity,
    int circles,
    float time_step,
    float restitution) {
    const uint id = (uint)get_global_id(0);
    if (id >= (uint)circles) {
        return;
    }
    const float4 body = circle[id];
    const float radius = body.z;
    const float2 old_velocity = velocities[id];
    const float2 acceleration = gravity[0];

    float2 position = body.xy + old_velocity * time_step + 0.5f * acceleration * time_step * time_step;
    const float2 rebound = -2.0f * restitution * old_velocity;
    float2 bounce = (float2)(0.0f, 0.0f);
    int bounced = 0;
    if (position.x - radius < 0.0f) {
        position.x = -(position.x - radius) + radius;
        bounce.x = rebound.x;
        bounced = 1;
    } else if (position.x + radius > 1.0f) {
        position.x = 2.0f - (position.x + radius) - radius;
        bounce.x = rebound.x;
        bounced = 1;
    }
    if (position.y - radius < 0.0f) {
        position.y = -(position.y - radius) + radius;
        bounce.y = rebound.y;
        bounced = 1;
    } else if (position.y + radius > 1.0f) {
        position.y = 2.0f - (position.y + radius) - radius;
        bounce.y = rebound.y;
        bounced = 1;
    }
    // As in the thesis, a bounce on one axis scales the velocity of both by the restitution.
    const float2 velocity = old_velocity + acceleration * time_step;
    velocities[id] = bounced ? restitution * velocity + bounce : velocity;
    *(__global float2 *)(circle + id) = position;
}

// Strategy 0: the MTV of every pair. One work-item a slot: a square root for the pair and one for its distance; a slot
// that collision_map_s1 maps wrongly is cleared and left.
__kernel void detect_collisions(
    __global const float4 *circle, __global float2 *collision, int potential_collisions, int circles) {
    FOR_EACH_SLOT(c, potential_collisions) {
        const int2 pair = collision_map_s1((uint)c, circles);
        // A wrong pair becomes (0, 0): a circle is at no distance from itself, so the slot is cleared.
        const int right = collision_pair_is_right(pair, circles);
        detect_pair(circle, collision, c, (int2)(right ? pair.x : 0, right ? pair.y : 0));
    }
}

// Strategy 2: the MTV of every pair. One work-item a slot: ROW_SEARCH_ROUNDS reads of rows and a square root.
__kernel void detect_collisions_precomputed_rows(
    __global const float4 *circle,
    __global float2 *collision,
    __global const int2 *rows,
    int potential_collisions,
    int circles) {
    FOR_EACH_SLOT(c, potential_collisions) {
        detect_pair(circle, collision, c, collision_map_s3((uint)c, rows, circles));
    }
}

// Strategy 1: the MTV of every pair. One work-item a slot: a read of indexes and a square root.
__kernel void detect_collisions_precomputed_pairs(
    __global const float4 *circle,
    __global float2 *collision,
    __global const int2 *indexes,
    int potential_collisions) {
    FOR_EACH_SLOT(c, potential_collisions) {
        detect_pair(circle, collision, c, collision_map_s2(c, indexes));
    }
}

// Strategy 0: the response of every overlapping pair. One work-item a slot: a read where the slot is empty, which most
// are; else the mapping and a dozen reads and writes, which race with those of other slots of the same circles.
__kernel void resolve_collisions(
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
                const int2 pair = collision_map_s1((uint)c, circles);
                // Asked again: the compiler may round the formula otherwise here than in detect_collisions.
                if (collision_pair_is_right(pair, circles)) {
                    resolve_pair(circle, velocities, mtvs[k], pair, restitution);
                }
            }
        }
    }
}

// Strategy 2: as resolve_collisions, with the row search.
__kernel void resolve_collisions_with_rows(
    __global float4 *circle,
    __global const float2 *collision,
    __global float2 *velocities,
    __global const int2 *rows,
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
                resolve_pair(circle, velocities, mtvs[k], collision_map_s3((uint)c, rows, circles), restitution);
            }
        }
    }
}

// Strategy 1: as resolve_collisions, with the look-up table.
__kernel void resolve_collisions_with_pairs(
    __global float4 *circle,
    __global const float2 *collision,
    __global float2 *velocities,
    __global const int2 *indexes,
    int potential_collisions,
    float restitution) {
    FOR_EACH_GROUP(first, potential_collisions) {
        float2 mtvs[GROUP];
        read_group(mtvs, collision, first, potential_collisions);
#pragma unroll
        for (int k = 0; k < GROUP; k++) {
            if (has_mtv(mtvs[k])) {
                const size_t c = slot_of_group(first, k);
                resolve_pair(circle, velocities, mtvs[k], collision_map_s2(c, indexes), restitution);
            }
        }
    }
}
