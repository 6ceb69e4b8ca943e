// uses: world/stages/World.cl
// A barrier over all work-groups of a launch. They must all run at once, which OpenCL does not promise: see the Java class PersistentGpu.
// OpenCL 1.2 orders nothing beyond a work-group, so two functions are PTX, on NVIDIA devices. One work-group alone needs neither.

// Counts this work-group, once its writes are visible; returns how many came before.
int arrive(volatile global int *arrivals) {
#if PTX
    int before;
    asm volatile("atom.release.gpu.global.add.s32 %0, [%1], 1;" : "=r"(before) : "l"(arrivals) : "memory");
    return before;
#else
    return atomic_inc(arrivals);
#endif
}

// How many have come; their writes are visible from here on.
int arrived(volatile global int *arrivals) {
#if PTX
    int count;
    asm volatile("ld.acquire.gpu.global.s32 %0, [%1];" : "=r"(count) : "l"(arrivals) : "memory");
    return count;
#else
    return *arrivals;
#endif
}

// arrivals: 0 at first.
void deviceBarrier(volatile global int *arrivals) {
    int groups = (int) get_num_groups(0);
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    if (get_local_id(0) == 0 && groups > 1) {
        int target = (arrive(arrivals) / groups + 1) * groups;
        while (arrived(arrivals) < target) {
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
}

// The last work-group makes the counters ready for the next launch.
void leave(const World *w) {
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    if (get_local_id(0) != 0 || get_num_groups(0) == 1) return;
    if (atomic_inc(&w->status[DEPARTURES]) == (int) get_num_groups(0) - 1) {
        w->status[ARRIVALS] = 0;
        w->status[DEPARTURES] = 0;
    }
}
