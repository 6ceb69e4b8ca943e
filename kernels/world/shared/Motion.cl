// uses: world/shared/Paths.cl world/shared/Wall.cl world/shared/Drive.cl world/shared/Turning.cl world/shared/PieceVisit.cl
// The motion of a circle through a sub-step, with its walls and pieces of terrain. m: motion; t: traits.

INLINE float2 beforeImpulses(const World *w, int slot, float invMass, float4 m) {
    if (w->k.driving != 0) return drivenVelocity(w, w->id[slot], invMass, m);
    return (float2)(m.VX + w->k.gravityStepX, m.VY + w->k.gravityStepY);
}

// Gravity, the impulses of the sub-step before, and the biased pass over the walls. l: load.
void integrateVelocities(const World *w, int slot, float4 c, float4 *m, float4 *t, float4 l, float2 *before, float2 *bounce,
                         bool *loaded AND_TURNING(Turning *turning) AND_TURNING(float spinSum)) {
    const StepConstants *k = &w->k;
    if (t->INVERSE_MASS == 0.0f) {
        *before = (float2)(m->VX, m->VY);
        *bounce = (float2)(0.0f);
        *loaded = false;
#if defined(TURNING) && (defined(RECORDING) || defined(BODIES))
        w->spinImpulse[slot] = turning->s;
#endif
        return;
    }
    *before = beforeImpulses(w, slot, t->INVERSE_MASS, *m);
    bool atWalls = wallsAct(w, slot, t->WALLS);
    *loaded = l.LOADED_NEXT > 0.0f || atWalls;
    IF_TERRAIN(*loaded = *loaded || piecesAct(w, slot);)
    // Arrays, in a loop that stays one: few circles are at walls, and in registers this would leave a GPU room for fewer work-groups.
    float x[2] = {c.x, c.y};
    float dx[2] = {m->DX, m->DY};
    float v[2] = {before->x, before->y};
    float next[2] = {afterImpulse(v[0], t->INVERSE_MASS, l.IMPULSES.x), afterImpulse(v[1], t->INVERSE_MASS, l.IMPULSES.y)};
    float wall[2] = {t->WALL_X, t->WALL_Y};
    IF_TURNING(turning->s = startedSpin(w, slot, c.RADIUS, turning->s, spinSum);)
    IF_TURNING(if (atWalls) startWallRows(w, c, wall, next, turning);)
    float target[2];
    float low[2] = {k->minX, k->minY};
    float high[2] = {k->maxX, k->maxY};
    float rate[2] = {k->thresholdRateX, k->thresholdRateY};
#pragma unroll 1
    for (int axis = 0; axis < 2; axis++) {
#ifdef TURNING
        turning->from[axis] = next[axis];
#ifdef RECORDING
        if (w->recording.walls) {
            float side = wallSide(x[axis], low[axis], high[axis]);
            turning->slid[axis] = slipAtWall(w, turning, axis, side, wallOf(axis, side), v[1 - axis], w->spinImpulse[slot]);
        }
#endif
#endif
        next[axis] = solveWall(w, axis, x[axis], &dx[axis], v[axis], next[axis], c.RADIUS, t->RESTITUTION, *loaded, low[axis], high[axis],
                               rate[axis], &wall[axis], &target[axis] AND_TURNING(turning) AND_TURNING(next + (1 - axis)));
        IF_TURNING(turning->to[axis] = next[axis];)
    }
    *bounce = (float2)(target[0], target[1]);
    *m = (float4)(dx[0], dx[1], next[0], next[1]);
    t->WALL_X = wall[0];
    t->WALL_Y = wall[1];
}

// The same if no wall pushes the circle; false if a wall may begin to.
INLINE bool integrateOffWalls(const World *w, int slot, float4 c, float4 m, float invMass, float2 impulses, float2 *before, float2 *v) {
    const StepConstants *k = &w->k;
    *before = beforeImpulses(w, slot, invMass, m);
    float2 next = (float2)(afterImpulse(before->x, invMass, impulses.x), afterImpulse(before->y, invMass, impulses.y));
    // Zeros, as the visits would add: the signs of zeros are state.
    *v = next + noWalls(k, c);
    bool farX = wallIsFar(k, c.x, m.DX, before->x, next.x, c.RADIUS, k->minX, k->maxX);
    bool farY = wallIsFar(k, c.y, m.DY, before->y, next.y, c.RADIUS, k->minY, k->maxY);
    return (invMass != 0.0f) & farX & farY;
}

// Impulses of walls, if they have changed.
void storeWalls(const World *w, int slot, float2 old, float2 walls) {
    if (as_int(old.x) != as_int(walls.x) || as_int(old.y) != as_int(walls.y)) {
        *(global float2 *) ((global float *) (w->traits + slot) + WALLS_AT) = walls;
    }
}

// Whether walls push a circle, or its zeros have other signs than off walls.
bool hasWalls(const World *w, float4 c, float2 walls) {
    float2 none = noWalls(&w->k, c);
    return as_int(walls.x) != as_int(none.x) || as_int(walls.y) != as_int(none.y);
}

INLINE float allowanceOf(const World *w, int slot, float r) {
#if defined(JOINTS) || defined(BODIES)
    return w->motionClamp[slot].ALLOWANCE; // of one that a joint holds, or a body has pushed, it is infinite
#else
    return w->k.sweeping ? w->motionClamp[slot].ALLOWANCE : CLAMP_ALLOWANCE * r;
#endif
}

// A displacement, brought as near to a place as is allowed.
INLINE float2 withinAllowance(float2 on, float2 d, float allowance) {
    float offX = d.x - on.x;
    float offY = d.y - on.y;
    float off = lengthf(offX, offY);
    if (!(off > allowance)) return d;
    float keep = allowance / off;
    return (float2)(on.x + keep * offX, on.y + keep * offY);
}

// Keeps a circle behind the place where it touches a static one, or takes it along. Not inlined: few circles come here, and all others
// would pay for its registers.
float2 clampAtStatic(float4 clamp_, float2 d) {
    if (clamp_.ALLOWANCE == CARRIED) return clamp_.PATH;
    float along = alongPath(d.x, d.y, clamp_.PATH_X, clamp_.PATH_Y);
    if (along > clamp_.FREE_SHARE) {
        d.x -= (along - clamp_.FREE_SHARE) * clamp_.PATH_X;
        d.y -= (along - clamp_.FREE_SHARE) * clamp_.PATH_Y;
    }
    float share = minf(nearest(d.x, d.y, clamp_.PATH_X, clamp_.PATH_Y), clamp_.FREE_SHARE);
    float allowance = along > 0.0f ? -ASIDE * clamp_.ALLOWANCE : -clamp_.ALLOWANCE;
    return withinAllowance((float2)(share * clamp_.PATH_X, share * clamp_.PATH_Y), d, allowance);
}

INLINE float2 clampMotion(const World *w, int slot, float r, float dx, float dy) {
    float allowance = allowanceOf(w, slot, r);
    if (dx * dx + dy * dy <= allowance * fabs(allowance)) return (float2)(dx, dy);
    float4 clamp_ = w->motionClamp[slot];
    if (allowance < 0.0f) return clampAtStatic(clamp_, (float2)(dx, dy));
    float share = nearest(dx, dy, clamp_.PATH_X, clamp_.PATH_Y);
    return withinAllowance((float2)(share * clamp_.PATH_X, share * clamp_.PATH_Y), (float2)(dx, dy), allowance);
}

// Cut by walls that move, where they are at the end of the sub-step.
float keepInside(const World *w, float x, float d, float r, int axis, float min, float max) {
    return within(x, d, (min - behindOf(w, 2 * axis)) + r, (max + behindOf(w, 2 * axis + 1)) - r);
}

INLINE float4 integratePositions(const World *w, int slot, float4 c, float4 m, bool isStatic) {
    const StepConstants *k = &w->k;
    float vx = limitSpeed(m.VX);
    float vy = limitSpeed(m.VY);
    float2 d = (float2)(m.DX + vx * k->h, m.DY + vy * k->h);
    if (!isStatic) d = clampMotion(w, slot, c.RADIUS, d.x, d.y);
    float edge = isStatic ? 0.0f : c.RADIUS;
    float dx = within(c.x, d.x, k->minX + edge, k->maxX - edge);
    float dy = within(c.y, d.y, k->minY + edge, k->maxY - edge);
    if (isStatic) {
        // What lies on a static circle must not see it move on when the bounds have stopped it.
        vx = dx == d.x ? vx : 0.0f;
        vy = dy == d.y ? vy : 0.0f;
    } else {
        if (((dx != d.x) | (dy != d.y)) && w->walls->any) {
            dx = keepInside(w, c.x, d.x, c.RADIUS, 0, k->minX, k->maxX);
            dy = keepInside(w, c.y, d.y, c.RADIUS, 1, k->minY, k->maxY);
        }
        vx = stopAtFarWall(vx, d.x, dx, wallSide(c.x, k->minX, k->maxX));
        vy = stopAtFarWall(vy, d.y, dy, wallSide(c.y, k->minY, k->maxY));
    }
    return (float4)(dx, dy, vx, vy);
}

void relaxAtWalls(const World *w, float4 c, float4 *m, float4 *t, float2 bounce, bool loaded AND_TURNING(Turning *turning)) {
    const StepConstants *k = &w->k;
    float x[2] = {c.x, c.y};
    float dx[2] = {m->DX, m->DY};
    float v[2] = {m->VX, m->VY};
    float wall[2] = {t->WALL_X, t->WALL_Y};
    float target[2] = {bounce.x, bounce.y};
    float low[2] = {k->minX, k->minY};
    float high[2] = {k->maxX, k->maxY};
    float rate[2] = {k->thresholdRateX, k->thresholdRateY};
#pragma unroll 1
    for (int axis = 0; axis < 2; axis++) {
#ifdef TURNING
        turning->from[axis] = v[axis];
#ifdef RECORDING
        if (w->recording.walls) {
            float side = wallSide(x[axis], low[axis], high[axis]);
            turning->slid[axis] = slipAtWall(w, turning, axis, side, wallOf(axis, side), v[1 - axis], turning->s);
        }
#endif
#endif
        v[axis] = relaxWall(w, axis, x[axis], dx[axis], v[axis], c.RADIUS, t->RESTITUTION, loaded, target[axis], low[axis], high[axis],
                            rate[axis], &wall[axis] AND_TURNING(turning) AND_TURNING(v + (1 - axis)));
        IF_TURNING(turning->to[axis] = v[axis];)
    }
    m->VX = v[0];
    m->VY = v[1];
    t->WALL_X = wall[0];
    t->WALL_Y = wall[1];
}

#ifdef EDGES
// Brings a coordinate that has crossed the edge of an axis that wraps to the other side. d: displacement.
void bringInside(float *x, float *d, float min_, float last, float period) {
    float lapsOfX = laps(*x, min_, period);
    if (lapsOfX == 0.0f) return;
    float away = -(lapsOfX * period);
    float near = *x + away;
    float rest = *d + lostByRounding(*x, away, near);
    float sum = near + rest;
    *x = clampf(sum, min_, last);
    *d = *x == sum ? lostByRounding(near, rest, sum) : 0.0f;
}
#endif

#ifdef SLEEPING
// m: motion, before the base takes the displacement.
void finalizeSleep(const World *w, int slot, float4 m, float inverseMass_) {
    int4 sleep = w->sleep[slot];
    if (inverseMass_ != 0.0f) {
        sleep.DRIFT_X = as_int(as_float(sleep.DRIFT_X) + m.DX);
        sleep.DRIFT_Y = as_int(as_float(sleep.DRIFT_Y) + m.DY);
        IF_TURNING(sleep.UNITS_TURNED = (int) ((uint) sleep.UNITS_TURNED + ((uint) w->homeTurn[slot].ANGLE - (uint) w->turn[slot].ANGLE));)
    }
    w->homeSleep[slot] = sleep;
}
#endif

// The base takes the displacement, the displacement what that lost; all goes home.
INLINE void finalizePositions(const World *w, int slot, float4 c, float4 m, float4 t) {
    const StepConstants *k = &w->k;
    float edge = t.INVERSE_MASS == 0.0f ? 0.0f : c.RADIUS;
    float x = c.x + m.DX;
    float y = c.y + m.DY;
    float keptX = clampf(x, k->minX + edge, k->maxX - edge);
    float keptY = clampf(y, k->minY + edge, k->maxY - edge);
    int id = w->id[slot];
    float dx = keptX == x ? lostByRounding(c.x, m.DX, x) : 0.0f;
    float dy = keptY == y ? lostByRounding(c.y, m.DY, y) : 0.0f;
#ifdef EDGES
    bringInside(&keptX, &dx, w->levels->minX, w->levels->lastX, w->levels->periodX);
    bringInside(&keptY, &dy, w->levels->minY, w->levels->lastY, w->levels->periodY);
#endif
    w->homeMotion[slot] = (float4)(dx, dy, limitSpeed(m.VX), limitSpeed(m.VY));
    w->homeCircle[slot] = (float4)(keptX, keptY, c.RADIUS, c.MASS);
    w->homeTraits[slot] = t;
    w->homeId[slot] = id;
    w->slotOf[id] = slot;
    IF_TURNING(finalizeTurning(w, slot, c.RADIUS);)
    IF_TERRAIN(finalizePieces(w, slot);)
    IF_SLEEPING(finalizeSleep(w, slot, m, t.INVERSE_MASS);)
}
