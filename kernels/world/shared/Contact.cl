// uses: world/shared/Real.cl*LANES world/stages/World.cl
// The physics of a contact, of two circles or of a circle and a wall. It is measured, made ready, which is everything that does
// not depend on velocities, and then visited, without branches. Schedules load, call and store.

// 1 for a restitution that is not nearly 1; from there it goes down to 0 at 1.
REAL NAME(inelasticity)(REAL restitution) {
    return NAME(least)((1.0f - restitution) * (1.0f / (1.0f - NEARLY_ELASTIC)), (REAL)(1.0f));
}

// The square of the normal speed beyond which a contact bounces: gravity's part, and a creeping speed. Both go down to 0 for elastic
// pairs, unless it is fixed. radii: their sum.
REAL NAME(bounceThreshold)(const StepConstants *k, REAL radii, REAL restitution, float gravityRate) {
    REAL length = NAME(inelasticity)(restitution) * radii;
    REAL creep = k->restRate * length;
    return OR_FIXED(k, gravityRate * length + creep * creep);
}

// The same for two circles that nothing carries, whose creeping speed is lower.
REAL NAME(flightThreshold)(const StepConstants *k, REAL radii, REAL restitution) {
    REAL creep = k->flightRestRate * ((1.0f - restitution) * radii);
    return OR_FIXED(k, k->thresholdRate * (NAME(inelasticity)(restitution) * radii) + creep * creep);
}

// The same for circles of which one is carried.
REAL NAME(restitutionThreshold)(const StepConstants *k, REAL radii, REAL restitution) {
    return NAME(bounceThreshold)(k, radii, restitution, k->thresholdRate);
}

// The greatest speed at which an overlap that is not deep is pushed out.
REAL NAME(pushSpeed)(const StepConstants *k, REAL radii) { return k->pushRate * radii; }

// The speed at which an overlap is pushed out, negative: in proportion to the depth, then constant, then growing again if the pair
// is deep; it never exceeds the proportion.
REAL NAME(pushOut)(const StepConstants *k, REAL separation, REAL pushSpeed, float biasRate) {
    REAL deep = DEEP_RATE_OF(k) * separation + DEEP_OFFSET * pushSpeed;
    return NAME(greatest)(biasRate * separation, NAME(least)(-pushSpeed, deep));
}

// What gravity adds to the normal speed of a pair in half a sub-step; 0 if both circles fall. Velocities are half a sub-step ahead of
// positions, so a free bounce leaves it out. fall: what gravity adds to a circle's speed along the normal in a whole sub-step.
REAL NAME(halfFall)(REAL fall, REAL invMassA, REAL invMassB) {
    REAL half_ = 0.5f * fall;
    return NAME(choose)(invMassA == 0.0f, half_, NAME(choose)(invMassB == 0.0f, -half_, (REAL)(0.0f)));
}

// Whether surfaces overlap and would need longer than LINGER to move as far as they are deep. squaredSpeed: of the relative velocity
// before any impulse.
MASK NAME(lingers)(REAL separation, REAL squaredSpeed) {
    REAL way = LINGER * LINGER * squaredSpeed;
    return separation < 0.0f && way < separation * separation;
}

REAL NAME(effectiveMass)(REAL invMassA, REAL invMassB) { return 1.0f / (invMassA + invMassB); }

// What an impulse along a normal adds to the velocity of a circle, for one component of both.
REAL NAME(velocityChange)(REAL normal, REAL invMass, REAL impulse) { return normal * (invMass * impulse); }

// Measures a contact: sets its separation, and its normal if there is a direction; returns whether there is. baseX, baseY:
// difference of the bases; movedX, movedY: of the displacements.
INLINE MASK NAME(measure)(REAL baseX, REAL baseY, REAL movedX, REAL movedY, REAL radii, REAL *normalX, REAL *normalY,
                          REAL *separation) {
    REAL dx = baseX + movedX;
    REAL dy = baseY + movedY;
    REAL distance = NAME(norm)(dx, dy);
    MASK apart = distance > COINCIDENT * radii;
    *separation = distance - radii;
    *normalX = NAME(choose)(apart, dx / distance, *normalX);
    *normalY = NAME(choose)(apart, dy / distance, *normalY);
    return apart;
}

// The square of the normal speed up to which a contact carries without an impulse, or -1.
REAL NAME(restingLimit)(REAL separation, REAL threshold) {
    return NAME(choose)(separation < 0.0f, threshold, (REAL)(-1.0f));
}

// Whether a contact carries its circles: it presses, or rests.
MASK NAME(carries)(REAL normalImpulse, REAL vn, REAL restingLimit) {
    return normalImpulse > 0.0f || vn * vn <= restingLimit;
}

// The target speed of a bounce, or 0. vn: the normal speed before any impulse.
REAL NAME(bounceSpeed)(REAL restitution, REAL vn, REAL separation, float h, REAL threshold, REAL pushSpeed) {
    MASK bounces = vn < 0.0f && vn * vn > threshold && separation + vn * h < 0.0f &&
                   separation + BOUNCE_DEPTH * pushSpeed >= 0.0f;
    return NAME(choose)(bounces, -restitution * vn, (REAL)(0.0f));
}

// A contact as a pass finds it.
typedef struct {
    REAL separation, restitution;
    REAL threshold; // see restitutionThreshold
    REAL flight;    // see flightThreshold; a wall has the threshold
    REAL mass;      // effective
    REAL normalImpulse;
    MASK loaded; // whether one of its circles is
    // In the biased pass:
    REAL pushSpeed;
    REAL before;       // normal speed before any impulse
    REAL squaredSpeed; // of the relative velocity before any impulse
    REAL halfFall;     // see the function
} NAME(Found);

// A contact made ready to be visited.
typedef struct {
    REAL mass, normalImpulse;
    REAL bounceMass;        // the effective mass at a free bounce
    REAL scale, bias, less; // a soft contact's; a rigid one is soft with 1, its bias, 0
    REAL flight;            // square of the normal speed beyond which circles fly free of each other; INFINITY: at none
    REAL gain;              // of the normal speed at a free bounce
    REAL halfFall;          // taken from the normal speed at a free bounce
    MASK lingers;           // in the biased pass: they overlap for long, and are not left alone even if they part
    REAL meeting;           // in the biased pass: they bounce freely if the sum of this and the normal speed is negative
    REAL bounce;            // target speed of a bounce
    REAL restingLimit;      // in the relaxing pass; see carries
    MASK still;             // in the relaxing pass: left alone at any speed
} NAME(Ready);

// A contact that has been visited.
typedef struct {
    REAL impulse;       // to apply, unless it leaves
    REAL normalImpulse; // accumulated
    MASK leaves;
    MASK solved;        // neither left alone nor bounced freely
} NAME(Visited);

// Makes a contact ready for the biased pass.
INLINE void NAME(makeReadyToSolve)(const StepConstants *k, Softness softness, const NAME(Found) *f, NAME(Ready) *c) {
    REAL bounce = NAME(bounceSpeed)(f->restitution, f->before, f->separation, k->h, f->threshold, f->pushSpeed);
    bounce = NAME(choose)(f->restitution > 0.0f && f->loaded, bounce, (REAL)(0.0f));
    REAL speculative = f->separation * k->inverseH;
    REAL push = softness.massScale * NAME(pushOut)(k, f->separation, f->pushSpeed, softness.biasRate);
    MASK rigid = bounce > 0.0f || f->separation > 0.0f;
    c->mass = f->mass;
    c->bounceMass = f->mass;
    c->normalImpulse = f->normalImpulse;
    c->scale = NAME(choose)(rigid, (REAL)(1.0f), (REAL)(softness.massScale));
    c->bias = NAME(choose)(bounce > 0.0f, -bounce, NAME(choose)(f->separation > 0.0f, speculative, push));
    c->less = NAME(choose)(rigid, (REAL)(0.0f), softness.impulseScale * f->normalImpulse);
    MASK flies = f->restitution > 0.0f && !f->loaded && f->normalImpulse == 0.0f;
    c->flight = NAME(choose)(flies, f->flight, (REAL)(INFINITY));
    c->gain = -(1.0f + f->restitution);
    c->halfFall = f->halfFall;
    c->lingers = NAME(lingers)(f->separation, f->squaredSpeed);
    c->meeting = speculative;
    c->bounce = bounce;
    c->restingLimit = (REAL)(-1.0f);
    c->still = (MASK)(0);
}

// Makes a contact that has been measured again ready for the relaxing pass, which takes the push-out speed away. bounce: its
// target speed from the biased pass.
INLINE void NAME(makeReadyToRelax)(const StepConstants *k, const NAME(Found) *f, REAL bounce, NAME(Ready) *c) {
    MASK idle = f->normalImpulse == 0.0f && bounce == 0.0f;
    c->mass = f->mass;
    c->bounceMass = f->mass;
    c->normalImpulse = f->normalImpulse;
    c->scale = (REAL)(1.0f);
    c->bias = NAME(choose)(bounce > 0.0f, -bounce, NAME(choose)(f->separation > 0.0f, f->separation * k->inverseH, (REAL)(0.0f)));
    c->less = (REAL)(0.0f);
    c->flight = NAME(choose)(idle && f->restitution > 0.0f && !f->loaded, f->flight, (REAL)(INFINITY));
    c->gain = -(1.0f + f->restitution);
    c->halfFall = (REAL)(0.0f);
    c->lingers = (MASK)(0);
    c->meeting = (REAL)(0.0f);
    c->bounce = bounce;
    c->restingLimit = NAME(restingLimit)(f->separation, f->threshold);
    c->still = idle && f->separation > 0.0f;
}

// Visits a contact. vn: its normal speed; relaxing: in the relaxing pass, where the impulse of a bounce is not kept.
INLINE void NAME(visit)(const NAME(Ready) *c, REAL vn, bool relaxing, NAME(Visited) *v) {
    MASK flies = vn * vn > c->flight;
    MASK parts = flies && vn > 0.0f;
    MASK leaves = c->still || (parts && !c->lingers);
    MASK bounces = flies && !parts;
    if (!relaxing) bounces = bounces && c->meeting + vn < 0.0f;
    MASK solved = !(leaves || bounces);
    REAL next = NAME(greatest)((c->normalImpulse - c->mass * (c->scale * vn + c->bias)) - c->less, (REAL)(0.0f));
    v->impulse = NAME(choose)(bounces, c->gain * (vn - c->halfFall) * c->bounceMass, next - c->normalImpulse);
    if (relaxing) next = NAME(choose)(c->bounce > 0.0f, (REAL)(0.0f), next);
    v->normalImpulse = NAME(choose)(solved, next, c->normalImpulse);
    v->leaves = leaves;
    v->solved = solved;
}
