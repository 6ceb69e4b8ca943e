package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.clamp;
import static io.github.circles2d.reference.Numbers.min;

/** An implicit spring of a joint. */
record JointSoftness(float massScale, float biasRate, float impulseScale) {
    private static final float FREQUENCY = 60f;
    private static final float GREATEST_FREQUENCY = 0.25f;
    private static final float DAMPING = 2f;
    private static final float GREATEST_IMPULSE = 1e20f;

    /** That of what is rigid. */
    static JointSoftness ofRigid(StepParameters k) {
        float omega = 2f * 3.14159265f * min(FREQUENCY * k.h(), GREATEST_FREQUENCY);
        float a1 = 2f * DAMPING + omega;
        float a2 = omega * a1;
        float impulseScale = 1f / (1f + a2);
        return new JointSoftness(a2 * impulseScale, omega / a1 * k.inverseH(), impulseScale);
    }

    float solve(float impulse, float m, float v, float way) {
        return clamp(unlimited(impulse, m, v, way), -GREATEST_IMPULSE, GREATEST_IMPULSE);
    }

    private float unlimited(float impulse, float m, float v, float way) {
        return (impulse - m * (massScale * v + massScale * (biasRate * way))) - impulseScale * impulse;
    }

    /** Of what is rigid, with the greatest speed by which it corrects. */
    float hold(float impulse, float m, float v, float way, float most) {
        return clamp(held(impulse, m, v, way, most), -GREATEST_IMPULSE, GREATEST_IMPULSE);
    }

    float held(float impulse, float m, float v, float way, float most) {
        float soft = m * (massScale * (biasRate * way)) + impulseScale * impulse;
        return (impulse - m * (massScale * v)) - clamp(soft, -(m * most), m * most);
    }
}
