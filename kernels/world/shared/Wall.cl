// uses: world/shared/Walls.cl world/shared/OneBody.cl world/shared/OneBodyRows.cl world/shared/Surface.cl
// Walls: one-body constraints, of a circle and the nearer wall of each axis. A circle keeps their impulses, positive for a lower wall.

#if defined(RECORDING) || defined(TURNING)
int wallOf(int axis, float side) { return 2 * axis + (side > 0.0f ? 0 : 1); }
#endif

#ifdef TURNING
Between betweenWall(const World *w, const Turning *t, int wall) { return betweenSurfaces(w, t, SURFACE_OF_WALLS + wall); }

// v: velocity along the wall; belt: of the wall.
float againstWall(int axis, float side, float v, float belt) { return tangentAlong(axis, side) * (v - belt); }

#ifdef RECORDING
// v: velocity along the wall; s: surface speed.
float slipAtWall(const World *w, const Turning *t, int axis, float side, int wall, float v, float s) {
    Between b = betweenWall(w, t, wall);
    return slipOfOneBody(&b, againstWall(axis, side, v, b.belt), s, t->surface[SURFACE_BELT]);
}
#endif

// As warmOneBodyRows. across, along: velocity across the wall and along it.
void warmWallRows(const World *w, Turning *t, int axis, float side, int wall, float *across, float *along) {
    Between b = betweenWall(w, t, wall);
    pushAtWall(warmOneBodyRows(t, &b, t->walls + axis), axis, side, across, along);
}

// As visitOneBodyRows.
void visitWallRows(const World *w, Turning *t, int axis, float side, int wall, float *across, float *along, const Visited *visited,
                   float bounce) {
    Between b = betweenWall(w, t, wall);
    if (!oneBodyRowsAct(&b)) return;
    float speed = againstWall(axis, side, *along, b.belt);
    RowGain gain = visitOneBodyRows(t, &b, t->walls + axis, speed, t->surface[SURFACE_BELT], visited, bounce);
    pushAtWall(gain, axis, side, across, along);
}
#endif

// If it moves, where it will be at the end of the sub-step.
Found foundWall(const World *w, int axis, float x, float dx, float r, float e, bool loaded, float min, float max,
                float thresholdRate, float stored, float *side, int *wall) {
    *side = wallSide(x, min, max);
    *wall = 2 * axis + (*side > 0.0f ? 0 : 1);
    float separation = wallGap(x, dx, r, *side, min, max) + behindOf(w, *wall);
    return foundOneBody(&w->k, separation, r, e, thresholdRate, wallImpulse(stored, *side), loaded);
}

// before: velocity along the axis before any impulse; v: after those of the contacts; returns the new one. A wall that moves is visited in
// its frame, by where it is now, unless it stays clear.
float solveWall(const World *w, int axis, float x, float *dx, float before, float v, float r, float e, bool loaded, float min,
                float max, float thresholdRate, float *stored, float *bounce AND_TURNING(Turning *turning)
                AND_TURNING(float *along)) {
    const StepConstants *k = &w->k;
    float side;
    int wall;
    Found f = foundWall(w, axis, x, *dx, r, e, loaded, min, max, thresholdRate, *stored, &side, &wall);
    v += side * f.normalImpulse;
    bool clear = staysClear(k, f.separation, side * v, side * before) & (f.normalImpulse == 0.0f);
    float speed = clear ? 0.0f : speedFor(w, wall, r);
    f.separation += clear ? 0.0f : sweepFor(w, wall, r);
    f.before = side * before - speed;
    float vn = side * v - speed;
    Visited visited;
    *bounce = solveOneBody(k, &f, vn, &visited);
    if (!visited.solved) *dx -= leftBehind(f.separation, vn, side * visited.impulse, k->dt, r);
    *stored = side * visited.normalImpulse;
    v = visited.leaves ? v : v + side * visited.impulse;
    IF_TURNING(if (bouncesFreely(&visited)) visitWallRows(w, turning, axis, side, wall, &v, along, &visited, *bounce);)
    return v;
}

// Returns the new velocity along the axis.
float relaxWall(const World *w, int axis, float x, float dx, float v, float r, float e, bool loaded, float bounce, float min,
                float max, float thresholdRate, float *stored AND_TURNING(Turning *turning) AND_TURNING(float *along)) {
    float side;
    int wall;
    Found f = foundWall(w, axis, x, dx, r, e, loaded, min, max, thresholdRate, *stored, &side, &wall);
    Visited visited;
    IF_TURNING(f.held = rowsHold(turning->walls[axis]);)
    relaxOneBody(&w->k, &f, bounce, side * v - speedFor(w, wall, r), &visited);
    // +0 at either wall after a bounce: the signs of zeros are state.
    if (visited.solved) *stored = bounce > 0.0f ? 0.0f : side * visited.normalImpulse;
    v = visited.leaves ? v : v + side * visited.impulse;
    IF_TURNING(if (!visited.still) visitWallRows(w, turning, axis, side, wall, &v, along, &visited, bounce);)
    return v;
}

// Impulses of the rows of walls, of x in even, of y in odd; there are none if circles cannot rotate.
INLINE WallRows wallRowsAt(const World *w, int slot) {
#ifdef TURNING
    return w->wallRows[slot];
#else
    return (WallRows)(0.0f);
#endif
}

// Whether a wall acts, see actingImpulse. walls: impulses.
bool wallsAct(const World *w, int slot, float2 walls) {
    WallRows rows = wallRowsAt(w, slot);
    return actingImpulse(fabs(walls.x), rows.even) > 0.0f || actingImpulse(fabs(walls.y), rows.odd) > 0.0f;
}

#ifdef TURNING
bool wallRowsHold(const Turning *t) { return rowsHold(t->walls[0]) || rowsHold(t->walls[1]); }
#endif

// The wall impulses of a circle that no wall pushes, with the signs of zeros.
float2 noWalls(const StepConstants *k, float4 c) {
    return (float2)(wallSide(c.x, k->minX, k->maxX) * 0.0f, wallSide(c.y, k->minY, k->maxY) * 0.0f);
}

// Whether solveWall changes no more than the sign of a zero, without an impulse of walls. A wall that moves is no nearer before the end of
// the step.
INLINE bool wallIsFar(const StepConstants *k, float x, float dx, float before, float v, float r, float min, float max) {
    float side = wallSide(x, min, max);
    return staysClear(k, wallGap(x, dx, r, side, min, max), side * v, side * before);
}

// Whether relaxWall changes nothing, without an impulse of walls and a bounce. m: motion.
INLINE bool wallsAreApart(const StepConstants *k, float4 c, float4 m) {
    float gapX = wallGap(c.x, m.DX, c.RADIUS, wallSide(c.x, k->minX, k->maxX), k->minX, k->maxX);
    float gapY = wallGap(c.y, m.DY, c.RADIUS, wallSide(c.y, k->minY, k->maxY), k->minY, k->maxY);
    return (gapX > 0.0f) & (gapY > 0.0f);
}
