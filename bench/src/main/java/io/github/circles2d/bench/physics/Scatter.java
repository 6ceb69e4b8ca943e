package io.github.circles2d.bench.physics;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** Puts circles at random places of a rectangle above the origin so that none overlap. */
final class Scatter {
    private static final int TRIES = 100_000;

    private final double width;
    private final double height;
    private final Random random;
    private final double cell;
    private final Map<Long, List<double[]>> taken = new HashMap<>();

    Scatter(double width, double height, Random random) {
        this(width, height, random, 1);
    }

    private Scatter(double width, double height, Random random, double cell) {
        this.width = width;
        this.height = height;
        this.random = random;
        this.cell = cell;
    }

    /** Adds circles of these radii, which are sorted, with density 1: the large ones first, while there is room. */
    void largestFirst(double[] sorted, Arena arena) {
        for (int i = sorted.length - 1; i >= 0; i--) {
            double[] place = place(sorted[i]);
            arena.add(place[0], place[1], sorted[i], Scenery.mass(sorted[i]));
        }
    }

    /** A free place for a circle, which is taken from now on. */
    double[] place(double radius) {
        for (int i = 0; i < TRIES; i++) {
            double x = radius + random.nextDouble() * (width - 2 * radius);
            double y = radius + random.nextDouble() * (height - 2 * radius);
            if (free(x, y, radius)) {
                double[] circle = {x, y, radius};
                forEachCell(circle, key -> taken.computeIfAbsent(key, k -> new ArrayList<>())
                        .add(circle));
                return circle;
            }
        }
        throw new IllegalStateException("no place for a circle of radius " + radius);
    }

    private boolean free(double x, double y, double radius) {
        boolean[] free = {true};
        forEachCell(new double[] {x, y, radius}, key -> {
            for (double[] other : taken.getOrDefault(key, List.of())) {
                free[0] &= Math.hypot(other[0] - x, other[1] - y) >= other[2] + radius;
            }
        });
        return free[0];
    }

    private interface Visitor {
        void cell(long key);
    }

    /** Every cell that the square around a circle meets. */
    private void forEachCell(double[] circle, Visitor visitor) {
        for (long u = (long) ((circle[0] - circle[2]) / cell); u <= (long) ((circle[0] + circle[2]) / cell); u++) {
            for (long v = (long) ((circle[1] - circle[2]) / cell); v <= (long) ((circle[1] + circle[2]) / cell); v++) {
                visitor.cell(u << 32 | v);
            }
        }
    }
}
