package io.github.circles2d.world.model;

/**
 * The joints as a step begins. Meaningless unless {@link StepConstants#joints}. The arrays belong to the host's tables, which change them between
 * steps; those that devices copy say by a version whether they have changed.
 *
 * <p>Joints of one colour share no circle. A pass visits joints colour by colour. Joints of hubs, and those that found no colour, are <em>split</em>, and come last.
 * Joints that circles connect are a component. Several small components are a batch, which one worker visits, colour by colour, without waiting for
 * others; the rest is visited by all workers, with a barrier behind each colour.
 */
public final class JointStep {
    /** Of a circle: no two of its joints have one colour. Joints beyond are split. */
    public static final int COLOURS = 24;

    /**
     * The most joints of a circle with other ones that have colours. A circle with more is a hub: all of these are split, for visited by turns, many
     * heavy circles throw a light one about until all burst.
     */
    public static final int HUB = 10;

    /** Elements of {@link #starts} of a batch. */
    public static final int BATCH_STRIDE = COLOURS + 1;

    /** The most joints of a batch. */
    public static final int BATCH = 512;

    /** Greatest id of a joint, and 1. */
    public int joints;

    /** {@link JointRow} */
    public float[] rows = new float[0];

    /** {@link JointRow#TRAITS} */
    public int[] traits = new int[0];

    /** Of rows and traits. */
    public int version;

    /** The joints whose rows and traits differ from those of the version before: from the first to before the last. */
    public int changedFrom;

    public int changedTo;

    /** Ids of joints: batch by batch, then those that are in none; in each by colour, then by id. Then the split joints by id. */
    public int[] order = new int[0];

    /** Joints in {@link #order}. */
    public int count;

    public int batches;

    /**
     * Of each batch, and behind them of the joints that are in none: where in {@link #order} each colour begins, and where the last one ends.
     */
    public int[] starts = new int[BATCH_STRIDE];

    /** Colours in use. */
    public int colours;

    /** The first split joint in {@link #order}. */
    public int splitStart;

    /** Circles of split joints. */
    public int splitCircles;

    /** By number: ids of these circles, ascending. */
    public int[] splitIds = new int[0];

    /** Of each split joint, in order: the numbers of A and B, or -1. */
    public int[] splitEnds = new int[0];

    /** Ids of the joints that hold bodies that are pushed, ascending. No other order has them. */
    public int[] rigidOrder = new int[0];

    public int rigidCount;

    /** Two elements a joint: the ids of the bodies at A and at B, or {@link JointRow#NONE}. */
    public int[] rigidBodies = new int[0];

    /** Four elements a joint: x and y of its points on these bodies, from the centroid, in the body's coordinates. */
    public float[] rigidPoints = new float[0];

    /** Of order, starts and split circles. */
    public int orderVersion;

    /** {@link JointSpring#STRIDE} floats a row; row 0 is of no spring. */
    public float[] springs = new float[JointSpring.STRIDE];

    /** Rows of springs. */
    public int springCount;

    public int springsVersion;

    /** {@link AnchorRow}; row 0 always. */
    public float[] anchors = new float[0];

    /** Rows of anchors. */
    public int anchorCount;

    public int anchorsVersion;

    /** Ids of circles that {@link #partnerStart} knows. */
    public int partnered;

    /** By id of a circle, and one more: where its partners begin, with which it does not collide. */
    public int[] partnerStart = new int[1];

    /** By partner: the id of the other circle, and the id of the joint, which may have broken. */
    public int[] partners = new int[0];

    public int partnersVersion;

    /** Whether any joint keeps two circles from colliding. */
    public boolean parts;

    /** Whether any joint may break. */
    public boolean breakable;

    /** Whether any joint turns circles. */
    public boolean turns;

    /** Whether a joint is split. */
    public boolean splits() {
        return splitStart < count;
    }
}
