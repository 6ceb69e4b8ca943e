package io.github.circles2d.world.jvm.bodies;

/** The table of a contact of rigid bodies: where its numbers lie in {@link RigidContacts#rows}. */
final class RigidRow {
    /** Floats of a contact. */
    static final int STRIDE = 27;

    /** The normal, from B to A. */
    static final int NX = 0;

    static final int NY = 1;
    static final int GAP = 2;

    // arms
    static final int AX = 3;
    static final int AY = 4;
    static final int BX = 5;
    static final int BY = 6;

    // accumulated impulses: along the normal and the tangent, and the angular one of rolling resistance
    static final int IMPULSE = 7;
    static final int GRIP = 8;
    static final int ROLL = 9;

    /** Within a sub-step: the speed after a bounce. */
    static final int BOUNCE = 10;

    /** Within a step: the greatest impulse. */
    static final int MOST = 11;

    /** Within a step: the greatest speed before an impulse, towards each other. */
    static final int APPROACH = 12;

    // effective masses along the normal and the tangent, since contacts were measured; not with circles
    static final int NORMAL_MASS = 13;
    static final int TANGENT_MASS = 14;

    // what both things have together
    static final int FRICTION = 15;
    static final int ROLLING = 16;
    static final int BELTS = 17;
    static final int RESTITUTION = 18;

    /** Lengths are measured by it. */
    static final int LENGTH = 19;

    /** The square of a speed: slower ones do not bounce. */
    static final int THRESHOLD = 20;

    // terms of a biased visit that does not bounce, since contacts were measured: factors of speed and impulse, and a
    // speed
    static final int SPEED_SCALE = 21;
    static final int DECAY = 22;
    static final int BIAS = 23;

    /** What a visit without bias aims at: to come as near as the gap lets. */
    static final int NEAR = 24;

    /** By how much the base of A lies beyond that of B. */
    static final int OX = 25;

    static final int OY = 26;

    private RigidRow() {}

    static int of(int contact) {
        return STRIDE * contact;
    }
}
