package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

import java.util.Arrays;
import java.util.Random;

/** Light circles under heavy ones. */
final class Masses {
    private static final int N = 2000;
    private static final double LEAST = 0.1;
    private static final double GREATEST = 10;

    /** Share of the place above the floor that the circles fill before they fall. */
    private static final double FILL = 0.5;

    private static final double WIDTH = 300;

    private Masses() {}

    static Row poured() {
        return Row.of(
                14,
                "2,000 circles poured, radii 0.1 to 10 (log-uniform), mass as r squared",
                Case.random(
                        "300 and 1,200 steps",
                        Masses::pour,
                        Measure.atMost("deepest pair after 5 s, radii of the smaller circle", 0.3),
                        Measure.shown("after 20 s"),
                        Measure.shown("deepest pair in between, at whole seconds")));
    }

    private static double[] pour(Physics physics, long seed, Effort effort) {
        Random random = new Random(seed);
        double[] radii = random.doubles(N)
                .map(u -> LEAST * Math.pow(GREATEST / LEAST, u))
                .toArray();
        Arrays.sort(radii);
        double area = Arrays.stream(radii).map(Scenery::mass).sum();
        double height = area / FILL / WIDTH;
        try (Arena arena = physics.open(Setup.box(WIDTH, 2 * height).withGravity(GRAVITY))) {
            new Scatter(WIDTH, height, random).largestFirst(radii, arena);
            double deepest = 0;
            arena.step(5 * Scenery.SECOND);
            double after5 = arena.state().deepestOfSmaller();
            for (int second = 6; second <= 20; second++) {
                arena.step(effort.of(Scenery.SECOND));
                deepest = Math.max(deepest, arena.state().deepestOfSmaller());
            }
            return new double[] {after5, arena.state().deepestOfSmaller(), deepest};
        }
    }

    static Row heavyOnLight() {
        return Row.of(
                17,
                "a heavy circle on a light one on the floor, 600 steps",
                heavyOnLight(100, 0.05).holds(),
                heavyOnLight(1000, 0.1),
                heavyOnLight(10_000, 0.3));
    }

    private static Case heavyOnLight(int ratio, double bound) {
        return Case.fixed(
                "1:" + ratio,
                (physics, effort) -> stack(physics, ratio),
                Measure.atMost("how far the heavy one sinks, r", bound),
                Measure.shown("deepest overlap of the pair on the way, r"));
    }

    private static double[] stack(Physics physics, int ratio) {
        try (Arena arena = physics.open(Setup.box(20, 20).withGravity(GRAVITY))) {
            arena.add(10, R, R, Scenery.mass(R));
            arena.add(10, 3 * R, R, ratio * Scenery.mass(R));
            double deepest = 0;
            for (int step = 0; step < 600; step++) {
                arena.step(1);
                deepest = Math.max(deepest, arena.state().overlap(0, 1));
            }
            return new double[] {(3 * R - arena.state().y[1]) / R, deepest / R};
        }
    }
}
