package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.R;

import java.util.Random;

/** A gas of light and heavy circles: collisions are to share the energy out evenly. */
final class Gases {
    private static final int EACH = 800;
    private static final double FILL = 0.5;
    private static final double HEAVY_RADIUS = 3 * R;
    private static final double HEAVY_MASS = 10;
    private static final int STEPS = 10_000;
    private static final int EVERY = 50;

    private Gases() {}

    static Row temperatures() {
        return Row.of(
                6,
                "gas of 800 light and 800 heavy circles, mass 1:10, radius 1:3, e = 1, fill 0.5, 10,000 steps",
                temperatures(0.1),
                temperatures(0.25),
                temperatures(0.5));
    }

    private static Case temperatures(double speed) {
        return Case.random(
                        "light ones at " + speed + " radii of the heavy a step (rms)",
                        (physics, seed, effort) ->
                                run(physics, speed * HEAVY_RADIUS / Scenery.TIME_STEP, seed, effort.of(STEPS)),
                        new Measure("temperature of the light over that of the heavy", Bound.between(0.97, 1.03)),
                        Measure.shown("energy over the first"))
                .harnessOnly();
    }

    /** The temperatures are means over the last three quarters of the steps. */
    private static double[] run(Physics physics, double speed, long seed, int steps) {
        Random random = new Random(seed);
        double side = Math.sqrt(EACH * Math.PI * (R * R + HEAVY_RADIUS * HEAVY_RADIUS) / FILL);
        try (Arena arena = physics.open(Setup.box(side, side).withRestitution(1))) {
            Scatter scatter = new Scatter(side, side, random);
            for (int i = 0; i < 2 * EACH; i++) {
                boolean heavy = i < EACH;
                double radius = heavy ? HEAVY_RADIUS : R;
                double mass = heavy ? HEAVY_MASS : 1;
                double[] place = scatter.place(radius);
                double sigma = speed / Math.sqrt(2 * mass);
                arena.add(
                        place[0], place[1], radius, mass, sigma * random.nextGaussian(), sigma * random.nextGaussian());
            }
            double before = arena.state().kineticEnergy();
            double[] temperature = new double[2];
            for (int step = EVERY; step <= steps; step += EVERY) {
                arena.step(EVERY);
                if (step > steps / 4) {
                    add(arena.state(), temperature);
                }
            }
            return new double[] {temperature[0] / temperature[1], arena.state().kineticEnergy() / before};
        }
    }

    private static void add(State state, double[] temperature) {
        for (int i = 0; i < state.size(); i++) {
            temperature[state.mass[i] == HEAVY_MASS ? 1 : 0] += state.mass[i] * Math.pow(state.speed(i), 2);
        }
    }
}
