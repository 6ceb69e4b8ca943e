package io.github.circles2d.world.model;

/** The numbers that the physics was tuned with, all in one place. Changing one changes every recorded state. */
public final class Tuning {
    private Tuning() {}

    /** A pair is listed as a contact from this gap on, in mean radii of the pair, even if nothing moves; half of it here. */
    public static final float MARGIN = 0.025f;

    /** Motion within a step that the speculative distance covers, in radii of the circle that moves; a faster one looks ahead. */
    public static final float CAP = 0.25f;

    /** A circle that is not static goes no farther in a step by itself, in its own radii. */
    public static final float TRAVEL = 64f;

    /** Fast circles do not look out for others that are this many times smaller, unless those are static. */
    public static final float SWEEP_RATIO = 16f;

    /** How far a collision may lead a circle away from its path in the same step, in its own radii. */
    public static final float CLAMP_ALLOWANCE = 0.5f;

    /** A fast circle nearer than this to one that it will touch, in sums of radii, does not stop there: their contact has it. */
    public static final float HOLD = 0.075f;

    /** What is left of its allowance to a circle that stands at a static one, unless it flies back. */
    public static final float ASIDE = 0.1f;

    /** Circles that would graze each other no deeper than this do not stop each other, in sums of radii. */
    public static final float GRAZE = 0.01f;

    /** The allowance of a circle that a static one pushes along: it goes to the end of its free path, whatever its velocity. */
    public static final float CARRIED = Float.NEGATIVE_INFINITY;

    /** A static circle that moves leaves circles to their contact unless it would be so deep in them, in radii of theirs. */
    public static final float RUN_OVER = 0.75f;

    /** Where both circles of a pair have more than this many candidates, only as many are kept of each, about. */
    public static final int CROWD = 60;

    /** A size class joins the level of the next larger class where it has at most this many times as many circles. */
    static final int JOIN = 2;

    /** Damping ratio of a soft contact. It is overdamped, so it does not swing. */
    static final float DAMPING = 20f;

    /** Frequency of a soft contact, hertz: the same for every step, so that the depth of a pile at rest is, too. */
    static final float FREQUENCY = 67f;

    /** The frequency times the length of a sub-step is at most this. Stiffer contacts tremble. */
    static final float GREATEST_FREQUENCY = 0.3f;

    /** Greatest ratio of the lengths of two steps by which the impulses of the first are scaled for the second. */
    static final float GREATEST_WARM_SCALE = 4f;

    /** Frequency of a wall, in frequencies of a contact. */
    static final float WALL_STIFFNESS = 2f;

    /**
     * Greatest push-out speed up to a depth of {@link #DEEP}, in sums of the radii a second. It is slow, so that a pile of which many
     * pairs overlap at once does not burst.
     */
    static final float PUSH = 0.4f;

    /** Beyond this depth, in sums of the radii, the push-out speed grows again, so that no pair stays deep. */
    static final float DEEP = 0.2f;

    /** Gain of the push-out speed per depth beyond {@link #DEEP}, 1/s. */
    public static final float DEEP_RATE = 15f;

    /**
     * Beyond {@link #DEEP} the push-out speed is {@code DEEP_RATE * depth - DEEP_OFFSET * PUSH * sum of the radii}. With this offset it
     * is {@link #PUSH} sums of the radii a second at {@link #DEEP}.
     */
    public static final float DEEP_OFFSET = DEEP * DEEP_RATE / PUSH - 1f;

    /** Gravity's part of the speed up to which impacts do not bounce, in units of sqrt(gravity * mean radius of the pair). */
    static final float BOUNCE_THRESHOLD = 0.4f;

    /** The other part of that speed, in mean radii of the pair a second, up to a restitution of {@link #NEARLY_ELASTIC}. */
    static final float REST_SPEED = 1f;

    /** From this restitution on, both parts of that speed go down, to 0 at a restitution of 1. */
    public static final float NEARLY_ELASTIC = 0.9f;

    /**
     * As {@link #REST_SPEED}, but for two circles that nothing carries and for a restitution of 0. It goes down evenly to 0 at a
     * restitution of 1.
     */
    static final float FLIGHT_REST_SPEED = 0.1f;

    /**
     * Surfaces that overlap by more than this do not bounce if something carries one of the circles, in units of the push-out speed:
     * this is 0.01 sums of the radii. In a crowd without room, push-out speeds would else count as impacts for ever.
     */
    public static final float BOUNCE_DEPTH = 0.01f / PUSH;

    /** Circles in free flight that overlap are pushed out if they would not part by themselves within this time, seconds. */
    public static final float LINGER = 1f;

    /** Centres nearer than this, in sums of radii, count as one point. */
    public static final float COINCIDENT = 1e-6f;

    /** No component of a velocity exceeds this, so that nothing can overflow. */
    public static final float GREATEST_SPEED = 1e9f;
}
