package io.github.circles2d.bench.physics;

import static io.github.circles2d.bench.physics.Scenery.GRAVITY;
import static io.github.circles2d.bench.physics.Scenery.R;

import java.util.Random;

/** Elastic balls under gravity, which are to keep their energy and to bounce however slow they are. */
final class ElasticBalls {
    private static final int BALLS = 100;
    private static final double WIDTH = 20;
    private static final double HEIGHT = 40;
    private static final double SPEED = 10;
    private static final double[] SPEEDS = {0.5, 1, 2, 4};
    private static final double DROP = 0.36;

    private ElasticBalls() {}

    static Row keepMoving() {
        return Row.withBox2d(
                8,
                "elastic balls under gravity",
                Case.random(
                                "100 balls at 10 m/s in a box of 20 x 40, 3,000 steps",
                                ElasticBalls::crowd,
                                new Measure("energy over the first", Bound.between(0.97, 1.01)))
                        .holds(),
                Case.fixed(
                                "one on the floor at 0.5, 1, 2 and 4 r/s against a side wall",
                                (physics, effort) -> sideWall(physics),
                                new Measure("least speed after over before", Bound.between(0.95, 1.01)))
                        .holds(),
                Case.fixed(
                                "one dropped from 0.36 m",
                                (physics, effort) -> drop(physics),
                                new Measure(
                                        "height of the first bounce over that of the drop", Bound.between(0.95, 1.01)))
                        .holds());
    }

    private static double[] crowd(Physics physics, long seed, Effort effort) {
        Random random = new Random(seed);
        Setup setup = Setup.box(WIDTH, HEIGHT).withGravity(GRAVITY).withRestitution(1);
        try (Arena arena = physics.open(setup)) {
            Scatter scatter = new Scatter(WIDTH, HEIGHT, random);
            for (int i = 0; i < BALLS; i++) {
                double[] place = scatter.place(R);
                double angle = 2 * Math.PI * random.nextDouble();
                arena.add(place[0], place[1], R, Scenery.mass(R), SPEED * Math.cos(angle), SPEED * Math.sin(angle));
            }
            double before = arena.state().energy();
            arena.step(effort.of(3000));
            return new double[] {arena.state().energy() / before};
        }
    }

    /** The least of speed after over speed before; 0 for a ball that stops. */
    private static double[] sideWall(Physics physics) {
        double least = Double.POSITIVE_INFINITY;
        for (double speed : SPEEDS) {
            Setup setup = Setup.box(10, 10).withGravity(GRAVITY).withRestitution(1);
            try (Arena arena = physics.open(setup)) {
                arena.add(10 - R - 0.2, R, R, Scenery.mass(R), speed * R, 0);
                arena.step((int) (0.4 / (speed * R) / Scenery.TIME_STEP) + 10);
                least = Math.min(least, -arena.state().vx[0] / (speed * R));
            }
        }
        return new double[] {least};
    }

    private static double[] drop(Physics physics) {
        Setup setup = Setup.box(10, 10).withGravity(GRAVITY).withRestitution(1);
        try (Arena arena = physics.open(setup)) {
            arena.add(5, R + DROP, R, Scenery.mass(R));
            int steps = (int) (4 * Math.sqrt(2 * DROP / GRAVITY) / Scenery.TIME_STEP);
            double greatest = 0;
            for (int step = 0; step < steps; step++) {
                arena.step(1);
                if (step > steps / 4) {
                    greatest = Math.max(greatest, arena.state().y[0] - R);
                }
            }
            return new double[] {greatest / DROP};
        }
    }
}
