// Contacts in bundles of four, a lane each, that share no circle: what one does to its circles none of the others sees, so that
// a processor can work on all four at a time, in the bits of one after the other.
//
// A bundle lies in the buffers of four contacts, word by word, four lanes a word. A lane that is not used stands at the
// circles of lane 0 in place of both of its own, and has no mass, impulse or bounce: it reads what changes nothing, and what
// it writes lane 0, which is always used and always written last, overwrites.

#define UNUSED_LANES (1.0f) // distance of the bases in a lane that is not used: a gap

global float4 *baseOf(const World *w, int bundle) { return w->base + 4 * bundle; }       // x, y, sum of radii, restitution
global float4 *massesOf(const World *w, int bundle) { return w->masses + 4 * bundle; }   // inverse masses, push speed, bounce
global float4 *stateOf(const World *w, int bundle) { return w->contact + 4 * bundle; } // normal x, y, separation, impulse
global float4 *shapeOf(const World *w, int bundle) { return (global float4 *) w->key + 2 * bundle; } // mass, threshold
global int4 *pairOf(const World *w, int bundle) { return (global int4 *) w->pair + 2 * bundle; }     // lower, higher ids' slots

// Vectors of four circles, component by component.
typedef struct {
    float4 x, y, z, w;
} Four;

Four take(global const float4 *from, int4 at) {
    float4 a = from[at.x], b = from[at.y], c = from[at.z], d = from[at.w];
    Four f;
    f.x = (float4)(a.x, b.x, c.x, d.x);
    f.y = (float4)(a.y, b.y, c.y, d.y);
    f.z = (float4)(a.z, b.z, c.z, d.z);
    f.w = (float4)(a.w, b.w, c.w, d.w);
    return f;
}

// Writes lower and higher circles of a bundle, lane 0 last.
void give(global float4 *to, int4 i, int4 j, const Four *a, const Four *b) {
    to[i.w] = (float4)(a->x.w, a->y.w, a->z.w, a->w.w);
    to[j.w] = (float4)(b->x.w, b->y.w, b->z.w, b->w.w);
    to[i.z] = (float4)(a->x.z, a->y.z, a->z.z, a->w.z);
    to[j.z] = (float4)(b->x.z, b->y.z, b->z.z, b->w.z);
    to[i.y] = (float4)(a->x.y, a->y.y, a->z.y, a->w.y);
    to[j.y] = (float4)(b->x.y, b->y.y, b->z.y, b->w.y);
    to[i.x] = (float4)(a->x.x, a->y.x, a->z.x, a->w.x);
    to[j.x] = (float4)(b->x.x, b->y.x, b->z.x, b->w.x);
}

// Measures four contacts, as measure does one: separation s; and the normal where there is a direction, elsewhere it stays.
// Returns where there is.
int4 measure4(float4 dx, float4 dy, float4 sum, float4 *nx, float4 *ny, float4 *s) {
    float4 d = norm4(dx, dy);
    int4 apart = d > COINCIDENT * sum;
    *s = d - sum;
    *nx = choose4(apart, dx / d, *nx);
    *ny = choose4(apart, dy / d, *ny);
    return apart;
}

// The normal of a contact whose circles have one centre.
float2 partingNormal(ulong ids) {
    int hash = pairHash((int) (ids >> 32), (int) ids);
    float px = partingX(hash);
    float py = partingY(hash);
    float l = norm(px, py);
    return (float2)(px / l, py / l);
}

float recall(const World *w, int lo, int hi, ulong ids) {
    return w->memory[hi] == FRESH ? 0.0f : remembered(w, w->memory[lo], (int) ids) * w->warmScale;
}

// Fills a bundle, as fillContact does a contact, but for the sums of impulses. ids, slots: of the lower id above that of the
// higher; used: how many of the four. Until the first biased pass, the word for the bounce says whether the contact carries.
void fillBundle(const World *w, int bundle, const ulong *ids, const ulong *slots, int used) {
    int4 lane = (int4)(0, 1, 2, 3);
    int4 real = lane < (int4)(used);
    int first = (int) (slots[0] >> 32);
    int4 i = (int4)(first, used > 1 ? (int) (slots[1] >> 32) : first, used > 2 ? (int) (slots[2] >> 32) : first,
                    used > 3 ? (int) (slots[3] >> 32) : first);
    int4 j = (int4)((int) slots[0], used > 1 ? (int) slots[1] : first, used > 2 ? (int) slots[2] : first,
                    used > 3 ? (int) slots[3] : first);
    Four ci = take(w->circle, i);
    Four cj = take(w->circle, j);
    Four ti = take(w->traits, i);
    Four tj = take(w->traits, j);
    Four mi = take(w->motion, i);
    Four mj = take(w->motion, j);
    float4 zero = (float4)(0.0f);
    float4 sum = choose4(real, ci.z + cj.z, zero);
    float4 ex = choose4(real, cj.x - ci.x, (float4)(UNUSED_LANES));
    float4 ey = choose4(real, cj.y - ci.y, zero);
    float4 e = choose4(real, greatest4(ti.y, tj.y), zero);
    float4 wi = choose4(real, ti.x, zero);
    float4 wj = choose4(real, tj.x, zero);
    float4 thr2 = bounceThreshold4(sum, e, w->k.thresholdRate, w->k.restRate);
    float4 nx = zero, ny = zero, s;
    int4 apart = measure4(ex + (mj.x - mi.x), ey + (mj.y - mi.y), sum, &nx, &ny, &s);
    if (!all(apart)) {
        float2 normal[4];
        for (int l = 0; l < 4; l++) normal[l] = partingNormal(l < used ? ids[l] : 0);
        nx = choose4(apart, nx, (float4)(normal[0].x, normal[1].x, normal[2].x, normal[3].x));
        ny = choose4(apart, ny, (float4)(normal[0].y, normal[1].y, normal[2].y, normal[3].y));
    }
    float4 lambda = zero;
    lambda.x = recall(w, i.x, j.x, ids[0]);
    if (used > 1) lambda.y = recall(w, i.y, j.y, ids[1]);
    if (used > 2) lambda.z = recall(w, i.z, j.z, ids[2]);
    if (used > 3) lambda.w = recall(w, i.w, j.w, ids[3]);
    float4 vn = along4(nx, ny, mj.z - mi.z, mj.w - mi.w);

    global float4 *base = baseOf(w, bundle);
    base[0] = ex;
    base[1] = ey;
    base[2] = sum;
    base[3] = e;
    global float4 *masses = massesOf(w, bundle);
    masses[0] = wi;
    masses[1] = wj;
    masses[2] = pushSpeed4(sum, w->k.pushPerLength, w->k.pushPerRoot);
    masses[3] = choose4(real & carries4(lambda, s, vn, thr2), (float4)(1.0f), zero);
    global float4 *contact = stateOf(w, bundle);
    contact[0] = nx;
    contact[1] = ny;
    contact[2] = s;
    contact[3] = lambda;
    global float4 *shape = shapeOf(w, bundle);
    shape[0] = choose4(real, 1.0f / (wi + wj), zero);
    shape[1] = thr2;
    global int4 *pair = pairOf(w, bundle);
    pair[0] = i;
    pair[1] = j;
}

// Adds the impulses of a bundle to the sums of its circles, marks as loaded those where they carry, and counts candidates: in
// one level, a circle's contacts. Returns whether a circle has too many.
bool gatherBundle(const World *w, int bundle) {
    global const float4 *contact = stateOf(w, bundle);
    int4 i = pairOf(w, bundle)[0];
    int4 j = pairOf(w, bundle)[1];
    float4 nx = contact[0], ny = contact[1], lambda = contact[3];
    int4 carrying = massesOf(w, bundle)[3] > 0.0f;
    Four a = take(w->load, i);
    Four b = take(w->load, j);
    a.x -= nx * lambda;
    a.y -= ny * lambda;
    a.z += 1.0f;
    a.w = choose4(carrying, (float4)(1.0f), a.w);
    b.x += nx * lambda;
    b.y += ny * lambda;
    b.z += 1.0f;
    b.w = choose4(carrying, (float4)(1.0f), b.w);
    give(w->load, i, j, &a, &b);
    return any(greatest4(a.z, b.z) > (float) CROWD);
}

// The bundles of a row of groups lie in one piece; where, is kept where other plans count the contacts of groups.
void noteRow(const World *w, int row, int firstBundle, int endBundle) {
    w->groupFill[row] = firstBundle;
    w->groupStart[row] = endBundle;
}

void gatherRow(const World *w, int row) {
    int end = w->groupStart[row];
    bool crowded = false;
    for (int bundle = w->groupFill[row]; bundle < end; bundle++) crowded |= gatherBundle(w, bundle);
    if (crowded) w->status[CROWDED] = 1;
}

// How many contacts each circle had in the last step, into rank, which is all zeros. Index space: a row of groups a work-item,
// no more than the level's. Cost: its contacts.
kernel void lanes_degrees(WORLD_PARAMETERS) {
    World w = WORLD;
    int row = (int) get_global_id(0);
    if (row >= 1 << levels->rowsLog[levels->used[0]]) return;
    for (int place = 4 * groupFill[row]; place < 4 * groupStart[row]; place++) {
        int bundle = place >> 2;
        int lo = ((global int *) pairOf(&w, bundle))[place & 3];
        int hi = ((global int *) pairOf(&w, bundle))[4 + (place & 3)];
        if (lo == hi) continue;
        atomic_inc(&rank[lo]);
        atomic_inc(&rank[hi]);
    }
}
