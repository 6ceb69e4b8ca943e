package io.github.circles2d.world.model;

/** Ordinals are in snapshots, the hash and kernels. */
public enum AxisEdge {
    WALL,

    /** Circles go on. */
    OPEN,

    /** What leaves on one side comes in on the other. */
    WRAP
}
