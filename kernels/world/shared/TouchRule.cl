// uses: world/shared/Real.cl*LANES
// When two surfaces touch, for the events of a step. The Java class world.model.TouchRule explains it; both give the same bits.

#define NO_TOUCH (-1.0f) // the approach speed of surfaces that did not touch

REAL NAME(approachSpeed)(REAL vn) { return NAME(greatest)(-vn, (REAL)(0.0f)); }

// Whether an approach is so fast that the place of the touch may be another after the step.
MASK NAME(isFastApproach)(REAL approach, float dt, REAL radii) { return approach * dt > TOUCH_SLACK * radii; }

MASK NAME(touches)(REAL approach, REAL separation) { return approach >= 0.0f || separation <= 0.0f; }

MASK NAME(staysInTouch)(REAL approach, REAL separation, REAL radii) {
    return approach >= 0.0f || separation <= TOUCH_SLACK * radii;
}

// Whether a touch is a hit. threshold: the square of the speed that it must exceed, unless a speed is set (0 or more).
MASK NAME(isHit)(REAL approach, REAL impulse, REAL threshold, float hitSpeed) {
    if (hitSpeed >= 0.0f) return impulse > 0.0f && approach >= hitSpeed;
    return impulse > 0.0f && approach * approach > threshold;
}

REAL NAME(touchPoint)(REAL x, REAL displacement, REAL normal, REAL radius, REAL separation) {
    return (x + displacement) + normal * (radius + 0.5f * separation);
}
