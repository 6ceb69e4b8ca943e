// uses: world/shared/CircleMath.cl
// When surfaces touch, for events. The Java class world.model.TouchRule explains it.

#define NO_TOUCH (-1.0f) // the approach speed of surfaces that did not touch

float approachSpeed(float vn) { return maxf(-vn, 0.0f); }

// Then the place of the touch may be another after the step.
bool isFastApproach(float approach, float dt, float radii) { return approach * dt > TOUCH_SLACK * radii; }
bool touches(float approach, float separation) { return approach >= 0.0f || separation <= 0.0f; }

bool staysInTouch(float approach, float separation, float radii) {
    return approach >= 0.0f || separation <= TOUCH_SLACK * radii;
}

// threshold: square of the least speed, unless hitSpeed is set (0 or more).
bool isHitSpeed(float approach, float threshold, float hitSpeed) {
    return hitSpeed >= 0.0f ? approach >= hitSpeed : approach * approach > threshold;
}

bool isHit(float approach, float impulse, float threshold, float hitSpeed) {
    return impulse > 0.0f && isHitSpeed(approach, threshold, hitSpeed);
}

float touchPoint(float x, float displacement, float normal, float radius, float separation) {
    return (x + displacement) + normal * (radius + 0.5f * separation);
}

// Then the hit goes on in the next step. vn: after the step.
bool isIncomplete(float vn, float approach) { return -vn > (1.0f / 64.0f) * approach; }
