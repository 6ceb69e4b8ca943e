// uses: world/shared/Contact.cl world/shared/Drive.cl world/shared/Surface.cl
// The visit of a contact of two circles, A of the lower id and B. A schedule has the order of contacts, takes what a pass reads from where
// it lies, and gives back the result: slots in Solver.cl, copies in TileVisits.cl, sums of heavy circles in CrossSolver.cl.

// What a pass reads.
typedef struct {
    float nx, ny, separation;
    float radii, restitution;
    float invMassA, invMassB;
    float mass; // effective
    float normalImpulse;
    float bounce; // in the relaxing pass: target speed from the biased pass
    bool loaded;  // whether one of its circles is
    IF_TURNING(bool held;) // see Found
} Pair;

// Contacts wait for each other only in visitPair: all else comes before.
typedef struct {
    float nx, ny;
    float invMassA, invMassB;
    Ready ready;
} Visit;

// One that sleeps is pushed as if it gave way: else a circle that lies on a heap would push the heap. p: slots; inverse masses: in traits.
float massOfPair(const World *w, uint2 p, float invMassA, float invMassB) {
    return effectiveMass(awakeInverseMass(w->circle[p.LOWER], invMassA), awakeInverseMass(w->circle[p.HIGHER], invMassB));
}

INLINE Found foundPair(const StepConstants *k, const Pair *p) {
    Found f;
    f.separation = p->separation;
    f.restitution = p->restitution;
    f.threshold = restitutionThreshold(k, p->radii, p->restitution);
    f.flight = flightThreshold(k, p->radii, p->restitution);
    f.mass = p->mass;
    f.normalImpulse = p->normalImpulse;
    f.loaded = p->loaded;
    IF_TURNING(f.held = p->held;)
    return f;
}

INLINE void beginVisit(const Pair *p, Visit *v) {
    v->nx = p->nx;
    v->ny = p->ny;
    v->invMassA = p->invMassA;
    v->invMassB = p->invMassB;
}

// before: relative velocity before any impulse. Returns the normal speed then.
INLINE float readyToSolve(const StepConstants *k, const Pair *p, float2 before, float2 fall, Visit *v) {
    Found f = foundPair(k, p);
    f.pushSpeed = pushSpeed(k, p->radii);
    f.before = dotf(p->nx, p->ny, before.x, before.y);
    f.squaredSpeed = before.x * before.x + before.y * before.y;
    f.halfFall = halfFall(dotf(p->nx, p->ny, fall.x, fall.y), p->invMassA, p->invMassB);
    beginVisit(p, v);
    makeReadyToSolve(k, contactSoftness(k), &f, &v->ready);
    IF_SLEEPING(v->ready.bounceMass = effectiveMass(p->invMassA, p->invMassB);)
    return f.before;
}

INLINE void readyToRelax(const StepConstants *k, const Pair *p, Visit *v) {
    Found f = foundPair(k, p);
    beginVisit(p, v);
    makeReadyToRelax(k, &f, p->bounce, &v->ready);
    IF_SLEEPING(v->ready.bounceMass = effectiveMass(p->invMassA, p->invMassB);)
}

INLINE void visitPair(const Visit *v, float2 va, float2 vb, bool relaxing, Visited *visited) {
    visit(&v->ready, dotf(v->nx, v->ny, vb.x - va.x, vb.y - va.y), relaxing, visited);
}

// For B to add; for A, with its mass, to subtract.
float2 changeOfVelocity(const Visit *v, float invMass, float impulse) {
    return (float2)(velocityChange(v->nx, invMass, impulse), velocityChange(v->ny, invMass, impulse));
}

// For B's sum of impulses to add, for A's to subtract.
float2 loadAlong(float nx, float ny, float normalImpulse) { return (float2)(nx * normalImpulse, ny * normalImpulse); }

// Into the sub-step to come. rows: as visited.
INLINE bool carriesOn(const Visit *v, const Visited *visited, RowImpulses rows) {
    float after = visited->vn + visited->impulse * (v->invMassA + v->invMassB);
    return visited->solved && carries(actingImpulse(visited->normalImpulse, rows), after, v->ready.restingLimit);
}

// What a free bounce gave and the contact does not keep.
float impulseOfFlight(const Visited *v) { return v->leaves || v->solved ? 0.0f : v->impulse; }

// The same in the relaxing pass, which keeps no bounce.
float impulseOfBounce(const Visit *v, const Visited *visited) {
    if (!visited->solved) return impulseOfFlight(visited);
    return v->ready.bounce > 0.0f ? v->ready.normalImpulse + visited->impulse : 0.0f;
}

// The entry of two circles in the step before, or NONE; none if a circle is new.
INLINE int cachedEntry(const World *w, uint lower, uint higher, int higherId) {
    if (w->firstCached[higher] == FRESH) return NONE;
    for (int c = w->firstCached[lower]; c >= 0;) {
        int4 entry = w->impulseCache[c];
        if (entry.CACHED_HIGHER_ID == higherId) return c;
        c = entry.CACHED_NEXT;
    }
    return NONE;
}

// Of an entry, or 0.
INLINE float warmStartImpulse(const World *w, int entry) {
    return entry == NONE ? 0.0f : as_float(w->impulseCache[entry].CACHED_IMPULSE) * w->warmScale;
}

// Impulses are looked up by id, so their order does not matter. firstCached: of the lower id.
void storeImpulse(const World *w, int c, volatile global int *firstCached, int higherId, float normalImpulse) {
    w->impulseCache[c] = cacheEntry(higherId, normalImpulse, atomic_xchg(firstCached, c));
}

// b: base; returns whether there is a direction.
bool measureContact(float4 b, float4 ma, float4 mb, float4 *n) {
    float x = n->NORMAL_X;
    float y = n->NORMAL_Y;
    float separation;
    bool apart = measure(b.BASE_X, b.BASE_Y, mb.DX - ma.DX, mb.DY - ma.DY, b.RADII, &x, &y, &separation);
    *n = (float4)(x, y, separation, n->NORMAL_IMPULSE);
    return apart;
}

float4 baseOfPair(const World *w, uint2 p) {
    float4 a = w->circle[p.LOWER];
    float4 b = w->circle[p.HIGHER];
    float restitution = maxf(w->traits[p.LOWER].RESTITUTION, w->traits[p.HIGHER].RESTITUTION);
    return (float4)(ACROSS_X(w, b.x - a.x), ACROSS_Y(w, b.y - a.y), a.RADIUS + b.RADIUS, restitution);
}

// As it starts the step, with impulses of rows.
float4 newContact(const World *w, uint2 p, ulong ids, float4 b, RowImpulses rows, bool *carrying) {
    float4 ma = w->motion[p.LOWER];
    float4 mb = w->motion[p.HIGHER];
    float4 n = (float4)(0.0f);
    if (!measureContact(b, ma, mb, &n)) n.NORMAL = partingNormal(ids);
    n.NORMAL_IMPULSE = warmStartImpulse(w, cachedEntry(w, p.LOWER, p.HIGHER, (int) ids));
    float vn = dotf(n.NORMAL_X, n.NORMAL_Y, mb.VX - ma.VX, mb.VY - ma.VY);
    float limit = restingLimit(n.SEPARATION, restitutionThreshold(&w->k, b.RADII, b.PAIR_RESTITUTION));
    *carrying = carries(actingImpulse(n.NORMAL_IMPULSE, rows), vn, limit);
    return n;
}
