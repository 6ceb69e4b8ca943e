// uses: world/shared/CrossRule.cl world/shared/PairRows.cl world/shared/Sleep.cl world/shared/Visit.cl world/shared/Wall.cl
// uses: world/stages/CellScan.cl world/stages/Grid.cl world/stages/PairFilter.cl world/stages/Pieces.cl world/stages/Joints.cl
// Which circles wake as a step begins, and which fall asleep behind it. The Java class world.jvm.Sleeping does the same.
//
// Who sleeps has the inverse mass 0, in traits and in sight: other stages need not know. Waking works on working slots, so a step that is
// refused has woken nobody. All sums are whole numbers, and all else is a maximum.
//
// heavySum: of one that sleeps, sums of impulses x, y, and of normal ones.

#ifdef SLEEPING
bool sleeps(const World *w, int slot) { return isAsleep(w->sleep[slot].REST); }
float ownInverseMass(const World *w, int slot) { return inverseMass(w->circle[slot].MASS); }

// What gravity and a force add to a circle's speed in a sub-step, if nothing holds it.
float ownGain(const World *w, int slot) {
    float2 g = gainOf(w, w->id[slot], ownInverseMass(w, slot));
    return lengthf(g.x, g.y);
}

float gainOfStep(const World *w, int slot) { return ownGain(w, slot) * (float) w->k.subSteps; }

int responseAt(const World *w, int slot, int other) {
    return w->k.filtering == 0 ? PAIR_SOLID : responseOf(w, w->id[slot], w->id[other]);
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

// As this step goes on from the one before.
float impulseOfMeeting(const World *w, const Meeting *m) {
    return warmStartImpulse(w, (uint) m->lower, (uint) m->higher, (ulong) (uint) w->id[m->higher]);
}

void wakeBy(const World *w, int slot, float speed) {
    if (speed > 0.0f) atomic_max((volatile global int *) (w->waking + slot), as_int(speed));
}

void wakeForSure(const World *w, int slot) {
    wakeBy(w, slot, strong(gainOfStep(w, slot), w->circle[slot].RADIUS, w->k.dt));
}

// ---- what presses those that sleep

void press(const World *w, int slot, const Meeting *m, float j, float f) {
    if (!sleeps(w, slot)) return;
    float4 c = w->circle[slot];
    float scale = scaleOf(impulseRange(c.RADIUS, w->k.inverseH, inverseMass(c.MASS)));
    float side = slot == m->lower ? -1.0f : 1.0f;
    global long *sums = (global long *) (w->heavySum + slot);
    addFixed(sums, toFixed(side * (m->nx * j - m->ny * f), scale));
    addFixed(sums + 1, toFixed(side * (m->ny * j + m->nx * f), scale));
    addFixed(sums + 2, toFixed(j, scale));
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
            if (still || (responseAt(w, slot, other) == PAIR_SOLID && areNear(w, slot, other))) {
                Meeting m = meetingOf(w, slot, other);
                float j = as_float(entry.CACHED_IMPULSE) * w->warmScale;
                float f = 0.0f;
#ifdef TURNING
                f = w->rowCache[k].FRICTION_IMPULSE * w->warmScale;
#endif
                press(w, slot, &m, j, f);
                press(w, other, &m, j, f);
            }
        }
        k = entry.CACHED_NEXT;
    }
}

// ---- who is about to push them

void hitSleeper(const World *w, int slot, int sleeper) {
    if (!areNear(w, slot, sleeper) || responseAt(w, slot, sleeper) != PAIR_SOLID) return;
    Meeting m = meetingOf(w, slot, sleeper);
    float2 v = w->motion[slot].VELOCITY;
    float along = dotf(m.nx, m.ny, v.x, v.y);
    float approach = slot == m.lower ? along : -along;
    if (!(approach > 0.0f)) return; // before all that is to be read
    float4 c = w->circle[sleeper];
    float restitution = maxf(w->traits[sleeper].RESTITUTION, w->traits[slot].RESTITUTION);
    wakeBy(w, sleeper, hit(approach, m.separation, inverseMass(c.MASS), ownInverseMass(w, slot), restitution,
                           impulseOfMeeting(w, &m), gainOfStep(w, sleeper), c.RADIUS, w->k.dt));
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
// A circle of a joint that has not broken: wakes as the step begins, and does not fall asleep behind it.
void holdCircle(const World *w, int id, bool begins) {
    if (id == NONE) return;
    if (!begins) {
        w->waking[w->slotOf[id]].WAKING_SPEED = 1;
        return;
    }
    int slot = slotOfCircle(w, id);
    if (sleeps(w, slot)) wakeForSure(w, slot);
}

// Index space: places in the order of joints. begins: see holdCircle.
kernel void sleeping_hold(WORLD_PARAMETERS, int begins) {
    World w = WORLD;
    int place = (int) get_global_id(0);
    if (place >= w.joints->count || (begins ? !haveSleepers(&w) || gridIsEmpty(&w) : refused(&w))) return;
    int joint = jointAt(&w, place);
    JointVisit v;
    takeTraits(&w, joint, &v);
    if (*jointSerial(&w, joint) == ~v.HOLD_SERIAL) return;
    holdCircle(&w, v.HOLDS_A, begins != 0);
    holdCircle(&w, v.HOLDS_B, begins != 0);
}
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
    long x, y, load;
} Pressed;

// j, f: impulses along an outward normal and along the tangent.
void addPressed(Pressed *p, float scale, float nx, float ny, float j, float f) {
    p->x += toFixed(nx * j - ny * f, scale);
    p->y += toFixed(ny * j + nx * f, scale);
    p->load += toFixed(j, scale);
}

// own: inverse mass.
void pressByWalls(const World *w, int slot, float own, float scale, Pressed *p) {
    float wall[2] = {w->traits[slot].WALL_X, w->traits[slot].WALL_Y};
    float along[2] = {0.0f, 0.0f};
#ifdef TURNING
    WallRows rows = w->wallRows[slot];
    RowImpulses ofX = rows.even;
    RowImpulses ofY = rows.odd;
    along[0] = wall[0] > 0.0f ? ofX.FRICTION_IMPULSE : -ofX.FRICTION_IMPULSE;
    along[1] = wall[1] > 0.0f ? -ofY.FRICTION_IMPULSE : ofY.FRICTION_IMPULSE;
#endif
    p->x += toFixed(wall[0] / own, scale);
    p->y += toFixed(wall[0] == 0.0f ? 0.0f : along[0] / own, scale);
    p->y += toFixed(wall[1] / own, scale);
    p->x += toFixed(wall[1] == 0.0f ? 0.0f : along[1] / own, scale);
    p->load += toFixed(fabs(wall[0]) / own, scale);
    p->load += toFixed(fabs(wall[1]) / own, scale);
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
        float2 push = w->push[k];
        if (!isConstraint(w->piece[k]) || !(push.PUSH_NORMAL > 0.0f)) continue;
        float4 g = w->measured[k];
        addPressed(p, scale, g.MEASURED_X, g.MEASURED_Y, push.PUSH_NORMAL / own, w->pieceRows[k].FRICTION_IMPULSE / own);
    }
    return moves;
}
#endif

// Is awake from now on, also to what describes it. Returns whether it is fast.
bool wakeSlot(const World *w, int slot) {
    float4 c = w->circle[slot];
    float4 m = w->motion[slot];
    float own = inverseMass(c.MASS);
    w->sleep[slot] = (int4)(0, as_int(0.0f - m.DX), as_int(0.0f - m.DY), 0);
    w->traits[slot].INVERSE_MASS = own;
#ifdef TURNING
    w->inverseInertia[slot] = own * w->surfaces[SURFACE_STRIDE * w->fields[w->id[slot]].kind + SURFACE_INERTIA];
#endif
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
    Pressed p = {sums.x, sums.y, sums.z};
    pressByWalls(w, slot, own, scale, &p);
    bool moved = wallsMoveNear(w, 0, c.x, c.RADIUS, w->k.minX, w->k.maxX) || wallsMoveNear(w, 1, c.y, c.RADIUS, w->k.minY, w->k.maxY);
#ifdef TURNING
    moved = moved || (w->surfaces[SURFACE_OWN] != 0.0f && w->own[slot].OWN_TORQUE != 0.0f);
#endif
#ifdef TERRAIN
    if (pressByPieces(w, slot, own, scale, &p)) moved = true;
#endif
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
        if (wakeSlot(&w, slot)) fast = 1;
        w.woken[atomic_inc(&status[WOKEN_COUNT])].x = slot;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0 && fast) status[FAST] = 1;
}

// ---- how far that wakes others

// What of the speed that woke a circle reaches one that sleeps, which is listed at its first.
void passOn(const World *w, int slot, int sleeper, global int *list, local int *count) {
    Meeting m = meetingOf(w, slot, sleeper);
    if (!(m.separation < MARGIN * m.radii) || responseAt(w, slot, sleeper) != PAIR_SOLID) return;
    float speed = as_float(w->waking[slot].WAKING_SPEED);
    float own = ownInverseMass(w, sleeper);
    float other = ownInverseMass(w, slot);
    float impulse = impulseOfMeeting(w, &m);
    float gain_ = gainOfStep(w, sleeper);
    float passed = impulse > 0.0f ? passedOn(speed, impulse, as_float(w->waking[sleeper].PRESSING), own, other, gain_)
                                  : passedFreely(speed, m.separation, own, other, gain_, w->k.dt);
    if (!(passed > 0.0f)) return;
    int before = atomic_max((volatile global int *) (w->waking + sleeper), as_int(passed));
    if (before == 0) list[2 * atomic_inc(count)] = sleeper;
}

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
bool wakeReached(const World *w, global int *listed) {
    int slot = *listed;
    float speed = as_float(w->waking[slot].WAKING_SPEED);
    if (speed > SLEEP_LEAST_HIT * w->circle[slot].RADIUS / w->k.dt) return wakeSlot(w, slot);
    w->waking[slot].WAKING_SPEED = 0;
    *listed = NONE;
    return false;
}

// Ring by ring. Index space: one work-group. Cost: the circles around those that wake.
kernel __attribute__((reqd_work_group_size(SLEEPING_GROUP, 1, 1))) void sleeping_spread(WORLD_PARAMETERS) {
    World w = WORLD;
    local int count;
    local int fast;
    global int *lists = (global int *) w.woken;
    int item = (int) get_local_id(0);
    bool idle = !haveSleepers(&w) || gridIsEmpty(&w);
    int woken = idle ? 0 : status[WOKEN_COUNT];
    if (item == 0) fast = 0;
    // As often for all, with no way out: see TILE_EACH.
    for (int ring = 1; ring < SLEEP_RINGS; ring++) {
        global int *from = lists + (~ring & 1);
        global int *to = lists + (ring & 1);
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
        if (item == 0) count = 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        for (int i = item; i < woken; i += SLEEPING_GROUP) {
            if (from[2 * i] != NONE) passOnAround(&w, from[2 * i], to, &count);
        }
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
        woken = count;
        for (int i = item; i < woken; i += SLEEPING_GROUP) {
            if (wakeReached(&w, to + 2 * i)) fast = 1;
        }
    }
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
#ifdef TURNING
                w->keptRows[place] = w->rowCache[k] * w->warmScale;
#endif
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
#ifdef TURNING
    w->rowCache[place] = w->keptRows[k];
#endif
    storeImpulse(w, place, w->homeFirstCached + entry.x, entry.y, as_float(entry.z));
}

// ---- who falls asleep

// Whether the next step, if nothing else is new, may find a circle in another state than this one has, which did not move it.
bool isRestless(const World *w, int slot) {
    float4 m = w->homeMotion[slot];
    bool moves = m.VX != 0.0f || m.VY != 0.0f;
#ifdef TURNING
    moves = moves || as_float(w->homeTurn[slot].ANGULAR_VELOCITY) != 0.0f;
#endif
    return moves || (isAsleep(w->homeSleep[slot].REST) && w->homeSleep[slot].REST != SLEEP_ASLEEP);
}

void restCircle(const World *w, int slot) {
    float4 t = w->homeTraits[slot];
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
#ifdef OWN_MOTION
    damping = orOfKind(w->ownMotion[id].OWN_DAMPING, damping);
#endif
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
#ifdef TURNING
    w->homeTurn[slot].ANGULAR_VELOCITY = 0;
#endif
}

// Behind the step and what it reports. Index space: any; work-items take impulses and slots in turn.
kernel void sleeping_end(WORLD_PARAMETERS) {
    World w = WORLD;
    if (refused(&w)) return;
    int kept = status[KEPT_COUNT];
    for (int k = (int) get_global_id(0); k < kept; k += (int) get_global_size(0)) restoreImpulse(&w, k);
    for (int slot = (int) get_global_id(0); slot < circles; slot += (int) get_global_size(0)) restCircle(&w, slot);
}
#endif
