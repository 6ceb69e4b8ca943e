// uses: world/shared/Arithmetic.cl world/stages/World.cl
// The physics of a contact, of two circles or of a circle and a wall. It is measured, made ready, which is everything that does
// not depend on velocities, and then visited, without branches. Schedules load, call and store.

// 1 for a restitution that is not nearly 1; from there it goes down to 0 at 1.
float inelasticity(float restitution) {
    return minf((1.0f - restitution) * (1.0f / (1.0f - NEARLY_ELASTIC)), 1.0f);
}

// The square of the normal speed beyond which a contact bounces: gravity's part, and a creeping speed. Both go down to 0 for elastic
// pairs, unless it is fixed. radii: their sum.
float bounceThreshold(const StepConstants *k, float radii, float restitution, float gravityRate) {
    float length = inelasticity(restitution) * radii;
    float creep = k->restRate * length;
    return OR_FIXED(k, gravityRate * length + creep * creep);
}

// The same for two circles that nothing carries, whose creeping speed is lower.
float flightThreshold(const StepConstants *k, float radii, float restitution) {
    float creep = k->flightRestRate * ((1.0f - restitution) * radii);
    return OR_FIXED(k, k->thresholdRate * (inelasticity(restitution) * radii) + creep * creep);
}

// The same for circles of which one is carried.
float restitutionThreshold(const StepConstants *k, float radii, float restitution) {
    return bounceThreshold(k, radii, restitution, k->thresholdRate);
}

// The greatest speed at which an overlap that is not deep is pushed out.
float pushSpeed(const StepConstants *k, float radii) { return k->pushRate * radii; }

// The speed at which an overlap is pushed out, negative: in proportion to the depth, then constant, then growing again if the pair
// is deep; it never exceeds the proportion.
float pushOut(const StepConstants *k, float separation, float pushSpeed, float biasRate) {
    float deep = DEEP_RATE_OF(k) * separation + DEEP_OFFSET * pushSpeed;
    return maxf(biasRate * separation, minf(-pushSpeed, deep));
}

// What gravity adds to the normal speed of a pair in half a sub-step; 0 if both circles fall. Velocities are half a sub-step ahead of
// positions, so a free bounce leaves it out. fall: what gravity adds to a circle's speed along the normal in a whole sub-step.
float halfFall(float fall, float invMassA, float invMassB) {
    float half_ = 0.5f * fall;
    return invMassA == 0.0f ? half_ : invMassB == 0.0f ? -half_ : 0.0f;
}

// Whether surfaces overlap and would need longer than LINGER to move as far as they are deep. squaredSpeed: of the relative velocity
// before any impulse.
bool lingers(float separation, float squaredSpeed) {
    float way = LINGER * LINGER * squaredSpeed;
    return separation < 0.0f && way < separation * separation;
}

float effectiveMass(float invMassA, float invMassB) { return 1.0f / (invMassA + invMassB); }

// What an impulse along a normal adds to the velocity of a circle, for one component of both.
float velocityChange(float normal, float invMass, float impulse) { return normal * (invMass * impulse); }

// Measures a contact: sets its separation, and its normal if there is a direction; returns whether there is. baseX, baseY:
// difference of the bases; movedX, movedY: of the displacements.
INLINE bool measure(float baseX, float baseY, float movedX, float movedY, float radii, float *normalX, float *normalY,
                    float *separation) {
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

// Whether a contact carries its circles: it presses, or rests.
bool carries(float normalImpulse, float vn, float restingLimit) {
    return normalImpulse > 0.0f || vn * vn <= restingLimit;
}

// The target speed of a bounce, or 0. vn: the normal speed before any impulse.
float bounceSpeed(float restitution, float vn, float separation, float h, float threshold, float pushSpeed) {
    bool bounces = vn < 0.0f && vn * vn > threshold && separation + vn * h < 0.0f &&
                   separation + BOUNCE_DEPTH * pushSpeed >= 0.0f;
    return bounces ? -restitution * vn : 0.0f;
}

// A contact as a pass finds it.
typedef struct {
    float separation, restitution;
    float threshold; // see restitutionThreshold
    float flight;    // see flightThreshold; a wall has the threshold
    float mass;      // effective
    float normalImpulse;
    bool loaded; // whether one of its circles is
    // In the biased pass:
    float pushSpeed;
    float before;       // normal speed before any impulse
    float squaredSpeed; // of the relative velocity before any impulse
    float halfFall;     // see the function
} Found;

// A contact made ready to be visited.
typedef struct {
    float mass, normalImpulse;
    float bounceMass;        // the effective mass at a free bounce
    float scale, bias, less; // a soft contact's; a rigid one is soft with 1, its bias, 0
    float flight;            // square of the normal speed beyond which circles fly free of each other; INFINITY: at none
    float gain;              // of the normal speed at a free bounce
    float halfFall;          // taken from the normal speed at a free bounce
    bool lingers;            // in the biased pass: they overlap for long, and are not left alone even if they part
    float meeting;           // in the biased pass: they bounce freely if the sum of this and the normal speed is negative
    float bounce;            // target speed of a bounce
    float restingLimit;      // in the relaxing pass; see carries
    bool still;              // in the relaxing pass: left alone at any speed
} Ready;

// A contact that has been visited.
typedef struct {
    float impulse;       // to apply, unless it leaves
    float normalImpulse; // accumulated
    bool leaves;
    bool solved;         // neither left alone nor bounced freely
} Visited;

// Makes a contact ready for the biased pass.
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

// Makes a contact that has been measured again ready for the relaxing pass, which takes the push-out speed away. bounce: its
// target speed from the biased pass.
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
}

// Visits a contact. vn: its normal speed; relaxing: in the relaxing pass, where the impulse of a bounce is not kept.
INLINE void visit(const Ready *c, float vn, bool relaxing, Visited *v) {
    bool flies = vn * vn > c->flight;
    bool parts = flies && vn > 0.0f;
    bool leaves = c->still || (parts && !c->lingers);
    bool bounces = flies && !parts;
    if (!relaxing) bounces = bounces && c->meeting + vn < 0.0f;
    bool solved = !(leaves || bounces);
    float next = maxf((c->normalImpulse - c->mass * (c->scale * vn + c->bias)) - c->less, 0.0f);
    v->impulse = bounces ? c->gain * (vn - c->halfFall) * c->bounceMass : next - c->normalImpulse;
    if (relaxing) next = c->bounce > 0.0f ? 0.0f : next;
    v->normalImpulse = solved ? next : c->normalImpulse;
    v->leaves = leaves;
    v->solved = solved;
}
