package io.github.circles2d.world.model;

/** The numbers that the physics was tuned with. Changing one changes every recorded state. */
public final class Tuning {
    private Tuning() {}

    /** Half of the gap from which on a pair is a contact, in mean radii. */
    public static final float MARGIN = 0.025f;

    /** Motion that the speculative distance covers, in radii. */
    public static final float CAP = 0.25f;

    /** The longest path of a circle that is not static, in radii. */
    public static final float TRAVEL = 64f;

    /** Fast circles do not look out for others so much smaller, unless those are static. */
    public static final float SWEEP_RATIO = 16f;

    /** How far a collision may lead a circle off its path, in radii. */
    public static final float CLAMP_ALLOWANCE = 0.5f;

    /** Nearer to a circle that it will touch, in sums of radii, a fast one does not stop: their contact has it. */
    public static final float HOLD = 0.075f;

    /** What is left of its allowance to a circle at a static one, unless it flies back. */
    public static final float ASIDE = 0.1f;

    /** Circles that graze no deeper do not stop each other, in sums of radii. */
    public static final float GRAZE = 0.01f;

    /** The allowance of a circle that a static one pushes: it goes to the end of its free path. */
    public static final float CARRIED = Float.NEGATIVE_INFINITY;

    /** A static circle leaves circles to their contact unless so deep in them, in their radii. */
    public static final float RUN_OVER = 0.75f;

    /** If both circles of a pair have more candidates, about so many of each are kept. */
    public static final int CROWD = 60;

    /** A size class with at most so many times the circles of the next larger joins its level. */
    static final int JOIN = 2;

    /** A ratio. Overdamped contacts do not swing. */
    static final float DAMPING = 20f;

    /** Hertz: the same for every step, and so is the depth of a pile at rest. */
    static final float FREQUENCY = 67f;

    /** Times the length of a sub-step. Stiffer contacts tremble. */
    static final float GREATEST_FREQUENCY = 0.3f;

    static final float GREATEST_WARM_SCALE = 4f;

    /** In frequencies of a contact. */
    static final float WALL_STIFFNESS = 2f;

    /**
     * Greatest push-out speed up to {@link #DEEP}, in sums of radii a second. Slow, so that a pile that overlaps does not burst.
     */
    static final float PUSH = 0.4f;

    /** From this depth on, in sums of radii, the push-out speed grows again. */
    static final float DEEP = 0.2f;

    /** Its gain, 1/s. */
    public static final float DEEP_RATE = 15f;

    /** Makes it continuous: {@code DEEP_RATE * depth - DEEP_OFFSET * PUSH * sum}. */
    public static final float DEEP_OFFSET = DEEP * DEEP_RATE / PUSH - 1f;

    /** Gravity's part of the restitution threshold, in sqrt(gravity * mean radius). */
    static final float BOUNCE_THRESHOLD = 0.4f;

    /** The other part, in mean radii a second. */
    static final float REST_SPEED = 1f;

    /** From this restitution on both go down, to 0 at 1. */
    public static final float NEARLY_ELASTIC = 0.9f;

    /** As {@link #REST_SPEED}, of two circles that nothing carries; goes down evenly from restitution 0. */
    static final float FLIGHT_REST_SPEED = 0.1f;

    /**
     * Deeper surfaces of circles that are carried do not bounce, in push-out speeds: else push-out would count as impacts for ever.
     */
    public static final float BOUNCE_DEPTH = 0.01f / PUSH;

    /** Free circles that overlap are pushed out if they do not part in this time, seconds. */
    public static final float LINGER = 1f;

    /** Centres nearer than this, in sums of radii, count as one point. */
    public static final float COINCIDENT = 1e-6f;

    /** Of a component; nothing can overflow. */
    public static final float GREATEST_SPEED = 1e9f;
}
