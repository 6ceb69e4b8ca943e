// uses: world/shared/Contact.cl world/stages/World.cl
// One-body constraints: what a circle meets that is no circle. Walls (Wall.cl) are the first kind. A kind finds, for a circle, how far away
// the constraint is and how it moves along its normal; the visit is here. The effective mass is 1, so impulses are speeds, and a circle
// visits its own constraints in order, without colours.

// r: radius; thresholdRate: gravity's part of the bounce threshold, by length.
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
    return f;
}

// The biased pass. vn: normal speed. Returns the target speed of a bounce.
float solveOneBody(const StepConstants *k, const Found *f, float vn, Visited *visited) {
    Ready c;
    makeReadyToSolve(k, oneBodySoftness(k), f, &c);
    visit(&c, vn, false, visited);
    return c.bounce;
}

// The relaxing pass. bounce: target speed from the biased pass.
void relaxOneBody(const StepConstants *k, const Found *f, float bounce, float vn, Visited *visited) {
    Ready c;
    makeReadyToRelax(k, f, bounce, &c);
    visit(&c, vn, true, visited);
}

// What a circle moves too far in a sub-step in which it bounces freely off a constraint that it did not reach before.
float leftBehind(float gap, float vn, float gain, float dt, float r) {
    return gap > 0.0f && vn < 0.0f && -vn * dt <= r ? gain * (gap / -vn) : 0.0f;
}

// Whether a gap closes neither at a normal speed nor at the one before any impulse.
INLINE bool staysClear(const StepConstants *k, float gap, float vn, float before) {
    return (gap > 0.0f) & (gap * k->inverseH + vn >= 0.0f) & (gap + before * k->h >= 0.0f);
}
