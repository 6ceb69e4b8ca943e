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

    /** Whether pairs have to be filtered: whether some pair of kinds is not solid, or some circle has a group. */
    public boolean filtering;

    /** By pair of kinds, what their circles do to each other: a table of {@link PairTable}. */
    public int[] responses;

    /** Counts the changes of the kinds. */
    public int kindsVersion;

    /** Whether any circle may move in another way than gravity alone moves it: by its kind, or by a force. */
    public boolean driving;

    /** By kind: what moves its circles, by {@link KindMotion}. */
    public final float[] kindMotion = new float[KindMotion.of(PairTable.KINDS)];

    /** Counts the changes of {@link #kindMotion}. */
    public int motionVersion;

    /** Whether what contacts or walls do is reported. */
    public boolean recording;

    /** Whether some pairs that are only sensed are reported. */
    public boolean sensing;

    /** By pair of kinds, which of two circles looks for the other, if the pair is sensed and reported: by {@link SensorRule}. */
    public int[] seeking;

    /** Counts the changes of {@link #seeking}. */
    public int seekingVersion;

    private float gravityX;
    private float gravityY;

    /** What {@link #kindMotion} has been computed from, besides the kinds. */
    private float motionDt;

    private int motionSubSteps;
    private float motionGravityX;
    private float motionGravityY;
    private int motionKinds = -1;

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
        thresholdRate = half * CircleMath.norm(gravityX, gravityY);
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

    /**
     * Sets how circles move by their kinds; after {@link #set} and {@link #setPairs}.
     *
     * @param drives whether any circle may move by its kind or a force
     * @param kinds the values of the kinds
     */
    public void setMotion(boolean drives, KindValues kinds) {
        driving = drives;
        if (!drives
                || motionKinds == kindsVersion
                        && motionDt == dt
                        && motionSubSteps == subSteps
                        && Float.floatToRawIntBits(motionGravityX) == Float.floatToRawIntBits(gravityX)
                        && Float.floatToRawIntBits(motionGravityY) == Float.floatToRawIntBits(gravityY)) {
            return;
        }
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            KindMotion.set(
                    kindMotion,
                    kind,
                    this,
                    gravityX,
                    gravityY,
                    kinds.gravityScale(kind),
                    kinds.damping(kind),
                    kinds.greatestSpeed(kind));
        }
        motionDt = dt;
        motionSubSteps = subSteps;
        motionGravityX = gravityX;
        motionGravityY = gravityY;
        motionKinds = kindsVersion;
        motionVersion++;
    }

    /** What the kinds say of the motion of their circles. */
    public interface KindValues {
        /** What gravity is multiplied by. */
        float gravityScale(int kind);

        /** Damping, 1/s. */
        float damping(int kind);

        /** Greatest speed, which may be infinite. */
        float greatestSpeed(int kind);
    }

    /**
     * Sets what filters pairs.
     *
     * @param filters whether any pair may be filtered
     * @param table by pair of kinds, what their circles do to each other; read during the step
     * @param version counts the changes of the table
     */
    public void setPairs(boolean filters, int[] table, int version) {
        filtering = filters;
        responses = table;
        kindsVersion = version;
    }

    /**
     * Sets what of the step is reported. It changes nothing in it.
     *
     * @param records whether what contacts or walls do is reported
     * @param senses whether pairs that are only sensed are
     * @param table by pair of kinds, which circle looks for the other; read during the step
     * @param version counts the changes of the table
     */
    public void setReports(boolean records, boolean senses, int[] table, int version) {
        recording = records;
        sensing = senses;
        seeking = table;
        seekingVersion = version;
    }
}
