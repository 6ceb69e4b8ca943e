// uses: world/stages/CrossSolver.cl world/tiles/TileSolver.cl
// Several levels by tiles, all in one launch, or joints, or bodies: like contacts, which leave the circles' motion apart; then Joints.cl,
// CrossSolver.cl and Bodies.cl; then circles by slots, with the arrays of Solver.cl and not those of TileCircles.cl.

// If bodies come behind a pass, a launch of its own has given circles their sums before.
void takeOwnSums(const World *w, int slot, bool velocities, bool impulses, float4 *m, float4 *l) {
#ifndef BODIES
    takeSums(w, slot, velocities, impulses, m, l);
#endif
}

// first: of the step.
void startSlot(const World *w, int slot, bool first) {
    float4 m = w->solvedMotion[slot];
    float4 l = w->load[slot];
    takeOwnSums(w, slot, !first, true, &m, &l);
#ifdef RECORDING
    int group = first && !hasOneLevel(w) ? crossGroupOf(w, slot) : 0;
    int end = group == 0 ? 0 : w->groupStart[group + 1];
    for (int c = w->groupStart[group]; c < end; c++) beginTouch(w, c);
#endif
    IF_TURNING(w->surfaceSpeed[slot] = w->solvedSpin[slot];)
    startCircleAt(w, slot, m, l);
}

void moveSlot(const World *w, int slot) {
    float4 m = w->solvedMotion[slot];
    float4 l = w->load[slot];
    takeOwnSums(w, slot, true, false, &m, &l);
    IF_TURNING(w->surfaceSpeed[slot] = w->solvedSpin[slot];)
    moveCircleAt(w, slot, m, l.LOADED);
    w->homeFirstCached[slot] = NONE;
}

void finishSlot(const World *w, int slot) {
    float4 m = w->solvedMotion[slot];
    float4 l = w->load[slot];
    takeOwnSums(w, slot, true, false, &m, &l);
    IF_TURNING(w->surfaceSpeed[slot] = w->solvedSpin[slot];)
    finalizePositions(w, slot, w->circle[slot], m, w->traits[slot]);
}

// Index space of both: a work-group a tile.

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
    IF_TURNING(w.relaxed = subStep;)
    takeTile(&w, &t, tile, refused(&w));
    relaxTile(&w, &t, tile, subStep == w.k.subSteps - 1, 0, true);
}

// Index space of the others: slots.

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
