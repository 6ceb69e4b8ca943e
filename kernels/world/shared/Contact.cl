// uses: world/shared/CircleMath.cl world/stages/World.cl
// The physics of a contact, of two circles or of one and a one-body constraint: measured, made ready (all that does not depend on
// velocities), visited, without branches.

// 1 up to NEARLY_ELASTIC, then down to 0 at 1.
float inelasticity(float restitution) {
    return minf((1.0f - restitution) * (1.0f / (1.0f - NEARLY_ELASTIC)), 1.0f);
}

// The square of the normal speed of a bounce: gravity's part and a creeping speed; 0 for elastic pairs, unless it is fixed. radii: their
// sum.
float bounceThreshold(const StepConstants *k, float radii, float restitution, float gravityRate) {
    float length = inelasticity(restitution) * radii;
    float creep = k->restRate * length;
    return OR_FIXED(k, gravityRate * length + creep * creep);
}

// The same for two circles that nothing carries, which creep less.
float flightThreshold(const StepConstants *k, float radii, float restitution) {
    float creep = k->flightRestRate * ((1.0f - restitution) * radii);
    return OR_FIXED(k, k->thresholdRate * (inelasticity(restitution) * radii) + creep * creep);
}

// The same for circles of which one is carried.
float restitutionThreshold(const StepConstants *k, float radii, float restitution) {
    return bounceThreshold(k, radii, restitution, k->thresholdRate);
}

float pushSpeed(const StepConstants *k, float radii) { return k->pushRate * radii; }

// Negative: in proportion to the depth, then constant, then growing again if the pair is deep; never more than the proportion.
float pushOut(const StepConstants *k, float separation, float pushSpeed, float biasRate) {
    float deep = DEEP_RATE_OF(k) * separation + DEEP_OFFSET * pushSpeed;
    return maxf(biasRate * separation, minf(-pushSpeed, deep));
}

// Velocities are half a sub-step ahead of positions, so a free bounce leaves out what gravity adds in that time; 0 if both circles fall.
// fall: of a whole sub-step, along the normal.
float halfFall(float fall, float invMassA, float invMassB) {
    float half_ = 0.5f * fall;
    return invMassA == 0.0f ? half_ : invMassB == 0.0f ? -half_ : 0.0f;
}

// Whether surfaces need longer than LINGER to move as far as they are deep. squaredSpeed: before any impulse.
bool lingers(float separation, float squaredSpeed) {
    float way = LINGER * LINGER * squaredSpeed;
    return separation < 0.0f && way < separation * separation;
}

float effectiveMass(float invMassA, float invMassB) { return 1.0f / (invMassA + invMassB); }
float velocityChange(float normal, float invMass, float impulse) { return normal * (invMass * impulse); }

// Returns whether there is a direction. base: difference of the bases; moved: of the displacements.
INLINE bool measure(float baseX, float baseY, float movedX, float movedY, float radii, float *normalX, float *normalY, float *separation) {
    float dx = baseX + movedX;
    float dy = baseY + movedY;
    float distance = lengthf(dx, dy);
    bool apart = distance > COINCIDENT * radii;
    *separation = distance - radii;
    *normalX = apart ? dx / distance : *normalX;
    *normalY = apart ? dy / distance : *normalY;
    return apart;
}

// The square of the normal speed up to which a contact carries without an impulse, or -1.
float restingLimit(float separation, float threshold) { return separation < 0.0f ? threshold : -1.0f; }

bool carries(float normalImpulse, float vn, float restingLimit) {
    return normalImpulse > 0.0f || vn * vn <= restingLimit;
}

// vn: before any impulse.
float bounceSpeed(float restitution, float vn, float separation, float h, float threshold, float pushSpeed) {
    bool bounces = vn < 0.0f && vn * vn > threshold && separation + vn * h < 0.0f &&
                   separation + BOUNCE_DEPTH * pushSpeed >= 0.0f;
    return bounces ? -restitution * vn : 0.0f;
}

typedef struct {
    float separation, restitution;
    float threshold; // see restitutionThreshold
    float flight;    // see flightThreshold
    float mass;      // effective
    float normalImpulse;
    bool loaded; // whether one of its circles is
    IF_TURNING(bool held;) // whether another row has acted, which the relaxing pass may have to take back
    // In the biased pass:
    float pushSpeed;
    float before;       // normal speed before any impulse
    float squaredSpeed; // relative, before any impulse
    float halfFall;     // see the function
} Found;

typedef struct {
    float mass, normalImpulse;
    float bounceMass;        // at a free bounce
    float scale, bias, less; // soft; a rigid one has 1, its bias, 0
    float flight;            // square of the normal speed from which they fly free
    float gain;              // at a free bounce, of the normal speed
    float halfFall;          // taken from that before
    bool lingers;            // not left alone even if they part
    float meeting;           // plus normal speed: negative if they bounce freely
    float bounce;            // target speed of a bounce
    float restingLimit;      // in the relaxing pass; see carries
    bool still;              // left alone at any speed
} Ready;

typedef struct {
    float vn;            // normal speed before the visit
    float impulse;       // to apply, unless it leaves
    float normalImpulse; // accumulated
    bool leaves;
    bool solved;         // neither left alone nor bounced freely
    IF_TURNING(float whole;) // accumulated, with a bounce
    IF_TURNING(bool still;)  // left alone at any speed
} Visited;

INLINE void makeReadyToSolve(const StepConstants *k, Softness softness, const Found *f, Ready *c) {
    float bounce = bounceSpeed(f->restitution, f->before, f->separation, k->h, f->threshold, f->pushSpeed);
    bounce = f->restitution > 0.0f && f->loaded ? bounce : 0.0f;
    float speculative = f->separation * k->inverseH;
    float push = softness.massScale * pushOut(k, f->separation, f->pushSpeed, softness.biasRate);
    bool rigid = bounce > 0.0f || f->separation > 0.0f;
    c->mass = f->mass;
    c->bounceMass = f->mass;
    c->normalImpulse = f->normalImpulse;
    c->scale = rigid ? 1.0f : softness.massScale;
    c->bias = bounce > 0.0f ? -bounce : f->separation > 0.0f ? speculative : push;
    c->less = rigid ? 0.0f : softness.impulseScale * f->normalImpulse;
    bool flies = f->restitution > 0.0f && !f->loaded && f->normalImpulse == 0.0f;
    c->flight = flies ? f->flight : INFINITY;
    c->gain = -(1.0f + f->restitution);
    c->halfFall = f->halfFall;
    c->lingers = lingers(f->separation, f->squaredSpeed);
    c->meeting = speculative;
    c->bounce = bounce;
    c->restingLimit = -1.0f;
    c->still = false;
}

// Takes the push-out speed away. bounce: target speed from the biased pass.
INLINE void makeReadyToRelax(const StepConstants *k, const Found *f, float bounce, Ready *c) {
    bool idle = f->normalImpulse == 0.0f && bounce == 0.0f;
    c->mass = f->mass;
    c->bounceMass = f->mass;
    c->normalImpulse = f->normalImpulse;
    c->scale = 1.0f;
    c->bias = bounce > 0.0f ? -bounce : f->separation > 0.0f ? f->separation * k->inverseH : 0.0f;
    c->less = 0.0f;
    c->flight = idle && f->restitution > 0.0f && !f->loaded ? f->flight : INFINITY;
    c->gain = -(1.0f + f->restitution);
    c->halfFall = 0.0f;
    c->lingers = false;
    c->meeting = 0.0f;
    c->bounce = bounce;
    c->restingLimit = restingLimit(f->separation, f->threshold);
    c->still = idle && f->separation > 0.0f;
    IF_TURNING(c->still = c->still && !f->held;)
}

bool bouncesFreely(const Visited *v) { return !v->solved && !v->leaves; }

#ifdef TURNING
// Of the normal impulses that a visit knows, the one that bounds the other rows behind it. If it leaves, there is none.
float boundingImpulse(const Visited *v) { return v->solved ? v->whole : v->leaves ? 0.0f : v->impulse; }

// Whether the impulses of the other rows accumulate. bounce: target speed.
bool rowsAreKept(const Visited *v, float bounce) { return v->solved && !(bounce > 0.0f); }
#endif

// relaxing: the impulse of a bounce is not kept.
INLINE void visit(const Ready *c, float vn, bool relaxing, Visited *v) {
    bool flies = vn * vn > c->flight;
    bool parts = flies && vn > 0.0f;
    bool leaves = c->still || (parts && !c->lingers);
    bool bounces = flies && !parts;
    if (!relaxing) bounces = bounces && c->meeting + vn < 0.0f;
    bool solved = !(leaves || bounces);
    float next = maxf((c->normalImpulse - c->mass * (c->scale * vn + c->bias)) - c->less, 0.0f);
    v->vn = vn;
    IF_TURNING(v->whole = next;)
    IF_TURNING(v->still = c->still;)
    v->impulse = bounces ? c->gain * (vn - c->halfFall) * c->bounceMass : next - c->normalImpulse;
    if (relaxing) next = c->bounce > 0.0f ? 0.0f : next;
    v->normalImpulse = solved ? next : c->normalImpulse;
    v->leaves = leaves;
    v->solved = solved;
}
