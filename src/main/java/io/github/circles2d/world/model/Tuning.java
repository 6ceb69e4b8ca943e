package io.github.circles2d.world.model;

/** The numbers that the physics was tuned with: a change of one changes all recorded states. A sum is that of the radii of a pair. */
public final class Tuning {
    private Tuning() {}

    /** Half of the greatest gap of a contact, in mean radii. */
    public static final float MARGIN = 0.025f;

    /** Motion that the speculative distance covers, in radii. */
    public static final float CAP = 0.25f;

    /** The longest path, in radii. */
    public static final float TRAVEL = 64f;

    /** Fast circles do not stop at others so much smaller, unless static. */
    public static final float SWEEP_RATIO = 16f;

    /** How far a collision may lead a circle off its path, in radii. */
    public static final float CLAMP_ALLOWANCE = 0.5f;

    /** So near, in sums, a fast circle does not stop: the contact has it. */
    public static final float HOLD = 0.075f;

    /** What a hit does not give back of a path, in radii, from which on it is dull: circles that it leaves together must get equally far. */
    public static final float DULL = 0.1f;

    /** Share of its allowance that a circle at a static one keeps, unless it flies back. */
    public static final float ASIDE = 0.1f;

    /** Circles that graze no deeper do not stop each other, in sums; of two that are free, in diameters of the smaller one. */
    public static final float GRAZE = 0.01f;

    /** A free vertex of terrain no higher over the face of another piece is no constraint, in radii. */
    public static final float COVER = 0.02f;

    /** The same of a vertex at a joint of a chain, which is as exact as its points. */
    public static final float FLUSH = 0.002f;

    /** How far coordinates of terrain may be off by rounding, in shares of them. */
    public static final float ROUNDED = 0x1p-22f;

    /** A circle so deep in a piece of terrain keeps no impulse of it, in radii: between pieces that jam it impulses would grow for ever. */
    public static final float JAMMED = 0.01f;

    /** How far a line of terrain goes on beyond a concave joint, in radii. */
    public static final float CORNER = 0.5f;

    /** The allowance of a pushed circle, which goes to the end of its free path. */
    public static final float CARRIED = Float.NEGATIVE_INFINITY;

    /** If less deep, in radii of the other, a static circle leaves it to the contact. */
    public static final float RUN_OVER = 0.75f;

    /** Of more candidates, about so many are kept. */
    public static final int CROWD = 60;

    /** A size class with at most so many times the circles of the next larger joins its level. */
    static final int JOIN = 2;

    /** A ratio: overdamped contacts do not swing. */
    static final float DAMPING = 20f;

    /** Hertz, whatever the step, so the depth of a pile at rest is always the same. */
    static final float FREQUENCY = 67f;

    /** Times the length of a sub-step; stiffer contacts tremble. */
    static final float GREATEST_FREQUENCY = 0.3f;

    static final float GREATEST_WARM_SCALE = 4f;

    /** In frequencies of a contact. */
    static final float WALL_STIFFNESS = 2f;

    /** Hertz, of rigid joints. */
    static final float JOINT_FREQUENCY = 60f;

    /** Times the length of a sub-step; of longer chains with heavy ends, stiffer joints burst. */
    static final float GREATEST_JOINT_FREQUENCY = 0.25f;

    /** A ratio. */
    static final float JOINT_DAMPING = 2f;

    /** Greatest speed by which a joint corrects, in radii a sub-step: less than {@link #CAP}, so that it leads nothing through terrain or stops it there. */
    public static final float JOINT_PUSH = 0.2f;

    /** In radii; joints of balls that hang and swing are nearer to their lengths. */
    public static final float JOINT_STRAIN = 0.1f;

    /** Greatest push-out speed up to {@link #DEEP}, in sums a second. */
    static final float PUSH = 0.4f;

    /** In sums. */
    static final float DEEP = 0.2f;

    /** Gain of push-out speed from {@link #DEEP} on, 1/s. */
    public static final float DEEP_RATE = 15f;

    /** Makes {@code DEEP_RATE * depth - DEEP_OFFSET * PUSH * sum} continuous. */
    public static final float DEEP_OFFSET = DEEP * DEEP_RATE / PUSH - 1f;

    /** Gravity's part of the restitution threshold, in sqrt(gravity * mean radius). */
    static final float BOUNCE_THRESHOLD = 0.4f;

    /** The other part, in mean radii a second. */
    static final float REST_SPEED = 1f;

    /** From this restitution on both fall, to 0 at 1. */
    public static final float NEARLY_ELASTIC = 0.9f;

    /** The same in free flight; falls evenly from restitution 0. */
    static final float FLIGHT_REST_SPEED = 0.1f;

    /** In push-out speeds. Carried circles that are deeper do not bounce, or push-out would count as impacts for ever. */
    public static final float BOUNCE_DEPTH = 0.01f / PUSH;

    /** Seconds in which free circles may part by themselves. */
    public static final float LINGER = 1f;

    /** Nearer centres count as one point, in sums. */
    public static final float COINCIDENT = 1e-6f;

    /** Of a component, so that nothing overflows. */
    public static final float GREATEST_SPEED = 1e9f;
}
