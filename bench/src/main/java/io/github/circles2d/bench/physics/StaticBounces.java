package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

import java.util.Arrays;
import java.util.stream.IntStream;

/** Balls that bounce straight up and down on a static circle for ever. */
final class StaticBounces {
    private static final int STEPS = 20_000;

    /** Heights of the drops above the static circle, in radii. */
    private static final double[] DROPS = IntStream.range(0, 47)
            .mapToDouble(i -> 0.1 * Math.pow(200, i / 46.0))
            .toArray();

    private StaticBounces() {}

    static Row forEver() {
        return Row.withBox2d(
                9,
                "47 balls dropped on static circles from 0.1 to 20 r, 20,000 steps",
                bounces(1, 1),
                bounces(1, 2),
                bounces(1, 4),
                bounces(1, 8),
                bounces(0.95, 1),
                bounces(0.95, 2),
                bounces(0.95, 4),
                bounces(0.95, 8));
    }

    private static Case bounces(double restitution, int subSteps) {
        Measure kept = restitution == 1
                ? Measure.atLeast("least height of the last 4,000 steps over the drop", 0.95)
                : Measure.shown("least height of the last 4,000 steps over the drop");
        return Case.fixed(
                        "e = " + restitution + ", " + subSteps + (subSteps == 1 ? " sub-step" : " sub-steps"),
                        (physics, effort) -> run(physics, restitution, subSteps, effort.of(STEPS)),
                        Measure.atMost("greatest height after the first bounce over the drop", 1.01),
                        kept)
                .holds();
    }

    /** Each drop has a column of the world to itself. Heights are seen at the ends of steps. */
    private static double[] run(Physics physics, double restitution, int subSteps, int steps) {
        Setup setup = Setup.box(10 * DROPS.length, 2000)
                .withGravity(GRAVITY)
                .withRestitution(restitution)
                .withSubSteps(subSteps);
        double[] greatest = new double[DROPS.length];
        double[] last = new double[DROPS.length];
        boolean[] landed = new boolean[DROPS.length];
        try (Arena arena = physics.open(setup)) {
            for (int i = 0; i < DROPS.length; i++) {
                arena.add(10 * i + 5, 5, R, Double.POSITIVE_INFINITY);
            }
            for (int i = 0; i < DROPS.length; i++) {
                arena.add(10 * i + 5, 5 + (2 + DROPS[i]) * R, R, Scenery.mass(R));
            }
            for (int step = 0; step < steps; step++) {
                arena.step(1);
                State state = arena.state();
                for (int i = 0; i < DROPS.length; i++) {
                    int ball = DROPS.length + i;
                    double height = (-state.overlap(i, ball)) / R / DROPS[i];
                    landed[i] |= state.vy[ball] >= 0;
                    greatest[i] = landed[i] ? Math.max(greatest[i], height) : 0;
                    last[i] = step >= steps - 4000 ? Math.max(last[i], height) : 0;
                }
            }
        }
        return new double[] {
            Arrays.stream(greatest).max().orElseThrow(),
            Arrays.stream(last).min().orElseThrow()
        };
    }
}
