package io.github.circles2d;

import io.github.circles2d.world.circles.KindTable;
import java.util.Arrays;

/**
 * The circles and joints that {@link Ropes} and {@link Blobs} have added to a world. They are the world's, as any others: they are removed, changed
 * and asked by their handles.
 *
 * @param circles the handles of the circles, in the order that the call says
 * @param joints the handles of the joints, likewise
 */
public record JointedCircles(long[] circles, long[] joints) {

    /** Adds circles at rest of one kind, and makes room for the handles of so many joints. */
    static JointedCircles add(World world, float[] circles, int kind, int joints) {
        int count = circles.length / 4;
        int[] kinds = null;
        if (KindTable.check(kind) != 0) {
            kinds = new int[count];
            Arrays.fill(kinds, kind);
        }
        JointedCircles made = new JointedCircles(new long[count], new long[joints]);
        world.addAll(circles, null, kinds, made.circles);
        return made;
    }
}
