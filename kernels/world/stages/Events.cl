// uses: world/shared/Contact.cl world/shared/Piece.cl world/shared/Sleep.cl world/shared/TouchRule.cl world/stages/World.cl
// Decides what a step reports: which pairs begin to touch, hit each other, and end to touch, in the order of a step's events. The Java class
// TouchTracker does the same. The phases, each behind all of the one before:
//
// 1. startEvents, by one work-item. 2. tell, for each pair that may be in touch. 3. tellOfEnds, for each place of the table.
// 4. eventStart: prefix sums of eventTally. 5. settleEvents; or the step waits for the host to make room. 6. writeEvent and writeHeader.
//
// touching: a hash table of pairs, with linear probing: ids (the higher may be a wall or a piece of terrain), the last step in which the pair touched, its hit that
// is not complete. A place whose last step is over is free. newcomers: pairs that begin, as in the table. openHits: by hit and parity of the
// step, an event's values. drafts: events in no order, three int4 each (EventRow), with the number among those of the lower id. decided: a
// header of three int4, then events in order. eventTally, eventStart: by id.
//
// A step that lacks room is decided again: until phase 5 nothing changes that a second try would not change in the same way.

#ifdef REPORTING
#define NEVER_USED (-1) // step of a place that no pair has had
#define NO_STEP 0       // step of a pair that is gone
#define MANY_OF_ONE 64  // events of one circle of lower id, beyond which the host sorts

// Of a batch of steps.
#define HEADER_EVENTS 0
#define HEADER_STEP 1
#define HEADER_UNORDERED 2

#define REPORTED_BY_KIND 0 // whether types go by kinds
#define REPORTED_TYPES 1   // else of all pairs
#define REPORTED_WALLS 2   // and of all walls
#define REPORTED_AXES 3    // a bit for each axis with walls
#define REPORTED_TABLE 4   // types of pairs of kinds, then of kinds and walls, four to an int

#define BEGINS 1
#define HITS 2
#define GOES_ON 4 // with the hit of the step before

typedef struct {
    int lower, higher, types, place, flags;
} Told;

int reportedAt(const World *w, int n) { return (w->reporting.reported[REPORTED_TABLE + (n >> 2)] >> 8 * (n & 3)) & 255; }

int typesOf(const World *w, int lower, int higher) {
    global const int *reported = w->reporting.reported;
#ifdef TERRAIN
    if (higher >= FIRST_PIECE) {
        if (!reported[REPORTED_BY_KIND]) return reported[REPORTED_TYPES];
        return reportedAt(w, 256 * w->fields[lower].kind + pieceTraits(w, higher - FIRST_PIECE).TRAIT_KIND);
    }
#endif
    int wall = higher - FIRST_WALL;
    if (wall >= 0 && !(reported[REPORTED_AXES] >> (wall >> 1) & 1)) return 0;
    if (!reported[REPORTED_BY_KIND]) return reported[wall >= 0 ? REPORTED_WALLS : REPORTED_TYPES];
    int kind = w->fields[lower].kind;
    return reportedAt(w, wall >= 0 ? 256 * 256 + kind : 256 * kind + w->fields[higher].kind);
}

// Of a pair that touched in the step before, or that this one has told of; or NONE.
int findTouching(const World *w, int lower, int higher) {
    const Reporting *r = &w->reporting;
    for (int place = pairHash(lower, higher) & r->mask;; place = (place + 1) & r->mask) {
        // The ids alone: others tell of their pairs at the same time, and write the rest of these.
        int2 ids = *(global const int2 *) (r->touching + place);
        if (ids.x == NONE) return NONE; // never used
        if (ids.x == lower && ids.y == higher && r->touching[place].z >= r->step - 1) return place;
    }
}

// A hit that is not complete: its number, and two bits of its step.
int openOf(int hit, int step) { return hit << 2 | (step & 3); }
bool isOpen(int open, int step) { return open != NONE && (open & 3) == (step & 3); }
global float4 *openHit(const World *w, int hit, int step) { return w->reporting.openHits + 2 * (2 * hit + (step & 1)); }

// Whether a pair has something to tell that is in touch, or near enough to stay so. touches: even if it did not before; threshold: square of
// the speed of a hit.
bool concerns(const World *w, int lower, int higher, bool touches, float approach, float impulse, float threshold, Told *told) {
    const Reporting *r = &w->reporting;
    told->types = typesOf(w, lower, higher);
    if (told->types == 0) return false; // if it touched, it ends, and nobody is told
    told->lower = lower;
    told->higher = higher;
    told->place = findTouching(w, lower, higher);
    told->flags = isHit(approach, impulse, threshold, r->hitSpeed) ? HITS : 0;
    if (told->place == NONE) {
        told->flags |= BEGINS;
        return touches;
    }
    r->touching[told->place].z = r->step;
    int open = r->touching[told->place].w;
    if (isOpen(open, r->step - 1)) {
        told->flags |= GOES_ON;
    } else if (open != NONE && !isOpen(open, r->step)) {
        r->touching[told->place].w = NONE; // before two bits of another step are the same
    }
    return told->flags != 0;
}

// rank: of EventRow.
void draft(const World *w, int lower, int higher, int types, int type, int rank, float4 values, float2 point, float slid) {
    const Reporting *r = &w->reporting;
    if (!(types & type)) return;
    int k = atomic_inc(&w->status[DRAFTS]);
    if (k >= r->room) return;
    global int4 *event = r->drafts + 3 * k;
    event[0] = (int4)(lower, higher, rank, r->step);
    event[1] = as_int4(values);
    event[2] = (int4)(as_int(point.x), as_int(point.y), as_int(slid), atomic_inc(&r->eventTally[lower]));
    r->eventOrder[k] = 0; // for those who find the place otherwise
}

// vn: normal speed after the step; slid: how fast the surfaces did.
void tell(const World *w, const Told *told, float approach, float impulse, float vn, float2 normal, float2 point, float slid) {
    const Reporting *r = &w->reporting;
    float4 values = (float4)(approach, impulse > 0.0f ? impulse : 0.0f, normal.x, normal.y);
    int open = NONE;
    if (told->flags & BEGINS) draft(w, told->lower, told->higher, told->types, TYPE_BEGIN, RANK_BEGIN, values, point, slid);
    if (told->flags & GOES_ON) {
        global const float4 *before = openHit(w, r->touching[told->place].w >> 2, r->step - 1);
        float sum = before[0].y + values.y;
        if (!(approach > before[0].x)) {
            values = before[0];
            point = before[1].xy;
            slid = before[1].z;
        }
        values.y = sum;
        draft(w, told->lower, told->higher, told->types, TYPE_HIT, RANK_HIT, values, point, slid);
    } else if ((told->flags & HITS) && isIncomplete(vn, approach)) {
        int hit = atomic_inc(&w->status[OPEN_HITS]);
        if (hit < r->openRoom) {
            openHit(w, hit, r->step)[0] = values;
            openHit(w, hit, r->step)[1] = (float4)(point.x, point.y, slid, 0.0f);
            open = openOf(hit, r->step);
        }
    } else if (told->flags & HITS) {
        draft(w, told->lower, told->higher, told->types, TYPE_HIT, RANK_HIT, values, point, slid);
    }
    if (told->flags & BEGINS) {
        int k = atomic_inc(&w->status[NEWCOMERS]);
        if (k < r->room) r->newcomers[k] = (int4)(told->lower, told->higher, r->step, open);
    } else if (open != NONE) {
        r->touching[told->place].w = open;
    }
}

// Not whether it was refused: a plan may take fast circles unasked.
bool isMade(const World *w) { return w->status[STEPS_DONE] == w->reporting.step - 1 && !w->status[EVENTS_LACK]; }

void startEvents(const World *w) {
    const Reporting *r = &w->reporting;
    global int *header = (global int *) r->decided;
    if (r->starting) {
        header[HEADER_EVENTS] = 0;
        header[HEADER_UNORDERED] = 0;
    }
    w->status[EVENTS_BEFORE] = header[HEADER_EVENTS];
    w->status[PLACES_BEFORE] = w->status[PLACES_USED];
    w->status[DRAFTS] = 0;
    w->status[NEWCOMERS] = 0;
    w->status[LEAVERS] = 0;
    w->status[OPEN_HITS] = 0;
}

#ifdef SLEEPING
// Whether none of a pair moves, and one sleeps: no contact tells of it, and it goes on to touch.
bool isAtRest(const World *w, int lower, int higher) {
    int slot = w->slotOf[lower];
    if (slot < 0) return false;
    bool sleeps_ = isAsleep(w->homeSleep[slot].REST);
    if (higher >= FIRST_WALL) return sleeps_;
    int other = w->slotOf[higher];
    if (other < 0) return false;
    bool still = w->homeTraits[slot].INVERSE_MASS == 0.0f && w->homeTraits[other].INVERSE_MASS == 0.0f;
    return still && (sleeps_ || isAsleep(w->homeSleep[other].REST));
}

// A pair at rest whose hit is not complete gets another place: a second try must find what this one has.
void goOnWithHit(const World *w, int4 pair) {
    const Reporting *r = &w->reporting;
    int open = NONE;
    int hit_ = atomic_inc(&w->status[OPEN_HITS]);
    if (hit_ < r->openRoom) {
        global const float4 *before = openHit(w, pair.w >> 2, r->step - 1);
        openHit(w, hit_, r->step)[0] = before[0];
        openHit(w, hit_, r->step)[1] = before[1];
        open = openOf(hit_, r->step);
    }
    int k = atomic_inc(&w->status[NEWCOMERS]);
    if (k < r->room) r->newcomers[k] = (int4)(pair.x, pair.y, r->step, open);
}
#endif

void tellOfEnds(const World *w, int place) {
    const Reporting *r = &w->reporting;
    int4 pair = r->touching[place];
    if (pair.z != r->step - 1) return;
    int types = typesOf(w, pair.x, pair.y);
#ifdef SLEEPING
    if (types != 0 && isAtRest(w, pair.x, pair.y)) {
        if (isOpen(pair.w, r->step - 1)) {
            atomic_inc(&w->status[LEAVERS]);
            goOnWithHit(w, pair);
        } else {
            r->touching[place].z = r->step;
            r->touching[place].w = NONE;
        }
        return;
    }
#endif
    atomic_inc(&w->status[LEAVERS]);
    if (isOpen(pair.w, r->step - 1)) {
        global const float4 *hit = openHit(w, pair.w >> 2, r->step - 1);
        draft(w, pair.x, pair.y, types, TYPE_HIT, RANK_HIT, hit[0], hit[1].xy, hit[1].z);
    }
    draft(w, pair.x, pair.y, types, TYPE_END, RANK_END, (float4)(0.0f), (float2)(0.0f), 0.0f);
}

// The same for all work-items.
bool lacksEventRoom(const World *w) {
    const Reporting *r = &w->reporting;
    int drafts = w->status[DRAFTS];
    int newcomers = w->status[NEWCOMERS];
    return drafts > r->room - w->status[EVENTS_BEFORE] || newcomers > r->room || w->status[OPEN_HITS] > r->openRoom ||
           newcomers > r->mask - (r->mask >> 2) - w->status[PLACES_BEFORE];
}

// Refuses all steps behind this one, until the host has made room.
void noteLackOfEventRoom(const World *w) {
    w->status[EVENTS_LACK] = 1;
    w->status[OUT_OF_ROOM] = 1;
}

// No two work-items add the same pair.
void addTouching(const World *w, int4 pair) {
    const Reporting *r = &w->reporting;
    for (int place = pairHash(pair.x, pair.y) & r->mask;; place = (place + 1) & r->mask) {
        volatile global int *step = (volatile global int *) (r->touching + place) + 2;
        int last = atomic_cmpxchg(step, NEVER_USED, pair.z);
        if (last == pair.z || (last != NEVER_USED && atomic_cmpxchg(step, last, pair.z) != last)) continue;
        if (last == NEVER_USED) atomic_inc(&w->status[PLACES_USED]);
        global int *words = (global int *) (r->touching + place);
        words[0] = pair.x;
        words[1] = pair.y;
        words[3] = pair.w;
        return;
    }
}

void settleEvents(const World *w, int first, int each) {
    const Reporting *r = &w->reporting;
    int drafts = w->status[DRAFTS];
    int newcomers = w->status[NEWCOMERS];
    for (int k = first; k < drafts; k += each) {
        global const int4 *event = r->drafts + 3 * k;
        r->eventOrder[r->eventStart[event[0].x] + event[2].w] = k;
    }
    for (int k = first; k < newcomers; k += each) addTouching(w, r->newcomers[k]);
}

bool comesBefore(int4 event, int4 other) {
    return event.x < other.x || (event.x == other.x && (event.y < other.y || (event.y == other.y && event.z < other.z)));
}

void writeEventAt(const World *w, int k, int place) {
    const Reporting *r = &w->reporting;
    global int4 *row = r->decided + 3 * (1 + w->status[EVENTS_BEFORE] + place);
    for (int i = 0; i < 3; i++) row[i] = r->drafts[3 * k + i];
}

void writeEvent(const World *w, int k) {
    const Reporting *r = &w->reporting;
    global const int4 *event = r->drafts + 3 * k;
    int4 own = event[0];
    int from = r->eventStart[own.x];
    int to = r->eventStart[own.x + 1];
    int place = from;
    if (to - from > MANY_OF_ONE) {
        place += event[2].w;
        ((global int *) r->decided)[HEADER_UNORDERED] = 1;
    } else {
        for (int i = from; i < to; i++) {
            place += comesBefore(r->drafts[3 * r->eventOrder[i]], own);
        }
    }
    writeEventAt(w, k, place);
}

void writeHeader(const World *w) {
    const Reporting *r = &w->reporting;
    global int *header = (global int *) r->decided;
    header[HEADER_EVENTS] = w->status[EVENTS_BEFORE] + w->status[DRAFTS];
    header[HEADER_STEP] = r->step;
    w->status[TOUCHING] += w->status[NEWCOMERS] - w->status[LEAVERS];
}

// An argument costs the host a part of a microsecond.
#define EVENT_PARAMETERS global int *status, global CircleFields *fields REPORTING_PARAMETERS
#define EVENTS_IN(w)                                                                                                   \
    World w;                                                                                                           \
    w.status = status;                                                                                                 \
    w.fields = fields;                                                                                                 \
    REPORT_IN(w);

// Index space of each: any number of work-items, which take what there is in turn.

kernel void events_begin(EVENT_PARAMETERS) {
    EVENTS_IN(w)
    bool comes = status[STEPS_DONE] >= w.reporting.step - 2 && !status[EVENTS_LACK];
    if (get_global_id(0) == 0 && comes) startEvents(&w);
}

#ifdef TERRAIN
#define KINDS_OF_PIECES , global int *kindMotion
#else
#define KINDS_OF_PIECES
#endif

#ifdef SLEEPING
#define WHO_SLEEPS , global int *slotOf, global float4 *homeTraits, global int4 *homeSleep
#else
#define WHO_SLEEPS
#endif

kernel void events_end(EVENT_PARAMETERS KINDS_OF_PIECES WHO_SLEEPS) {
    EVENTS_IN(w)
    IF_TERRAIN(w.terrain = kindMotion + TERRAIN_AT;)
#ifdef SLEEPING
    w.slotOf = slotOf;
    w.homeTraits = homeTraits;
    w.homeSleep = homeSleep;
#endif
    if (!isMade(&w)) return;
    for (int place = (int) get_global_id(0); place <= w.reporting.mask; place += (int) get_global_size(0)) {
        tellOfEnds(&w, place);
    }
}

kernel void events_settle(EVENT_PARAMETERS) {
    EVENTS_IN(w)
    if (status[STEPS_DONE] != w.reporting.step - 1) return;
    bool lacks = lacksEventRoom(&w);
    if (!lacks && !status[EVENTS_LACK]) settleEvents(&w, (int) get_global_id(0), (int) get_global_size(0));
    if (lacks && get_global_id(0) == 0) noteLackOfEventRoom(&w);
}

kernel void events_write(EVENT_PARAMETERS) {
    EVENTS_IN(w)
    if (!isMade(&w)) return;
    int count = status[DRAFTS];
    for (int k = (int) get_global_id(0); k < count; k += (int) get_global_size(0)) writeEvent(&w, k);
    if (get_global_id(0) == 0) writeHeader(&w);
}

kernel void events_clear(global int4 *touching, int mask) {
    for (int place = (int) get_global_id(0); place <= mask; place += (int) get_global_size(0)) {
        touching[place] = (int4)(NONE, NONE, NEVER_USED, NONE);
    }
}

kernel void events_add(EVENT_PARAMETERS, int count) {
    EVENTS_IN(w)
    for (int k = (int) get_global_id(0); k < count; k += (int) get_global_size(0)) addTouching(&w, w.reporting.newcomers[k]);
}

// The pairs of another table, which touched in the step before.
kernel void events_move(EVENT_PARAMETERS, global const int4 *from, int fromMask) {
    EVENTS_IN(w)
    for (int place = (int) get_global_id(0); place <= fromMask; place += (int) get_global_size(0)) {
        int4 pair = from[place];
        if (pair.z < w.reporting.step - 1) continue;
        pair.z = w.reporting.step - 1;
        if (!isOpen(pair.w, w.reporting.step - 1)) pair.w = NONE;
        addTouching(&w, pair);
    }
}

// In eventTally, which is all zeros between steps.
kernel void events_mark(global const int *ids, int count, global int *eventTally, int mark, global int *status) {
    int k = (int) get_global_id(0);
    if (k == 0 && mark) status[PAIRS_MARKED] = 0;
    if (k < count) eventTally[ids[k]] = mark;
}

// Lists pairs as newcomers, or forgets them.
kernel void events_ofMarked(EVENT_PARAMETERS, int forgets) {
    EVENTS_IN(w)
    const Reporting *r = &w.reporting;
    for (int place = (int) get_global_id(0); place <= r->mask; place += (int) get_global_size(0)) {
        int4 pair = r->touching[place];
        if (pair.z < r->step) continue;
        if (!r->eventTally[pair.x] && (pair.y >= FIRST_WALL || !r->eventTally[pair.y])) continue;
        int k = atomic_inc(&status[PAIRS_MARKED]);
        if (forgets) {
            r->touching[place].z = NO_STEP;
            atomic_dec(&status[TOUCHING]);
        } else if (k < r->room) {
            r->newcomers[k] = pair;
        }
    }
}
#endif
