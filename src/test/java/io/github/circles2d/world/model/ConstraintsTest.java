package io.github.circles2d.world.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The formulas of {@link Constraints} have the bits of their plain forms, which have branches. */
class ConstraintsTest {
    private static final float[] EDGES = {0f, Float.MIN_VALUE, Float.MIN_NORMAL, 1f, Math.nextUp(1f), 1e9f, 0x1p-60f};

    private final SplittableRandom random = new SplittableRandom(13);
    private final StepConstants constants = new StepConstants();

    ConstraintsTest() {
        constants.deepRate = Tuning.DEEP_RATE;
        constants.inverseH = 240f;
        constants.contactSoftness.biasRate = 45f;
        constants.contactSoftness.massScale = 0.9f;
        constants.contactSoftness.impulseScale = 0.1f;
    }

    @Test
    void everyFormulaHasTheBitsOfItsPlainForm() {
        for (int i = 0; i < 200_000; i++) {
            float separation = signed();
            float vn = signed();
            float impulse = positive();
            float bounce = random.nextBoolean() ? 0f : positive();
            float restitution = random.nextBoolean() ? -0f : positive();
            float loaded = random.nextInt(3);
            float threshold = positive();
            float mass = positive();
            float push = positive();
            float next = impulse - mass * (vn - bounce);
            float relaxed = next;
            if (bounce == 0f) {
                next = separation > 0f
                        ? impulse - mass * (vn + separation * 240f)
                        : (impulse - mass * (0.9f * vn + 0.9f * pushOut(separation, push))) - 0.1f * impulse;
                relaxed = separation > 0f ? next : impulse - mass * vn;
            }
            same(
                    Constraints.solve(
                            impulse, mass, vn, separation, bounce, push, constants.contactSoftness, constants),
                    max(next, 0f));
            same(Constraints.relax(impulse, mass, vn, separation, bounce, 240f), max(relaxed, 0f));

            boolean impact = vn * vn > threshold;
            boolean bounces = restitution > 0f
                    && loaded > 0f
                    && vn < 0f
                    && impact
                    && separation + vn * 0.004f < 0f
                    && separation + Tuning.BOUNCE_DEPTH * push >= 0f;
            same(
                    Constraints.bounceSpeed(restitution, loaded, vn, separation, 0.004f, threshold, push),
                    bounces ? -restitution * vn : 0f);
            boolean meets = separation * 240f + vn < 0f;
            float squaredSpeed = positive();
            boolean lingers = separation < 0f && Tuning.LINGER * Tuning.LINGER * squaredSpeed < separation * separation;
            int lingering = Constraints.lingers(separation, squaredSpeed);
            assertThat(lingering).isEqualTo(lingers ? -1 : 0);
            boolean flies = restitution > 0f && loaded == 0f && impulse == 0f && impact;
            assertThat(Constraints.visitOf(
                            restitution,
                            loaded,
                            lingering,
                            impulse,
                            vn,
                            Constraints.meets(separation, vn, 240f),
                            threshold))
                    .isEqualTo(
                            flies && vn > 0f && !lingers
                                    ? Constraints.LEAVE
                                    : flies && !(vn > 0f) && meets ? Constraints.BOUNCE : Constraints.SOLVE);
            assertThat(Constraints.carries(impulse, separation, vn, threshold))
                    .isEqualTo(impulse > 0f || separation < 0f && !impact ? -1 : 0);
            boolean idle = separation > 0f && impulse == 0f && bounce == 0f;
            assertThat(Constraints.isIdle(separation, impulse, bounce)).isEqualTo(idle ? -1 : 0);
        }
    }

    private static void same(float actual, float expected) {
        assertThat(Float.floatToRawIntBits(actual)).isEqualTo(Float.floatToRawIntBits(expected));
    }

    private static float pushOut(float separation, float push) {
        float deep = Tuning.DEEP_RATE * separation + Tuning.DEEP_OFFSET * push;
        return max(45f * separation, deep < -push ? deep : -push);
    }

    private static float max(float a, float b) {
        return a > b ? a : b;
    }

    private float positive() {
        return switch (random.nextInt(3)) {
            case 0 -> EDGES[random.nextInt(EDGES.length)];
            case 1 -> (float) random.nextDouble();
            default -> 1000f * (float) random.nextDouble();
        };
    }

    /** Never -0. */
    private float signed() {
        float a = positive();
        return a == 0f || random.nextBoolean() ? a : -a;
    }
}
