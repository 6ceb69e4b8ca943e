package io.github.circles2d.bench.broadphase;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Every broad phase finds the pairs of {@link AllPairs}, in every step, whatever came before. */
class BroadPhasesTest {
    @ParameterizedTest
    @EnumSource(BroadPhases.class)
    void crowdsOfAllKinds(BroadPhases kind) {
        Random random = new Random(1);
        for (int run = 0; run < 40; run++) {
            int n = 1 + random.nextInt(run < 10 ? 6 : 400);
            double ratio = Math.pow(10, random.nextInt(4));
            double extent = random.nextBoolean() ? 1 : 0.02;
            double speed = random.nextBoolean() ? 0.001 : 0.1;
            compare(kind, random, n, ratio, extent, speed, 0.4 * random.nextDouble());
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
        for (int i = 0; i < n; i++) {
            reach[i] = (float)
                    ((extent == 0 ? 1 : extent) * Math.sqrt(fill / n) * Math.pow(ratio, -random.nextDouble()) + 1e-7);
            x[i] = (float) (extent * random.nextDouble());
            y[i] = (float) (extent * random.nextDouble());
        }
        BroadPhase phase = kind.create();
        BroadPhase oracle = new AllPairs();
        phase.start(reach);
        oracle.start(reach);
        for (int step = 0; step < 8; step++) {
            compare(phase, oracle, x, y, "step " + step + " of " + n + " circles, radii 1:" + ratio);
            for (int i = 0; i < n; i++) {
                x[i] = move(x[i], speed * extent, random);
                y[i] = move(y[i], speed * extent, random);
            }
        }
    }

    private static float move(float at, double speed, Random random) {
        return (float) Math.max(0, Math.min(1, at + speed * random.nextGaussian()));
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
