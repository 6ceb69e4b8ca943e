package io.github.circles2d;

/**
 * The two ends of an axis of a world; see {@link World.Builder#edges}.
 *
 * <p><img src="doc-files/edges.svg" alt="Three axes: walls keep a circle inside, an open end lets it go on, and a circle at a seam is on both sides">
 */
public enum Edge {
    /** Walls, which keep the circles in. */
    WALL,

    /** Nothing: circles go on beyond the bounds, up to coordinates of 1e9 in magnitude. */
    OPEN,

    /** Each other: a circle that leaves on one side comes in on the other, and circles meet across the seam. */
    WRAP
}
