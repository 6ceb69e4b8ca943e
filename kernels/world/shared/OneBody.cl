// uses: world/shared/Contact.cl world/stages/World.cl
// Contacts with walls and terrain pieces. Each of the two finds how far away it is and how it moves along its normal; the visit is here.
// The effective mass is 1, so impulses are speeds. A circle visits its walls and pieces in order, without colours.

// thresholdRate: gravity's part of the bounce threshold, by length.
Found foundOneBody(const StepConstants *k, float separation, float r, float restitution, float thresholdRate, float normalImpulse,
                   bool loaded) {
    Found f;
    f.separation = separation;
    f.restitution = restitution;
    f.threshold = bounceThreshold(k, 2.0f * r, restitution, thresholdRate);
    f.flight = f.threshold; // there is one threshold
    f.mass = 1.0f;
    f.normalImpulse = normalImpulse;
    f.loaded = loaded;
    f.pushSpeed = pushSpeed(k, 2.0f * r);
    f.squaredSpeed = INFINITY; // never lingers
    f.halfFall = 0.0f;         // leftBehind takes its place
    IF_TURNING(f.held = false;)
    return f;
}

// Returns the target speed of a bounce.
float solveOneBody(const StepConstants *k, const Found *f, float vn, Visited *visited) {
    Ready c;
    makeReadyToSolve(k, oneBodySoftness(k), f, &c);
    visit(&c, vn, false, visited);
    return c.bounce;
}

void relaxOneBody(const StepConstants *k, const Found *f, float bounce, float vn, Visited *visited) {
    Ready c;
    makeReadyToRelax(k, f, bounce, &c);
    visit(&c, vn, true, visited);
}

// A free bounce turns at the start of the sub-step, and not when the circle arrives: how far it is too far away then.
float leftBehind(float gap, float vn, float gain, float dt, float r) {
    return gap > 0.0f && vn < 0.0f && -vn * dt <= r ? gain * (gap / -vn) : 0.0f;
}

// Neither at this normal speed nor at the one before any impulse.
INLINE bool staysClear(const StepConstants *k, float gap, float vn, float before) {
    return (gap > 0.0f) & (gap * k->inverseH + vn >= 0.0f) & (gap + before * k->h >= 0.0f);
}
