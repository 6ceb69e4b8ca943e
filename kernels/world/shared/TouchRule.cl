// uses: world/shared/Arithmetic.cl
// When two surfaces touch, for the events of a step. The Java class world.model.TouchRule explains it; both give the same bits.

#define NO_TOUCH (-1.0f) // the approach speed of surfaces that did not touch

float approachSpeed(float vn) { return maxf(-vn, 0.0f); }

// Whether an approach is so fast that the place of the touch may be another after the step.
bool isFastApproach(float approach, float dt, float radii) { return approach * dt > TOUCH_SLACK * radii; }

bool touches(float approach, float separation) { return approach >= 0.0f || separation <= 0.0f; }

bool staysInTouch(float approach, float separation, float radii) {
    return approach >= 0.0f || separation <= TOUCH_SLACK * radii;
}

// Whether a touch is a hit. threshold: the square of the speed that it must exceed, unless a speed is set (0 or more).
bool isHit(float approach, float impulse, float threshold, float hitSpeed) {
    if (hitSpeed >= 0.0f) return impulse > 0.0f && approach >= hitSpeed;
    return impulse > 0.0f && approach * approach > threshold;
}

float touchPoint(float x, float displacement, float normal, float radius, float separation) {
    return (x + displacement) + normal * (radius + 0.5f * separation);
}

// Whether surfaces go on approaching after a step so fast that the hit goes on in the next one. vn: normal speed after the step.
bool isIncomplete(float vn, float approach) { return -vn > (1.0f / 64.0f) * approach; }
