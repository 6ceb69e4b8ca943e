package io.github.circles2d;

import io.github.circles2d.world.changes.Net;
import io.github.circles2d.world.circles.KindTable;

/**
 * The circles and joints that {@link Ropes} and {@link Blobs} have added to a world. They are the world's, as any others: they are removed, changed
 * and asked by their handles.
 *
 * @param circles the handles of the circles, in the order that the call says
 * @param joints the handles of the joints, likewise
 */
public record JointedCircles(long[] circles, long[] joints) {

    /** Begins circles at rest of one kind, which so many joints are to hold. */
    static Net net(float[] circles, int kind, int joints) {
        return new Net(circles, KindTable.check(kind), joints);
    }

    /** Adds circles and their joints, all or nothing. */
    static JointedCircles add(World world, Net net) {
        JointedCircles made = new JointedCircles(new long[net.size()], new long[net.joints()]);
        world.simulation().nets.add(net, made.circles, made.joints);
        return made;
    }
}
