// uses: world/stages/World.cl
// Work-groups of one work-item that run at the same time and wait for each other, on devices whose compute units are the
// threads of a processor. OpenCL does not promise that they run at once, so a launch begins with a meeting that may fail: who
// waits too long calls it off for all, and all leave before anything has been changed. Once all have come, all are running,
// and later meetings cannot fail.

// A work-group that waits looks again and again. It cannot offer its processor to others: no OpenCL function does that. So on a
// busy machine it may wait for one that has no processor for a time slice of the system, a hundred times as long as a step takes.
// Work-groups measure how long they wait. The host chooses their number by that, and steps are left to it after they have waited for long.
#define LOOKS 100

#if defined(__x86_64__) && defined(__has_builtin)
#if __has_builtin(__builtin_ia32_pause)
#define PAUSE __builtin_ia32_pause()
#endif
#if __has_builtin(__builtin_ia32_rdtsc)
#define CLOCK ((ulong) __builtin_ia32_rdtsc())
#endif
#endif
#ifndef PAUSE
#define PAUSE
#endif
#ifndef CLOCK
#define CLOCK 0UL // then nobody seems to wait
#endif

#define UNIT_LOG 16 // cycles of a unit of the host's: about 20 us
#define LONG_WAIT (1UL << 20) // cycles, about 0.4 ms: shorter ones are due to shares that are not quite equal

// Values of status[MEETING]; 0 while it is not decided.
#define ALL_HERE 1
#define CALLED_OFF 2

// Which of how many work-groups this is, and how long it has waited for others.
typedef struct {
    int groups, group;
    ulong *waited;
} Crew;

void noteWait(const Crew *crew, ulong begin) {
    ulong cycles = CLOCK - begin;
    if (cycles > LONG_WAIT) *crew->waited += cycles;
}

// The first meeting of a launch. patience: how often to look for the others. Returns the same to all of them.
bool allHere(const World *w, const Crew *crew, int patience) {
    if (crew->groups == 1) return true;
    volatile global int *decision = w->status + MEETING;
    ulong begin = CLOCK;
    if (atomic_inc(&w->status[ARRIVALS]) == crew->groups - 1) atomic_cmpxchg(decision, 0, ALL_HERE);
    for (int looks = 0; *decision == 0; looks++) {
        if (looks >= patience) atomic_cmpxchg(decision, 0, CALLED_OFF);
        PAUSE;
    }
    noteWait(crew, begin);
    // An atomic operation, so that nothing that follows is read before.
    return atomic_add(decision, 0) == ALL_HERE;
}

// Work-groups are handed out to threads in any order, but a thread has in its cache what it worked on in the launch before. So
// they take their numbers in the order in which the stacks of their threads lie: each notes that of its own before the first
// meeting, and counts those below it afterwards. Any order would do.
global uint *stacks(const World *w) { return (global uint *) w->groupStart; } // free until contacts are listed

void noteStack(const World *w, const Crew *crew) { stacks(w)[crew->group] = (uint) ((ulong) crew >> 12); }

int numberByStack(const World *w, const Crew *crew) {
    global const uint *stack = stacks(w);
    uint own = stack[crew->group];
    int below = 0;
    for (int g = 0; g < crew->groups; g++) below += stack[g] < own || (stack[g] == own && g < crew->group);
    return below;
}

// Waits until a count has come to a number, and sees what was written before it did.
void awaitCount(const Crew *crew, volatile global int *count, int number) {
    for (int looks = 0; looks < LOOKS && *count < number; looks++) PAUSE;
    if (*count < number) {
        ulong begin = CLOCK;
        while (*count < number) PAUSE;
        noteWait(crew, begin);
    }
    atomic_add(count, 0);
    mem_fence(CLK_GLOBAL_MEM_FENCE);
}

// Brings a count to a number, and makes what was written visible to those who wait for that.
void announce(volatile global int *count, int number) {
    mem_fence(CLK_GLOBAL_MEM_FENCE);
    atomic_xchg(count, number);
}

// Waits until all work-groups are here, and makes what each has written visible to the others.
void awaitCrew(const World *w, const Crew *crew) {
    if (crew->groups == 1) return;
    volatile global int *arrivals = w->status + ARRIVALS;
    mem_fence(CLK_GLOBAL_MEM_FENCE);
    awaitCount(crew, arrivals, (atomic_inc(arrivals) / crew->groups + 1) * crew->groups);
}

// How long it has waited, in the host's unit.
int waitedOf(const Crew *crew) { return (int) (*crew->waited >> UNIT_LOG); }

// Tells the host how long a work-group took, and how long of that it waited.
void noteTimes(const World *w, const Crew *crew, ulong begin) {
    atomic_add(&w->status[TOOK], (int) ((CLOCK - begin) >> UNIT_LOG));
    if (*crew->waited > 0) atomic_add(&w->status[WAITED], waitedOf(crew));
}

// Ends a work-group. The last one makes the counters ready for the next launch.
void disperse(const World *w) {
    mem_fence(CLK_GLOBAL_MEM_FENCE);
    if (atomic_inc(&w->status[DEPARTURES]) == (int) get_num_groups(0) - 1) {
        w->status[ARRIVALS] = 0;
        w->status[DEPARTURES] = 0;
        w->status[MEETING] = 0;
    }
}

// Where a work-group's part of [0, count) begins; that of the next one is where it ends.
int partOf(int count, int group, int groups) { return (int) ((long) count * group / groups); }

#define EACH_OF_PART(i, count, crew)                                                                                   \
    for (int i = partOf(count, (crew)->group, (crew)->groups), end_##i = partOf(count, (crew)->group + 1, (crew)->groups); \
         i < end_##i; i++)
