package io.github.circles2d.world.jvm.bodies;

import java.util.Arrays;

/** The {@link RigidThing things} of a step. The first ones are the bodies, in the order of their ids. */
final class RigidThings {
    RigidThing[] all = {};
    int count;
    int bodies;

    /** Forgets the things from a number on, which have been added last. */
    void truncate(int from) {
        count = Math.min(count, from);
    }

    /** One more thing without corners and lines, at rest and unturned. */
    RigidThing add(int type, int id, float x, float y) {
        if (count == all.length) {
            RigidThing[] grown = Arrays.copyOf(all, Math.max(64, 2 * count));
            for (int t = count; t < grown.length; t++) {
                grown[t] = new RigidThing(t);
            }
            all = grown;
        }
        RigidThing t = all[count++];
        t.begin(type, id, x, y);
        return t;
    }

    long bytes() {
        long sum = 0;
        for (RigidThing each : all) {
            sum += each.bytes();
        }
        return sum;
    }
}
