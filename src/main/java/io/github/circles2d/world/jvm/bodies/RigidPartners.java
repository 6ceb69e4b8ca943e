package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.jvm.state.HeapSort;
import java.util.Arrays;

/** Pairs of a rigid body with another one, or with a circle, that do not collide. */
final class RigidPartners {
    private static final int CIRCLES_SHIFT = 62;
    private static final int A_SHIFT = 32;

    /** Ascending once all are in. */
    private long[] keys = new long[0];

    private int count;

    void clear() {
        count = 0;
    }

    /** Two bodies. */
    void addBodies(int body, int other) {
        add(key(RigidStep.BODY_BODY, Math.min(body, other), Math.max(body, other)));
    }

    void addCircle(int body, int circle) {
        add(key(RigidStep.BODY_CIRCLE, body, circle));
    }

    private void add(long key) {
        if (count == keys.length) {
            keys = Arrays.copyOf(keys, Math.max(16, 2 * count));
        }
        keys[count++] = key;
    }

    /** All are in. */
    void sort() {
        HeapSort.ascending(keys, count);
    }

    /** Whether a body and something of a type of {@link RigidStep}, of two bodies that of the higher id, do not collide. */
    boolean has(int type, int body, int other) {
        return count > 0 && Arrays.binarySearch(keys, 0, count, key(type, body, other)) >= 0;
    }

    private static long key(int type, int body, int other) {
        boolean mayBe = type == RigidStep.BODY_BODY || type == RigidStep.BODY_CIRCLE;
        long high = mayBe ? (long) (type == RigidStep.BODY_CIRCLE ? 1 : 0) << CIRCLES_SHIFT : -1L << CIRCLES_SHIFT;
        return high | (long) body << A_SHIFT | other;
    }

    long bytes() {
        return 8L * keys.length;
    }
}
