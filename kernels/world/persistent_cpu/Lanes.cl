// uses: world/persistent_cpu/LaneGrid.cl world/persistent_cpu/LaneSweep.cl world/persistent_cpu/LanePasses.cl
// Whole steps in one launch on a processor, where all circles are of one level: as many work-groups of one work-item as the
// device has compute units, each with a band of rows of cells, and as few meetings as can be. Contacts are solved four at a
// time, as wide contacts (LaneContacts.cl). The Java classes Contacts and Solver explain rows, bands and sweeps; it is the
// same here.

bool isIn(int row, int low, int high) { return low <= row && row < high; }

// The sub-step up to which a work-group has made its lowest rows, for which the one below it waits. In a cache line each, of an
// array that is free once contacts have been found.
volatile global int *lowestRowsDone(const World *w, int group) { return w->bucketBefore + 16 * group; }

// Each work-group lists its contacts in a region of its own: so many wide contacts.
int regionOf(const World *w, const Crew *crew) { return w->contactRoom / 4 / crew->groups; }

void beginSearch(const World *w, const Crew *crew, Search *f) {
    f->x = searchX(w);
    f->y = searchY(w);
    f->speculativeDistance = searchSpeculativeDistance(w);
    f->gathered = f->groups = f->start[0] = f->contacts = f->nodes = 0;
    f->crowded = false;
#ifdef RECORDING
    f->met = 0;
#endif
    f->owner = crew->group;
    f->wide = crew->group * regionOf(w, crew);
    f->endWide = f->wide + regionOf(w, crew);
}

// Tells what a work-group has found.
void endSearch(const World *w, const Crew *crew, const Search *f) {
    int region = regionOf(w, crew);
    int first = crew->group * region;
    if (f->crowded) w->status[CROWDED] = 1;
    if (f->crowded && w->k.thinning) {
        w->status[TOO_CLOSE] = 1;
        w->status[OUT_OF_ROOM] = 1;
    }
    if (f->wide > f->endWide) w->status[OUT_OF_ROOM] = 1;
    atomic_add(&w->status[CONTACTS], f->contacts);
#ifdef RECORDING
    atomic_add(&w->status[TOUCHES_MET], f->met);
#endif
    atomic_max(&w->status[MOST_PLACES], 4 * (f->wide - first + (first + region - f->endWide)));
    atomic_max(&w->status[PLACES], 4 * min(f->wide, f->endWide));
}

// Tells how much room is needed, where it is not enough. After a meeting.
void askForRoom(const World *w, const Crew *crew) {
    if (outOfRoom(w) && crew->group == 0) {
        long places = (long) w->status[MOST_PLACES] * crew->groups;
        w->status[CONTACTS] = max(w->status[CONTACTS], (int) min(places, 1L << 30));
    }
}

// Stage Contacts. Returns false where the step is refused, the same to all work-groups.
bool listContacts(const World *w, const Crew *crew, const Band *band) {
    Search f;
    beginSearch(w, crew, &f);
    if (w->k.thinning) {
        countCandidates(w, &f, cellsOfBand(w, onlyLevel(w), *band), 0);
        awaitCrew(w, crew);
    }
    for (int row = band->from; row <= band->to; row += 2) {
        for (int r = 0; r < 2 && row < band->to; r++) findRow(w, &f, onlyLevel(w), row + r);
        if (row == band->to) {
            endSearch(w, crew, &f);
            awaitCrew(w, crew); // the row after the last is another band's
            *lowestRowsDone(w, crew->group) = 0;
        }
        // Sums of impulses: an even row, then the odd one between it and the one before.
        for (int r = 0; r < 2; r++) {
            if (isIn(row - r, band->from, band->to)) gatherRow(w, row - r);
        }
    }
    awaitCrew(w, crew);
    askForRoom(w, crew);
    return !outOfRoom(w) && !tooCrowded(w);
}

int ringRow(const World *w, int row) { return onRing(row, w->levels->rowCount[onlyLevel(w)]); }

Cells cellsOfRow(const World *w, int row) { return cellsOf(w, onlyLevel(w), row); }

// All stages of a sub-step, each on what of [low, high) it can do, where its sweep has come to an even row.
void visitRows(World *w, int row, int low, int high, int inwards, int subStep) {
    w->subStep = subStep;
    if (isIn(row, low, high)) {
        for (int r = 0; r < 2; r++) integrateVelocitiesOf(w, cellsOfRow(w, ringRow(w, row + r)));
    }
    for (int r = 0; r < 2; r++) {
        if (isIn(row - r, low + r * inwards, high - r * inwards)) solveRow(w, ringRow(w, row - r));
    }
    for (int r = 2; r > 0; r--) {
        if (isIn(row - r, low + inwards, high - inwards)) integratePositionsOf(w, cellsOfRow(w, ringRow(w, row - r)), subStep == 0);
    }
    for (int r = 2; r < 4; r++) {
        if (isIn(row - r, low + r * inwards, high - r * inwards)) {
            relaxRow(w, ringRow(w, row - r), subStep == w->k.subSteps - 1);
        }
    }
}

// Makes sub-steps [from, to) on a band of rows: each stage on fewer rows than the one before it (inwards 1), or on more
// (inwards -1, from an empty band at the edge of two). The former announces when the band below may go on with its edge: from
// front low + 2 * lag on, it comes to no row below low + lag. Bands are so high that all come to that.
void sweepRows(World *w, const Crew *crew, int low, int high, int inwards, int from, int to) {
    int lag = LAG * (to - from);
    int end = high + 2 * LAG + (inwards > 0 ? 0 : 2 * lag);
    for (int front = low; front < end; front += 2) {
        int behind = 0;
        for (int subStep = from; subStep < to; subStep++) {
            visitRows(w, front - behind, low + inwards * behind, high - inwards * behind, inwards, subStep);
            behind += LAG;
        }
        for (int r = 0; r < 2 && to == w->k.subSteps; r++) {
            int row = front - lag + r;
            if (isIn(row, low + inwards * lag, high - inwards * lag)) finish(w, cellsOfRow(w, ringRow(w, row)));
        }
        if (inwards > 0 && front == low + 2 * lag - 2) announce(lowestRowsDone(w, crew->group), to);
    }
}

#define ROWS_PER_SUB_STEP 24 // of the narrowest band, in a sweep over several sub-steps

// What a sweep cannot do at the edges of its band, because it needs rows of the next one, a second sweep does, from the edge
// outwards: each work-group at the upper edge of its band, where the next one has long been, as it begins there.
void solveInSweeps(World *w, const Crew *crew, const Band *band, int mostWaiting) {
    int most = max(1, band->narrowest / ROWS_PER_SUB_STEP);
    for (int subStep = 0; subStep < w->k.subSteps; subStep += most) {
        int end = min(w->k.subSteps, subStep + most);
        sweepRows(w, crew, band->from, band->to, 1, subStep, end);
        awaitCount(crew, lowestRowsDone(w, (crew->group + 1) % crew->groups), end);
        sweepRows(w, crew, band->to, band->to, -1, subStep, end);
        if (waitedOf(crew) > mostWaiting) w->status[HINDERED] = 1; // before the barrier, so that all see it or none
        awaitCrew(w, crew);
    }
}

// Pass after pass, by one work-group, where there are hardly any rows.
void solveInPasses(World *w, int rows) {
    for (int subStep = 0; subStep < w->k.subSteps; subStep++) {
        w->subStep = subStep;
        for (int row = 0; row < rows; row++) integrateVelocitiesOf(w, cellsOfRow(w, row));
        for (int odd = 0; odd < 2; odd++) {
            for (int row = odd; row < rows; row += 2) solveRow(w, row);
        }
        for (int row = 0; row < rows; row++) integratePositionsOf(w, cellsOfRow(w, row), subStep == 0);
        for (int odd = 0; odd < 2; odd++) {
            for (int row = odd; row < rows; row += 2) relaxRow(w, row, subStep == w->k.subSteps - 1);
        }
    }
    for (int row = 0; row < rows; row++) finish(w, cellsOfRow(w, row));
}

#ifdef RECORDING
// Records pairs after a step, once all have made it.
void recordBand(const World *w, const Crew *crew, const Band *band) {
    bool all = recordsAll(w);
    int held = 0;
    for (int row = band->from; row < band->to; row++) held += recordRow(w, row, all);
    endRecords(w, all, held);
    awaitCrew(w, crew);
}
#endif

// Makes steps, unless one is refused. Index space: work-groups of one work-item. groups: how many have to come, which is how
// many there are; patience: how often to look for the others before the launch is called off; mostWaiting: how long they may wait
// before they leave further steps to the host.
kernel __attribute__((reqd_work_group_size(1, 1, 1))) void persistentCpu_steps(WORLD_PARAMETERS, int steps, int groups,
                                                                        int patience, int mostWaiting RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    ulong begin = CLOCK;
    ulong waited = 0;
    Crew crew = {groups, (int) get_group_id(0), &waited};
    noteStack(&w, &crew);
    // None behind a launch that was called off or left steps out: it counts on what that one would have left.
    if (status[APART] == 0 && status[HINDERED] == 0 && allHere(&w, &crew, patience)) {
        crew.group = numberByStack(&w, &crew);
        bool made = !outOfRoom(&w) && !tooCrowded(&w);
        awaitCrew(&w, &crew); // nobody may run ahead and be out of room before all have looked
        for (int step = 0; step < steps && made; step++) {
            Band band = sortCircles(&w, &crew);
            awaitCrew(&w, &crew);
            sweepCircles(&w, &crew);
            made = listContacts(&w, &crew, &band);
            if (!made) break;
            band = bandOf(&w, &crew, onlyLevel(&w), 2 * LAG, true);
            if (band.narrowest >= 2 * LAG) {
                solveInSweeps(&w, &crew, &band, mostWaiting);
            } else {
                solveInPasses(&w, band.to);
            }
#ifdef RECORDING
            recordBand(&w, &crew, &band);
#endif
            if (crew.group == 0) status[STEPS_DONE]++;
            w.slots = w.circles;
            w.warmScale = 1.0f;
            made = status[HINDERED] == 0;
        }
    } else if (status[HINDERED] == 0) {
        status[APART] = 1;
    }
    noteTimes(&w, &crew, begin);
    disperse(&w);
}
