// Stage Solver for tiles: what is a circle's own business, made once by the work-group whose tile it is in. The same as
// solver_accelerate and solver_move of Solver.cl. Most circles are far from the walls: what belongs to walls stays in memory
// unread, unless the mark AT_WALL of the tile's record says that there is something, or the circle comes near.

// A slot in a tile's record: not the tile's own; has something to do with a wall.
#define NOT_OWN ((int) 0x80000000)
#define AT_WALL 0x40000000
#define SLOT_MASK 0x3fffffff

// Whether a wall without an impulse leaves a circle alone in the biased pass: pushFromWall would change no more than the sign
// of a zero. before: velocity along the axis before any impulse; v: after those of its contacts.
bool wallIsFar(const World *w, float x, float dx, float before, float v, float r, float min, float max) {
    float side = wallSide(x, min, max);
    float gap = wallGap(x, dx, r, side, min, max);
    return gap > 0.0f && !(gap * w->k.inverseH + side * v < 0.0f) && !(gap + side * before * w->k.h < 0.0f);
}

// Begins a sub-step for a circle: gravity, the impulses of the sub-step before, the walls. place: in the tile's record;
// atWall: whether the impulses of walls may be other than 0; d: displacement; v: velocity; mass: inverse; sum: of the impulses
// of its contacts; carried: whether one of them carries. Leaves to the biased pass its drive, burden and startDisplacement.
void startCircle(const World *w, global int *place, int slot, bool atWall, float4 c, float2 d, float2 v, float mass,
                 float2 sum, bool carried) {
    const StepConstants *k = &w->k;
    float2 before = v;
    bool loaded = false;
    bool walled = false;
    if (mass != 0.0f) {
        before = (float2)(v.x + k->gravityStepX, v.y + k->gravityStepY);
        loaded = carried;
        float2 kept = (float2)(0.0f);
        if (atWall) kept = (float2)(w->traits[slot].z, w->traits[slot].w);
        float2 next = (float2)(limitSpeed(before.x + mass * sum.x), limitSpeed(before.y + mass * sum.y));
        if (kept.x == 0.0f && kept.y == 0.0f && wallIsFar(w, c.x, d.x, before.x, next.x, c.z, k->minX, k->maxX) &&
            wallIsFar(w, c.y, d.y, before.y, next.y, c.z, k->minY, k->maxY)) {
            float2 none = (float2)(wallSide(c.x, k->minX, k->maxX) * 0.0f, wallSide(c.y, k->minY, k->maxY) * 0.0f);
            v = (float2)(next.x + none.x, next.y + none.y);
            if (atWall) {
                w->traits[slot].z = none.x;
                w->traits[slot].w = none.y;
            }
        } else {
            float4 m = (float4)(d.x, d.y, v.x, v.y);
            float4 t = (float4)(mass, w->traits[slot].y, w->traits[slot].z, w->traits[slot].w);
            float2 bounce;
            accelerate(w, c, &m, &t, (float4)(sum.x, sum.y, 0.0f, carried ? 1.0f : 0.0f), &before, &bounce, &loaded);
            d = m.xy;
            v = m.zw;
            w->traits[slot].z = t.z;
            w->traits[slot].w = t.w;
            w->wallBounce[slot] = bounce;
            walled = t.z != 0.0f || t.w != 0.0f || bounce.x != 0.0f || bounce.y != 0.0f;
        }
    }
    int marked = walled ? slot | AT_WALL : slot;
    if (*place != marked) *place = marked;
    w->drive[slot] = (float4)(v.x, v.y, before.x, before.y);
    w->burden[slot] = as_float(as_uint(mass) | (loaded ? 0x80000000u : 0u));
    w->startDisplacement[slot] = d;
}

// Ends the biased pass for a circle: its move, within the walls, and the relaxing pass over those. place: in the tile's record,
// what it says; c, d: the circle and its displacement; v: velocity; burden: inverse mass, negative where loaded.
void endPush(const World *w, global int *place, int said, float4 c, float2 d, float2 v, float burden) {
    const StepConstants *k = &w->k;
    int slot = said & SLOT_MASK;
    bool atWall = (said & AT_WALL) != 0;
    float mass = fabs(burden);
    float4 m = (float4)(d.x, d.y, v.x, v.y);
    moveFreely(w, slot, c, &m, mass);
    if (mass != 0.0f &&
        (atWall || !(wallGap(c.x, m.x, c.z, wallSide(c.x, k->minX, k->maxX), k->minX, k->maxX) > 0.0f) ||
         !(wallGap(c.y, m.y, c.z, wallSide(c.y, k->minY, k->maxY), k->minY, k->maxY) > 0.0f))) {
        float4 t = w->traits[slot];
        relaxAtWalls(w, c, &m, &t, atWall ? w->wallBounce[slot] : (float2)(0.0f), as_int(burden) < 0);
        w->traits[slot].z = t.z;
        w->traits[slot].w = t.w;
        if (!atWall && (t.z != 0.0f || t.w != 0.0f)) *place = slot | AT_WALL;
    }
    w->pushedVelocity[slot] = (float4)(m.z, m.w, burden, 0.0f);
    w->pushedDisplacement[slot] = m.xy;
}
