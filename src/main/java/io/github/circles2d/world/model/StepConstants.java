package io.github.circles2d.world.model;

/**
 * The numbers that a step needs. The host computes them once, in float, and every back end gets the bits: no device computes them
 * again, so they cannot differ.
 */
public final class StepConstants {
    /** Length of the step, seconds. */
    public float dt;

    /** Sub-steps a step. */
    public int subSteps;

    /** Length of a sub-step, seconds. */
    public float h;

    /** 1 / length of a sub-step, 1/s. */
    public float inverseH;

    /** Gain of speed in a sub-step. */
    public float gravityStepX;

    /** Gain of speed in a sub-step. */
    public float gravityStepY;

    /** What gravity moves a circle in the sub-steps of a step. */
    public float fallX;

    /** What gravity moves a circle in the sub-steps of a step. */
    public float fallY;

    /** Softness of contacts: push-out speed per depth, 1/s. */
    public float biasRate;

    /** Softness of contacts: share of the impulse of a rigid contact. */
    public float massScale;

    /** Softness of contacts: share of the accumulated impulse that a visit takes away. */
    public float impulseScale;

    /** Softness of walls: push-out speed per depth, 1/s. */
    public float wallBiasRate;

    /** Softness of walls: share of the impulse of a rigid wall. */
    public float wallMassScale;

    /** Softness of walls: share of the accumulated impulse that a visit takes away. */
    public float wallImpulseScale;

    /** Gravity's part of the square of the restitution threshold, per sum of radii. */
    public float thresholdRate;

    /** The same for the left and the right wall, from gravity along x. */
    public float thresholdRateX;

    /** The same for the lower and the upper wall, from gravity along y. */
    public float thresholdRateY;

    /** Threshold per sum of radii without gravity, of pairs that are not nearly elastic, 1/s. */
    public float restRate;

    /** The same, of pairs without restitution that nothing carries, 1/s. */
    public float flightRestRate;

    /** The square of a restitution threshold that does not follow from gravity and radii; else 0. */
    public float fixedThreshold;

    /** Greatest push-out speed of overlaps that are not deep, per sum of radii, 1/s. */
    public float pushRate;

    /** Gain of the push-out speed of deep overlaps, 1/s. */
    public float deepRate;

    /** Factor for the impulses of the step before: the ratio of the two steps' lengths, limited. */
    public float warmScale;

    /** The walls at the end of the step; where there is none, it stands where no circle meets it. */
    public Bounds bounds;

    /** The arena, at the end of the step, with its edges. */
    public Bounds arena;

    /** How its walls move there. */
    public final WallMotion walls = new WallMotion();

    /** Whether the step reads {@link PairResponses}: some pair of kinds is not solid, or some circle has a group. */
    public boolean filtering;

    /** Whether the step reads {@link KindMotion}: some circle may move in another way than gravity alone moves it. */
    public boolean driving;

    float gravityX;
    float gravityY;

    /** No constants, until they are set. */
    public StepConstants() {}

    /**
     * Computes the constants.
     *
     * @param dt length of the step, seconds
     * @param subSteps sub-steps a step
     * @param gravityX gravity
     * @param gravityY gravity
     * @param from where the walls start
     * @param bounds where they are at the end of the step: the arena
     * @param previousDt length of the step before, seconds; without meaning in the first step
     * @param contacts how contacts are
     */
    public void set(
            float dt,
            int subSteps,
            float gravityX,
            float gravityY,
            Bounds from,
            Bounds bounds,
            float previousDt,
            ContactSettings contacts) {
        this.dt = dt;
        this.subSteps = subSteps;
        if (arena != bounds) {
            arena = bounds;
            this.bounds = bounds.walls();
        }
        walls.set(from == bounds ? this.bounds : from.walls(), this.bounds, dt, subSteps);
        h = dt / subSteps;
        inverseH = subSteps / dt;
        gravityStepX = gravityX * h;
        gravityStepY = gravityY * h;
        this.gravityX = gravityX;
        this.gravityY = gravityY;
        fallX = gravityStepX * h * falls(subSteps);
        fallY = gravityStepY * h * falls(subSteps);
        warmScale = Math.min(Tuning.GREATEST_WARM_SCALE, dt / previousDt);

        float omega = 2f * 3.14159265f * Math.min(contacts.frequency() * h, Tuning.GREATEST_FREQUENCY); // times h
        float damping = 2f * contacts.damping();
        biasRate = (omega / (damping + omega)) * inverseH;
        float a2 = omega * (damping + omega);
        impulseScale = 1f / (1f + a2);
        massScale = a2 * impulseScale;

        float wallOmega = Tuning.WALL_STIFFNESS * omega;
        wallBiasRate = (wallOmega / (damping + wallOmega)) * inverseH;
        float wallA2 = wallOmega * (damping + wallOmega);
        wallImpulseScale = 1f / (1f + wallA2);
        wallMassScale = wallA2 * wallImpulseScale;

        setThresholds(gravityX, gravityY, contacts.restitutionThreshold());
        pushRate = 0.5f * contacts.pushOutSpeed();
        deepRate = Tuning.DEEP_RATE * (pushRate / Tuning.PUSH);
    }

    /** A fixed threshold takes the place of all that follows from gravity and radii. */
    private void setThresholds(float gravityX, float gravityY, float fixed) {
        boolean byGravity = fixed == ContactSettings.BY_GRAVITY;
        float half = byGravity ? Tuning.BOUNCE_THRESHOLD * Tuning.BOUNCE_THRESHOLD * 0.5f : 0f;
        thresholdRate = half * CircleMath.length(gravityX, gravityY);
        thresholdRateX = half * Math.abs(gravityX);
        thresholdRateY = half * Math.abs(gravityY);
        restRate = byGravity ? Tuning.REST_SPEED * 0.5f : 0f;
        flightRestRate = byGravity ? Tuning.FLIGHT_REST_SPEED * 0.5f : 0f;
        fixedThreshold = byGravity ? 0f : fixed * fixed;
    }

    /** How many times the gain of speed of a sub-step moves a circle in the sub-steps of a step. */
    static float falls(int subSteps) {
        return 0.5f * subSteps * (subSteps + 1);
    }
}
