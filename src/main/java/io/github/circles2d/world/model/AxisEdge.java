package io.github.circles2d.world.model;

/** The ends of an axis. The ordinals are in snapshots, in the hash and in kernels. */
public enum AxisEdge {
    WALL,

    /** Circles go on. */
    OPEN,

    /** What leaves on one side comes in on the other. */
    WRAP
}
