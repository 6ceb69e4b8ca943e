// uses: world/persistent_cpu/Lanes.cl world/persistent_cpu/LaneCrossFinding.cl world/persistent_cpu/LaneCrossPasses.cl
// Whole steps in one launch on a processor, where circles are of several levels. A work-group has a band of each level. Like contacts of
// all levels are solved between the same meetings, pass after pass, and then cross contacts (LaneCross.cl): the Java classes Solver and
// CrossPasses do it in the same order.

// What a work-group has of each level, by its number among those used.
typedef struct {
    Band rows[LEVELS];
    Cells cells[LEVELS];
    int crossFrom, crossTo; // its wide cross contacts
} Part;

#define EACH_LEVEL(w, l) for (int l = 0; l < (w)->levels->usedCount; l++)

// Stage Grid. Leaves it to a meeting that others see what the last part has written.
void sortMixed(World *w, const Crew *crew, Part *part) {
    listCircles(w, crew, true);
    EACH_LEVEL(w, l) {
        int level = w->levels->used[l];
        part->rows[l] = bandOf(w, crew, level, 0, false);
        part->cells[l] = cellsOfBand(w, level, part->rows[l]);
        gatherCircles(w, part->cells[l]);
    }
    awaitCrew(w, crew);
    EACH_LEVEL(w, l) {
        noteCircles(w, part->cells[l]);
        for (int slot = part->cells[l].from; slot < part->cells[l].to; slot++) clearCross(w, slot, crew->group);
    }
    if (crew->group == 0) noteSpareSlots(w);
}

// Finds the like contacts of the bands, and adds to the sums of impulses, but for the last row, which is another band's, too.
void findLike(const World *w, Search *f, const Part *part) {
    EACH_LEVEL(w, l) {
        int level = w->levels->used[l];
        Band rows = part->rows[l];
        for (int row = rows.from; row < rows.to; row += 2) {
            findRow(w, f, level, row);
            findRow(w, f, level, row + 1);
            gatherRow(w, rowNumber(w, level, row));
            if (row > rows.from) gatherRow(w, rowNumber(w, level, row - 1));
        }
    }
}

// Notes where there is a crowd: circles count what they have found in coarser levels, too.
void noteCrowds(const World *w, Cells cells) {
    for (int slot = cells.from; slot < cells.to; slot++) {
        if (w->load[slot].z + (float) w->coarser[slot] > (float) CROWD) w->status[CROWDED] = 1;
    }
}

// Stage Contacts. Returns false where the step is refused, the same to all work-groups.
bool listMixed(const World *w, const Crew *crew, Part *part) {
    Search f;
    beginSearch(w, crew, &f);
    int used = w->levels->usedCount;
    if (w->k.thinning) {
        for (int l = 0; l < used; l++) countCandidates(w, &f, part->cells[l], l);
        awaitCrew(w, crew);
    }
    findLike(w, &f, part);
    int first = f.wide;
    for (int l = 0; l + 1 < used; l++) findCross(w, &f, part->cells[l], l + 1);
    awaitCrew(w, crew);
    EACH_LEVEL(w, l) {
        if (part->rows[l].from < part->rows[l].to) gatherRow(w, rowNumber(w, w->levels->used[l], part->rows[l].to - 1));
    }
    *lowestRowsDone(w, crew->group) = 0;
    for (int l = 1; l < used; l++) dealNoted(w, &f, part->cells[l]);
    part->crossFrom = min(first, f.endWide);
    part->crossTo = min(f.wide, f.endWide);
    global int *cross = crossRange(w, crew->group);
    cross[0] = part->crossFrom;
    cross[1] = part->crossTo;
    endSearch(w, crew, &f);
    awaitCrew(w, crew);
    prepareCross(w, part->crossFrom, part->crossTo);
    EACH_LEVEL(w, l) noteCrowds(w, part->cells[l]);
    awaitCrew(w, crew);
    askForRoom(w, crew);
    return !outOfRoom(w) && !tooCrowded(w);
}

INLINE void visitRow(const World *w, int row, bool relaxing, bool last) {
    if (relaxing) {
        relaxRow(w, row, last);
    } else {
        solveRow(w, row);
    }
}

// A pass over like contacts, the number-th of the step. relaxing: the relaxing pass, else the biased one. The lowest rows of all levels
// come first: the highest ones share circles with those of other work-groups, which are long done when it comes to them.
INLINE void visitLike(const World *w, const Crew *crew, const Part *part, int number, bool relaxing, bool last) {
    EACH_LEVEL(w, l) {
        Band rows = part->rows[l];
        if (rows.from < rows.to) visitRow(w, rowNumber(w, w->levels->used[l], rows.from), relaxing, last);
    }
    announce(lowestRowsDone(w, crew->group), number);
    EACH_LEVEL(w, l) {
        int first = rowNumber(w, w->levels->used[l], 0);
        for (int row = part->rows[l].from + 2; row < part->rows[l].to; row += 2) {
            visitRow(w, first + row, relaxing, last);
            visitRow(w, first + row - 1, relaxing, last);
        }
    }
    for (int group = 0; group < crew->groups; group++) awaitCount(crew, lowestRowsDone(w, group), number);
    EACH_LEVEL(w, l) {
        Band rows = part->rows[l];
        if (rows.from < rows.to) visitRow(w, rowNumber(w, w->levels->used[l], rows.to - 1), relaxing, last);
    }
    awaitCrew(w, crew);
    EACH_LEVEL(w, l) beginCross(w, part->cells[l]);
}

void solveMixed(World *w, const Crew *crew, const Part *part, int mostWaiting) {
    setCrossMasses(w, part->crossFrom, part->crossTo);
    EACH_LEVEL(w, l) takeFromCross(w, part->cells[l], false, true);
    for (int subStep = 0; subStep < w->k.subSteps; subStep++) {
        bool last = subStep == w->k.subSteps - 1;
        w->subStep = subStep;
        EACH_LEVEL(w, l) integrateVelocitiesOf(w, part->cells[l]);
        visitLike(w, crew, part, 2 * subStep + 1, false, last);
        solveWideCrosses(w, part->crossFrom, part->crossTo);
        awaitCrew(w, crew);
        EACH_LEVEL(w, l) {
            takeFromCross(w, part->cells[l], true, false);
            integratePositionsOf(w, part->cells[l], subStep == 0);
        }
        visitLike(w, crew, part, 2 * subStep + 2, true, last);
        relaxWideCrosses(w, part->crossFrom, part->crossTo, last);
        awaitCrew(w, crew);
        EACH_LEVEL(w, l) takeFromCross(w, part->cells[l], true, !last);
    }
    EACH_LEVEL(w, l) finish(w, part->cells[l]);
    if (waitedOf(crew) > mostWaiting) w->status[HINDERED] = 1; // before the barrier, so that all see it or none
    awaitCrew(w, crew);
}

#ifdef RECORDING
// Records pairs after a step, once all have made it.
void recordMixed(const World *w, const Crew *crew, const Part *part) {
    bool all = recordsAll(w);
    int held = recordWides(w, part->crossFrom, part->crossTo, all, true);
    EACH_LEVEL(w, l) {
        int first = rowNumber(w, w->levels->used[l], 0);
        for (int row = part->rows[l].from; row < part->rows[l].to; row++) held += recordRow(w, first + row, all);
    }
    endRecords(w, all, held);
    awaitCrew(w, crew);
}
#endif

// As persistentCpu_steps.
kernel __attribute__((reqd_work_group_size(1, 1, 1))) void persistentCpu_mixedSteps(WORLD_PARAMETERS, int steps, int groups,
                                                                             int patience, int mostWaiting RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    ulong begin = CLOCK;
    ulong waited = 0;
    Crew crew = {groups, (int) get_group_id(0), &waited};
    noteStack(&w, &crew);
    if (status[APART] == 0 && status[HINDERED] == 0 && allHere(&w, &crew, patience)) {
        crew.group = numberByStack(&w, &crew);
        bool made = !outOfRoom(&w) && !tooCrowded(&w);
        awaitCrew(&w, &crew);
        for (int step = 0; step < steps && made; step++) {
            Part part;
            sortMixed(&w, &crew, &part);
            awaitCrew(&w, &crew);
            sweepCircles(&w, &crew);
            made = listMixed(&w, &crew, &part);
            if (!made) break;
            solveMixed(&w, &crew, &part, mostWaiting);
#ifdef RECORDING
            recordMixed(&w, &crew, &part);
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
