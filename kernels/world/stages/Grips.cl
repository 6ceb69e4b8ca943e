// uses: world/shared/CrossRule.cl world/shared/Surface.cl world/shared/Visit.cl
// What surfaces do in the visit of a contact of two circles, A of the lower id and B. The Java class world.jvm.PairRows does the same.

#ifdef TURNING
bool doesGrip(float4 pairSkin) { return pairSkin.PAIR_FRICTION > 0.0f || pairSkin.ROLLING_REACH > 0.0f; }
float2 tangentOf(float2 n) { return (float2)(-n.y, n.x); }

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

// n: normal; along: see speedAlong; keep: whether what acts accumulates.
INLINE void gripPair(Bodies *b, float4 skin, float4 *g, float2 n, float along, float normalImpulse, bool keep) {
    if (skin.ROLLING_REACH > 0.0f) {
        float omega = b->sb / b->rb - b->sa / b->ra;
        float next = rolling(g->ROLLING_IMPULSE, g->ROLLING_MASS, omega, skin.ROLLING_REACH * normalImpulse);
        float impulse = next - g->ROLLING_IMPULSE;
        g->ROLLING_IMPULSE = keep ? next : 0.0f;
        turnBodies(b, -impulse / b->ra, impulse / b->rb);
    }
    if (skin.PAIR_FRICTION > 0.0f) {
        float2 t = tangentOf(n);
        float slip_ = slip(along, b->sa, b->sb, skin.PAIR_BELT);
        float next = grip(g->FRICTION_IMPULSE, skin.TANGENT_MASS, slip_, skin.PAIR_FRICTION * normalImpulse);
        float impulse = next - g->FRICTION_IMPULSE;
        g->FRICTION_IMPULSE = keep ? next : 0.0f;
        float2 ofA = (float2)(velocityChange(t.x, b->wa, impulse), velocityChange(t.y, b->wa, impulse));
        float2 ofB = (float2)(velocityChange(t.x, b->wb, impulse), velocityChange(t.y, b->wb, impulse));
        b->va = pushedBy(b, b->isHeavyA, b->va, -ofA);
        b->vb = pushedBy(b, b->isHeavyB, b->vb, ofB);
        turnBodies(b, -impulse, -impulse);
    }
}

// The normal impulse that a visit grips by.
float gripImpulse(const Visited *v) { return v->solved ? v->whole : v->leaves ? 0.0f : v->impulse; }
bool keepsGrip(const Visit *v, const Visited *visited) { return visited->solved && !(v->ready.bounce > 0.0f); }
bool bouncesFreely(const Visited *v) { return !v->solved && !v->leaves; }

// A visit of a contact of one level.
void gripContact(const World *w, int c, uint2 pr, float2 n, float along, float normalImpulse, bool keep) {
    float4 skin = w->pairSkin[c];
    if (!doesGrip(skin)) return;
    float4 g = w->grip[c];
    float4 q = w->masses[c];
    float4 ma = w->motion[pr.LOWER];
    float4 mb = w->motion[pr.HIGHER];
    Bodies b = {.va = ma.VELOCITY, .vb = mb.VELOCITY, .sa = w->surfaceSpeed[pr.LOWER], .sb = w->surfaceSpeed[pr.HIGHER],
                .wa = q.INVERSE_MASS_A, .wb = q.INVERSE_MASS_B, .ia = w->inverseInertia[pr.LOWER],
                .ib = w->inverseInertia[pr.HIGHER],
                .ra = w->circle[pr.LOWER].RADIUS, .rb = w->circle[pr.HIGHER].RADIUS, .isHeavyA = false, .isHeavyB = false};
    gripPair(&b, skin, &g, n, along, normalImpulse, keep);
    ma.VELOCITY = b.va;
    mb.VELOCITY = b.vb;
    w->motion[pr.LOWER] = ma;
    w->motion[pr.HIGHER] = mb;
    w->surfaceSpeed[pr.LOWER] = b.sa;
    w->surfaceSpeed[pr.HIGHER] = b.sb;
    w->grip[c] = g;
}

// By entry of the step before: friction and rolling resistance, or zeros.
float2 cachedGrip(const World *w, int first, int higherId) {
    for (int c = first; c >= 0;) {
        int4 entry = w->impulseCache[c];
        if (entry.CACHED_HIGHER_ID == higherId) return w->cachedGrip[c];
        c = entry.CACHED_NEXT;
    }
    return (float2)(0.0f);
}

// Without its tangent mass.
float4 skinOfPair(const World *w, uint a, uint b) {
    float4 skinA = w->skin[a];
    float4 skinB = w->skin[b];
    float4 skin = (float4)(0.0f);
    skin.PAIR_FRICTION = friction(skinA.FRICTION, skinB.FRICTION);
    skin.PAIR_BELT = skinA.BELT + skinB.BELT;
    skin.ROLLING_REACH = maxf(skinA.ROLLING_RESISTANCE, skinB.ROLLING_RESISTANCE) *
                         maxf(w->circle[a].RADIUS, w->circle[b].RADIUS);
    return skin;
}

// Lets the grip of contact c begin with what the step before ended with. If nothing turns the circles, rolling resistance has nothing to do.
void fillGrip(const World *w, int c, uint2 p, int higherId, float4 skin, float rollingMass_) {
    float2 cached = (float2)(0.0f);
    if (!(rollingMass_ <= FLT_MAX)) skin.ROLLING_REACH = 0.0f;
    if (doesGrip(skin) && w->firstCached[p.HIGHER] != FRESH) cached = cachedGrip(w, w->firstCached[p.LOWER], higherId);
    float4 g = (float4)(0.0f);
    g.FRICTION_IMPULSE = skin.PAIR_FRICTION > 0.0f ? cached.CACHED_FRICTION * w->warmScale : 0.0f;
    g.ROLLING_IMPULSE = skin.ROLLING_REACH > 0.0f ? cached.CACHED_ROLLING * w->warmScale : 0.0f;
    g.ROLLING_MASS = rollingMass_;
    w->pairSkin[c] = skin;
    w->grip[c] = g;
}

// Of a contact of one level.
void fillLikeGrip(const World *w, int c, uint2 p, int higherId) {
    float4 skin = skinOfPair(w, p.LOWER, p.HIGHER);
    float ia = w->inverseInertia[p.LOWER];
    float ib = w->inverseInertia[p.HIGHER];
    skin.TANGENT_MASS = tangentMass(w->traits[p.LOWER].INVERSE_MASS, ia, w->traits[p.HIGHER].INVERSE_MASS, ib);
    fillGrip(w, c, p, higherId, skin, rollingMass(w->circle[p.LOWER].RADIUS, ia, w->circle[p.HIGHER].RADIUS, ib, 1.0f));
}

// What is accumulated, as impulses on the surface speeds of A and B.
float2 spinImpulses(const World *w, uint2 p, float4 skin, float4 g) {
    float2 of = (float2)(-g.FRICTION_IMPULSE, -g.FRICTION_IMPULSE);
    if (skin.ROLLING_REACH > 0.0f) {
        of.x -= g.ROLLING_IMPULSE / w->circle[p.LOWER].RADIUS;
        of.y += g.ROLLING_IMPULSE / w->circle[p.HIGHER].RADIUS;
    }
    return of;
}

// Beside the normal impulse of the contact.
void storeGrip(const World *w, int c) {
    float4 g = w->grip[c];
    float2 cached = (float2)(0.0f);
    cached.CACHED_FRICTION = g.FRICTION_IMPULSE;
    cached.CACHED_ROLLING = g.ROLLING_IMPULSE;
    w->cachedGrip[c] = cached;
}
#endif

// What a contact adds to the sums of its circles, see loadAlong. n: normal.
float2 loadOf(const World *w, int c, float2 n, float normalImpulse) {
    float2 g = loadAlong(n.x, n.y, normalImpulse);
#ifdef TURNING
    if (doesGrip(w->pairSkin[c])) g += loadAlong(-n.y, n.x, w->grip[c].FRICTION_IMPULSE);
#endif
    return g;
}
