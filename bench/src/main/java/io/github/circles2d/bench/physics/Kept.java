package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Random;

/** What World did well before, and is to keep. */
final class Kept {
    private static final int CRADLE = 5;

    private Kept() {}

    static Row today() {
        return Row.of(
                18,
                "what was good before: not worse by more than a tenth",
                kept(
                                "packed, 1,250: settled after 3,000 steps",
                                Kept::packed,
                                "mean depth, r",
                                0,
                                "deepest pair, r",
                                0,
                                "creep in 3,000 more steps, r",
                                0.01)
                        .harnessOnly(),
                kept("column of 10 in a tube", (p, seed, e) -> column(p, 10), "sag, r", 0.001),
                kept("column of 20 in a tube", (p, seed, e) -> column(p, 20), "sag, r", 0.001),
                kept("column of 50 in a tube", (p, seed, e) -> column(p, 50), "sag, r", 0.001),
                kept("piston of 1,000 masses on 200 circles", Kept::piston, "mean depth, r", 0, "deepest pair, r", 0),
                kept("Newton's cradle of 5, 10,000 steps", Kept::cradle, "energy lost or gained, share", 1e-3),
                kept("billiard break, e = 1, 2,000 steps", Kept::billiards, "energy lost or gained, share", 1e-4),
                kept(
                        "drops from 10 m, e = 0.5 to 1",
                        Kept::bounceHeights,
                        "greatest error of the height, share of the drop",
                        0.006),
                kept("gas of 2,000, 10,000 steps", Kept::gas, "energy lost or gained, share", 1e-4)
                        .harnessOnly(),
                kept("pile of 1,250, all lengths x 0.001", (p, seed, e) -> scaled(p, 0.001, seed), "mean depth, r", 0),
                kept("pile of 1,250", (p, seed, e) -> scaled(p, 1, seed), "mean depth, r", 0),
                kept("pile of 1,250, all lengths x 1,000", (p, seed, e) -> scaled(p, 1000, seed), "mean depth, r", 0));
    }

    /** A case whose figures are bounded by the baseline; figures are pairs of a name and what is good enough. */
    private static Case kept(String name, Case.Run run, Object... figures) {
        Measure[] measures = new Measure[figures.length / 2];
        for (int i = 0; i < measures.length; i++) {
            double good = ((Number) figures[2 * i + 1]).doubleValue();
            measures[i] = Baseline.measure(name, (String) figures[2 * i], good);
        }
        return Case.random(name, run, measures).holds();
    }

    private static double[] packed(Physics physics, long seed, Effort effort) {
        Scene scene = Scenes.packed(1250, seed);
        try (Arena arena = load(scene, physics)) {
            arena.step(3000);
            State settled = arena.state();
            arena.step(effort.of(3000));
            double radius = 0.0125;
            return new double[] {
                settled.meanDepth() / radius,
                settled.deepest() / radius,
                arena.state().farthestFrom(settled) / radius
            };
        }
    }

    private static double[] column(Physics physics, int n) {
        double width = 2.1 * R;
        try (Arena arena = physics.open(Setup.box(width, 100).withGravity(GRAVITY))) {
            for (int i = 0; i < n; i++) {
                arena.add(width / 2, R + 2 * R * i, R, Scenery.mass(R));
            }
            arena.step(4000);
            return new double[] {((2 * n - 1) * R - arena.state().y[n - 1]) / R};
        }
    }

    /** The piston is a circle as wide as the box. */
    private static double[] piston(Physics physics, long seed, Effort effort) {
        Random random = new Random(seed);
        double width = 16;
        try (Arena arena = physics.open(Setup.box(width, 100).withGravity(GRAVITY))) {
            int columns = 12;
            for (int i = 0; i < 200; i++) {
                double x = (i % columns + 0.5) * width / columns + 0.05 * (random.nextDouble() - 0.5);
                double radius = Piles.anyRadius(random);
                arena.add(x, 0.7 + i / columns * 1.3, radius, Scenery.mass(R));
            }
            arena.add(width / 2, 35, width / 2 - 0.1, 1000 * Scenery.mass(R));
            arena.step(2000);
            State state = arena.state();
            return new double[] {state.meanDepth() / R, state.deepest() / R};
        }
    }

    private static double[] cradle(Physics physics, long seed, Effort effort) {
        try (Arena arena = physics.open(Setup.box(12, 2).withRestitution(1))) {
            for (int i = 0; i < CRADLE; i++) {
                arena.add(i == 0 ? 1 : 4 + 2 * R * i, 1, R, Scenery.mass(R), i == 0 ? 2 : 0, 0);
            }
            return energyError(arena, effort.of(10_000));
        }
    }

    private static double[] billiards(Physics physics, long seed, Effort effort) {
        Random random = new Random(seed);
        double r = 0.028575;
        try (Arena arena = physics.open(Setup.around(0.915, 0.56).withRestitution(1))) {
            for (int row = 0; row < 5; row++) {
                for (int j = 0; j <= row; j++) {
                    double pitch = 2 * r + 0.0005;
                    double x = 0.4 + pitch * row * Math.sqrt(0.75);
                    arena.add(x, pitch * (j - 0.5 * row), r, 0.17);
                }
            }
            arena.add(-0.6, 0.001 * (random.nextDouble() - 0.5), r, 0.17, 3, 0);
            return energyError(arena, effort.of(2000));
        }
    }

    private static double[] gas(Physics physics, long seed, Effort effort) {
        try (Arena arena = load(Scenes.gas(2000, seed), physics)) {
            return energyError(arena, effort.of(10_000));
        }
    }

    private static double[] energyError(Arena arena, int steps) {
        double before = arena.state().kineticEnergy();
        arena.step(steps);
        return new double[] {Math.abs(arena.state().kineticEnergy() / before - 1)};
    }

    /** The height of the first bounce, at the ends of steps, against e squared times the drop. */
    private static double[] bounceHeights(Physics physics, long seed, Effort effort) {
        double drop = 10;
        double worst = 0;
        for (double e = 0.5; e < 1.05; e += 0.1) {
            Setup setup = Setup.box(10, 30).withGravity(GRAVITY).withRestitution(Math.min(e, 1));
            try (Arena arena = physics.open(setup)) {
                arena.add(5, R + drop + 0.01 * seed, R, Scenery.mass(R));
                double height = 0;
                boolean bounced = false;
                for (int step = 0; step < 300; step++) {
                    arena.step(1);
                    State state = arena.state();
                    if (bounced && state.vy[0] < 0) {
                        break;
                    }
                    bounced |= state.vy[0] > 0;
                    height = bounced ? Math.max(height, state.y[0] - R) : 0;
                }
                worst = Math.max(worst, Math.abs(height / (drop + 0.01 * seed) - e * e));
            }
        }
        return new double[] {worst};
    }

    private static double[] scaled(Physics physics, double scale, long seed) {
        Random random = new Random(seed);
        double width = 40 * scale;
        try (Arena arena = physics.open(Setup.box(width, 3 * width).withGravity(GRAVITY * scale))) {
            for (int i = 0; i < 1250; i++) {
                double radius = Piles.anyRadius(random) * scale;
                double x = (i % 32 + 0.5) * 1.25 * scale;
                arena.add(x, (0.65 + i / 32 * 1.2) * scale, radius, Scenery.mass(radius / scale));
            }
            arena.step(1500);
            return new double[] {arena.state().meanDepth() / R / scale};
        }
    }

    private static Arena load(Scene scene, Physics physics) {
        Setup setup = new Setup(
                scene.minX(),
                scene.minY(),
                scene.maxX(),
                scene.maxY(),
                -scene.gravityY(),
                scene.restitution(),
                4,
                false);
        Arena arena = physics.open(setup);
        for (int i = 0; i < scene.size(); i++) {
            arena.add(scene.x(i), scene.y(i), scene.radius(i), scene.mass(i), scene.vx(i), scene.vy(i));
        }
        return arena;
    }
}
