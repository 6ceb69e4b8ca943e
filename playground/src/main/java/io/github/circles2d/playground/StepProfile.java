package io.github.circles2d.playground;

import io.github.circles2d.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * How the time of a step divides over the stages of a world, as means of some tenths of a second. Only a world that is built to measure
 * its stages has them. On a device they are the kernels' time there, and the reading of what is drawn is one of them.
 */
final class StepProfile {
    /** Numbers that change more often cannot be read. */
    private static final long PERIOD_NANOS = 500_000_000;

    /**
     * A stage.
     *
     * @param name what it does, in words
     * @param millis milliseconds a step
     */
    record Part(String name, double millis) {}

    private Map<String, Double> before = Map.of();
    private long since;
    private int steps;
    private List<Part> parts = List.of();

    /** Another world has come, whose stages have taken so many milliseconds until now: to build it is no part of a step. */
    void start(Map<String, Double> stageMillis) {
        before = stageMillis;
        parts = List.of();
        steps = 0;
        since = System.nanoTime();
    }

    /** Notes that a world has made so many steps, and takes its times if the last are old enough, or at once. */
    void note(World world, int made, boolean now) {
        steps += made;
        if (steps == 0 || !now && System.nanoTime() - since < PERIOD_NANOS) {
            return;
        }
        Map<String, Double> times = world.stats().stageMillis();
        List<Part> next = new ArrayList<>();
        times.forEach((stage, millis) ->
                next.add(new Part(words(stage), (millis - before.getOrDefault(stage, 0.0)) / steps)));
        parts = List.copyOf(next);
        before = times;
        steps = 0;
        since = System.nanoTime();
    }

    /** In the order that the world has; empty before the first steps. */
    List<Part> parts() {
        return parts;
    }

    /** {@code ContinuousCollision} is "continuous collision". */
    static String words(String stage) {
        return stage.replaceAll("(?<=[a-z])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }
}
