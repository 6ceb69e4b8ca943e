package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

import io.github.circles2d.scenes.Scenes;
import java.util.Random;

/** Scenes whose energy World kept before. */
final class KeptEnergy {
    /** Circles of Newton's cradle. */
    private static final int CRADLE = 5;

    private KeptEnergy() {}

    static double[] cradle(Physics physics, long seed, Effort effort) {
        try (Arena arena = physics.open(Setup.box(12, 2).withRestitution(1))) {
            for (int i = 0; i < CRADLE; i++) {
                arena.add(i == 0 ? 1 : 4 + 2 * R * i, 1, R, Scenery.mass(R), i == 0 ? 2 : 0, 0);
            }
            return energyError(arena, effort.of(10_000));
        }
    }

    static double[] billiards(Physics physics, long seed, Effort effort) {
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

    static double[] gas(Physics physics, long seed, Effort effort) {
        try (Arena arena = Kept.load(Scenes.gas(2000, seed), physics)) {
            return energyError(arena, effort.of(10_000));
        }
    }

    /** The height of the first bounce, at the ends of steps, against e squared times the drop. */
    static double[] bounceHeights(Physics physics, long seed, Effort effort) {
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

    private static double[] energyError(Arena arena, int steps) {
        double before = arena.state().kineticEnergy();
        arena.step(steps);
        return new double[] {Math.abs(arena.state().kineticEnergy() / before - 1)};
    }
}
