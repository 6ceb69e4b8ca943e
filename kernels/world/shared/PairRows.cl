// uses: world/shared/CrossRule.cl world/shared/OneBodyRows.cl world/shared/Surface.cl world/shared/Visit.cl
// The rows behind the normal one of a contact of two circles, A of the lower id and B: friction along the tangent, rolling resistance. A
// schedule moves RowImpulses, the accumulated impulses of all rows. The Java class world.jvm.solver.PairRows does the same.

// As warmStartImpulse.
INLINE RowImpulses warmStartRows(const World *w, int entry) {
    IF_TURNING(if (entry != NONE) return w->rowCache[entry] * w->warmScale;)
    return (RowImpulses)(0.0f);
}

#ifdef TURNING
// By what the rows of a contact act.
typedef struct {
    float friction, tangentMass;
    float belt;
    float reach, rollingMass; // of rolling resistance
} PairSurface;

// Most contacts have friction alone, without a belt. Of others the tangent mass is negative in memory, and the rest lies apart.
bool hasRest(float2 stored) { return as_int(stored.TANGENT_MASS) < 0; }

PairSurface surfaceOfPair(float2 stored, global const float4 *rest) {
    PairSurface s = {.friction = stored.PAIR_FRICTION, .tangentMass = fabs(stored.TANGENT_MASS)};
    if (hasRest(stored)) {
        float4 r = *rest;
        s.belt = r.PAIR_BELT;
        s.reach = r.ROLLING_REACH;
        s.rollingMass = r.ROLLING_MASS;
    }
    return s;
}

void storeSurface(const World *w, int c, const PairSurface *s) {
    bool rest = s->belt != 0.0f || s->reach > 0.0f;
    float4 r = (float4)(0.0f);
    r.PAIR_BELT = s->belt;
    r.ROLLING_REACH = s->reach;
    r.ROLLING_MASS = s->rollingMass;
    w->pairSurface[c] = (float2)(s->friction, rest ? -s->tangentMass : s->tangentMass);
    if (rest) w->pairRest[c] = r;
}

PairSurface surfaceAt(const World *w, int c) { return surfaceOfPair(w->pairSurface[c], w->pairRest + c); }

// Of each row, by the normal impulse; 0 if it does nothing.
RowImpulses boundsOf(const PairSurface *s) {
    RowImpulses bounds = (RowImpulses)(0.0f);
    bounds.FRICTION_IMPULSE = s->friction;
    bounds.ROLLING_IMPULSE = s->reach;
    return bounds;
}

bool rowsAct(const PairSurface *s) { return any(boundsOf(s) > 0.0f); }

// The circles of a contact as its visit sees them. A heavy one stays as it was before the pass; sums take what it gets.
typedef struct {
    float2 va, vb;
    float sa, sb; // surface speeds
    float wa, wb, ia, ib; // inverse masses, inertias
    float ra, rb;
    bool isHeavyA, isHeavyB;
    float scale;              // of the sums
    global long *velocitySums;
    global long *spinSum;     // null of a static circle, as velocitySums
} Bodies;

INLINE float turnedBy(const Bodies *b, bool isHeavy, float s, float gain_) {
    if (!isHeavy) return s + gain_;
    if (b->spinSum != 0) addFixed(b->spinSum, toFixed(gain_, b->scale));
    return s;
}

INLINE float2 pushedBy(const Bodies *b, bool isHeavy, float2 v, float2 change) {
    if (!isHeavy) return v + change;
    if (b->velocitySums != 0) {
        addFixed(b->velocitySums, toFixed(change.x, b->scale));
        addFixed(b->velocitySums + 1, toFixed(change.y, b->scale));
    }
    return v;
}

// Gives impulses to surface speeds.
INLINE void turnBodies(Bodies *b, float ofA, float ofB) {
    b->sa = turnedBy(b, b->isHeavyA, b->sa, b->ia * ofA);
    b->sb = turnedBy(b, b->isHeavyB, b->sb, b->ib * ofB);
}

// Of B against A; before the impulse of the visit, so that neither waits for the other.
INLINE float speedAlong(float2 n, float2 va, float2 vb) { return dotf(-n.y, n.x, vb.x - va.x, vb.y - va.y); }

// Behind the visit of the contact, in the relaxing pass and if it bounces freely. along: see speedAlong.
INLINE void visitRows(Bodies *b, const PairSurface *s, RowImpulses *i, const Visit *v, const Visited *visited, float along) {
    float2 n = (float2)(v->nx, v->ny);
    float normalImpulse = boundingImpulse(visited);
    bool keep = rowsAreKept(visited, v->ready.bounce);
    if (s->reach > 0.0f) {
        float omega = b->sb / b->rb - b->sa / b->ra;
        float next = rolling(i->ROLLING_IMPULSE, s->rollingMass, omega, s->reach * normalImpulse);
        float impulse = next - i->ROLLING_IMPULSE;
        i->ROLLING_IMPULSE = keep ? next : 0.0f;
        turnBodies(b, -impulse / b->ra, impulse / b->rb);
    }
    if (s->friction > 0.0f) {
        float2 t = (float2)(-n.y, n.x);
        float slip_ = slip(along, b->sa, b->sb, s->belt);
        float next = grip(i->FRICTION_IMPULSE, s->tangentMass, slip_, s->friction * normalImpulse);
        float impulse = next - i->FRICTION_IMPULSE;
        i->FRICTION_IMPULSE = keep ? next : 0.0f;
        float2 ofA = (float2)(velocityChange(t.x, b->wa, impulse), velocityChange(t.y, b->wa, impulse));
        float2 ofB = (float2)(velocityChange(t.x, b->wb, impulse), velocityChange(t.y, b->wb, impulse));
        b->va = pushedBy(b, b->isHeavyA, b->va, -ofA);
        b->vb = pushedBy(b, b->isHeavyB, b->vb, ofB);
        turnBodies(b, -impulse, -impulse);
    }
}

// What the impulses give to B's velocity in the sub-step to come. n: normal.
float2 rowLoad(float2 n, RowImpulses i) { return loadAlong(-n.y, n.x, tangentImpulse(i)); }

// What they give to the surface speeds of A and B, whose slots p has.
float2 spinImpulses(const World *w, uint2 p, const PairSurface *s, RowImpulses i) {
    float2 of = (float2)(-i.FRICTION_IMPULSE, -i.FRICTION_IMPULSE);
    if (s->reach > 0.0f) {
        of.x -= i.ROLLING_IMPULSE / w->circle[p.LOWER].RADIUS;
        of.y += i.ROLLING_IMPULSE / w->circle[p.HIGHER].RADIUS;
    }
    return of;
}

// How fast surfaces slide that have friction. before: velocities; sa, sb: surface speeds.
float slipOfPair(const PairSurface *s, float2 n, float2 beforeA, float2 beforeB, float sa, float sb) {
    return hitSlip(s->friction, speedAlong(n, beforeA, beforeB), sa, sb, s->belt);
}

// share: 1, or of the second circle if it is heavy. If nothing turns the circles, rolling resistance has nothing to do.
PairSurface findSurface(const World *w, uint first, uint second, float share) {
    global const float *a = surfaceOfCircle(w, (int) first);
    global const float *b = surfaceOfCircle(w, (int) second);
    float ra = w->circle[first].RADIUS;
    float rb = w->circle[second].RADIUS;
    float ia = w->inverseInertia[first];
    float ib = w->inverseInertia[second];
    PairSurface s;
    s.friction = friction(a[SURFACE_FRICTION], b[SURFACE_FRICTION]);
    s.tangentMass = tangentMass(w->traits[first].INVERSE_MASS, ia, w->traits[second].INVERSE_MASS, ib, share);
    s.belt = a[SURFACE_BELT] + b[SURFACE_BELT];
    s.rollingMass = rollingMass(ra, ia, rb, ib, share);
    s.reach = s.rollingMass <= FLT_MAX ? maxf(a[SURFACE_ROLLING_RESISTANCE], b[SURFACE_ROLLING_RESISTANCE]) * maxf(ra, rb) : 0.0f;
    return s;
}

// Fills the rows of contact c of the circles p, and starts them with what the step before ended with. first, second, share: see findSurface.
// Returns by what they act.
PairSurface fillRows(const World *w, int c, uint2 p, int higherId, uint first, uint second, float share) {
    PairSurface s = findSurface(w, first, second, share);
    int entry = rowsAct(&s) ? cachedEntry(w, p.LOWER, p.HIGHER, higherId) : NONE;
    storeSurface(w, c, &s);
    w->rowImpulses[c] = select((RowImpulses)(0.0f), warmStartRows(w, entry), boundsOf(&s) > 0.0f);
    return s;
}

// Beside the normal impulse of the contact.
void storeRows(const World *w, int c) { w->rowCache[c] = w->rowImpulses[c]; }
#endif

// Impulses; there are none if circles cannot rotate.
INLINE RowImpulses rowsAt(const World *w, int c) {
#ifdef TURNING
    return w->rowImpulses[c];
#else
    return (RowImpulses)(0.0f);
#endif
}

// What a contact adds to the sums of its circles, see loadAlong. n: normal.
float2 loadOf(const World *w, int c, float2 n, float normalImpulse) {
    float2 g = loadAlong(n.x, n.y, normalImpulse);
    IF_TURNING(PairSurface s = surfaceAt(w, c);)
    IF_TURNING(if (rowsAct(&s)) g += rowLoad(n, w->rowImpulses[c]);)
    return g;
}
