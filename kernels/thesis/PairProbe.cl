// Looks at the pair indexing of every strategy, for tests. Comes after CirclePhysV2.cl, thesis/ExactPairs.cl and
// thesis/WrongSlots.cl. None of the kernels needs a collision buffer.

// Defines a kernel that adds the number of slots that MAP gets wrong to wrong[0], as count_wrong_slots does for strategy
// 0; one that writes the pair of every slot; and one that writes the pairs of the slots in a list. TABLE is the strategy's buffer. The first shares the slots out in blocks
// to as many work-items as the host starts: a long block is a loop of vector instructions, which counts the
// 2,147,450,880 slots of n = 65536 five times faster where the mapping is arithmetic, and five times slower where it reads
// a table. The others take one work-item per slot. A slot costs what the mapping costs.
#define PROBE(NAME, TABLE, MAP)                                                                        \
    __kernel void count_wrong_##NAME(                                                                  \
        __global uint *wrong, __global const int2 *TABLE, int potential_collisions, int circles) {     \
        const uint slots = (uint)potential_collisions;                                                 \
        const uint block = (slots - 1) / (uint)get_global_size(0) + 1;                                 \
        const uint first = (uint)get_global_id(0) * block;                                             \
        const uint end = min(first + block, slots);                                                    \
        uint count = 0;                                                                                \
        for (uint c = first; c < end; c++) {                                                           \
            count += !slot_holds_pair(c, MAP, circles);                                                \
        }                                                                                              \
        if (count > 0) {                                                                               \
            atomic_add(wrong, count);                                                                  \
        }                                                                                              \
    }                                                                                                  \
    __kernel void map_##NAME(                                                                          \
        __global int2 *pairs, __global const int2 *TABLE, int potential_collisions, int circles) {     \
        const uint c = (uint)get_global_id(0);                                                         \
        if (c < (uint)potential_collisions) {                                                          \
            const int2 pair = MAP;                                                                     \
            __global int *target = (__global int *)(pairs + c);                                        \
            target[0] = pair.x;                                                                        \
            target[1] = pair.y;                                                                        \
        }                                                                                              \
    }                                                                                                  \
    __kernel void map_some_##NAME(                                                                     \
        __global int2 *pairs, __global const int2 *TABLE, int potential_collisions, int circles,       \
        __global const uint *list, int length) {                                                       \
        const int k = (int)get_global_id(0);                                                           \
        if (k < length) {                                                                              \
            const uint c = list[k];                                                                    \
            const int2 pair = MAP;                                                                     \
            __global int *target = (__global int *)(pairs + k);                                        \
            target[0] = pair.x;                                                                        \
            target[1] = pair.y;                                                                        \
        }                                                                                              \
    }

PROBE(computed, unused, collision_map_s1(c, circles))
PROBE(pairs, indexes, collision_map_s2(c, indexes))
PROBE(rows, rows, collision_map_s3(c, rows, circles))
PROBE(exact, unused, collision_map_exact(c, potential_collisions, circles))
