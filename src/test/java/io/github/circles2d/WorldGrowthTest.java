package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;

/** A circle that grows or shrinks over steps: its radius, and where that is saved. */
class WorldGrowthTest {
    private static final float STEP = 1 / 64f;

    private static World world(Backend backend) {
        return World.builder()
                .bounds(0, 0, 10, 10)
                .gravity(0, -10)
                .threads(1)
                .backend(backend)
                .build();
    }

    private static World world() {
        return world(Backend.JVM);
    }

    @OnEachBackend
    void theRadiusChangesByEqualPartsAndEndsExactly(Backend backend) {
        try (World world = world(backend)) {
            long a = world.add(3, 3, 0.5f, 2);
            long b = world.add(7, 3, 0.9f, 2);
            world.grow(a, 1, 8);
            world.grow(b, 0.3f, 7);
            assertThat(world.radius(a)).isEqualTo(0.5f);
            for (int step = 1; step <= 8; step++) {
                world.step(STEP);
                assertThat(world.radius(a)).isCloseTo(0.5f + step / 16f, within(1e-6f));
                assertThat(world.growthSteps(a)).isEqualTo(8 - step);
                assertThat(world.growthSteps(b)).isEqualTo(Math.max(0, 7 - step));
            }
            assertThat(world.radius(a)).isEqualTo(1);
            assertThat(world.radius(b)).isEqualTo(0.3f);
            assertThat(world.mass(a)).isEqualTo(2);
            float[] radii = new float[3];
            world.readRadiiById(radii, null);
            assertThat(radii).containsExactly(1, 0.3f, Float.NaN);
        }
    }

    @OnEachBackend
    void severalStepsInOneCallAreTheSameSteps(Backend backend) {
        try (World world = world(backend);
                World same = world()) {
            for (World each : new World[] {world, same}) {
                for (int k = 0; k < 12; k++) {
                    long handle = each.add(1 + k % 4 * 2, 1 + k / 4 * 2, 0.8f, 1 + k);
                    if (k % 3 == 0) {
                        each.grow(handle, 1.2f, 4 + k);
                    }
                }
            }
            world.step(STEP, 20);
            for (int step = 0; step < 20; step++) {
                same.step(STEP);
            }
            assertThat(world.hash()).isEqualTo(same.hash());
            assertThat(snapshot(world)).isEqualTo(snapshot(same));
        }
    }

    /** A circle that setRadius changes forgets the impulses by which it carries others, and sinks in. */
    @Test
    void aCircleThatGrowsGoesOnToCarryWhatLiesOnIt() {
        try (World world = world();
                World rest = world()) {
            for (World each : new World[] {world, rest}) {
                for (int k = 0; k < 5; k++) {
                    each.add(5, 0.5f + k, 0.5f, 1);
                }
                each.step(STEP, 200);
                assertThat(each.y(each.handle(4))).isCloseTo(4.5f, within(0.02f));
            }
            world.grow(world.handle(0), 0.5f, 60);
            world.step(STEP, 60);
            rest.step(STEP, 60);
            assertThat(world.hash()).isEqualTo(rest.hash());
        }
    }

    @Test
    void theLastCallCounts() {
        try (World world = world()) {
            long a = world.add(3, 3, 0.5f, 1);
            world.grow(a, 1, 10);
            world.step(STEP, 5);
            world.grow(a, 0.25f, 2);
            assertThat(world.growthSteps(a)).isEqualTo(2);
            world.step(STEP);
            assertThat(world.radius(a)).isEqualTo(0.5f);
            world.setRadius(a, 0.4f);
            assertThat(world.growthSteps(a)).isZero();
            world.step(STEP, 3);
            assertThat(world.radius(a)).isEqualTo(0.4f);
        }
    }

    /** The id of a circle that grew does not make the next circle grow, nor grow twice as fast. */
    @Test
    void aRemovedCircleTakesItsGrowthAlong() {
        try (World world = world()) {
            long a = world.add(3, 3, 0.5f, 1);
            world.grow(a, 1, 10);
            world.remove(a);
            long b = world.add(3, 3, 0.5f, 1);
            assertThat(World.id(b)).isEqualTo(World.id(a));
            assertThat(world.growthSteps(b)).isZero();
            world.grow(b, 1.5f, 10);
            world.step(STEP);
            assertThat(world.radius(b)).isEqualTo(0.6f);
            world.clear();
            long c = world.add(3, 3, 0.5f, 1);
            world.step(STEP);
            assertThat(world.radius(c)).isEqualTo(0.5f);
        }
    }

    @Test
    void aWorldInWhichNoCircleGrowsAnyMoreIsAsOneInWhichNoneHas() {
        try (World world = world();
                World same = world()) {
            world.grow(world.add(3, 3, 0.5f, 1), 0.5f, 3);
            same.add(3, 3, 0.5f, 1);
            assertThat(world.hash()).isNotEqualTo(same.hash());
            assertThat(snapshot(world)).isNotEqualTo(snapshot(same));
            world.step(STEP, 3);
            same.step(STEP, 3);
            assertThat(world.hash()).isEqualTo(same.hash());
            assertThat(snapshot(world)).isEqualTo(snapshot(same));
        }
    }

    /** Two worlds that look the same, but go on differently, have different hashes. */
    @Test
    void theHashKnowsToWhichRadiusAndHowFastACircleGrows() {
        long[] hashes = new long[3];
        for (int k = 0; k < 3; k++) {
            try (World world = world()) {
                world.grow(world.add(3, 3, 0.5f, 1), k == 0 ? 1 : 0.75f, k == 2 ? 8 : 5);
                hashes[k] = world.hash();
            }
        }
        assertThat(hashes).doesNotHaveDuplicates();
    }

    @OnEachBackend
    void aGrowthGoesOnAfterARestoreAndInAFrameThatComesBack(Backend backend) {
        try (World world = world(backend);
                World other = world()) {
            for (int k = 0; k < 10; k++) {
                world.add(1 + 0.8f * k, 1, 0.4f, 1);
            }
            world.grow(world.handle(3), 0.9f, 12);
            world.step(STEP, 5);
            Rewind rewind = new Rewind(world, 3);
            rewind.save(5);
            other.restore(snapshot(world));
            assertThat(other.growthSteps(other.handle(3))).isEqualTo(7);
            world.step(STEP, 20);
            other.step(STEP, 20);
            assertThat(other.hash()).isEqualTo(world.hash());
            rewind.restore(5);
            world.step(STEP, 20);
            assertThat(world.hash()).isEqualTo(other.hash());
        }
    }

    @Test
    void badValuesAreRefusedAndChangeNothing() {
        try (World world = world()) {
            long a = world.add(3, 3, 0.5f, 1);
            ByteBuffer before = snapshot(world);
            assertIllegalArgument("radius is NaN", () -> world.grow(a, Float.NaN, 5));
            assertIllegalArgument("radius is 5.1", () -> world.grow(a, 5.1f, 5));
            for (int steps : new int[] {0, -1, 100_001, Integer.MIN_VALUE}) {
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> world.grow(a, 1, steps))
                        .withMessage("the number of steps is " + steps + ", but must be from 1 to 100000");
            }
            assertThat(snapshot(world)).isEqualTo(before);
            world.grow(a, 4, 100_000);
            assertIllegalArgument("the radius to which a circle grows is 4.0", () -> world.setBounds(0, 0, 6, 6));
            world.setRadius(a, 0.5f);
            world.setBounds(0, 0, 6, 6);
        }
    }
}
