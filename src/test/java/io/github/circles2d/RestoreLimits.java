package io.github.circles2d;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Restores that lack memory, and are made again some steps later: steps exchange arrays of which only one may have grown. {@code
 * AllocationLimitLoader} loads it, so that the library asks {@link AllocationLimit}.
 */
public final class RestoreLimits {
    private static final float DT = 1 / 60f;

    private RestoreLimits() {}

    /** Ends memory at each allocation. Returns what is wrong. */
    public static List<String> restore(int stepsBetween) {
        List<String> wrong = new ArrayList<>();
        restore(300, 0, false, 300, 0.5f, stepsBetween, wrong);
        restore(40, 0, true, 900, 0, stepsBetween, wrong);
        return wrong;
    }

    private static void restore(
            int circles, float friction, boolean terrain, int more, float grip, int between, List<String> wrong) {
        ByteBuffer snapshot = snapshot(more, grip, terrain);
        boolean lacks = true;
        for (int allocations = 0; lacks; allocations++) {
            try (World world = world(circles, friction, terrain)) {
                AllocationLimit.onceAfter(allocations);
                lacks = lacksMemory(world, snapshot);
                AllocationLimit.end();
                try {
                    world.step(DT, between);
                    world.restore(snapshot.duplicate());
                    world.step(DT, 3);
                } catch (RuntimeException e) {
                    wrong.add(allocations + " allocations: " + e);
                }
            }
        }
    }

    private static boolean lacksMemory(World world, ByteBuffer snapshot) {
        try {
            world.restore(snapshot.duplicate());
            return false;
        } catch (OutOfMemoryError e) {
            return true;
        }
    }

    private static ByteBuffer snapshot(int circles, float friction, boolean terrain) {
        try (World world = world(circles, friction, terrain)) {
            ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(snapshot);
            return snapshot.flip();
        }
    }

    private static World world(int circles, float friction, boolean terrain) {
        World world = World.builder()
                .bounds(0, 0, 20, 20)
                .gravity(0, -10)
                .friction(friction)
                .backend(Backend.JVM)
                .threads(1)
                .capacity(50)
                .build();
        if (terrain) {
            world.terrain().addSegment(0, 1, 20, 2);
        }
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < circles; k++) {
            world.add(1 + 18 * (float) random.nextDouble(), 3 + 16 * (float) random.nextDouble(), 0.1f, 1);
        }
        world.step(DT, 20);
        return world;
    }
}
