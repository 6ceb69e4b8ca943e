// uses: world/shared/CrossRule.cl world/shared/PairRows.cl world/shared/Sleep.cl world/shared/Visit.cl world/shared/Wall.cl world/shared/Surface.cl
// uses: world/stages/CellScan.cl world/stages/Grid.cl world/stages/PairFilter.cl world/stages/Pieces.cl world/stages/Joints.cl
// Which circles wake as a step begins, and which fall asleep behind it. The Java classes world.jvm.Waking and FallingAsleep do the same.
//
// Who sleeps has the inverse mass 0, in traits and in sight: other stages need not know. Waking works on working slots, so a step that is
// refused has woken nobody. All sums are whole numbers, and all else is a maximum.
//
// heavySum: of one that sleeps, sums of impulses x, y, of those that carry it, and of those along its surface.

#ifdef SLEEPING
bool sleeps(const World *w, int slot) { return isAsleep(w->sleep[slot].REST); }

// What gravity and a force add to a circle's speed in a sub-step, if nothing holds it.
float ownGain(const World *w, int slot) {
    float2 g = gainOf(w, w->id[slot], ownInverseMass(w, slot));
    return lengthf(g.x, g.y);
}

float gainOfStep(const World *w, int slot) { return ownGain(w, slot) * (float) w->k.subSteps; }

int responseAt(const World *w, int slot, int other) {
    return w->k.filtering == 0 ? PAIR_SOLID : responseOf(w, w->id[slot], w->id[other]);
}

// Whether two circles would meet, if one of them moves.
bool wouldMeet(const World *w, int slot, int other) {
    IF_JOINTS(if (areParted(w, w->id[slot], w->id[other])) return false;)
    return responseAt(w, slot, other) == PAIR_SOLID;
}

bool areNear(const World *w, int slot, int other) {
    float4 s = w->sight[slot];
    float4 o = w->sight[other];
    return isNear(ACROSS_X(w, o.x - s.x), ACROSS_Y(w, o.y - s.y), s.SIGHT_DISTANCE, o.SIGHT_DISTANCE);
}

// The normal points from the circle of lower id to the other; it is zero if they have one centre.
typedef struct {
    int lower, higher;
    float nx, ny, separation, radii;
} Meeting;

Meeting meetingOf(const World *w, int slot, int other) {
    Meeting m;
    bool isLower = w->id[slot] < w->id[other];
    m.lower = isLower ? slot : other;
    m.higher = isLower ? other : slot;
    float4 a = w->circle[m.lower];
    float4 b = w->circle[m.higher];
    float4 ma = w->motion[m.lower];
    float4 mb = w->motion[m.higher];
    m.radii = a.RADIUS + b.RADIUS;
    m.nx = 0.0f;
    m.ny = 0.0f;
    measure(ACROSS_X(w, b.x - a.x), ACROSS_Y(w, b.y - a.y), mb.DX - ma.DX, mb.DY - ma.DY, m.radii, &m.nx, &m.ny, &m.separation);
    return m;
}

// How hard their contact acts, as this step goes on from the one before.
float actingOfMeeting(const World *w, const Meeting *m) {
    int entry = cachedEntry(w, (uint) m->lower, (uint) m->higher, w->id[m->higher]);
    return actingImpulse(warmStartImpulse(w, entry), warmStartRows(w, entry));
}

void wakeBy(const World *w, int slot, float speed) {
    if (speed > 0.0f) atomic_max((volatile global int *) (w->waking + slot), as_int(speed));
}

void wakeForSure(const World *w, int slot) {
    wakeBy(w, slot, strong(gainOfStep(w, slot), w->circle[slot].RADIUS, w->k.dt));
}

#ifdef JOINTS
// PRESSING of one that sleeps and that joints turn, until it is known.
#define JOINT_TURNED 1

// WAKING_SPEED behind a step: of a circle that a joint drives, and of one whose joint has broken
#define HELD_DRIVEN 1
#define HELD_TORN 2
#endif

// PRESSING of one that woke in a ring.
#define WOKEN_IN(ring) (-1 - (ring))

// ---- what presses those that sleep

// j, f: impulses along the normal and the tangent; load: how hard the contact acts.
void press(const World *w, int slot, const Meeting *m, float j, float load, float f, float rolling_) {
    if (!sleeps(w, slot)) return;
    float4 c = w->circle[slot];
    float scale = scaleOf(impulseRange(c.RADIUS, w->k.inverseH, inverseMass(c.MASS)));
    float side = slot == m->lower ? -1.0f : 1.0f;
    global long *sums = (global long *) (w->heavySum + slot);
    addFixed(sums, toFixed(side * (m->nx * j - m->ny * f), scale));
    addFixed(sums + 1, toFixed(side * (m->ny * j + m->nx * f), scale));
    addFixed(sums + 2, toFixed(load, scale));
    addFixed(sums + 3, toFixed(-f + side * rolling_ / c.RADIUS, scale));
}

// The circle of higher id of a cached impulse, or NONE if it is another one now.
int partnerOf(const World *w, int4 entry) {
    int home = w->slotOf[entry.CACHED_HIGHER_ID];
    if (home == NONE) return NONE;
    int slot = workingSlotOf(w)[home];
    return w->firstCached[slot] == FRESH ? NONE : slot;
}

// By the cached impulses of a circle as the one of lower id.
void pressByImpulses(const World *w, int slot) {
    for (int k = w->firstCached[slot]; k >= 0;) {
        int4 entry = w->impulseCache[k];
        int other = partnerOf(w, entry);
        if (other != NONE && (sleeps(w, slot) || sleeps(w, other))) {
            bool still = w->traits[slot].INVERSE_MASS == 0.0f && w->traits[other].INVERSE_MASS == 0.0f;
            if (still || (wouldMeet(w, slot, other) && areNear(w, slot, other))) {
                Meeting m = meetingOf(w, slot, other);
                float pushed = as_float(entry.CACHED_IMPULSE) * w->warmScale;
                RowImpulses rows = warmStartRows(w, k);
                float j = impulseAlongNormal(pushed, rows);
                float load = actingImpulse(pushed, rows);
                press(w, slot, &m, j, load, tangentImpulse(rows), angularImpulse(rows));
                press(w, other, &m, j, load, tangentImpulse(rows), angularImpulse(rows));
            }
        }
        k = entry.CACHED_NEXT;
    }
}

// ---- who is about to push them

void hitSleeper(const World *w, int slot, int sleeper) {
    if (!areNear(w, slot, sleeper) || !wouldMeet(w, slot, sleeper)) return;
    Meeting m = meetingOf(w, slot, sleeper);
    float2 v = w->motion[slot].VELOCITY;
    float along = dotf(m.nx, m.ny, v.x, v.y);
    float approach = slot == m.lower ? along : -along;
    if (!(approach > 0.0f)) return; // before all that is to be read
    float4 c = w->circle[sleeper];
    float restitution = maxf(w->traits[sleeper].RESTITUTION, w->traits[slot].RESTITUTION);
    wakeBy(w, sleeper, hit(approach, m.separation, inverseMass(c.MASS), ownInverseMass(w, slot), restitution,
                           actingOfMeeting(w, &m), gainOfStep(w, sleeper), c.RADIUS, w->k.dt));
}

// A static circle that moves, and may come near.
void comeNear(const World *w, int slot, int sleeper, float path) {
    float4 c = w->circle[sleeper];
    float4 o = w->circle[slot];
    float radii = c.RADIUS + o.RADIUS;
    float dx = ACROSS_X(w, o.x - c.x);
    float dy = ACROSS_Y(w, o.y - c.y);
    float far = (radii + MARGIN * radii) + path;
    if (dx * dx + dy * dy < far * far && responseAt(w, slot, sleeper) != PAIR_IGNORE) wakeForSure(w, sleeper);
}

// How far to look for circles up to a radius that a circle with a path may reach, with room for rounding.
float reachToWake(float r, float path, float top) { return 1.125f * ((r + top) + maxf(path, CAP * (r + top))); }

// What a circle does that does not sleep.
void pushSleepers(const World *w, int slot) {
    float4 c = w->circle[slot];
    bool isStatic = w->traits[slot].INVERSE_MASS == 0.0f;
    float2 v = w->motion[slot].VELOCITY;
    float path = isStatic ? w->motionClamp[slot].PATH_LENGTH : 0.0f;
    if (isStatic ? path == 0.0f : v.x == 0.0f && v.y == 0.0f) return;
    for (int l = 0; l < w->levels->usedCount; l++) {
        int level = w->levels->used[l];
        float reach = reachToWake(c.RADIUS, path, w->levels->top[level]);
        CellRange range = cellsAround(w, level, c.x - reach, c.x + reach, c.y - reach, c.y + reach);
        CellCursor at = firstCells(&range);
        int2 found;
        while (nextCells(w, &range, &at, false, &found)) {
            for (int other = found.x; other < found.y; other++) {
                if (!sleeps(w, other)) continue;
                if (isStatic) {
                    comeNear(w, slot, other, path);
                } else {
                    hitSleeper(w, slot, other);
                }
            }
        }
    }
}

bool haveSleepers(const World *w) { return w->status[SLEEPERS] != 0 && w->status[OUT_OF_ROOM] == 0; }

// Index space: slots. Cost: the impulses of the circle, and the circles around it if it moves.
kernel void sleeping_press(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot >= circles || !haveSleepers(&w) || gridIsEmpty(&w)) return;
    pressByImpulses(&w, slot);
    if (!sleeps(&w, slot)) pushSleepers(&w, slot);
}

#ifdef JOINTS
// Takes what a joint is. Returns whether it has begun, and has not broken.
bool takeHeld(const World *w, int joint, JointVisit *v) {
    takeTraits(w, joint, v);
    if (*jointSerial(w, joint) != v->HOLD_SERIAL) return false;
    takeRows(w, joint, v);
    return true;
}

bool drivesEnds(const JointVisit *v) { return drives(angularOf(v), v->ROW_SPEED, v->ROW_MAX_TORQUE, v->HOLD_ANCHOR); }

// Whether a circle of infinite mass moves so that a joint takes along what it holds. turns: whether the circle does.
bool takesAlong(const JointVisit *v, float4 c, float2 velocity, bool turns) {
    return inverseMass(c.MASS) == 0.0f &&
           (velocity.x != 0.0f || velocity.y != 0.0f || (turns && (angularOf(v) != 0 || holds(v, HOLD_ACROSS))));
}

// What a joint did in a sub-step of the last step, as this one goes on from it.
float jointSubStep(const World *w, float sum) { return ofSubStep(sum, w->warmScale, w->k.subSteps); }

float jointLoad(const World *w, const JointVisit *v) {
    return loadOfJoint(jointSubStep(w, v->KEPT_SUM_X), jointSubStep(w, v->KEPT_SUM_Y), holds(v, HOLD_ELASTIC));
}

// From slot a to slot b. Returns how far they are apart.
float wayOfJoint(const World *w, int a, int b, float2 *n) {
    float4 ca = w->circle[a];
    float4 cb = w->circle[b];
    float4 ma = w->motion[a];
    float4 mb = w->motion[b];
    float x = ACROSS_X(w, cb.x - ca.x) + (mb.DX - ma.DX);
    float y = ACROSS_Y(w, cb.y - ca.y) + (mb.DY - ma.DY);
    float d = lengthf(x, y);
    *n = d > 0.0f ? (float2)(x / d, y / d) : (float2)(0.0f);
    return d;
}

// Adds what a joint gives to a circle that sleeps. both: an angular impulse on both circles.
void pressByJoint(const World *w, const JointVisit *v, int slot, bool isA, float both) {
    float4 c = w->circle[slot];
    float scale = scaleOf(impulseRange(c.RADIUS, w->k.inverseH, inverseMass(c.MASS)));
    float x = jointSubStep(w, v->KEPT_SUM_X);
    float y = jointSubStep(w, v->KEPT_SUM_Y);
    float twist = jointSubStep(w, v->KEPT_SUM_ANGULAR);
    global long *sums = (global long *) (w->heavySum + slot);
    addFixed(sums, toFixed(isA ? -x : x, scale));
    addFixed(sums + 1, toFixed(isA ? -y : y, scale));
    addFixed(sums + 2, toFixed(jointLoad(w, v), scale));
    addFixed(sums + 3, toFixed((isA ? both + twist : both - twist) / c.RADIUS, scale));
    if (angularOf(v) != 0 || holds(v, HOLD_ACROSS)) w->waking[slot].PRESSING = JOINT_TURNED;
}

float pull(const World *w, int sleeper, int slot, float approach, float gap, float impulse) {
    return hit(approach, gap, ownInverseMass(w, sleeper), ownInverseMass(w, slot), 0.0f, impulse, gainOfStep(w, sleeper),
               w->circle[sleeper].RADIUS, w->k.dt);
}

// By a joint of a circle that is awake. d, n: from A to B.
void pullSleeper(const World *w, const JointVisit *v, int sleeper, int slot, bool isA, float d, float2 n) {
    float2 velocity = w->motion[slot].VELOCITY;
    float along = dotf(n.x, n.y, velocity.x, velocity.y);
    float apart = isA ? along : -along;
    float impulse = jointLoad(w, v);
    if (holds(v, HOLD_RIGID)) {
        float speed = fabs(apart);
#ifdef TURNING
        if (holds(v, HOLD_ACROSS)) {
            speed = lengthf(velocity.x, velocity.y) + 0.5f * d * fabs(as_float(w->turn[slot].ANGULAR_VELOCITY));
        }
#endif
        wakeBy(w, sleeper, pull(w, sleeper, slot, speed, 0.0f, impulse));
    }
    if (holds(v, HOLD_LOWER)) wakeBy(w, sleeper, pull(w, sleeper, slot, -apart, d - v->ROW_MIN_LENGTH, impulse));
    if (holds(v, HOLD_UPPER)) wakeBy(w, sleeper, pull(w, sleeper, slot, apart, v->ROW_MAX_LENGTH - d, impulse));
}

bool turnsNow(const World *w, int slot) {
#ifdef TURNING
    return as_float(w->turn[slot].ANGULAR_VELOCITY) != 0.0f;
#else
    return false;
#endif
}

// What a joint does to a circle that sleeps. other: the slot of what it holds it to, or NONE.
void holdSleeper(const World *w, const JointVisit *v, int slot, int other, bool isA, float both, float d, float2 n) {
    pressByJoint(w, v, slot, isA, both);
    if (drivesEnds(v)) wakeForSure(w, slot);
    if (other == NONE) return;
    if (w->traits[other].INVERSE_MASS != 0.0f) {
        pullSleeper(w, v, slot, other, isA, d, n);
    } else if (takesAlong(v, w->circle[other], w->motion[other].VELOCITY, turnsNow(w, other))) {
        wakeForSure(w, slot);
    }
}

void holdEnds(const World *w, int joint) {
    JointVisit v;
    if (!takeHeld(w, joint, &v)) return;
    int a = slotOfCircle(w, v.HOLDS_A);
    int b = slotOfCircle(w, v.HOLDS_B);
    if (!isStill(w, a) && !isStill(w, b)) return;
    float2 n = (float2)(0.0f);
    float d = b == NONE ? 0.0f : wayOfJoint(w, a, b, &n);
    float both = holds(&v, HOLD_ACROSS) ? -0.5f * d * (v.KEPT_ACROSS * w->warmScale) : 0.0f;
    if (isStill(w, a)) holdSleeper(w, &v, a, b, true, both, d, n);
    if (isStill(w, b)) holdSleeper(w, &v, b, a, false, both, d, n);
}

// Joints as the step begins. Index space: places in the order of joints.
kernel void sleeping_hold(WORLD_PARAMETERS) {
    World w = WORLD;
    int place = (int) get_global_id(0);
    if (place < w.joints->count && haveSleepers(&w) && !gridIsEmpty(&w)) holdEnds(&w, jointAt(&w, place));
}

// Marks a circle that does not fall asleep behind the step, or one that wakes behind it. id: or NONE.
void markHeld(const World *w, int id, int as) {
    if (id != NONE) atomic_max((volatile global int *) (w->waking + w->slotOf[id]), as);
}

bool takesAlongBehind(const World *w, const JointVisit *v, int id) {
    if (id == NONE) return false;
    int slot = w->slotOf[id];
    bool turns = false;
    IF_TURNING(turns = as_float(w->homeTurn[slot].ANGULAR_VELOCITY) != 0.0f;)
    return takesAlong(v, w->homeCircle[slot], w->homeMotion[slot].VELOCITY, turns);
}

// Joints behind the step: some have broken in it. Index space: places in the order of joints.
kernel void sleeping_held(WORLD_PARAMETERS) {
    World w = WORLD;
    int place = (int) get_global_id(0);
    if (place >= w.joints->count || refused(&w)) return;
    JointVisit v;
    if (!takeHeld(&w, jointAt(&w, place), &v)) {
        if (endsOf(&w, place)->x == NONE) return;
        markHeld(&w, v.HOLDS_A, HELD_TORN);
        markHeld(&w, v.HOLDS_B, HELD_TORN);
        return;
    }
    bool drives_ = drivesEnds(&v);
    if (drives_ || takesAlongBehind(&w, &v, v.HOLDS_B)) markHeld(&w, v.HOLDS_A, HELD_DRIVEN);
    if (drives_ || takesAlongBehind(&w, &v, v.HOLDS_A)) markHeld(&w, v.HOLDS_B, HELD_DRIVEN);
}

#ifdef BODIES
// Circles that joints hold to bodies, behind the step. Index space: these, of which held has the ids.
kernel void sleeping_holdByBodies(WORLD_PARAMETERS, global const int *held, int count) {
    World w = WORLD;
    int k = (int) get_global_id(0);
    if (k < count && !refused(&w)) markHeld(&w, held[k], HELD_DRIVEN);
}
#endif
#endif

// ---- who wakes

// Of the walls of an axis.
bool wallsMoveNear(const World *w, int axis, float x, float r, float min_, float max_) {
    float low = w->walls->travel[2 * axis];
    float high = w->walls->travel[2 * axis + 1];
    float far = r + MARGIN * (2.0f * r);
    return (low != 0.0f && x - min_ < far + fabs(low)) || (high != 0.0f && max_ - x < far + fabs(high));
}

typedef struct {
    long x, y, load, spin;
} Pressed;

// j, f: impulses along an outward normal and along the tangent; load: how hard the contact acts.
void addPressed(Pressed *p, float scale, float nx, float ny, float j, float load, float f) {
    p->x += toFixed(nx * j - ny * f, scale);
    p->y += toFixed(ny * j + nx * f, scale);
    p->load += toFixed(load, scale);
}

void addSpin(Pressed *p, float scale, RowImpulses i, float own) {
    p->spin += toFixed(spinOfOneBody(i) / own, scale);
}

// Of the wall that has a signed impulse. nearer: side of the nearer one.
float sideOfPush(float impulse, float nearer) { return impulse == 0.0f ? nearer : impulse > 0.0f ? 1.0f : -1.0f; }

// own: inverse mass.
void pressByWalls(const World *w, int slot, float own, float scale, Pressed *p) {
    float2 walls = w->traits[slot].WALLS;
    float4 c = w->circle[slot];
    WallRows rows = wallRowsAt(w, slot);
    float sideX = sideOfPush(walls.x, wallSide(c.x, w->k.minX, w->k.maxX));
    float sideY = sideOfPush(walls.y, wallSide(c.y, w->k.minY, w->k.maxY));
    float loadX = actingImpulse(fabs(walls.x), rows.even);
    float loadY = actingImpulse(fabs(walls.y), rows.odd);
    addSpin(p, scale, rows.even, own);
    addSpin(p, scale, rows.odd, own);
    p->x += toFixed(sideX * impulseAlongNormal(fabs(walls.x), rows.even) / own, scale);
    p->y += toFixed(loadX > 0.0f ? tangentAlong(0, sideX) * tangentImpulse(rows.even) / own : 0.0f, scale);
    p->y += toFixed(sideY * impulseAlongNormal(fabs(walls.y), rows.odd) / own, scale);
    p->x += toFixed(loadY > 0.0f ? tangentAlong(1, sideY) * tangentImpulse(rows.odd) / own : 0.0f, scale);
    p->load += toFixed(loadX / own, scale);
    p->load += toFixed(loadY / own, scale);
}

#ifdef TERRAIN
// By the pieces of terrain that it lies on, as this step would find them. Returns whether one that moves may come near.
bool pressByPieces(const World *w, int slot, float own, float scale, Pressed *p) {
    PieceSeeker s = seekerOfPieces(w, slot, 0.0f);
    if (!listPieces(w, &s)) return false;
    float4 c = s.c;
    goOnTouching(w, &s, w->pieces[slot]);
    int2 found = (int2)(s.first, s.count);
    bool moves = false;
    float near_ = (c.RADIUS + MARGIN * c.RADIUS) + MARGIN * c.RADIUS;
#pragma unroll 1
    for (int k = s.first; k < s.first + s.count; k++) {
        int piece = w->piece[k].TOUCHED_PIECE;
        int4 traits = pieceTraits(w, piece);
        if (traits.TRAIT_MOTION == 0) continue;
        global const float *row = pieceRow(w, piece);
        float2 o = offsetOf(w, c, row);
        moves |= distanceOfPiece(row, traits.TRAIT_SHAPE, o.x, o.y) < near_ + row[PIECE_MOST];
    }
    measurePieces(w, found, c, w->motion[slot].DISPLACEMENT, 0);
#pragma unroll 1
    for (int k = s.first; k < s.first + s.count; k++) {
        if (!isConstraint(w->piece[k]) || !pieceActs(w, k)) continue;
        float4 g = w->measured[k];
        float pushed = w->push[k].PUSH_NORMAL;
        RowImpulses rows = w->pieceRows[k];
        addPressed(p, scale, g.MEASURED_X, g.MEASURED_Y, impulseAlongNormal(pushed, rows) / own, actingImpulse(pushed, rows) / own,
                   tangentImpulse(rows) / own);
        addSpin(p, scale, rows, own);
    }
    return moves;
}
#endif

// Is awake from now on, also to what describes it. Returns whether it is fast.
bool wakeSlot(const World *w, int slot, int ring) {
    float4 c = w->circle[slot];
    w->waking[slot].PRESSING = WOKEN_IN(ring);
    float4 m = w->motion[slot];
    float own = inverseMass(c.MASS);
    w->sleep[slot] = (int4)(0, as_int(0.0f - m.DX), as_int(0.0f - m.DY), 0);
    w->traits[slot].INVERSE_MASS = own;
    IF_TURNING(w->inverseInertia[slot] = own * w->surfaces[SURFACE_STRIDE * w->fields[w->id[slot]].kind + SURFACE_INERTIA];)
    return describeCircle(w, slot, w->id[slot], c, m, own);
}

// Whether a circle that sleeps wakes. Counts the steps in a row in which it was out of balance.
bool wakes(const World *w, int slot) {
    float4 c = w->circle[slot];
    float own = inverseMass(c.MASS);
    float range = impulseRange(c.RADIUS, w->k.inverseH, own);
    float scale = scaleOf(range);
    long4 sums = w->heavySum[slot];
    w->heavySum[slot] = (long4)(0);
    Pressed p = {sums.x, sums.y, sums.z, sums.w};
    pressByWalls(w, slot, own, scale, &p);
    bool moved = wallsMoveNear(w, 0, c.x, c.RADIUS, w->k.minX, w->k.maxX) || wallsMoveNear(w, 1, c.y, c.RADIUS, w->k.minY, w->k.maxY);
    IF_TURNING(moved = moved || (w->surfaces[SURFACE_OWN] != 0.0f && w->own[slot].OWN_TORQUE != 0.0f);)
    IF_TERRAIN(if (pressByPieces(w, slot, own, scale, &p)) moved = true;)
    float unit = unitOf(range);
    float load = fromFixed(p.load, unit);
    float2 g = gainOf(w, w->id[slot], own);
    float gain_ = lengthf(g.x, g.y);
    int4 sleep = w->sleep[slot];
    bool strict = changes(g, as_float(sleep.KNOWN_X), as_float(sleep.KNOWN_Y), w->k.h, gain_, c.RADIUS, w->k.dt);
    if (strict) {
        sleep.KNOWN_X = as_int(g.x * w->k.inverseH);
        sleep.KNOWN_Y = as_int(g.y * w->k.inverseH);
    }
    float x = g.x + own * fromFixed(p.x, unit);
    float y = g.y + own * fromFixed(p.y, unit);
    if (sleep.OFFSET == SLEEP_NO_OFFSET) sleep.OFFSET = strict ? 0 : offset(x, y, gain_);
    float imbalance = lengthf(x - offsetX(sleep.OFFSET, gain_), y - offsetY(sleep.OFFSET, gain_));
#if defined(JOINTS) && defined(TURNING)
    if (w->waking[slot].PRESSING == JOINT_TURNED) {
        imbalance = maxf(imbalance, SLEEP_SHARE_OF_SPIN * fabs(ownInverseInertia(w, slot) * fromFixed(p.spin, unit)));
    }
#endif
    float speed = as_float(w->waking[slot].WAKING_SPEED);
    if (moved) speed = maxf(speed, strong(gain_ * (float) w->k.subSteps, c.RADIUS, w->k.dt));
    int rest = SLEEP_ASLEEP;
    if (imbalance > tolerance(strict, gain_, own * load, c.RADIUS, w->k.dt)) {
        rest = sleep.REST - 1;
        if (losesPatience(strict, gain_, imbalance, SLEEP_ASLEEP - rest)) {
            speed = maxf(speed, imbalanceOfStep(imbalance, w->k.subSteps, c.RADIUS, w->k.dt));
        }
    }
    sleep.REST = rest;
    w->sleep[slot] = sleep;
    w->waking[slot] = (int2)(as_int(speed), as_int(load));
    return speed > 0.0f;
}

// Index space: slots. Lists those that wake.
kernel void sleeping_wake(WORLD_PARAMETERS) {
    World w = WORLD;
    local int fast;
    int slot = (int) get_global_id(0);
    if (get_local_id(0) == 0) fast = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (slot < circles && haveSleepers(&w) && !gridIsEmpty(&w) && sleeps(&w, slot) && wakes(&w, slot)) {
        if (wakeSlot(&w, slot, 0)) fast = 1;
        w.woken[atomic_inc(&status[WOKEN_COUNT])].x = slot;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0 && fast) status[FAST] = 1;
}

// ---- how far that wakes others

float passImpulse(const World *w, int slot, int sleeper, float impulse) {
    return passedOn(as_float(w->waking[slot].WAKING_SPEED), impulse, as_float(w->waking[sleeper].PRESSING),
                    ownInverseMass(w, sleeper), ownInverseMass(w, slot), gainOfStep(w, sleeper));
}

float passFreely(const World *w, int slot, int sleeper, float separation) {
    return passedFreely(as_float(w->waking[slot].WAKING_SPEED), separation, ownInverseMass(w, sleeper), ownInverseMass(w, slot),
                        gainOfStep(w, sleeper), w->k.dt);
}

// One that sleeps is listed at its first.
void reach(const World *w, int sleeper, float passed, global int *list, local int *count) {
    if (!(passed > 0.0f)) return;
    int before = atomic_max((volatile global int *) (w->waking + sleeper), as_int(passed));
    if (before == 0) list[2 * atomic_inc(count)] = sleeper;
}

// What of the speed that woke a circle reaches one that sleeps.
void passOn(const World *w, int slot, int sleeper, global int *list, local int *count) {
    Meeting m = meetingOf(w, slot, sleeper);
    if (!(m.separation < MARGIN * m.radii) || !wouldMeet(w, slot, sleeper)) return;
    float impulse = actingOfMeeting(w, &m);
    reach(w, sleeper, impulse > 0.0f ? passImpulse(w, slot, sleeper, impulse) : passFreely(w, slot, sleeper, m.separation), list, count);
}

#ifdef JOINTS
void passOnByJoint(const World *w, const JointVisit *v, int slot, int sleeper, global int *list, local int *count) {
    float impulse = jointLoad(w, v);
    if (impulse > 0.0f) {
        reach(w, sleeper, passImpulse(w, slot, sleeper, impulse), list, count);
        return;
    }
    float2 n;
    float d = wayOfJoint(w, slot, sleeper, &n);
    if (holds(v, HOLD_RIGID)) reach(w, sleeper, passFreely(w, slot, sleeper, 0.0f), list, count);
    if (holds(v, HOLD_LOWER)) reach(w, sleeper, passFreely(w, slot, sleeper, d - v->ROW_MIN_LENGTH), list, count);
    if (holds(v, HOLD_UPPER)) reach(w, sleeper, passFreely(w, slot, sleeper, v->ROW_MAX_LENGTH - d), list, count);
}

// By a joint, if one of its circles woke in the ring before, and the other sleeps.
void passOnBetween(const World *w, int joint, int ring, global int *list, local int *count) {
    JointVisit v;
    if (!takeHeld(w, joint, &v) || v.HOLDS_B == NONE) return;
    int a = slotOfCircle(w, v.HOLDS_A);
    int b = slotOfCircle(w, v.HOLDS_B);
    if (w->waking[a].PRESSING == WOKEN_IN(ring - 1) && sleeps(w, b)) passOnByJoint(w, &v, a, b, list, count);
    if (w->waking[b].PRESSING == WOKEN_IN(ring - 1) && sleeps(w, a)) passOnByJoint(w, &v, b, a, list, count);
}
#endif

void passOnAround(const World *w, int slot, global int *list, local int *count) {
    float4 c = w->circle[slot];
    for (int l = 0; l < w->levels->usedCount; l++) {
        int level = w->levels->used[l];
        float reach = reachToWake(c.RADIUS, 0.0f, w->levels->top[level]);
        CellRange range = cellsAround(w, level, c.x - reach, c.x + reach, c.y - reach, c.y + reach);
        CellCursor at = firstCells(&range);
        int2 found;
        while (nextCells(w, &range, &at, false, &found)) {
            for (int other = found.x; other < found.y; other++) {
                if (sleeps(w, other)) passOn(w, slot, other, list, count);
            }
        }
    }
}

// Of those that a ring has reached. Returns whether it is awake, and fast.
bool wakeReached(const World *w, global int *listed, int ring) {
    int slot = *listed;
    float speed = as_float(w->waking[slot].WAKING_SPEED);
    if (speed > SLEEP_LEAST_HIT * w->circle[slot].RADIUS / w->k.dt) return wakeSlot(w, slot, ring);
    w->waking[slot].WAKING_SPEED = 0;
    *listed = NONE;
    return false;
}

#ifdef BODIES
// Circles that sleep and that bodies touch, which the host has: BODY_SLEEPER_WORDS of each, behind how many circles woke in the last ring.
#define RING_PARAMETERS , int firstRing, int endRing, global int *touched, int touchedCount
#define FIRST_RING firstRing
#define END_RING endRing

global int *rowOfSleeper(global int *touched, int k) { return touched + BODY_SLEEPERS + BODY_SLEEPER_WORDS * k; }

// What bodies do to them. Index space: these.
kernel void sleeping_pressByBodies(WORLD_PARAMETERS, global int *touched, int touchedCount) {
    World w = WORLD;
    int k = (int) get_global_id(0);
    if (k >= touchedCount || !haveSleepers(&w) || gridIsEmpty(&w)) return;
    global const int *row = rowOfSleeper(touched, k);
    global const int *halves = row + SLEEPER_SUMS;
    int slot = row[SLEEPER_SLOT];
    for (int e = 0; e < 4; e++) {
        ulong sum = (ulong) (uint) halves[2 * e] | (ulong) (uint) halves[2 * e + 1] << 32;
        addFixed((global long *) (w.heavySum + slot) + e, (long) sum);
    }
    wakeBy(&w, slot, as_float(row[SLEEPER_SPEED]));
}

void reachByBody(const World *w, global const int *row, global int *list, local int *count) {
    int slot = row[SLEEPER_SLOT];
    if (sleeps(w, slot)) reach(w, slot, as_float(row[SLEEPER_SPEED]), list, count);
}

void tellOfSleeper(const World *w, global int *row) {
    int2 waking = w->waking[row[SLEEPER_SLOT]];
    row[SLEEPER_WOKEN_BY] = waking.WAKING_SPEED;
    row[SLEEPER_PRESSING] = waking.PRESSING;
}
#else
#define RING_PARAMETERS
#define FIRST_RING 1
#define END_RING SLEEP_RINGS
#endif

// Ring by ring. Index space: one work-group. Cost: the circles around those that wake.
kernel __attribute__((reqd_work_group_size(SLEEPING_GROUP, 1, 1))) void sleeping_spread(WORLD_PARAMETERS RING_PARAMETERS) {
    World w = WORLD;
    local int count;
    local int fast;
    global int *lists = (global int *) w.woken;
    int item = (int) get_local_id(0);
    bool idle = !haveSleepers(&w) || gridIsEmpty(&w);
    int woken = idle ? 0 : status[WOKEN_COUNT];
    if (item == 0) fast = 0;
    // As often for all, with no way out: see TILE_EACH.
    for (int ring = FIRST_RING; ring < END_RING; ring++) {
        global int *from = lists + (~ring & 1);
        global int *to = lists + (ring & 1);
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
        if (item == 0) count = 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        for (int i = item; i < woken; i += SLEEPING_GROUP) {
            if (from[2 * i] != NONE) passOnAround(&w, from[2 * i], to, &count);
        }
#ifdef JOINTS
        for (int place = item; woken > 0 && place < w.joints->count; place += SLEEPING_GROUP) {
            passOnBetween(&w, jointAt(&w, place), ring, to, &count);
        }
#endif
        IF_BODIES(for (int i = item; i < touchedCount && !idle; i += SLEEPING_GROUP) reachByBody(&w, rowOfSleeper(touched, i), to, &count);)
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
        woken = count;
        for (int i = item; i < woken; i += SLEEPING_GROUP) {
            if (wakeReached(&w, to + 2 * i, ring)) fast = 1;
        }
    }
#ifdef BODIES
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    for (int i = item; i < touchedCount; i += SLEEPING_GROUP) tellOfSleeper(&w, rowOfSleeper(touched, i));
    if (item == 0) {
        touched[0] = woken;
        if (!idle) status[WOKEN_COUNT] = woken;
    }
#endif
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item != 0 || idle) return;
    if (fast) status[FAST] = 1;
#ifdef TERRAIN
    // Those that have been found were for the balance alone.
    if (status[PIECES_FOUND] > w.contactRoom) {
        status[OUT_OF_ROOM] = 1;
    } else {
        status[PIECES_FOUND] = 0;
    }
#endif
}

// ---- what those that rest keep

// The impulses of pairs of which none moves, as the one of lower id: no contact has them.
void keepImpulses(const World *w, int slot) {
    w->waking[slot] = (int2)(0);
    if (w->traits[slot].INVERSE_MASS != 0.0f) return;
    for (int k = w->firstCached[slot]; k >= 0;) {
        int4 entry = w->impulseCache[k];
        int other = partnerOf(w, entry);
        if (other != NONE && w->traits[other].INVERSE_MASS == 0.0f && (sleeps(w, slot) || sleeps(w, other))) {
            int place = atomic_inc(&w->status[KEPT_COUNT]);
            if (place < w->contactRoom) {
                w->kept[place] = (int4)(slot, entry.CACHED_HIGHER_ID, as_int(as_float(entry.CACHED_IMPULSE) * w->warmScale), 0);
                IF_TURNING(w->keptRows[place] = w->rowCache[k] * w->warmScale;)
            }
        }
        k = entry.CACHED_NEXT;
    }
}

// Index space: slots. Cost: the impulses of the circle.
kernel void sleeping_keep(WORLD_PARAMETERS) {
    World w = WORLD;
    int slot = (int) get_global_id(0);
    if (slot < circles && haveSleepers(&w) && !gridIsEmpty(&w)) keepImpulses(&w, slot);
}

// Behind those of the contacts of the step.
void restoreImpulse(const World *w, int k) {
    int4 entry = w->kept[k];
    int place = w->status[CONTACTS] + k;
    IF_TURNING(w->rowCache[place] = w->keptRows[k];)
    storeImpulse(w, place, w->homeFirstCached + entry.x, entry.y, as_float(entry.z));
}

// ---- who falls asleep

// Whether the next step, if nothing else is new, may find a circle in another state than this one has, which did not move it.
bool isRestless(const World *w, int slot) {
    float4 m = w->homeMotion[slot];
    bool moves = m.VX != 0.0f || m.VY != 0.0f;
    IF_TURNING(moves = moves || as_float(w->homeTurn[slot].ANGULAR_VELOCITY) != 0.0f;)
    return moves || (isAsleep(w->homeSleep[slot].REST) && w->homeSleep[slot].REST != SLEEP_ASLEEP);
}

void restCircle(const World *w, int slot) {
    float4 t = w->homeTraits[slot];
#ifdef JOINTS
    if (w->waking[slot].WAKING_SPEED == HELD_TORN) {
        float4 m = w->homeMotion[slot];
        t.INVERSE_MASS = inverseMass(w->homeCircle[slot].MASS);
        w->homeTraits[slot].INVERSE_MASS = t.INVERSE_MASS;
        float2 drift_ = t.INVERSE_MASS == 0.0f ? (float2)(0.0f) : (float2)(0.0f - m.DX, 0.0f - m.DY);
        w->homeSleep[slot] = (int4)(0, as_int(drift_.x), as_int(drift_.y), 0);
        w->status[RESTLESS] = 1;
        return;
    }
#endif
    if (t.INVERSE_MASS == 0.0f) {
        if (isRestless(w, slot)) w->status[RESTLESS] = 1;
        return;
    }
    w->status[RESTLESS] = 1;
    int id = w->homeId[slot];
    float4 c = w->homeCircle[slot];
    float4 m = w->homeMotion[slot];
    int4 s = w->homeSleep[slot];
    float2 g = gainOf(w, id, t.INVERSE_MASS);
    float gain_ = lengthf(g.x, g.y);
    global const float *kind = w->kindSleep + KIND_SLEEP_STRIDE * w->fields[id].kind;
    float damping = kind[KIND_SLEEP_DAMPING];
    IF_OWN_MOTION(damping = orOfKind(w->ownMotion[id].OWN_DAMPING, damping);)
    bool mayRest = (gain_ > 0.0f || damping > 0.0f) && kind[KIND_SLEEP_AWAKE] == 0.0f && w->waking[slot].WAKING_SPEED == 0;
#ifdef TURNING
    mayRest = mayRest && !(w->surfaces[SURFACE_OWN] != 0.0f && w->homeOwn[slot].OWN_TORQUE != 0.0f) &&
              !(fabs(as_float(w->homeTurn[slot].ANGULAR_VELOCITY)) * w->k.dt >= SLEEP_TURN_OF_STEP);
#endif
    float x = as_float(s.DRIFT_X);
    float y = as_float(s.DRIFT_Y);
    if (!mayRest || !rests(x, y, s.UNITS_TURNED, c.RADIUS, drift(c.RADIUS, gain_, w->k.inverseH, damping))) {
        w->homeSleep[slot] = (int4)(0, as_int(0.0f - m.DX), as_int(0.0f - m.DY), 0);
        return;
    }
    if (!fallsAsleep(s.REST + 1, w->k.dt) || !stays(c.x, m.DX) || !stays(c.y, m.DY)) {
        w->homeSleep[slot] = (int4)(s.REST + 1, as_int(x - m.DX), as_int(y - m.DY), s.UNITS_TURNED);
        return;
    }
    w->homeSleep[slot] = (int4)(SLEEP_ASLEEP, as_int(g.x * w->k.inverseH), as_int(g.y * w->k.inverseH), SLEEP_NO_OFFSET);
    w->homeMotion[slot].VELOCITY = (float2)(0.0f);
    w->homeTraits[slot].INVERSE_MASS = 0.0f;
    IF_TURNING(w->homeTurn[slot].ANGULAR_VELOCITY = 0;)
}

// Behind the step and what it reports. Index space: any; work-items take impulses and slots in turn.
kernel void sleeping_end(WORLD_PARAMETERS) {
    World w = WORLD;
    bool idle = refused(&w);
    int kept = idle ? 0 : status[KEPT_COUNT];
    int slotsToRest = idle ? 0 : circles;
    for (int k = (int) get_global_id(0); k < kept; k += (int) get_global_size(0)) restoreImpulse(&w, k);
    local int awake;
    if (get_local_id(0) == 0) awake = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    int own = 0;
    for (int slot = (int) get_global_id(0); slot < slotsToRest; slot += (int) get_global_size(0)) {
        restCircle(&w, slot);
        own += w.homeTraits[slot].INVERSE_MASS != 0.0f;
    }
    if (own > 0) atomic_add(&awake, own);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0 && awake > 0) atomic_add(&status[AWAKE], awake);
}
#endif
