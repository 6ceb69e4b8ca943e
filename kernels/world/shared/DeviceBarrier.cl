// uses: world/stages/World.cl
// A barrier over all work-groups of a launch. It needs all of them to run at once, which OpenCL does not promise: the host enqueues no
// more than the device has room for, and only on devices where that and the barrier are known to hold. One work-group alone runs anywhere.

// OpenCL 1.2 orders nothing beyond a work-group, and its fences leave the first-level cache stale: the two functions that do
// are PTX, for NVIDIA devices. From the host: PTX. On others one work-group alone may run this, which needs neither.

// Counts this work-group, after all that it has written is visible; returns how many were counted before.
int arrive(volatile global int *arrivals) {
#if PTX
    int before;
    asm volatile("atom.release.gpu.global.add.s32 %0, [%1], 1;" : "=r"(before) : "l"(arrivals) : "memory");
    return before;
#else
    return atomic_inc(arrivals);
#endif
}

// How many have been counted; what these have written is visible from here on.
int arrived(volatile global int *arrivals) {
#if PTX
    int count;
    asm volatile("ld.acquire.gpu.global.s32 %0, [%1];" : "=r"(count) : "l"(arrivals) : "memory");
    return count;
#else
    return *arrivals;
#endif
}

// Waits until all work-groups are here; a single one for its own work-items alone. arrivals: counts them; starts at 0.
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

// Ends a work-group. The last one makes the counters ready for the next launch.
void leave(const World *w) {
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    if (get_local_id(0) != 0 || get_num_groups(0) == 1) return;
    if (atomic_inc(&w->status[DEPARTURES]) == (int) get_num_groups(0) - 1) {
        w->status[ARRIVALS] = 0;
        w->status[DEPARTURES] = 0;
    }
}
