// uses: world/shared/Contact.cl*4 world/stages/Contacts.cl
// A wide contact is four contacts, a lane each, that share no circle: what one does to its circles none of the others sees,
// so that a processor can work on all four at a time, in the bits of one after the other.
//
// A wide contact lies in the buffers of four contacts, word by word, four lanes a word. A lane that is not used stands at the
// lower circle of lane 0 in place of both of its own, and has no mass, impulse or bounce: what it adds is 0, and what it writes
// is overwritten by lane 0, which is always used and always written last.

#define UNUSED_LANES (1.0f) // distance of the bases in a lane that is not used: a gap

// Difference of the bases x, y, sum of the radii, restitution.
global float4 *baseOf(const World *w, int wide) { return w->base + 4 * wide; }

// Inverse masses, square of the flight threshold, target speed of a bounce.
global float4 *massesOf(const World *w, int wide) { return w->masses + 4 * wide; }

// Normal x, y, separation, accumulated impulse.
global float4 *stateOf(const World *w, int wide) { return w->contact + 4 * wide; }

// Effective mass, square of the bounce threshold; in place of keys, which are not needed once a contact is filled.
global float4 *shapeOf(const World *w, int wide) { return (global float4 *) w->key + 2 * wide; }

// Working slots: those of lower id, those of higher id.
global uint *pairOf(const World *w, int wide) { return (global uint *) w->pair + 8 * wide; }

// The slots of a wide contact's circles of lower id (0) or higher (1), read one by one, as they are used.
INLINE uint4 slotsOf(const World *w, int wide, int higher) {
    global const uint *pair = pairOf(w, wide) + 4 * higher;
    return (uint4)(pair[0], pair[1], pair[2], pair[3]);
}

// Whether a mask is true in any lane. Not any(), of which POCL makes branches.
INLINE bool someLane(int4 mask) {
    ulong2 halves = as_ulong2(mask);
    return (halves.x | halves.y) != 0;
}

// Vectors of four circles, component by component.
typedef struct {
    float4 x, y, z, w;
} Four;

INLINE Four take(global const float4 *from, uint4 at) {
    float4 a = from[at.x], b = from[at.y], c = from[at.z], d = from[at.w];
    Four f;
    f.x = (float4)(a.x, b.x, c.x, d.x);
    f.y = (float4)(a.y, b.y, c.y, d.y);
    f.z = (float4)(a.z, b.z, c.z, d.z);
    f.w = (float4)(a.w, b.w, c.w, d.w);
    return f;
}

// Halves of the vectors of four circles: those of lanes 0 and 1, those of lanes 2 and 3.
typedef struct {
    float4 a, b;
} Halves;

#define XY 0 // the first half
#define ZW 1 // the second

INLINE global float *halfOf(global const float4 *vectors, uint at, int half_) {
    return (global float *) (vectors + at) + 2 * half_;
}

// Put together from single numbers: Oclgrind does not survive vectors put together from shorter ones.
INLINE float4 takeTwo(global const float4 *from, uint one, uint other, int half_) {
    float2 a = vload2(0, halfOf(from, one, half_));
    float2 b = vload2(0, halfOf(from, other, half_));
    return (float4)(a.x, a.y, b.x, b.y);
}

INLINE Halves takeHalves(global const float4 *from, uint4 at, int half_) {
    Halves h = {takeTwo(from, at.x, at.y, half_), takeTwo(from, at.z, at.w, half_)};
    return h;
}

// Writes halves of the lower and higher circles of a wide contact, lane 0 last.
INLINE void giveHalves(global float4 *to, uint4 i, uint4 j, const Halves *lower, const Halves *higher,
                       int half_) {
    vstore2((float2)(lower->b.z, lower->b.w), 0, halfOf(to, i.w, half_));
    vstore2((float2)(higher->b.z, higher->b.w), 0, halfOf(to, j.w, half_));
    vstore2((float2)(lower->b.x, lower->b.y), 0, halfOf(to, i.z, half_));
    vstore2((float2)(higher->b.x, higher->b.y), 0, halfOf(to, j.z, half_));
    vstore2((float2)(lower->a.z, lower->a.w), 0, halfOf(to, i.y, half_));
    vstore2((float2)(higher->a.z, higher->a.w), 0, halfOf(to, j.y, half_));
    vstore2((float2)(lower->a.x, lower->a.y), 0, halfOf(to, i.x, half_));
    vstore2((float2)(higher->a.x, higher->a.y), 0, halfOf(to, j.x, half_));
}

INLINE Halves halvesOf(float4 first, float4 second) {
    Halves h;
    h.a = (float4)(first.x, second.x, first.y, second.y);
    h.b = (float4)(first.z, second.z, first.w, second.w);
    return h;
}

INLINE Halves halvesMinus(const Halves *p, const Halves *q) {
    Halves h = {p->a - q->a, p->b - q->b};
    return h;
}

INLINE Halves halvesPlus(const Halves *p, const Halves *q) {
    Halves h = {p->a + q->a, p->b + q->b};
    return h;
}

INLINE float4 firstOf(const Halves *h) { return (float4)(h->a.x, h->a.z, h->b.x, h->b.z); }

INLINE float4 secondOf(const Halves *h) { return (float4)(h->a.y, h->a.w, h->b.y, h->b.w); }

// Adds to the sums of a wide contact's circles: impulses x, y (to those of lower id, taken away), z and w. Sums are never -0,
// so adding any zero changes none. Returns the greatest of each component afterwards.
INLINE float4 addToLoads(const World *w, uint4 i, uint4 j, float4 x, float4 y, float4 z, float4 ww) {
    float4 away = (float4)(-1.0f, -1.0f, 1.0f, 1.0f);
    float4 a = (float4)(x.x, y.x, z.x, ww.x), b = (float4)(x.y, y.y, z.y, ww.y);
    float4 c = (float4)(x.z, y.z, z.z, ww.z), d = (float4)(x.w, y.w, z.w, ww.w);
    global float4 *load = w->load;
    float4 most = load[i.x] += away * a;
    most = greatest4(most, load[j.x] += a);
    most = greatest4(most, load[i.y] += away * b);
    most = greatest4(most, load[j.y] += b);
    most = greatest4(most, load[i.z] += away * c);
    most = greatest4(most, load[j.z] += c);
    most = greatest4(most, load[i.w] += away * d);
    return greatest4(most, load[j.w] += d);
}

// Fills a wide contact, as fillContact does a contact, but for the sums of impulses. ids, slots: of the lower id above that
// of the higher; used: how many of the four. Until the first biased pass, the word for the bounce says whether the contact
// carries.
void fillWide(const World *w, int wide, const ulong *ids, const ulong *slots, int used) {
    int4 lane = (int4)(0, 1, 2, 3);
    int4 real = lane < (int4)(used);
    uint first = (uint) (slots[0] >> 32);
    uint4 i = (uint4)(first, used > 1 ? (uint) (slots[1] >> 32) : first, used > 2 ? (uint) (slots[2] >> 32) : first,
                      used > 3 ? (uint) (slots[3] >> 32) : first);
    uint4 j = (uint4)((uint) slots[0], used > 1 ? (uint) slots[1] : first, used > 2 ? (uint) slots[2] : first,
                      used > 3 ? (uint) slots[3] : first);
    Four ci = take(w->circle, i);
    Four cj = take(w->circle, j);
    Four ti = take(w->traits, i);
    Four tj = take(w->traits, j);
    Four mi = take(w->motion, i);
    Four mj = take(w->motion, j);
    float4 zero = (float4)(0.0f);
    float4 sum = choose4(real, ci.z + cj.z, zero);
    float4 ex = choose4(real, ACROSS_X4(w, cj.x - ci.x), (float4)(UNUSED_LANES));
    float4 ey = choose4(real, ACROSS_Y4(w, cj.y - ci.y), zero);
    float4 e = choose4(real, greatest4(ti.y, tj.y), zero);
    float4 wi = choose4(real, ti.x, zero);
    float4 wj = choose4(real, tj.x, zero);
    float4 threshold = restitutionThreshold4(&w->k, sum, e);
    float4 nx = zero, ny = zero, s;
    int4 apart = measure4(ex, ey, mj.x - mi.x, mj.y - mi.y, sum, &nx, &ny, &s);
    if (someLane(!apart)) {
        float2 normal[4];
        for (int l = 0; l < 4; l++) normal[l] = partingNormal(l < used ? ids[l] : 0);
        nx = choose4(apart, nx, (float4)(normal[0].x, normal[1].x, normal[2].x, normal[3].x));
        ny = choose4(apart, ny, (float4)(normal[0].y, normal[1].y, normal[2].y, normal[3].y));
    }
    float4 normalImpulse = zero;
    normalImpulse.x = warmStartImpulse(w, i.x, j.x, ids[0]);
    if (used > 1) normalImpulse.y = warmStartImpulse(w, i.y, j.y, ids[1]);
    if (used > 2) normalImpulse.z = warmStartImpulse(w, i.z, j.z, ids[2]);
    if (used > 3) normalImpulse.w = warmStartImpulse(w, i.w, j.w, ids[3]);
    float4 vn = along4(nx, ny, mj.z - mi.z, mj.w - mi.w);

    global float4 *base = baseOf(w, wide);
    base[0] = ex;
    base[1] = ey;
    base[2] = sum;
    base[3] = e;
    global float4 *masses = massesOf(w, wide);
    masses[0] = wi;
    masses[1] = wj;
    masses[2] = flightThreshold4(&w->k, sum, e);
    masses[3] = choose4(real && carries4(normalImpulse, vn, restingLimit4(s, threshold)), (float4)(1.0f), zero);
    global float4 *contact = stateOf(w, wide);
    contact[0] = nx;
    contact[1] = ny;
    contact[2] = s;
    contact[3] = normalImpulse;
    global float4 *shape = shapeOf(w, wide);
    shape[0] = choose4(real, effectiveMass4(wi, wj), zero);
    shape[1] = threshold;
    vstore4(i, 0, pairOf(w, wide));
    vstore4(j, 1, pairOf(w, wide));
}

// Adds the impulses of a wide contact to the sums of its circles, marks as loaded those where they carry, and counts
// candidates: among circles of one level, those are its contacts. Returns whether a circle has too many.
INLINE bool gatherWide(const World *w, int wide) {
    global const float4 *contact = stateOf(w, wide);
    float4 normalImpulse = contact[3], one = (float4)(1.0f);
    int4 used = shapeOf(w, wide)[0] > 0.0f;
    float4 most = addToLoads(w, slotsOf(w, wide, 0), slotsOf(w, wide, 1), contact[0] * normalImpulse,
                             contact[1] * normalImpulse, choose4(used, one, (float4)(0.0f)), massesOf(w, wide)[3]);
    return most.z > (float) CROWD;
}

// The number of a row of a level among those of all levels: each has room for rows of four cells at least.
int rowNumber(const World *w, int level, int row) { return (w->levels->first[level] >> 2) + row; }

// The wide contacts of a row of groups lie in one piece; where, is kept where other plans count the contacts of groups.
void noteRow(const World *w, int row, int firstWide, int endWide) {
    w->groupStart[2 * row] = firstWide;
    w->groupStart[2 * row + 1] = endWide;
}

void gatherRow(const World *shared, int row) {
    World own = *shared;
    const World *w = &own;
    int end = w->groupStart[2 * row + 1];
    bool crowded = false;
    for (int wide = w->groupStart[2 * row]; wide < end; wide++) crowded |= gatherWide(w, wide);
    if (crowded) w->status[CROWDED] = 1;
}
