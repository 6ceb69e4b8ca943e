// uses: world/stages/CrossSolver.cl world/tiles/TileSolver.cl
// Worlds of several levels by tiles: all levels' tiles are in one launch. In a pass the tiles make the like contacts, and leave the
// circles' motion apart; the cross contacts follow, CrossSolver.cl has them; then each circle takes what these have for it, and goes
// on. What is a circle's own business lies in between, so it has launches of its own, by slots, as in Solver.cl, and with the same
// arrays: motion, load, wallBounce. Those of TileCircles.cl are not used.

// A circle behind its contacts: its motion, and its load. impulses: whether it has been given any for the sub-step to come.
void takeAll(const World *w, int slot, bool impulses, float4 *m, float4 *l) {
    *m = w->solvedMotion[slot];
    *l = w->load[slot];
    if (!isHeavy(w, slot)) return;
    m->VELOCITY = velocityTaken(w, slot, m->VELOCITY);
    if (impulses) {
        l->IMPULSES = impulsesTaken(w, slot, l->IMPULSES);
        w->claim[slot] = 0;
    }
    w->heavySum[slot] = (long4)(0);
}

// Begins a step for a circle: what its contacts begin with.
void beginCircle(const World *w, int slot, float4 *m, float4 *l) {
    *m = w->solvedMotion[slot];
    *l = w->load[slot];
    if (isHeavy(w, slot)) {
        l->IMPULSES = impulsesTaken(w, slot, l->IMPULSES);
        w->heavySum[slot] = (long4)(0);
    }
#ifdef RECORDING
    for (int c = w->groupStart[crossGroupOf(w, slot)]; c < w->groupStart[crossGroupOf(w, slot) + 1]; c++) {
        beginTouch(w->recording.touch, c);
    }
#endif
}

void startSlot(const World *w, int slot, bool first) {
    float4 m, l;
    if (first) {
        beginCircle(w, slot, &m, &l);
    } else {
        takeAll(w, slot, true, &m, &l);
    }
    startCircleAt(w, slot, m, l);
}

void moveSlot(const World *w, int slot) {
    float4 m, l;
    takeAll(w, slot, false, &m, &l);
    moveCircleAt(w, slot, m, l.LOADED);
    w->homeFirstCached[slot] = NONE;
}

// Ends the step for a circle.
void finishSlot(const World *w, int slot) {
    float4 m, l;
    takeAll(w, slot, false, &m, &l);
    finalizePositions(w, slot, w->circle[slot], m, w->traits[slot]);
}

// Index space of each: a work-group a tile.

TILE_KERNEL solver_solveLevels(WORLD_PARAMETERS, int subStep RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    SET_TOUCH_NUMBERS(w);
    local Tile t;
    int tile = (int) get_group_id(0);
    takeTile(&w, &t, tile, refused(&w));
    solveTile(&w, &t, tile, subStep, 0, true);
}

TILE_KERNEL solver_relaxLevels(WORLD_PARAMETERS, int subStep RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    SET_TOUCH_NUMBERS(w);
    local Tile t;
    int tile = (int) get_group_id(0);
    takeTile(&w, &t, tile, refused(&w));
    relaxTile(&w, &t, tile, subStep == w.k.subSteps - 1, 0, true);
}

// Index space of each: a working slot a work-item.

kernel void solver_startSlots(WORLD_PARAMETERS, int subStep RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    w.subStep = subStep;
    int slot = (int) get_global_id(0);
    if (slot < circles && !refused(&w)) startSlot(&w, slot, subStep == 0);
}

kernel void solver_moveSlots(WORLD_PARAMETERS, int subStep RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    w.subStep = subStep;
    int slot = (int) get_global_id(0);
    if (slot < circles && !refused(&w)) moveSlot(&w, slot);
}

kernel void solver_finishSlots(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || refused(&w)) return;
    finishSlot(&w, slot);
    if (slot == 0) status[STEPS_DONE]++;
}
