package io.github.circles2d.reference;

/** What two surfaces did to each other in a step. */
final class Touch {
    static final float SLACK = 0.005f;

    /** The greatest approach speed of the sub-steps in which they touched; -1 if they did not. */
    float approach = -1f;

    /** The approach speed of circles that are only sensed, and never hit. */
    float sensedSpeed;

    /** How fast the surfaces slid along each other then. */
    float slip;

    float impulse;
    float[] normal = {0f, 0f};
    float[] point = {0f, 0f};

    /** After the step. */
    float separation;

    /** Up to this gap they stay in touch. */
    float slack;

    float normalVelocity;

    /** The square of the speed that a hit exceeds. */
    float threshold;

    /**
     * They touch in a sub-step.
     *
     * @param isFast whether this is the place; else it is where they are after the step
     */
    void seen(float speed, float slipThen, float[] direction, float[] place, boolean isFast) {
        if (speed > approach) {
            approach = speed;
            slip = slipThen;
            if (isFast) {
                normal = direction.clone();
                point = place.clone();
            }
        }
    }

    /** The step ends: if the place is not known yet, it is this. */
    void end(float[] direction, float[] place) {
        if (normal[0] == 0f && normal[1] == 0f) {
            normal = direction.clone();
            point = place.clone();
        }
    }

    float speed() {
        return Numbers.max(approach, sensedSpeed);
    }

    boolean touches() {
        return approach >= 0f || separation <= 0f;
    }

    boolean staysInTouch() {
        return touches() || separation <= slack;
    }
}
