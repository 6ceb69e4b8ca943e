package io.github.circles2d.bench.broadphase;

import io.github.circles2d.World;
import io.github.circles2d.WorldStats;
import java.util.Map;

/** Where the circles of a scene are in consecutive steps of World: what every broad phase is given. */
final class Track {
    /** A circle looks for others this much beyond its radius: about as far as World does. */
    static final float REACH = 1.1f;

    private static final float TIME_STEP = 1 / 60f;

    /** Radius times {@link #REACH}. */
    final float[] reach;

    /** By step and circle. */
    final float[][] x;

    /** By step and circle. */
    final float[][] y;

    /** Mean length of what a circle moves in a step, in mean radii. */
    final double motion;

    /** Processor time of a step of World, on one thread. */
    final double worldMillis;

    /** The part of it that World spends on sorting circles, finding pairs, and making them contacts for its solver. */
    final double worldFindingMillis;

    /**
     * Runs a scene.
     *
     * @param skipped steps before those that are kept
     */
    Track(Crowd crowd, int skipped, int steps) {
        int n = crowd.size();
        reach = new float[n];
        x = new float[steps][n];
        y = new float[steps][n];
        double radii = 0;
        for (int i = 0; i < n; i++) {
            reach[i] = REACH * crowd.circles()[4 * i + 2];
            radii += crowd.circles()[4 * i + 2];
        }
        float[] circles = new float[4 * n];
        try (World world = crowd.world()) {
            world.step(TIME_STEP, skipped);
            Map<String, Double> before = world.stats().stageMillis();
            long spent = 0;
            for (int step = 0; step < steps; step++) {
                long start = Clock.nanos();
                world.step(TIME_STEP);
                spent += Clock.nanos() - start;
                world.read(circles);
                for (int i = 0; i < n; i++) {
                    x[step][i] = circles[4 * i];
                    y[step][i] = circles[4 * i + 1];
                }
            }
            worldMillis = spent * 1e-6 / steps;
            worldFindingMillis = worldMillis * share(before, world.stats());
        }
        motion = motion() / (radii / n);
    }

    int size() {
        return reach.length;
    }

    int steps() {
        return x.length;
    }

    private static double share(Map<String, Double> before, WorldStats after) {
        double all = 0;
        double finding = 0;
        for (Map.Entry<String, Double> stage : after.stageMillis().entrySet()) {
            double millis = stage.getValue() - before.get(stage.getKey());
            all += millis;
            finding += stage.getKey().equals("Grid") || stage.getKey().equals("Contacts") ? millis : 0;
        }
        return finding / all;
    }

    private double motion() {
        double sum = 0;
        for (int step = 1; step < steps(); step++) {
            for (int i = 0; i < size(); i++) {
                sum += Math.hypot(x[step][i] - x[step - 1][i], y[step][i] - y[step - 1][i]);
            }
        }
        return sum / ((steps() - 1.0) * size());
    }
}
