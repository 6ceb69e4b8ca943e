package io.github.circles2d.world.model;

/** The numbers that the physics was tuned with, all in one place. Changing one changes every recorded state. */
public final class Tuning {
    private Tuning() {}

    /** A pair is listed as a contact from this gap on, in mean radii of the pair, even if nothing moves; half of it here. */
    public static final float MARGIN = 0.025f;

    /** Motion within a step that the speculative distance covers, in radii of the circle that moves; a faster one looks ahead. */
    public static final float CAP = 0.25f;

    /** A circle goes no farther in a step, in its own radii. */
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

    /** Where both circles of a pair have more than this many candidates, only as many are kept of each, about. */
    public static final int CROWD = 32;

    /** A size class joins the level of the next larger class where it has at most this many times as many circles. */
    static final int JOIN = 2;

    /** Damping ratio of a soft contact. */
    static final float DAMPING = 20f;

    /** Frequency of a soft contact, hertz. It does not depend on the length of a step, so nor does the depth of a pile at rest. */
    static final float FREQUENCY = 67f;

    /** The frequency is no higher than this over the length of a sub-step: what is stiffer trembles. */
    static final float GREATEST_FREQUENCY = 0.3f;

    /** Impulses of the step before are multiplied by no more than this, however much longer the step is. */
    static final float GREATEST_WARM_SCALE = 4f;

    /** Walls are stiffer than contacts by this factor. */
    static final float WALL_STIFFNESS = 2f;

    /** Push-out speed up to {@link #DEEP}, in sums of the radii a second: slow, so that what overlaps at once does not burst. */
    static final float PUSH = 0.4f;

    /** Deeper than this, in sums of the radii, the push-out speed grows with the depth, so that no pair stays so. */
    static final float DEEP = 0.2f;

    /** Push-out speed per depth beyond {@link #DEEP}, 1/s. */
    public static final float DEEP_RATE = 15f;

    /** The line of {@link #DEEP_RATE} begins above 0 by so many times the push-out speed: it meets that speed at {@link #DEEP}. */
    public static final float DEEP_OFFSET = DEEP * DEEP_RATE / PUSH - 1f;

    /** Slower impacts do not bounce, in units of sqrt(gravity x mean radius of the pair). */
    static final float BOUNCE_THRESHOLD = 0.4f;

    /** Slower impacts do not bounce, in mean radii of the pair a second; see {@link #NEARLY_ELASTIC}. */
    static final float REST_SPEED = 1f;

    /** From here on to a restitution of 1, at which all impacts bounce, that speed goes down to 0. */
    public static final float NEARLY_ELASTIC = 0.9f;

    /** The same for two circles that nothing carries, where the restitution is 0; at 1 all bounce. */
    static final float FLIGHT_REST_SPEED = 0.1f;

    /** Free elastic circles that overlap are pushed apart if they do not move apart within this time, seconds. */
    public static final float LINGER = 1f;

    /** Centres nearer than this, in sums of radii, count as one point. */
    public static final float COINCIDENT = 1e-6f;

    /** No component of a velocity exceeds this, so that nothing can overflow. */
    public static final float GREATEST_SPEED = 1e9f;
}
