// Stage Solver for tiles: the passes of Solver.cl, tile by tile. A sub-step has two launches. Push reads drive, burden and held
// and writes pushedVelocity, pushedDisplacement and impulse; it ends with the move and the walls. Relax measures the contacts
// anew, goes back to held, and begins the next sub-step.

// A tile in local memory, by the numbers of its record. It is as small as can be: a work-group mostly waits, for a contact to
// follow another, so that speed is how many of them a device has room for.
typedef struct {
    float2 velocity[TILE_CIRCLES];
    float2 load[TILE_CIRCLES]; // in the biased pass the velocity before any impulse, in the relaxing pass sums of impulses
    float burden[TILE_CIRCLES]; // inverse mass, negative where loaded
    uchar carried[TILE_CIRCLES]; // in the relaxing pass: 1 where a contact carries
    int partStart[TILE_PARTS + 2]; // by part of a round
    int circles, parts;
} Tile;

// Takes a tile from its record. idle: as one without circles.
void takeTile(const World *w, local Tile *t, int tile, bool idle) {
    global int *record = recordOf(w, tile);
    int circles = idle ? 0 : record[RECORD_CIRCLES];
    int parts = circles > 0 ? record[RECORD_PARTS] : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) {
        t->circles = circles;
        t->parts = parts;
    }
    TILE_EACH(part, parts + 1) t->partStart[part] = circles > 0 ? record[RECORD_STARTS + part] : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
}

void applyTo(local Tile *t, int2 p, float2 vi, float2 vj, float nx, float ny, float wi, float wj, float impulse) {
    vi.x -= nx * (wi * impulse);
    vi.y -= ny * (wi * impulse);
    vj.x += nx * (wj * impulse);
    vj.y += ny * (wj * impulse);
    t->velocity[p.x] = vi;
    t->velocity[p.y] = vj;
}

// The biased pass over one contact; returns its new impulse and the target speed of its bounce. The same as pushImpulse of
// Solver.cl, to the bit, without its branches: they would be most of the time.
float2 pushInTile(const World *w, local Tile *t, int2 p, float4 n, float lambda, float4 shape) {
    const StepConstants *k = &w->k;
    float e = shape.x;
    float thr2 = shape.y;
    float s = n.z;
    float mass = n.w;
    float2 bi = t->load[p.x];
    float2 bj = t->load[p.y];
    float wi = t->burden[p.x];
    float wj = t->burden[p.y];
    float2 vi = t->velocity[p.x];
    float2 vj = t->velocity[p.y];
    bool loaded = (as_int(wi) | as_int(wj)) < 0;
    float vn = along(n.x, n.y, vj.x - vi.x, vj.y - vi.y);
    float before = along(n.x, n.y, bj.x - bi.x, bj.y - bi.y);
    float speculative = s * k->inverseH;
    float bounce = bounceSpeed(e, before, s, k->h, thr2);
    bounce = e > 0.0f && loaded ? bounce : 0.0f;
    bool flies = e > 0.0f && !loaded && lambda == 0.0f && vn * vn > thr2;
    bool leaves = flies && vn > 0.0f;
    bool bounces = flies && !leaves && speculative + vn < 0.0f;
    // A rigid contact is a soft one with these numbers.
    bool rigidly = bounce > 0.0f || s > 0.0f;
    float massScale = rigidly ? 1.0f : k->massScale;
    float impulseScale = rigidly ? 0.0f : k->impulseScale;
    float bias = k->massScale * greatest(k->biasRate * s, -shape.z);
    bias = bounce > 0.0f ? -bounce : s > 0.0f ? speculative : bias;
    float next = greatest((lambda - mass * (massScale * vn + bias)) - impulseScale * lambda, 0.0f);
    next = leaves || bounces ? lambda : next;
    float impulse = bounces ? freeBounce(e, vn, mass) : next - lambda;
    if (!leaves) applyTo(t, p, vi, vj, n.x, n.y, fabs(wi), fabs(wj), impulse);
    return (float2)(next, bounce);
}

// The relaxing pass over one contact: returns its new impulse. The same as relaxImpulse of Solver.cl, to the bit.
float relaxInTile(const World *w, local Tile *t, int2 p, float4 n, float2 held, float e, float thr2, bool last) {
    float s = n.z;
    float mass = n.w;
    float lambda = held.x;
    float bounce = held.y;
    float wi = t->burden[p.x];
    float wj = t->burden[p.y];
    float2 vi = t->velocity[p.x];
    float2 vj = t->velocity[p.y];
    bool unloaded = (as_int(wi) | as_int(wj)) >= 0;
    wi = fabs(wi);
    wj = fabs(wj);
    float vn = along(n.x, n.y, vj.x - vi.x, vj.y - vi.y);
    bool idle = lambda == 0.0f && bounce == 0.0f;
    bool flies = idle && e > 0.0f && unloaded && vn * vn > thr2;
    bool leaves = idle && (s > 0.0f || (flies && vn > 0.0f));
    bool bounces = flies && !leaves;
    float bias = bounce > 0.0f ? -bounce : s > 0.0f ? s * w->k.inverseH : 0.0f;
    float next = rigid(lambda, mass, vn, bias);
    float impulse = bounces ? freeBounce(e, vn, mass) : next - lambda;
    next = leaves || bounces ? lambda : bounce > 0.0f ? 0.0f : next;
    if (leaves) return next;
    applyTo(t, p, vi, vj, n.x, n.y, wi, wj, impulse);
    if (!bounces && !last && carries(next, s, vn + impulse * (wi + wj), thr2)) {
        float2 lo = t->load[p.x];
        float2 hi = t->load[p.y];
        t->load[p.x] = (float2)(lo.x - n.x * next, lo.y - n.y * next);
        t->load[p.y] = (float2)(hi.x + n.x * next, hi.y + n.y * next);
        t->carried[p.x] = 1;
        t->carried[p.y] = 1;
    }
    return next;
}

// A pass over the contacts of a tile.
typedef struct {
    global int *record;
    size_t offset; // of its contacts
    local float2 *displacement; // of its circles, in the relaxing pass
    bool relaxing, last;
} Pass;

// What a pass has read of a contact. Every component that is loaded is used: one that is not would share its register with
// another value, which would then have to wait for the load.
typedef struct {
    int at;         // its place in the tile, or -1
    int number;     // as in the record
    int pair;       // its circles
    float4 normal;  // as tileNormal; before the relaxing pass has measured, as tileBase
    float4 shape;   // as tileShape
    float2 impulse; // accumulated, and in the relaxing pass the target speed of a bounce
} Reading;

// Reads what lies at a contact's own place: this work-item's of a part, or any, unused, where it has none.
void readContact(const World *w, local const Tile *t, const Pass *pass, int part, Reading *r) {
    r->at = -1;
    if (t->parts == 0) return;
    part = min(part, t->parts);
    int end = t->partStart[min(part + 1, t->parts)];
    int at = t->partStart[part] + (int) get_local_id(0);
    r->at = at < end ? at : -1;
    at = max(min(at, end - 1), 0);
    r->number = numbersOf(pass->record)[at];
    if (pass->relaxing) {
        r->pair = pairsOf(pass->record)[at];
        r->normal = w->tileBase[pass->offset + at];
        r->shape.z = w->tileMass[pass->offset + at];
    } else {
        r->normal = w->tileNormal[pass->offset + at];
        r->shape = w->tileShape[pass->offset + at];
    }
}

// Reads a contact's impulse, where the tile has it that the contact belongs to.
void readImpulse(const World *w, const Pass *pass, Reading *r) {
    if (r->at < 0) return;
    size_t at = r->number < 0 ? (size_t) (r->number & ~NOT_OWN) : pass->offset + r->at;
    if (pass->relaxing) {
        r->impulse = w->impulse[at];
    } else {
        r->impulse.x = w->held[at];
    }
}

// Measures a contact that has been read, after the circles have moved: then shape is restitution, square of the threshold.
void measureContact(const World *w, const Pass *pass, Reading *r) {
    if (r->at < 0) return;
    int2 p = (int2)(r->pair & 0xffff, r->pair >> 16);
    float4 b = r->normal;
    float4 n;
    global float4 *normal = w->tileNormal + pass->offset + r->at;
    if (!measure(&n, b.x, b.y, b.z, pass->displacement[p.x], pass->displacement[p.y])) n.xy = normal->xy;
    n.w = r->shape.z;
    if (!pass->last) *normal = n;
    r->normal = n;
    r->shape.x = b.w;
    r->shape.y = thresholdOf(w, b.z, b.w);
}

// Remembers a contact's impulse for the step to come. Several of one circle may at the same time, in no order: they are
// looked up by id.
void rememberHeld(const World *w, const Pass *pass, int2 p, int c, float lambda) {
    int lo = pass->record[RECORD_SLOTS + p.x] & SLOT_MASK;
    int hi = pass->record[RECORD_SLOTS + p.y] & SLOT_MASK;
    int next = atomic_xchg(&w->homeMemory[lo], c);
    w->old[c] = (int4)(w->id[hi], as_int(lambda), next, 0);
}

void solveContact(const World *w, local Tile *t, const Pass *pass, const Reading *r) {
    int pair = pass->relaxing ? r->pair : as_int(r->shape.w);
    int2 p = (int2)(pair & 0xffff, pair >> 16);
    if (!pass->relaxing) {
        float2 next = pushInTile(w, t, p, r->normal, r->impulse.x, r->shape);
        if (r->number >= 0) w->impulse[pass->offset + r->at] = next;
        return;
    }
    float next = relaxInTile(w, t, p, r->normal, r->impulse, r->shape.x, r->shape.y, pass->last);
    if (r->number < 0) return;
    if (!pass->last) {
        w->held[pass->offset + r->at] = next;
    } else if (next > 0.0f) {
        rememberHeld(w, pass, p, r->number, next);
    }
}

// Solves the contacts of a part of a round; reads those of the fourth part from here, the impulses of the second, and measures
// those of the next.
void solvePart(const World *w, local Tile *t, const Pass *pass, int part, Reading *r, Reading *next, Reading *second) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if (r->at >= 0) solveContact(w, t, pass, r);
    readContact(w, t, pass, part + 4, r);
    readImpulse(w, pass, second);
    if (pass->relaxing) measureContact(w, pass, next);
}

// Solves the contacts of a tile, part by part, four in turn, so that what each needs is on its way for the time of several.
void solveParts(const World *w, local Tile *t, int tile, local float2 *displacement, bool relaxing, bool last) {
    Pass pass;
    pass.record = recordOf(w, tile);
    pass.offset = contactOffset(tile);
    pass.displacement = displacement;
    pass.relaxing = relaxing;
    pass.last = last;
    int parts = t->parts;
    Reading a, b, c, d;
    readContact(w, t, &pass, 0, &a);
    readContact(w, t, &pass, 1, &b);
    readContact(w, t, &pass, 2, &c);
    readContact(w, t, &pass, 3, &d);
    readImpulse(w, &pass, &a);
    readImpulse(w, &pass, &b);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (relaxing) measureContact(w, &pass, &a);
#pragma unroll 1
    for (int part = 0; part < parts; part += 4) {
        solvePart(w, t, &pass, part, &a, &b, &c);
        solvePart(w, t, &pass, part + 1, &b, &c, &d);
        solvePart(w, t, &pass, part + 2, &c, &d, &a);
        solvePart(w, t, &pass, part + 3, &d, &a, &b);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}

// How many circles or contacts a work-item takes at a time outside of the rounds: each is a chain of reads.
#define TOGETHER 4
#define TILE_TOGETHER(first, count)                                                                                    \
    _Pragma("unroll 1") for (int first = (int) get_local_id(0); first < (count);                                       \
                             first += TOGETHER * (int) get_local_size(0))
#define TOGETHER_EACH(n) _Pragma("unroll") for (int n = 0; n < TOGETHER; n++)

int togetherPlace(int first, int n, int count) { return min(first + n * (int) get_local_size(0), count - 1); }

// Notes where the owners of contacts that are not the tile's own keep their impulses.
void findOwners(const World *w, local const Tile *t, int tile) {
    global int *numbers = numbersOf(recordOf(w, tile));
    int contacts = t->circles > 0 ? t->partStart[t->parts] : 0;
    TILE_TOGETHER(first, contacts) {
        int number[TOGETHER], position[TOGETHER];
        TOGETHER_EACH(n) number[n] = numbers[togetherPlace(first, n, contacts)];
        TOGETHER_EACH(n) position[n] = number[n] < 0 ? w->position[number[n] & ~NOT_OWN] : 0;
        TOGETHER_EACH(n) {
            int at = first + n * (int) get_local_size(0);
            if (at < contacts && number[n] < 0) numbers[at] = position[n] | NOT_OWN;
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
}

// The biased pass of a tile.
void pushTile(const World *w, local Tile *t, int tile, int subStep) {
    global int *slots = recordOf(w, tile) + RECORD_SLOTS;
    int circles = t->circles;
    if (subStep == 0) findOwners(w, t, tile);
    TILE_TOGETHER(first, circles) {
        int slot[TOGETHER];
        float4 drive[TOGETHER];
        float burden[TOGETHER];
        TOGETHER_EACH(n) slot[n] = slots[togetherPlace(first, n, circles)];
        TOGETHER_EACH(n) {
            drive[n] = w->drive[slot[n] & SLOT_MASK];
            burden[n] = w->burden[slot[n] & SLOT_MASK];
        }
        TOGETHER_EACH(n) {
            int i = first + n * (int) get_local_size(0);
            if (i >= circles) continue;
            t->velocity[i] = drive[n].xy;
            t->load[i] = drive[n].zw;
            t->burden[i] = burden[n];
            if (subStep == 0 && slot[n] >= 0) w->homeMemory[slot[n] & SLOT_MASK] = NONE;
        }
    }
    solveParts(w, t, tile, 0, false, false);
    TILE_TOGETHER(first, circles) {
        int slot[TOGETHER];
        float4 c[TOGETHER];
        float2 d[TOGETHER];
        TOGETHER_EACH(n) slot[n] = slots[togetherPlace(first, n, circles)];
        TOGETHER_EACH(n) {
            c[n] = w->circle[slot[n] & SLOT_MASK];
            d[n] = slot[n] >= 0 ? w->startDisplacement[slot[n] & SLOT_MASK] : (float2)(0.0f);
        }
        TOGETHER_EACH(n) {
            int i = first + n * (int) get_local_size(0);
            if (i < circles && slot[n] >= 0) endPush(w, slots + i, slot[n], c[n], d[n], t->velocity[i], t->burden[i]);
        }
    }
}

// The relaxing pass of a tile; in the last sub-step the circles go home.
void relaxTile(const World *w, local Tile *t, int tile, local float2 *displacement, bool last) {
    global int *slots = recordOf(w, tile) + RECORD_SLOTS;
    int circles = t->circles;
    TILE_TOGETHER(first, circles) {
        int slot[TOGETHER];
        float4 v[TOGETHER];
        float2 d[TOGETHER];
        TOGETHER_EACH(n) slot[n] = slots[togetherPlace(first, n, circles)] & SLOT_MASK;
        TOGETHER_EACH(n) {
            v[n] = w->pushedVelocity[slot[n]];
            d[n] = w->pushedDisplacement[slot[n]];
        }
        TOGETHER_EACH(n) {
            int i = first + n * (int) get_local_size(0);
            if (i >= circles) continue;
            t->velocity[i] = v[n].xy;
            t->load[i] = (float2)(0.0f);
            t->burden[i] = v[n].z;
            t->carried[i] = 0;
            displacement[i] = d[n];
        }
    }
    solveParts(w, t, tile, displacement, true, last);
    TILE_TOGETHER(first, circles) {
        int place[TOGETHER];
        float4 c[TOGETHER];
        TOGETHER_EACH(n) place[n] = slots[togetherPlace(first, n, circles)];
        TOGETHER_EACH(n) c[n] = w->circle[place[n] & SLOT_MASK];
        TOGETHER_EACH(n) {
            int i = first + n * (int) get_local_size(0);
            if (i >= circles || place[n] < 0) continue;
            int slot = place[n] & SLOT_MASK;
            float2 d = displacement[i];
            float2 v = t->velocity[i];
            if (last) {
                goHome(w, slot, c[n], (float4)(d.x, d.y, v.x, v.y), w->traits[slot]);
            } else {
                startCircle(w, slots + i, slot, (place[n] & AT_WALL) != 0, c[n], d, v, fabs(t->burden[i]), t->load[i],
                            t->carried[i] != 0);
            }
        }
    }
}

// Index space of each: a work-group a tile. Cost: see Tiles.cl.

TILE_KERNEL solver_pushTile(WORLD_PARAMETERS, int subStep) {
    World w = WORLD;
    local Tile t;
    int tile = (int) get_group_id(0);
    takeTile(&w, &t, tile, refused(&w));
    pushTile(&w, &t, tile, subStep);
}

TILE_KERNEL solver_relaxTile(WORLD_PARAMETERS, int last) {
    World w = WORLD;
    local Tile t;
    local float2 displacement[TILE_CIRCLES];
    int tile = (int) get_group_id(0);
    bool idle = refused(&w);
    if (last && get_global_id(0) == 0 && !idle) status[STEPS_DONE]++;
    takeTile(&w, &t, tile, idle);
    relaxTile(&w, &t, tile, displacement, last);
}
