package io.github.circles2d.world.model;

/** What there is at the two ends of an axis. The ordinals are in snapshots, in the hash and in kernels. */
public enum AxisEdge {
    /** A wall at each end. */
    WALL,

    /** Nothing: circles go on. Cells are numbered from coordinate 0 on, in both directions. */
    OPEN,

    /** The other end: what leaves on one side comes in on the other. */
    WRAP
}
