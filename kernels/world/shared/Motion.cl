// uses: world/shared/Wall.cl
// The motion of a circle through a sub-step, walls included: velocities, then, after the biased pass over the contacts,
// positions; and its state at the end of the step.

// Gravity, the impulses of the sub-step before, and the biased pass over the walls, for one circle: changes motion m and
// the wall impulses in traits t; l: its sums of impulses, and whether one of its contacts carries. Gives the velocity
// before any impulse, the target speeds of bounces off walls, and whether the circle is loaded.
void integrateVelocities(const World *w, float4 c, float4 *m, float4 *t, float4 l, float2 *before, float2 *bounce,
                         bool *loaded) {
    const StepConstants *k = &w->k;
    if (t->x == 0.0f) {
        *before = (float2)(m->z, m->w);
        *bounce = (float2)(0.0f);
        *loaded = false;
        return;
    }
    float vx = m->z + k->gravityStepX;
    float vy = m->w + k->gravityStepY;
    *before = (float2)(vx, vy);
    *loaded = l.w > 0.0f || t->z != 0.0f || t->w != 0.0f;
    float nextX, nextY;
    // A loop over the axes: half the instructions to fetch.
#pragma unroll 1
    for (int axis = 0; axis < 2; axis++) {
        bool y = axis != 0;
        float v = y ? vy : vx;
        float wall = y ? t->w : t->z;
        float target;
        float dx = y ? m->y : m->x;
        float next = solveWall(k, y ? c.y : c.x, &dx, v, afterImpulse(v, t->x, y ? l.y : l.x), c.z, t->y, *loaded,
                               y ? k->minY : k->minX, y ? k->maxY : k->maxX, &wall, &target);
        if (y) {
            nextY = next;
            m->y = dx;
            t->w = wall;
            bounce->y = target;
        } else {
            nextX = next;
            m->x = dx;
            t->z = wall;
            bounce->x = target;
        }
    }
    m->z = nextX;
    m->w = nextY;
}

// integrateVelocities for a circle that no wall pushes, as long as none begins to: gives the velocities, and returns false if a
// wall may have to be visited. m: its motion; impulses: their sum.
INLINE bool integrateOffWalls(const StepConstants *k, float4 c, float4 m, float invMass, float2 impulses, float2 *before,
                              float2 *v) {
    *before = (float2)(m.z + k->gravityStepX, m.w + k->gravityStepY);
    float2 next = (float2)(afterImpulse(before->x, invMass, impulses.x), afterImpulse(before->y, invMass, impulses.y));
    // Adding zeros, as the visits would: the signs of zeros are part of the state.
    *v = next + noWalls(k, c);
    bool farX = wallIsFar(k, c.x, m.x, before->x, next.x, c.z, k->minX, k->maxX);
    bool farY = wallIsFar(k, c.y, m.y, before->y, next.y, c.z, k->minY, k->maxY);
    return (invMass != 0.0f) & farX & farY;
}

// Keeps a circle's displacement on its leash: no farther from the free part of its path than it is allowed.
INLINE float2 onLeash(const World *w, int slot, float r, float dx, float dy) {
    float allowance = LEASH * r;
    float square = dx * dx + dy * dy;
    if (w->k.sweeping) allowance = w->leash[slot].z;
    if (!(square > 0.0f) || !(square > allowance * allowance)) return (float2)(dx, dy);
    float4 leash = w->leash[slot];
    float share = nearest(dx, dy, leash.x, leash.y);
    float offX = dx - share * leash.x;
    float offY = dy - share * leash.y;
    float off = norm(offX, offY);
    if (!(off > allowance)) return (float2)(dx, dy);
    float keep = allowance / off;
    return (float2)(share * leash.x + keep * offX, share * leash.y + keep * offY);
}

// Moves a circle, and keeps it within the walls. m: its motion; returns what that becomes.
INLINE float4 integratePositions(const World *w, int slot, float4 c, float4 m, bool fixed) {
    const StepConstants *k = &w->k;
    float vx = limitSpeed(m.z);
    float vy = limitSpeed(m.w);
    float2 d = (float2)(m.x + vx * k->h, m.y + vy * k->h);
    if (!fixed) d = onLeash(w, slot, c.z, d.x, d.y);
    float edge = fixed ? 0.0f : c.z;
    float dx = within(c.x, d.x, k->minX + edge, k->maxX - edge);
    float dy = within(c.y, d.y, k->minY + edge, k->maxY - edge);
    if (fixed) {
        // a fixed circle that is stopped has stopped: what lies on it must not see it go on
        vx = dx == d.x ? vx : 0.0f;
        vy = dy == d.y ? vy : 0.0f;
    }
    return (float4)(dx, dy, vx, vy);
}

// The relaxing pass over the walls for a circle that has moved: changes the velocity in motion m and the wall impulses in
// traits t.
void relaxAtWalls(const World *w, float4 c, float4 *m, float4 *t, float2 bounce, bool loaded) {
    const StepConstants *k = &w->k;
#pragma unroll 1
    for (int axis = 0; axis < 2; axis++) {
        bool y = axis != 0;
        float wall = y ? t->w : t->z;
        float next = relaxWall(k, y ? c.y : c.x, y ? m->y : m->x, y ? m->w : m->z, c.z, t->y, loaded,
                                 y ? bounce.y : bounce.x, y ? k->minY : k->minX, y ? k->maxY : k->maxX, &wall);
        if (y) {
            m->w = next;
            t->w = wall;
        } else {
            m->z = next;
            t->z = wall;
        }
    }
}

// Ends the step for one circle: the base takes the displacement, the displacement what that lost, and all of it goes home.
INLINE void finalizePositions(const World *w, int slot, float4 c, float4 m, float4 t) {
    const StepConstants *k = &w->k;
    float edge = t.x == 0.0f ? 0.0f : c.z;
    float x = c.x + m.x;
    float y = c.y + m.y;
    float keptX = bounded(x, k->minX + edge, k->maxX - edge);
    float keptY = bounded(y, k->minY + edge, k->maxY - edge);
    int id = w->id[slot];
    w->homeMotion[slot] = (float4)(keptX == x ? lostByRounding(c.x, m.x, x) : 0.0f,
                                   keptY == y ? lostByRounding(c.y, m.y, y) : 0.0f,
                                   limitSpeed(m.z), limitSpeed(m.w));
    w->homeCircle[slot] = (float4)(keptX, keptY, c.z, c.w);
    w->homeTraits[slot] = t;
    w->homeId[slot] = id;
    w->slotOf[id] = slot;
}
