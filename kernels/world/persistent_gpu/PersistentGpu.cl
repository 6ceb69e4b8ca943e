// uses: world/shared/DeviceBarrier.cl world/stages/Scan.cl world/stages/Grid.cl world/stages/Joints.cl world/stages/Pieces.cl world/tiles/TileLevels.cl
// Whole steps in one launch, for worlds so small that launches would be most of their time: work-groups that stay run the stages one after
// another, with a barrier over all of them in between.

// Whether a step is refused must look the same to all work-groups, or some would wait for ever: each asks for what nobody writes before the
// next barrier.

// Not unrolled: fetching instructions is much of the time of a stage.
#define EACH(i, count)                                                                                                 \
    _Pragma("unroll 1") for (int i = (int) get_global_id(0); i < (count); i += (int) get_global_size(0))

// The next stage clears the counts. Each work-group sums up what is before its blocks: cheaper than a barrier.
void scanAll(const World *w, global const int *counts, global int *starts, int count, local int *cells) {
    int before = 0;
    int summed = 0;
    int step = (int) get_num_groups(0) * RESIDENT_GROUP;
    for (int first = (int) get_group_id(0) * RESIDENT_GROUP; first < count; first += step) {
        int part = 0;
        for (int i = summed + (int) get_local_id(0); i < first; i += RESIDENT_GROUP) part += counts[i];
        int total;
        scanGroup(part, cells, &total);
        before += total;
        summed = first;
        int i = first + (int) get_local_id(0);
        int sum = scanGroup(i < count ? counts[i] : 0, cells, &total);
        if (i < count) starts[i] = before + sum;
    }
}

typedef union {
    int cells[2 * RESIDENT_GROUP];
    int classes; // see noteClasses
    Findings findings;
    Arrangement arrangement;
    Tile tile;
} Local;

#define SEEKERS 8 // work-items that look for the neighbours of a circle

// Stages Grid, ContinuousCollision where some circle is fast, and Contacts.
void listAll(World *w, local Local *l) {
    volatile global int *arrivals = w->status + ARRIVALS;
    int buckets = w->levels->first[LEVELS];
    int groups = hasOneLevel(w) ? likeGroups(w) : crossGroupOf(w, w->circles);
    w->k.sweeping = 1; // until it is known
    w->subStep = 0;
    if (get_global_id(0) == 0) startStep(w);
    EACH(slot, w->slots) countSlot(w, slot);
    deviceBarrier(arrivals);
    scanAll(w, w->tally, w->bucketStart, buckets + 1, l->cells);
    deviceBarrier(arrivals);
    EACH(slot, w->slots) scatterSlot(w, slot);
    EACH(i, buckets) w->tally[i] = 0;
    deviceBarrier(arrivals);
    bool fast = false;
    EACH(i, w->circles) fast |= gatherCircle(w, i);
    if (fast) w->status[FAST] = 1;
    deviceBarrier(arrivals);
    w->k.sweeping = w->status[FAST];
#ifdef JOINTS
    if (w->joints->any) {
        EACH(place, max(w->joints->count, w->joints->splitCircles)) findJoint(w, place);
        deviceBarrier(arrivals);
    }
#endif
    if (w->k.sweeping) {
        if (get_local_id(0) == 0) l->classes = 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        int classes = 0;
        EACH(slot, w->circles) classes |= noteReach(w, slot, looksForStops(w, slot));
        if (classes != 0) atomic_or(&l->classes, classes);
        barrier(CLK_LOCAL_MEM_FENCE);
        if (get_local_id(0) == 0) noteClasses(w, l->classes);
        EACH(block, blocksOfCells(w)) summarize(w, block);
        deviceBarrier(arrivals);
        EACH(number, partsOfAllLooks(w)) makePartOfLook(w, number);
        deviceBarrier(arrivals);
        // A loop, so that what looks for them is there once.
        int looks = w->status[CARRYING] ? CARRIERS : STOPS;
#pragma unroll 1
        for (int look = CARRY_TIMES; look <= looks; look++) {
            EACH(slot, w->circles) {
                if (looksAhead(w, slot)) lookForCarriers(w, slot, (Look) look);
            }
            deviceBarrier(arrivals);
        }
        EACH(slot, w->circles) setMotionClamp(w, slot);
        deviceBarrier(arrivals);
    }
    if (get_local_id(0) == 0) l->findings.count = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
#ifdef TERRAIN
    EACH(slot, w->circles) findPieces(w, slot);
#endif
    // Several work-items a circle: there are more of them than circles.
    EACH(item, SEEKERS * w->circles) {
        seekAll(w, item / SEEKERS, item % SEEKERS, SEEKERS, hasOneLevel(w), w->levels->haveSheets != 0, &l->findings);
    }
    recordFindings(w, &l->findings, hasOneLevel(w));
    deviceBarrier(arrivals);
    scanAll(w, w->tally, w->groupStart, groups + 1, l->cells);
    deviceBarrier(arrivals);
    if (get_global_id(0) == 0) noteContacts(w);
    EACH(i, groups) w->tally[i] = 0;
    bool lists = !lackContactRoom(w) && !tooCrowded(w);
    EACH(k, lists ? contactsListed(w) : 0) listContact(w, k);
    deviceBarrier(arrivals);
    if (outOfRoom(w) || tooCrowded(w)) return;
    SET_TOUCH_NUMBERS(*w);
    EACH(c, likeContacts(w)) linkContact(w, c);
    deviceBarrier(arrivals);
    int tiles = w->levels->tileCount;
#pragma unroll 1
    for (int tile = (int) get_group_id(0); tile < tiles; tile += (int) get_num_groups(0)) {
        Region r = regionOf(w, tile);
        arrangeTile(w, &r, &l->arrangement, tile, false, 3);
    }
    deviceBarrier(arrivals);
}

#ifdef JOINTS
#define IN_BATCHES 0 // a batch by a work-group
#define IN_NONE 1    // a colour by all work-groups
#define SPLIT 2

// All joints of a pass, as the Java class JointKernels has it. A visit is long: it is there once, in a loop over all that may follow each other.
void passJoints(const World *w, int pass, int subStep, bool speeds, bool impulses) {
    volatile global int *arrivals = w->status + ARRIVALS;
    World cross = crossWorld(*w);
    int batches = w->joints->batches;
    int colours = w->joints->colours;
    int which = IN_BATCHES;
    int batch = (int) get_group_id(0);
    int colour = 0;
#pragma unroll 1
    while (true) {
        if (which == IN_BATCHES && batch >= batches) {
            if (batches > 0) deviceBarrier(arrivals);
            which = IN_NONE;
            batch = batches;
        }
        global const int *starts = startsOf(w, batch);
        while (which == IN_NONE && colour < colours && starts[colour] == starts[colour + 1]) colour++;
        if (which == IN_NONE && colour >= colours) which = SPLIT;
        int from = which == SPLIT ? w->joints->splitStart : starts[colour];
        int to = which == SPLIT ? w->joints->count : starts[colour + 1];
        if (which == SPLIT && from == to) break;
        bool alone = which == IN_BATCHES;
        int step = (int) (alone ? get_local_size(0) : get_global_size(0));
#pragma unroll 1
        for (int place = from + (int) (alone ? get_local_id(0) : get_global_id(0)); place < to; place += step) {
            visitJoint(&cross, place, pass, subStep, which == SPLIT);
        }
        if (alone) {
            barrier(CLK_GLOBAL_MEM_FENCE);
        } else {
            deviceBarrier(arrivals);
        }
        if (which == SPLIT) {
            EACH(number, w->joints->splitCircles) takeJointSums(&cross, number, speeds, impulses);
            deviceBarrier(arrivals);
            break;
        }
        colour++;
        if (alone && colour >= colours) {
            colour = 0;
            batch += (int) get_num_groups(0);
        }
    }
}

// The pass before the first one prepares joints.
#define FIRST_PASS(w) ((w)->joints->any ? -1 : 0)
#else
#define FIRST_PASS(w) 0
#endif

// With several levels, or joints: what of a pass is before and behind the tiles' part, see the Java class SubSteps.
void beforeTiles(const World *w, int subStep, bool relaxing) {
    if (relaxing) return;
    EACH(slot, w->circles) startSlot(w, slot, subStep == 0);
    deviceBarrier(w->status + ARRIVALS);
}

void behindTiles(const World *w, int subStep, bool relaxing) {
    World cross = crossWorld(*w);
    cross.firstCached = w->homeFirstCached;
    bool last = subStep == w->k.subSteps - 1;
    int circles = hasOneLevel(w) ? 0 : w->circles;
    EACH(slot, circles) {
        if (relaxing) {
            relaxCrossOf(&cross, slot, last);
        } else {
            solveCrossOf(&cross, slot);
        }
    }
    if (circles > 0) deviceBarrier(w->status + ARRIVALS);
    if (relaxing && !last) return;
    EACH(slot, w->circles) {
        if (relaxing) {
            finishSlot(w, slot);
        } else {
            moveSlot(w, slot);
        }
    }
    deviceBarrier(w->status + ARRIVALS);
}

void fillCross(const World *w) {
    World cross = crossWorld(*w);
    EACH(slot, w->circles) fillCrossOf(&cross, slot);
    deviceBarrier(w->status + ARRIVALS);
}

// Stage Solver. A work-group that has one tile alone keeps it in local memory for the whole step.
void solveAll(World *w, local Tile *t) {
    volatile global int *arrivals = w->status + ARRIVALS;
    bool several = sharesPasses(w);
    int tiles = w->levels->tileCount;
    int group = (int) get_group_id(0);
    int groups = (int) get_num_groups(0);
    if (tiles <= groups && group < tiles) takeTile(w, t, group, false);
    int firstPass = FIRST_PASS(w);
#ifdef JOINTS
    EACH(place, firstPass < 0 ? w->joints->count : 0) beginJoint(w, place);
    if (firstPass < 0) deviceBarrier(arrivals);
#endif
    if (firstPass == 0 && !hasOneLevel(w)) fillCross(w);
#pragma unroll 1
    for (int pass = firstPass; pass < 2 * w->k.subSteps; pass++) {
        int subStep = pass >> 1;
        bool relaxing = pass & 1;
        if (pass >= 0) {
            w->subStep = subStep + (relaxing && !several ? 1 : 0); // circles start into the next one
            if (several) beforeTiles(w, subStep, relaxing);
#pragma unroll 1
            for (int tile = group; tile < tiles; tile += groups) {
                if (tiles > groups) takeTile(w, t, tile, false);
                IF_TURNING(w->relaxed = subStep;)
                if (relaxing) {
                    relaxTile(w, t, tile, subStep == w->k.subSteps - 1, 3, several);
                } else {
                    solveTile(w, t, tile, subStep, 2, several);
                }
            }
            deviceBarrier(arrivals);
        }
#ifdef JOINTS
        if (firstPass < 0) {
            bool last = pass == 2 * w->k.subSteps - 1;
            int what = pass < 0 ? JOINT_PREPARE : relaxing ? JOINT_RELAX : JOINT_SOLVE;
            passJoints(w, what, max(subStep, 0), pass >= 0, pass < 0 || (relaxing && !last));
        }
#endif
        if (several && pass >= 0) behindTiles(w, subStep, relaxing);
        if (pass < 0 && !hasOneLevel(w)) fillCross(w);
    }
}

#ifdef RECORDING
#define RANKERS 16 // work-items that find the place of an event

void rankEvent(const World *w, int k, int part, int drafts) {
    const Reporting *r = &w->reporting;
    int4 own = r->drafts[3 * k];
    int before = 0;
    for (int i = part; i < drafts; i += RANKERS) before += comesBefore(r->drafts[3 * i], own);
    if (before > 0) atomic_add(&r->eventOrder[k], before);
}

// The phases of Events.cl, but an event's place is found by comparing it with all: that costs less than barriers. sensing: sensed pairs and the
// phases behind them follow. Returns whether the step waits for the host.
bool reportAll(const World *w, bool sensing) {
    volatile global int *arrivals = w->status + ARRIVALS;
    const Reporting *r = &w->reporting;
    int first = (int) get_global_id(0);
    int each = (int) get_global_size(0);
    int tiles = w->levels->tileCount;
    for (int tile = (int) get_group_id(0); tile < tiles; tile += (int) get_num_groups(0)) tellOfTile(w, tile);
    tellOfCrossContacts(w, first, each);
    tellOfWalls(w, first, each);
    deviceBarrier(arrivals);
    EACH(place, sensing ? 0 : r->mask + 1) tellOfEnds(w, place);
    deviceBarrier(arrivals);
    bool lacks = !sensing && lacksEventRoom(w);
    int drafts = sensing ? 0 : min(w->status[DRAFTS], r->room);
    int settled = lacks ? 0 : drafts;
    if (lacks && first == 0) noteLackOfEventRoom(w);
    EACH(item, RANKERS * settled) rankEvent(w, item / RANKERS, item % RANKERS, drafts);
    EACH(k, lacks || sensing ? 0 : w->status[NEWCOMERS]) addTouching(w, r->newcomers[k]);
    deviceBarrier(arrivals);
    EACH(k, drafts) r->eventTally[r->drafts[3 * k].x] = 0;
    EACH(k, settled) writeEventAt(w, k, r->eventOrder[k]);
    if (!lacks && !sensing && first == 0) writeHeader(w);
    return lacks;
}
#endif

#ifdef RECORDING
#define DECIDING_PARAMETERS RECORDING_PARAMETERS REPORTING_PARAMETERS, int sensing
#else
#define DECIDING_PARAMETERS
#endif

// Index space: no more work-groups than run at once, of RESIDENT_GROUP. No reqd_work_group_size: NVIDIA's compiler would make room for two on a
// compute unit, with 128 registers and many spills.
kernel void persistentGpu_steps(WORLD_PARAMETERS, int steps DECIDING_PARAMETERS) {
    World w = WORLD;
    IF_RECORDING(RECORD_IN(w);)
    IF_RECORDING(REPORT_IN(w);)
    local Local l;
    w.k.sweeping = 1; // these steps take fast circles
    w.k.tiled = 1;
    if (refused(&w)) return;
    // Nobody may run ahead and be out of room before all have looked.
    deviceBarrier(status + ARRIVALS);
#pragma unroll 1
    for (int step = 0; step < steps; step++) {
        listAll(&w, &l);
        if (refused(&w)) break;
#ifdef RECORDING
        // All have left the events of the step before, and many barriers follow.
        if (get_global_id(0) == 0 && !sensing) startEvents(&w);
#endif
        int contacts = likeContacts(&w);
        solveAll(&w, &l.tile);
        // Shares a barrier that follows: of events, of the next step's beginning, or of the end of the launch.
        EACH(c, contacts) storeHeldImpulse(&w, c);
        if (get_global_id(0) == 0) status[STEPS_DONE]++;
#ifdef RECORDING
        if (reportAll(&w, sensing != 0)) steps = 0;
        w.reporting.step++;
        w.reporting.starting = 0;
#endif
        w.slots = w.circles;
        w.warmScale = 1.0f;
    }
    leave(&w);
}
