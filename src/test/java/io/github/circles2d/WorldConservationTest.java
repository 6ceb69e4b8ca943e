package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What must stay, and what must not grow. */
class WorldConservationTest {
    @Test
    @Tag("long")
    void anElasticGasKeepsItsEnergyFor10000Steps() {
        Scene scene = Scenes.gas(500, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            double before = new Totals(world).energy;
            world.step(scene.timeStep(), 10_000);
            double after = new Totals(world).energy;
            assertThat(after / before).isCloseTo(1, within(1e-4));
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {0, 0.5f, 1})
    void collisionsKeepTheMomentum(float restitution) {
        Scene scene = Scenes.gas(500, Scenes.SEED);
        // the gas in the middle of an arena so wide that no circle comes to a wall
        try (World world = WorldScenes.jvm()
                .bounds(-100, -100, 101, 101)
                .restitution(restitution)
                .build()) {
            WorldScenes.load(scene, world);
            Totals before = new Totals(world);
            int contacts = 0;
            for (int k = 0; k < 30; k++) {
                world.step(scene.timeStep(), 100);
                contacts += world.stats().contacts();
            }
            Totals after = new Totals(world);
            assertThat(contacts).isPositive();
            assertThat((after.momentumX - before.momentumX) / before.momenta).isCloseTo(0, within(1e-5));
            assertThat((after.momentumY - before.momentumY) / before.momenta).isCloseTo(0, within(1e-5));
        }
    }

    /** Discs of like or mixed radii and masses spin, and hit each other off the centre. */
    @ParameterizedTest
    @ValueSource(floats = {1, 10, 100})
    void aPairThatGripsKeepsItsMomentaAndGainsNoEnergy(float ratio) {
        SplittableRandom random = new SplittableRandom(1);
        try (World world = WorldScenes.jvm().bounds(-100, -100, 100, 100).build()) {
            for (int k = 0; k < 100; k++) {
                world.clear();
                world.kind(1).setFriction(between(random, 0, 2)).setRollingResistance(between(random, 0, 1));
                float r = 2 / ratio;
                float speed = between(random, 0.5f, 2);
                long slow = world.add(0, 0, 2, between(random, 0.1f, 10), 0, 0, 1);
                long fast = world.add(3 + r, between(random, -r, r), r, between(random, 0.1f, 10), -speed, 0, 1);
                world.setAngularVelocity(slow, between(random, -1, 1));
                world.setAngularVelocity(fast, between(random, -1, 1) * ratio);
                double[] before = momentaAndEnergy(world, slow, fast);
                world.step(1 / 60f, 180);
                double[] after = momentaAndEnergy(world, slow, fast);
                assertThat(world.vx(slow)).as("the pair has met").isNotZero();
                double momenta = world.mass(fast) * speed;
                double spins = 0.5 * (world.mass(slow) * 4 + world.mass(fast) * r);
                assertThat((after[0] - before[0]) / momenta).isCloseTo(0, within(1e-6));
                assertThat((after[1] - before[1]) / momenta).isCloseTo(0, within(1e-6));
                // friction has the radii for its arms, and the gap or overlap as it acts is up to 2 / 240 of a length
                assertThat((after[2] - before[2]) / (momenta * (2 + r) + spins)).isCloseTo(0, within(2e-3));
                assertThat(after[3]).isLessThanOrEqualTo(before[3] * (1 + 1e-6));
            }
        }
    }

    private static float between(SplittableRandom random, float least, float most) {
        return least + (most - least) * (float) random.nextDouble();
    }

    /** Momentum x, y, angular momentum about the origin, and energy, of discs. */
    private static double[] momentaAndEnergy(World world, long... circles) {
        double[] sums = new double[4];
        for (long circle : circles) {
            double m = world.mass(circle);
            double vx = world.vx(circle);
            double vy = world.vy(circle);
            double inertia = 0.5 * m * world.radius(circle) * world.radius(circle);
            double omega = world.angularVelocity(circle);
            sums[0] += m * vx;
            sums[1] += m * vy;
            sums[2] += m * (world.x(circle) * vy - world.y(circle) * vx) + inertia * omega;
            sums[3] += 0.5 * (m * (vx * vx + vy * vy) + inertia * omega * omega);
        }
        return sums;
    }

    /** A closed box without gravity, from the radii 1:1 to 1:100. */
    @ParameterizedTest
    @ValueSource(floats = {1, 10, 100})
    void discsThatGripInABoxGainNoEnergy(float ratio) {
        SplittableRandom random = new SplittableRandom(2);
        for (int scene = 0; scene < 4; scene++) {
            try (World world = WorldScenes.jvm()
                    .bounds(0, 0, 60, 60)
                    .restitution(scene / 3f)
                    .friction(between(random, 0.1f, 2))
                    .rollingResistance(scene % 2 * 0.2f)
                    .build()) {
                long[] discs = new long[36];
                for (int i = 0; i < discs.length; i++) {
                    float r = 4 * (float) Math.pow(ratio, -random.nextDouble());
                    float x = 5 + 10 * (i % 6);
                    float y = 5 + 10 * (i / 6);
                    discs[i] = world.add(x, y, r, r * r, between(random, -10, 10), between(random, -10, 10));
                    world.setAngularVelocity(discs[i], between(random, -5, 5) / r);
                }
                double before = momentaAndEnergy(world, discs)[3];
                for (int second = 0; second < 10; second++) {
                    world.step(1 / 60f, 60);
                    double after = momentaAndEnergy(world, discs)[3];
                    assertThat(after).as("scene %d, second %d", scene, second).isLessThanOrEqualTo(before * (1 + 1e-5));
                    before = after;
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {0, 0.3f, 1})
    @Tag("long")
    void withoutGravityEnergyNeverGrows(float restitution) {
        assertEnergyNeverGrows(restitution);
    }

    @ParameterizedTest
    @ValueSource(floats = {0.02f, 0.05f, 0.1f, 0.2f, 0.5f, 0.7f, 0.95f})
    @Tag("exhaustive")
    void withoutGravityEnergyNeverGrowsAtAnyRestitution(float restitution) {
        assertEnergyNeverGrows(restitution);
    }

    private static void assertEnergyNeverGrows(float restitution) {
        Scene scene = Scenes.gas(800, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene).restitution(restitution))) {
            for (int i = 0; i < scene.size(); i++) {
                world.setRestitution(handleOf(world, i), restitution);
            }
            double first = new Totals(world).energy;
            double before = first;
            double worst = 0;
            for (int step = 0; step < 1500; step++) {
                world.step(scene.timeStep());
                double energy = new Totals(world).energy;
                worst = Math.max(worst, (energy - before) / first);
                before = energy;
            }
            assertThat(before).isLessThanOrEqualTo(first * (1 + 1e-6));
            assertThat(worst)
                    .as("the greatest growth in a step, as a share of the first energy")
                    .isLessThanOrEqualTo(1e-5);
        }
    }

    private static long handleOf(World world, int place) {
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        return handles[place];
    }

    @Test
    void whereNothingMayTouchNothingEverDoes() {
        Scene scene = Scenes.noCollide();
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            int n = scene.size();
            float[] circles = new float[4 * n];
            float[] velocities = new float[2 * n];
            for (int step = 0; step < 3000; step++) {
                world.step(scene.timeStep());
                world.read(circles);
                world.readVelocities(velocities);
                for (int i = 0; i < n; i++) {
                    boolean alongX = scene.vx(i) != 0;
                    boolean alongY = scene.vy(i) != 0;
                    // exactly: any contact would leave a trace
                    assertThat(Math.abs(velocities[2 * i])).isEqualTo(alongX ? 100f : 0f);
                    assertThat(Math.abs(velocities[2 * i + 1])).isEqualTo(alongY ? 100f : 0f);
                    if (!alongX) {
                        assertThat(circles[4 * i]).isEqualTo(scene.x(i));
                    }
                    if (!alongY) {
                        assertThat(circles[4 * i + 1]).isEqualTo(scene.y(i));
                    }
                }
            }
        }
    }

    /** Sums over all circles that are not static, in double. */
    private static final class Totals {
        private double energy;
        private double momentumX;
        private double momentumY;

        /** Sum of the magnitudes of all momenta: what rounding errors are to be measured by. */
        private double momenta;

        Totals(World world) {
            int n = world.size();
            float[] circles = new float[4 * n];
            float[] velocities = new float[2 * n];
            world.read(circles);
            world.readVelocities(velocities);
            for (int i = 0; i < n; i++) {
                double m = circles[4 * i + 3];
                double vx = velocities[2 * i];
                double vy = velocities[2 * i + 1];
                if (m < Double.POSITIVE_INFINITY) {
                    energy += 0.5 * m * (vx * vx + vy * vy);
                    momentumX += m * vx;
                    momentumY += m * vy;
                    momenta += m * Math.sqrt(vx * vx + vy * vy);
                }
            }
        }
    }
}
