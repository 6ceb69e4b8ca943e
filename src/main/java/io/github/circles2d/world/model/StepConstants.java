package io.github.circles2d.world.model;

/** The host computes the constants of a step once, in float, and every back end gets the bits. Rates are by the sum of radii. */
public final class StepConstants {
    /** Seconds. */
    public float dt;

    public int subSteps;

    /** Length of a sub-step, seconds. */
    public float h;

    public float inverseH;

    public float gravityX;

    public float gravityY;

    /** Speed in a sub-step. */
    public float gravityStepX;

    public float gravityStepY;

    /** Gravity's part of a path. */
    public float fallX;

    public float fallY;

    public final Softness contactSoftness = new Softness();

    public final Softness oneBodySoftness = new Softness();

    /** Of rigid joints. */
    public final Softness jointSoftness = new Softness();

    /** Gravity's part of the square of the restitution threshold. */
    public float thresholdRate;

    /** Of the walls across x. */
    public float thresholdRateX;

    public float thresholdRateY;

    /** Threshold without gravity, 1/s. */
    public float restRate;

    public float flightRestRate;

    /** A square in place of these, or 0. */
    public float fixedThreshold;

    /** Greatest push-out speed if not deep, 1/s. */
    public float pushRate;

    /** Gain of push-out speed if deep, 1/s. */
    public float deepRate;

    /** Of the impulses of the step before. */
    public float warmScale;

    /** {@link Bounds#walls} at the end of the step. */
    public Bounds bounds;

    public Bounds arena;

    public final WallMotion walls = new WallMotion();

    /** Whether circles may have a gravity scale, a damping or a greatest speed of their own. */
    public boolean ownMotion;

    /** Whether the step reads {@link StepInput#responses}. */
    public boolean filtering;

    /** Whether the step reads {@link KindMotion}. */
    public boolean driving;

    /** Whether the step reads {@link KindSurface} and {@link #surfaces}: circles turn. */
    public boolean turning;

    public SurfaceSettings surfaces = SurfaceSettings.NONE;

    /** Whether the step reads {@link TerrainStep}: there are pieces. */
    public boolean terrain;

    /** Whether the step reads {@link JointStep}: there are joints. */
    public boolean joints;

    /** Whether there are rigid bodies. */
    public boolean rigid;

    /** Whether circles fall asleep and wake. */
    public boolean sleeping;

    /** In the first step previousDt has no meaning. */
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
        contactSoftness.set(omega, damping, inverseH);
        oneBodySoftness.set(Tuning.WALL_STIFFNESS * omega, damping, inverseH);

        float jointOmega = 2f * 3.14159265f * Math.min(Tuning.JOINT_FREQUENCY * h, Tuning.GREATEST_JOINT_FREQUENCY);
        jointSoftness.set(jointOmega, 2f * Tuning.JOINT_DAMPING, inverseH);

        setThresholds(gravityX, gravityY, contacts.restitutionThreshold());
        pushRate = 0.5f * contacts.pushOutSpeed();
        deepRate = Tuning.DEEP_RATE * (pushRate / Tuning.PUSH);
    }

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

    /** How often a sub-step's gain moves a circle. */
    static float falls(int subSteps) {
        return 0.5f * subSteps * (subSteps + 1);
    }
}
