// uses: world/shared/Contact.cl world/shared/TouchRule.cl world/stages/World.cl
// What a step tells the host of the pairs in touch, if events are reported.
//
// Most pairs of a pile press each other step after step, and nothing happens to them: they have no records. A contact that ends a step
// with an impulse, which the next one starts with, holds. If all that held are contacts again (TOUCHES_MET), a step records only pairs
// that do not hold, held not before, hit or hit before; and those that held and are not in touch any more. If one is missing, which
// circles that leave or jump do, or if the host asks for it, it records all pairs in touch (TOUCHES_ALL).

#ifdef RECORDING

// Begins the records of a step. A single work-item, before all others; kernels that begin a step need not have recording.
void startRecords(const World *w) {
    w->status[TOUCHES] = 0;
    w->status[TOUCHES_MET] = 0;
    w->status[TOUCHES_HELD + (w->status[STEPS_DONE] & 1)] = 0; // the parity of recording.step
}

// The place in hitBy of a circle, for hits of a step.
global int *hitOf(const World *w, int id, int step) { return w->recording.hitBy + 2 * id + (step & 1); }

// In place of a normal that is not known yet: zeros, the first of which is -0 if the contact held before the step, the second if its
// circle of lower id was in a hit then.
float2 noNormal(const World *w, float held, int lowerId) {
    if (!(held > 0.0f)) return (float2)(0.0f);
    int before = w->recording.step - 1;
    return (float2)(-0.0f, *hitOf(w, lowerId, before) == before ? -0.0f : 0.0f);
}

bool isKnown(float2 normal) { return normal.x != 0.0f || normal.y != 0.0f; }

bool heldBefore(float2 normal) { return !isKnown(normal) && as_int(normal.x) < 0; }

bool hitBefore(float2 normal) { return as_int(normal.y) < 0; }

// Whether the step records all pairs in touch.
bool recordsAll(const World *w) {
    int before = w->status[TOUCHES_HELD + (w->recording.step - 1 & 1)];
    return w->recording.all || w->status[TOUCHES_MET] != before;
}

// What a record says of a pair.
#define TOUCHING 1 // it touches even if it did not before
#define HOLDS 2    // the device will tell when it is not in touch any more
#define PARTED 4   // it is not in touch any more: no more is recorded

// Writes the record of a pair. other: the higher id, or the wall; vn: normal speed after the step; threshold: the square of the speed
// of a hit.
void writeRecord(const World *w, int id, int other, int says, float approach, float impulse, float vn, float threshold,
                 float2 normal, float2 point) {
    int k = atomic_inc(&w->status[TOUCHES]);
    if (k >= w->recording.room) return;
    global int4 *record = w->recording.records + 3 * k;
    record[0] = (int4)(id, other, says, as_int(approach));
    record[1] = (int4)(as_int(impulse), as_int(vn), as_int(threshold), as_int(normal.x));
    record[2] = (int4)(as_int(normal.y), as_int(point.x), as_int(point.y), 0);
}

// Records a pair of circles after a step, if it has to. all: see recordsAll; pr: slots; n: contact, but for its impulse, held;
// approach, impulse: of the step; normal, point: where it touched, if that is known; else it is where it touches now.
void recordPair(const World *w, bool all, uint2 pr, float4 n, float held, float radii, float approach, float impulse,
                float2 normal, float2 point) {
    bool before = heldBefore(normal);
    bool inTouch = staysInTouch(approach, n.z, radii);
    if (!inTouch && (all || !before)) return;
    float threshold = bounceThreshold(&w->k, radii, 0.0f, w->k.thresholdRate);
    float fastest = greatest(approach, 0.0f);
    bool hits = isHit(fastest, impulse, threshold, w->recording.hitSpeed);
    if (inTouch && !all && before && held > 0.0f && !hits && !hitBefore(normal)) return;
    int id = w->id[pr.x];
    int other = w->id[pr.y];
    if (!inTouch) {
        writeRecord(w, id, other, PARTED, 0.0f, 0.0f, 0.0f, 0.0f, (float2)(0.0f), (float2)(0.0f));
        return;
    }
    if (hits) *hitOf(w, id, w->recording.step) = w->recording.step;
    if (!isKnown(normal)) {
        float4 lower = w->homeCircle[pr.x];
        normal = n.xy;
        point = (float2)(touchPoint(lower.x, 0.0f, n.x, lower.z, n.z), touchPoint(lower.y, 0.0f, n.y, lower.z, n.z));
    }
    float4 mi = w->homeMotion[pr.x];
    float4 mj = w->homeMotion[pr.y];
    float vn = along(n.x, n.y, mj.z - mi.z, mj.w - mi.w);
    int says = (touches(approach, n.z) ? TOUCHING : 0) | (held > 0.0f ? HOLDS : 0);
    writeRecord(w, id, other, says, fastest, impulse, vn, threshold, normal, point);
}

// Ends the records of a step, once nothing more is to be known of the step before. A work-item or more, each for the contacts that it
// has looked at. held: how many of these hold.
void endRecords(const World *w, bool all, int held) {
    if (get_global_id(0) == 0) w->status[TOUCHES_ALL] = all;
    if (held > 0) atomic_add(&w->status[TOUCHES_HELD + (w->recording.step & 1)], held);
}
#endif
