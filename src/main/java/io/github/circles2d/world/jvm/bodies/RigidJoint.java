package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.jvm.state.State;

/** A joint that holds rigid bodies, in a step. */
final class RigidJoint {
    int id;
    final RigidJointEnd a;
    final RigidJointEnd b;

    // from the base of A to that of B
    float baseX;
    float baseY;

    // from A to B, as measured last
    float normalX;
    float normalY;
    float distance;

    /** The greatest speed by which it corrects where its ends are. */
    float push;

    RigidJoint(State state, RigidPairs pairs) {
        a = new RigidJointEnd(state, pairs, 0);
        b = new RigidJointEnd(state, pairs, 1);
    }
}
