// uses: world/shared/Motion.cl world/tiles/TileTouches.cl
// A circle's start into a sub-step and its move, by the work-group that owns it. Neighbours read drive and burden after the start,
// solvedMotion and solvedBurden after the move; motion and traits are the owner's.

// Work-items take several circles or contacts at a time: all reads are on their way before the first is needed. How many is a matter of
// registers, and tried out.
#define MOST_TOGETHER 4
#define TOGETHER_EACH(n, together)                                                                                     \
    _Pragma("unroll") for (int n = 0; n < MOST_TOGETHER; n++) if (n < (together))
#define TILE_TOGETHER(first, count, together)                                                                          \
    _Pragma("unroll 1") for (int first = 0; first < (count); first += (together) * (int) get_local_size(0))

// May be count or more.
int togetherItem(int first, int n) { return first + n * (int) get_local_size(0) + (int) get_local_id(0); }

// Negative if loaded. A static circle has 0 and is never loaded.
float burdenOf(float inverseMass, bool loaded) { return loaded ? -inverseMass : inverseMass; }
bool isLoaded(float burden) { return as_int(burden) < 0; }

// Its owner may be about to write the other half.
float2 lastingTraits(const World *w, int slot) {
    return *(global const float2 *) ((global const float *) (w->traits + slot) + INVERSE_MASS_AT);
}

// Without impulses of walls; false if that is not all. sum: of contact impulses; carried: by a contact; s, spinSum: surface speed, and sum of
// impulses on it.
bool startOffWalls(const World *w, int slot, float4 c, float4 m, float inverseMass, float2 sum,
                   bool carried AND_TURNING(float s) AND_TURNING(float spinSum)) {
    float2 before, next;
    if (!integrateOffWalls(w, slot, c, m, inverseMass, sum, &before, &next)) return false;
    IF_TURNING(w->startSpin[slot] = startedSpin(w, slot, c.RADIUS, s, spinSum);)
    w->drive[slot] = (float4)(next.x, next.y, before.x, before.y);
    w->burden[slot] = burdenOf(inverseMass, carried);
    w->motion[slot] = (float4)(m.DX, m.DY, 0.0f, 0.0f);
    return true;
}

// atPieces: whether pieces of terrain are near. Returns whether it is at a wall, or near a piece.
bool startCircle(const World *w, int slot, float4 c, float4 m, float4 t, float2 sum,
                 bool carried AND_TURNING(float s) AND_TURNING(float spinSum) AND_TERRAIN(bool atPieces)) {
    float2 walls = t.WALLS;
    bool acted = wallsAct(w, slot, walls);
    IF_TERRAIN(acted = acted || atPieces;)
    if (!acted && startOffWalls(w, slot, c, m, t.INVERSE_MASS, sum, carried AND_TURNING(s) AND_TURNING(spinSum))) {
        storeWalls(w, slot, walls, noWalls(&w->k, c));
        return false;
    }
    float2 before, bounce;
    bool loaded;
    IF_RECORDING(float4 old = m;)
    IF_TURNING(Turning turning = turningOf(w, slot, t, s);)
    integrateVelocities(w, slot, c, &m, &t, (float4)(sum.x, sum.y, 0.0f, carried ? 1.0f : 0.0f), &before, &bounce,
                        &loaded AND_TURNING(&turning) AND_TURNING(spinSum));
    IF_RECORDING(noteWallsSolved(w, slot, c, t.INVERSE_MASS, sum, before, old, m AND_TURNING(&turning));)
    IF_TERRAIN(if (atPieces) solvePieces(w, slot, c, t.RESTITUTION, before, loaded, &m AND_TURNING(&turning));)
    IF_TURNING(w->startSpin[slot] = turning.s;)
    IF_TURNING(keepWallRows(w, slot, &turning);)
    storeWalls(w, slot, walls, t.WALLS);
    w->drive[slot] = (float4)(m.VX, m.VY, before.x, before.y);
    w->burden[slot] = burdenOf(t.INVERSE_MASS, loaded);
    w->motion[slot] = (float4)(m.DX, m.DY, bounce.x, bounce.y);
    IF_TURNING(if (wallRowsHold(&turning)) return true;)
    IF_TERRAIN(if (atPieces) return true;)
    return bounce.x != 0.0f || bounce.y != 0.0f || hasWalls(w, c, t.WALLS);
}

// started: motion as the start has left it. Returns as startCircle.
bool endSolve(const World *w, int slot, bool atWall, float4 c, float4 started, float2 v,
              float burden AND_TURNING(float s) AND_TERRAIN(bool atPieces)) {
    bool isStatic = burden == 0.0f;
    IF_TURNING(s = moveTurning(w, slot, s);)
    float4 m = integratePositions(w, slot, c, (float4)(started.DX, started.DY, v.x, v.y), isStatic);
    if (!isStatic && (atWall || !wallsAreApart(&w->k, c, m))) {
        float4 t = w->traits[slot];
        float2 walls = t.WALLS;
        IF_TERRAIN(if (atPieces) m.DISPLACEMENT = movePieces(w, slot, c, started.DISPLACEMENT, m.DISPLACEMENT);)
        IF_RECORDING(float2 moving = m.VELOCITY;)
        IF_TURNING(Turning turning = turningOf(w, slot, t, s);)
        relaxAtWalls(w, c, &m, &t, started.WALL_TARGETS, isLoaded(burden) AND_TURNING(&turning));
        IF_RECORDING(noteWallsRelaxed(w, slot, c, t.INVERSE_MASS, moving, m AND_TURNING(&turning));)
        atWall = hasWalls(w, c, t.WALLS);
        IF_TURNING(atWall = atWall || wallRowsHold(&turning);)
        IF_TERRAIN(if (atPieces) relaxPieces(w, slot, c, t.RESTITUTION, isLoaded(burden), &m AND_TURNING(&turning));)
        IF_TERRAIN(atWall = atWall || atPieces;)
        IF_TURNING(s = turning.s;)
        IF_TURNING(keepWallRows(w, slot, &turning);)
        storeWalls(w, slot, walls, t.WALLS);
    }
    w->solvedMotion[slot] = m;
    w->solvedBurden[slot] = burden;
    IF_TURNING(w->solvedSpin[slot] = s;)
    return atWall;
}
