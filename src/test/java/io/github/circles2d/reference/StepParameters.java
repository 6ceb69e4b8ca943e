package io.github.circles2d.reference;

/** What a step is made with. */
final class StepParameters {
    private static final float DAMPING = 4f;
    private static final float FREQUENCY = 0.28f;
    private static final float WALL_STIFFNESS = 2f;
    private static final float PUSH = 4f;
    private static final float PUSH_GRAVITY = 2.7f;
    private static final float BOUNCE_THRESHOLD = 1.2f;
    private static final float REST_SPEED = 0.1f;

    final Walls x;
    final Walls y;
    final float dt;
    final int subSteps;
    final float h;
    final float inverseH;
    final float gravityStepX;
    final float gravityStepY;
    final Softness contactSoftness;
    final Softness wallSoftness;
    private final float gravity;

    StepParameters(Walls x, Walls y, float dt, int subSteps, float gravityX, float gravityY) {
        this.x = x;
        this.y = y;
        this.dt = dt;
        this.subSteps = subSteps;
        h = dt / subSteps;
        inverseH = subSteps / dt;
        gravityStepX = gravityX * h;
        gravityStepY = gravityY * h;
        gravity = Numbers.length(gravityX, gravityY);
        float omega = 2f * 3.14159265f * FREQUENCY;
        contactSoftness = Softness.of(omega, inverseH);
        wallSoftness = Softness.of(WALL_STIFFNESS * omega, inverseH);
    }

    /** The position of two parallel walls. */
    record Walls(float low, float high) {}

    /** How a constraint gives way. */
    record Softness(float biasRate, float massScale, float impulseScale) {
        /** Of an angular frequency times the length of a sub-step. */
        static Softness of(float omega, float inverseH) {
            float a1 = 2f * DAMPING + omega;
            float a2 = omega * a1;
            float impulseScale = 1f / (1f + a2);
            return new Softness((omega / a1) * inverseH, a2 * impulseScale, impulseScale);
        }
    }

    /** What gravity moves a circle in a step, from its gain of speed in a sub-step. */
    float fall(float gravityStep) {
        return gravityStep * h * (0.5f * subSteps * (subSteps + 1));
    }

    float squaredRestitutionThreshold(float radii, float restitution) {
        float creep = REST_SPEED * 0.5f * ((1f - restitution) * radii);
        return BOUNCE_THRESHOLD * BOUNCE_THRESHOLD * 0.5f * gravity * radii + creep * creep;
    }

    /** The greatest speed at which overlaps are pushed out. */
    float pushSpeed(float radii) {
        float perRoot = PUSH_GRAVITY * (float) Math.sqrt(0.5f * gravity);
        return Numbers.max(PUSH * 0.5f * radii, perRoot * (float) Math.sqrt(radii));
    }
}
