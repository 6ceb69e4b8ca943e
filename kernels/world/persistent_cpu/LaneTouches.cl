// uses: world/shared/TouchRule.cl*4 world/stages/Touches.cl world/persistent_cpu/LaneCross.cl world/persistent_cpu/LaneMover.cl
// Records what wide contacts do in a step, as Touches.cl does for contacts, if events are reported.
//
// A row has eight float4: approach speed, impulse; approach speed of the sub-step, impulse of the sub-step that no contact keeps;
// where the contacts touched, which is noted only if they are fast: normal x, y, point x, y.

#ifdef RECORDING

global float4 *touchOf(const World *w, int wide) { return w->recording.touch + 8 * wide; }

// Begins a step for a wide contact, of which so many lanes are used. Returns how many of them held before.
INLINE int clearTouch(const World *w, int wide, const ulong *ids, int used) {
    global float4 *t = touchOf(w, wide);
    t[0] = (float4)(NO_TOUCH);
    t[1] = (float4)(0.0f);
    global const float *held = (global const float *) (stateOf(w, wide) + 3);
    global float *normal = (global float *) (t + 4);
    int met = 0;
    for (int l = 0; l < 4; l++) {
        float2 none = l < used ? noNormal(w, held[l], (int) (ids[l] >> 32)) : (float2)(0.0f);
        normal[l] = none.x;
        normal[4 + l] = none.y;
        met += heldBefore(none);
    }
    return met;
}

// Notes where lanes touch. Not inlined: hardly any contact is fast.
void placeTouch(const World *w, int wide, int4 lanes) {
    int fast[4] = {lanes.x, lanes.y, lanes.z, lanes.w};
    global float *place = (global float *) (touchOf(w, wide) + 4);
    global const float *contact = (global const float *) stateOf(w, wide);
    for (int l = 0; l < 4; l++) {
        if (!fast[l]) continue;
        uint lower = pairOf(w, wide)[isLightHigher(w, wide, l) ? 4 + l : l];
        float4 c = w->circle[lower];
        float4 m = w->motion[lower];
        float nx = contact[l], ny = contact[4 + l], separation = contact[8 + l];
        place[l] = nx;
        place[4 + l] = ny;
        place[8 + l] = touchPoint(c.x, m.x, nx, c.z, separation);
        place[12 + l] = touchPoint(c.y, m.y, ny, c.z, separation);
    }
}

// Notes the approach speeds of the sub-step, of lanes whose surfaces touch.
INLINE void noteTouches(const World *w, int wide, float4 approach, int4 touching) {
    global float4 *t = touchOf(w, wide);
    float4 before = t[0];
    int4 faster = touching && approach > before;
    t[0] = choose4(faster, approach, before);
    int4 fast = faster && isFastApproach4(approach, w->k.dt, baseOf(w, wide)[2]);
    if (someLane(fast)) placeTouch(w, wide, fast);
}

// Looks at a wide contact after its biased pass. before: normal speeds before any impulse.
INLINE void noteSolved(const World *w, int wide, float4 before, float4 separation, const Visited4 *visited) {
    global float4 *t = touchOf(w, wide);
    float4 approach = approachSpeed4(before);
    float4 notKept = choose4(visited->leaves || visited->solved, (float4)(0.0f), visited->impulse);
    t[2] = approach;
    t[3] = notKept;
    noteTouches(w, wide, approach, visited->normalImpulse + notKept > 0.0f || separation <= 0.0f);
}

// Looks at a wide contact after its relaxing pass. normalImpulse: before it; bounce: target speed.
INLINE void noteRelaxed(const World *w, int wide, float4 normalImpulse, float4 bounce, const Visited4 *visited) {
    global float4 *t = touchOf(w, wide);
    float4 zero = (float4)(0.0f);
    float4 bounced = choose4(bounce > 0.0f, normalImpulse + visited->impulse, zero);
    float4 notKept = choose4(visited->solved, bounced, choose4(visited->leaves, zero, visited->impulse));
    float4 impulse = (t[3] + notKept) + visited->normalImpulse;
    t[1] += impulse;
    noteTouches(w, wide, t[2], impulse > 0.0f);
}

// Records those contacts of the wide ones [from, end) that have to be. cross: whether these are cross contacts. Returns how many hold.
INLINE int recordWides(const World *shared, int from, int end, bool all, bool cross) {
    World own = *shared;
    const World *w = &own;
    int4 holding = (int4)(0);
    for (int wide = from; wide < end; wide++) {
        global const float4 *t = touchOf(w, wide);
        global const float4 *state = stateOf(w, wide);
        float4 zero = (float4)(0.0f), approach = t[0], radii = baseOf(w, wide)[2];
        int4 holds = state[3] > 0.0f;
        holding += holds;
        int4 used = shapeOf(w, wide)[0] > 0.0f;
        int4 inTouch = used && staysInTouch4(approach, state[2], radii);
        // What recordPair finds out of each lane, for all at once: hardly any has a record.
        int4 known = t[4] != 0.0f || t[5] != 0.0f;
        int4 before = !known && as_int4(t[4]) < 0;
        float4 threshold = bounceThreshold4(&w->k, radii, zero, w->k.thresholdRate);
        int4 hits = isHit4(greatest4(approach, zero), t[1], threshold, w->recording.hitSpeed) || as_int4(t[5]) < 0;
        int4 recorded = choose4(inTouch, hits || !(before && holds), before);
        if (all) recorded = inTouch;
        if (!someLane(recorded)) continue;
        int some[4] = {recorded.x, recorded.y, recorded.z, recorded.w};
        for (int l = 0; l < 4; l++) {
            if (!some[l]) continue;
            global const float *touch = (global const float *) t + l;
            global const float *n = (global const float *) state + l;
            bool exchanged = cross && isLightHigher(w, wide, l);
            uint2 pr = (uint2)(pairOf(w, wide)[exchanged ? 4 + l : l], pairOf(w, wide)[exchanged ? l : 4 + l]);
            recordPair(shared, all, pr, (float4)(n[0], n[4], n[8], 0.0f), n[12],
                       ((global const float *) (baseOf(w, wide) + 2))[l], touch[0], touch[4],
                       (float2)(touch[16], touch[20]), (float2)(touch[24], touch[28]));
        }
    }
    return -(holding.x + holding.y + holding.z + holding.w);
}

// The same for a row of groups.
int recordRow(const World *w, int row, bool all) {
    return recordWides(w, w->groupStart[2 * row], w->groupStart[2 * row + 1], all, false);
}

// Begins a step for the walls of a circle.
void clearWallTouch(const World *w, int slot) {
    if (!w->recording.walls) return;
    w->recording.wallTouch[2 * slot] = (float4)(NO_TOUCH, 0.0f, 0.0f, 0.0f);
    w->recording.wallTouch[2 * slot + 1] = (float4)(NO_TOUCH, 0.0f, 0.0f, 0.0f);
}
#endif
