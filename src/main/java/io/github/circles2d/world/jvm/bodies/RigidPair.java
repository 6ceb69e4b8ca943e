package io.github.circles2d.world.jvm.bodies;

/** A body, A, and something near to it, B, in a step. */
final class RigidPair {
    RigidThing a;
    RigidThing b;

    // by how much the base of A lies beyond that of B
    float ox;
    float oy;

    /** How near both may have contacts. */
    float margin;

    // its contacts of the step before
    int firstOld;
    int endOld;

    // its contacts, by their numbers among all
    int begin;
    int end;

    /** By which {@link RigidOrder} spreads pairs. */
    int hash;

    /** The colour by which it is visited, unless B is a circle. */
    int colour;

    /** Whether it may bounce in the sub-step, or be a hit. */
    boolean mayBounce;

    /** How far the place of A is from that of B. */
    float x() {
        return ox + (a.dx - b.dx);
    }

    float y() {
        return oy + (a.dy - b.dy);
    }
}
