package io.github.circles2d.bench.broadphase;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.bench.Devices;
import java.util.Random;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Every broad phase finds the pairs of {@link AllPairs}, in every step, whatever came before. */
class BroadPhasesTest {
    @ParameterizedTest
    @EnumSource(BroadPhases.class)
    void crowdsOfAllKinds(BroadPhases kind) {
        Random random = new Random(1);
        for (int run = 0; run < 100; run++) {
            int n = 1 + random.nextInt(run < 20 ? 6 : 300);
            double ratio = Math.pow(10, random.nextInt(4));
            double extent = random.nextBoolean() ? 1 : 0.02;
            double speed = 0.0005 * Math.pow(200, random.nextDouble());
            compare(kind, random, n, ratio, extent, speed, 0.4 * random.nextDouble());
            // Neighbours that approach by less than a margin a step, and by more than it together.
            compare(kind, random, n, 1, 1, 0.18 * Math.sqrt(0.2 / n), 0.2);
        }
    }

    @ParameterizedTest
    @EnumSource(BroadPhases.class)
    void everyCircleAtOnePoint(BroadPhases kind) {
        compare(kind, new Random(2), 60, 3, 0, 0, 0.1);
    }

    /** Circles that touch, at the distances at which rounding decides. */
    @ParameterizedTest
    @EnumSource(BroadPhases.class)
    void aLatticeOfCirclesThatTouch(BroadPhases kind) {
        int side = 24;
        for (float r : new float[] {1f / 48, 1 / 50f, Math.nextDown(1f / 48), Math.nextUp(1 / 50f)}) {
            float[] reach = new float[side * side];
            float[] x = new float[reach.length];
            float[] y = new float[reach.length];
            for (int i = 0; i < reach.length; i++) {
                reach[i] = r;
                x[i] = r + 2 * r * (i % side);
                y[i] = r + 2 * r * (i / side);
            }
            BroadPhase phase = kind.create();
            BroadPhase oracle = new AllPairs();
            phase.start(reach);
            oracle.start(reach);
            compare(phase, oracle, x, y, "lattice of " + r);
        }
    }

    /** Two circles that touch: rounding decides if they overlap, and may put the end of one before the begin of the other. */
    @ParameterizedTest
    @EnumSource(BroadPhases.class)
    void twoCirclesThatTouch(BroadPhases kind) {
        Random random = new Random(4);
        for (int run = 0; run < 4000; run++) {
            float[] reach = {0.001f + 0.2f * random.nextFloat(), 0.001f + 0.2f * random.nextFloat()};
            float along = 0.25f + 0.25f * random.nextFloat();
            if (run % 2 == 0) {
                // The first one is at the border of two cells of a grid.
                reach[0] = 0.001f + 0.02f * random.nextFloat();
                reach[1] = reach[0];
                along = 2 * reach[0] * (1 + random.nextInt((int) (0.4f / reach[0])));
                for (int ulps = random.nextInt(4); ulps > 0; ulps--) {
                    along = Math.nextDown(along);
                }
            }
            float across = 0.5f;
            float[] row = {along, along + reach[0] + reach[1]};
            for (int ulps = random.nextInt(4); ulps > 0; ulps--) {
                row[1] = Math.nextDown(row[1]);
            }
            float[] line = {across, across};
            BroadPhase phase = kind.create();
            BroadPhase oracle = new AllPairs();
            phase.start(reach);
            oracle.start(reach);
            compare(phase, oracle, row, line, "side by side at " + along);
            compare(phase, oracle, line, row, "above each other at " + along);
        }
    }

    @Test
    @Tag("long")
    void theDeviceFindsThePairsOfTheJvm() {
        if (Devices.all().isEmpty() && !Boolean.getBoolean("circles2d.device.required")) {
            Assumptions.abort("no OpenCL device");
        }
        Random random = new Random(3);
        for (int n : new int[] {1, 2, 300, 5000}) {
            float[] reach = radii(n, n > 300 ? 100 : 3, 1, 0.4, random);
            float[] x = new float[n];
            float[] y = new float[n];
            BroadPhase oracle = new AllPairs();
            oracle.start(reach);
            try (DeviceSweep sweep = new DeviceSweep(Devices.find("best"), reach)) {
                for (int step = 0; step < 3; step++) {
                    // In the last step all circles are at one point: more pairs than there is room for.
                    float extent = step < 2 || n > 300 ? 1 : 0;
                    for (int i = 0; i < n; i++) {
                        x[i] = extent * random.nextFloat();
                        y[i] = extent * random.nextFloat();
                    }
                    PairList wanted = new PairList();
                    oracle.findPairs(x, y, wanted);
                    sweep.move(x, y);
                    assertThat(sweep.findPairs()).isEqualTo(wanted.size());
                    PairList found = new PairList();
                    sweep.read(found);
                    assertThat(found.checksum()).isEqualTo(wanted.checksum());
                }
            }
        }
    }

    /** What a scene of the comparison promises: circles within the walls, and radii of the ratio that it names. */
    @ParameterizedTest
    @EnumSource(Crowds.class)
    void theScenesFitIntoTheArena(Crowds scene) {
        Crowd crowd = scene.of(500);
        assertThat(crowd.size()).isEqualTo(500);
        float least = Float.MAX_VALUE;
        float greatest = 0;
        for (int i = 0; i < 500; i++) {
            float r = crowd.circles()[4 * i + 2];
            least = Math.min(least, r);
            greatest = Math.max(greatest, r);
            assertThat(crowd.circles()[4 * i]).isBetween(r, 1 - r);
            assertThat(crowd.circles()[4 * i + 1]).isBetween(r * 0.9f, 1 - r);
        }
        double ratio =
                switch (scene) {
                    case MIXED_100 -> 100;
                    case MIXED_10 -> 10;
                    case BOULDERS -> 40;
                    case PILE -> 1.01;
                    default -> 1.5;
                };
        assertThat((double) greatest / least).isBetween(0.7 * ratio, 1.2 * ratio);
    }

    @Test
    void theChecksumIsThatOfTheSet() {
        PairList pairs = new PairList();
        pairs.add(1, 2);
        pairs.add(3, 4);
        PairList others = new PairList();
        others.add(4, 3);
        others.add(1, 2);
        assertThat(others.checksum()).isEqualTo(pairs.checksum());
        others.add(1, 3);
        assertThat(others.checksum()).isNotEqualTo(pairs.checksum());
    }

    @Test
    void anUnknownNameIsRefused() {
        assertThatThrownBy(() -> BroadPhases.named("octree"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("octree")
                .hasMessageContaining("uniform-grid");
    }

    private static void compare(
            BroadPhases kind, Random random, int n, double ratio, double extent, double speed, double fill) {
        float[] reach = new float[n];
        float[] x = new float[n];
        float[] y = new float[n];
        double[] angle = new double[n];
        for (int i = 0; i < n; i++) {
            reach[i] = (float)
                    ((extent == 0 ? 1 : extent) * Math.sqrt(fill / n) * Math.pow(ratio, -random.nextDouble()) + 1e-7);
            x[i] = (float) (extent * random.nextDouble());
            y[i] = (float) (extent * random.nextDouble());
            angle[i] = 2 * Math.PI * random.nextDouble();
        }
        BroadPhase phase = kind.create();
        BroadPhase oracle = new AllPairs();
        phase.start(reach);
        oracle.start(reach);
        for (int step = 0; step < 8; step++) {
            compare(phase, oracle, x, y, "step " + step + " of " + n + " circles, radii 1:" + ratio);
            for (int i = 0; i < n; i++) {
                x[i] = within(x[i] + speed * extent * Math.cos(angle[i]));
                y[i] = within(y[i] + speed * extent * Math.sin(angle[i]));
            }
        }
    }

    private static float[] radii(int n, double ratio, double extent, double fill, Random random) {
        float[] reach = new float[n];
        for (int i = 0; i < n; i++) {
            reach[i] = (float) (extent * Math.sqrt(fill / n) * Math.pow(ratio, -random.nextDouble()) + 1e-7);
        }
        return reach;
    }

    private static float within(double at) {
        return (float) Math.max(0, Math.min(1, at));
    }

    private static void compare(BroadPhase phase, BroadPhase oracle, float[] x, float[] y, String label) {
        PairList found = new PairList();
        PairList wanted = new PairList();
        phase.findPairs(x, y, found);
        oracle.findPairs(x, y, wanted);
        assertThat(found.size()).as(label).isEqualTo(wanted.size());
        assertThat(found.checksum()).as(label).isEqualTo(wanted.checksum());
    }
}
