package io.github.circles2d;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Arrays;

/**
 * Measures steps in which one circle has very many pairs that report. Arguments: a back end, then numbers of circles. Prints, for each
 * number, how long a step takes if a sensor over all circles, or a boulder on them, has the lowest id, and if it has the highest;
 * and how long it takes for each pair of a crowd of sensors in one point.
 */
final class ManyPairsOfOne {
    private static final int ALL = Events.BEGIN | Events.HIT | Events.END | Events.WALL;
    private static final int SENSOR = 1;
    private static final float DT = 1 / 60f;
    private static final int STEPS = 4;
    private static final int ROUNDS = 11;

    private ManyPairsOfOne() {}

    public static void main(String[] args) {
        Backend backend = Backend.valueOf(args[0]);
        for (int k = 1; k < args.length; k++) {
            int circles = Integer.parseInt(args[k]);
            if (circles > 1000) {
                print(
                        "a sensor over",
                        circles,
                        of(() -> sensor(backend, circles, true), () -> sensor(backend, circles, false)));
                print(
                        "a boulder on",
                        circles,
                        of(() -> boulder(backend, circles, true), () -> boulder(backend, circles, false)));
            } else {
                crowd(backend, circles);
            }
        }
    }

    private static void print(String what, int circles, Times times) {
        System.out.printf(
                "%s %d: lowest id %.3f ms a step, highest %.3f, ratio %.2f%n",
                what, circles, times.lowest, times.highest, times.ratio());
    }

    private static void crowd(Backend backend, int circles) {
        double pairs = circles * (circles - 1) / 2.0;
        try (World world = crowdOf(backend, circles)) {
            double first = time(world, 1);
            double[] rounds = new double[ROUNDS];
            for (int round = 0; round < ROUNDS; round++) {
                rounds[round] = time(world, STEPS);
            }
            System.out.printf(
                    "%d sensors in one point: %.1f ns a step and pair, first step %.1f ns a pair%n",
                    circles, 1e6 * median(rounds) / pairs, 1e6 * first / pairs);
        }
    }

    private static World crowdOf(Backend backend, int circles) {
        World world = World.builder().bounds(0, 0, 100, 100).backend(backend).build();
        world.setResponse(SENSOR, SENSOR, Response.SENSE);
        world.report(ALL);
        for (int k = 0; k < circles; k++) {
            world.add(50, 50, 0.5f, 1, 0, 0, SENSOR);
        }
        return world;
    }

    /** The median times of a step, interleaved, of which two worlds take the same. */
    static Times ofSensor(Backend backend, int circles) {
        return of(() -> sensor(backend, circles, true), () -> sensor(backend, circles, false));
    }

    private static Times of(Maker lowest, Maker highest) {
        try (World first = lowest.make();
                World last = highest.make()) {
            double[][] rounds = new double[2][ROUNDS];
            for (int round = -3; round < ROUNDS; round++) {
                double ofFirst = time(first, STEPS);
                double ofLast = time(last, STEPS);
                if (round >= 0) {
                    rounds[0][round] = ofFirst;
                    rounds[1][round] = ofLast;
                }
            }
            return new Times(median(rounds[0]), median(rounds[1]));
        }
    }

    private static double median(double[] values) {
        Arrays.sort(values);
        return values[values.length / 2];
    }

    /** Milliseconds of a step and of taking its events. */
    private static double time(World world, int steps) {
        long from = System.nanoTime();
        for (int k = 0; k < steps; k++) {
            world.step(DT);
            world.events();
        }
        return 1e-6 * (System.nanoTime() - from) / steps;
    }

    /** A static sensor over circles at rest. */
    private static World sensor(Backend backend, int circles, boolean isFirst) {
        int columns = (int) Math.ceil(Math.sqrt(circles));
        float side = 1.05f * columns;
        World world = World.builder()
                .bounds(-side, -side, 2 * side, 2 * side)
                .backend(backend)
                .build();
        world.kind(SENSOR).setSensor(true);
        world.report(ALL);
        for (int k = 0; k <= circles; k++) {
            if (k == (isFirst ? 0 : circles)) {
                world.add(side / 2, side / 2, 0.75f * side, Float.POSITIVE_INFINITY, 0, 0, SENSOR);
            }
            if (k < circles) {
                world.add(0.5f + 1.05f * (k % columns), 0.5f + 1.05f * (k / columns), 0.5f, 1);
            }
        }
        return world;
    }

    private static World boulder(Backend backend, int circles, boolean isFirst) {
        Scene scene = Scenes.boulder(circles + 1, 1);
        World world = WorldScenes.builder(scene).backend(backend).build();
        world.report(ALL);
        for (int k = 0; k <= circles; k++) {
            int circle = isFirst ? k : circles - k;
            world.add(scene.x(circle), scene.y(circle), scene.radius(circle), scene.mass(circle));
        }
        return world;
    }

    /** Makes a world. */
    private interface Maker {
        World make();
    }

    /** Milliseconds of a step. */
    record Times(double lowest, double highest) {
        double ratio() {
            return lowest / highest;
        }
    }
}
