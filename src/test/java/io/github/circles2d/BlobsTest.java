package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.offset;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Soft bodies: who is joined to whom, and that they stay in shape. */
class BlobsTest {
    private static final float STEP = 1 / 60f;

    private static World world(float gravity) {
        return WorldScenes.jvm()
                .bounds(-50, 0, 50, 50)
                .gravity(0, gravity)
                .friction(0.6f)
                .threads(1)
                .build();
    }

    private static double area(World world, long[] ring) {
        double sum = 0;
        for (int k = 0; k < ring.length; k++) {
            long next = ring[(k + 1) % ring.length];
            sum += 0.5 * ((double) world.x(ring[k]) * world.y(next) - (double) world.x(next) * world.y(ring[k]));
        }
        return sum;
    }

    /** A ring of 24 that falls on the floor. */
    @Test
    void aRingKeepsItsArea() {
        try (World world = world(-10)) {
            JointedCircles ring = Blobs.ring(world, 0, 4, 2, 24, 0.24f, 1, 10, 0.7f);
            double first = area(world, ring.circles());
            double least = first;
            for (int k = 0; k < 1200; k++) {
                world.step(STEP);
                least = Math.min(least, area(world, ring.circles()));
            }
            assertThat(least / first).isBetween(0.8, 0.99);
            assertThat(area(world, ring.circles()) / first).isBetween(0.9, 1.0);
            double speed = 0;
            for (long circle : ring.circles()) {
                speed += Math.hypot(world.vx(circle), world.vy(circle)) / 24;
            }
            assertThat(speed).isLessThan(0.1);
        }
    }

    /** No two joints hold the same circles. */
    @ParameterizedTest
    @CsvSource({"3, 3", "4, 6", "5, 10", "6, 15", "7, 21", "8, 20", "24, 60", "25, 75"})
    void aRingHasSpringsAroundAndAcross(int count, int joints) {
        try (World world = world(0)) {
            JointedCircles ring = Blobs.ring(world, 0, 10, 3, count, 0.2f, 1, 8, 0.5f);
            assertThat(ring.circles()).hasSize(count).doesNotContain(0);
            assertThat(ring.joints()).hasSize(joints).doesNotContain(0);
            assertPairsDiffer(world, ring);
            for (long circle : ring.circles()) {
                assertThat(Math.hypot(world.x(circle), world.y(circle) - 10)).isCloseTo(3, offset(1e-4));
            }
            long last = ring.joints()[joints - 1];
            boolean hasAcross = count > 3 && count != 5;
            assertThat(world.joints().joint(last).hertz()).isEqualTo(hasAcross ? 0.4f * 8 : 8);
            assertThat(world.joints().joint(ring.joints()[0]).hertz()).isEqualTo(8);
            assertStaysAsItIs(world, ring);
        }
    }

    private static void assertPairsDiffer(World world, JointedCircles blob) {
        Set<Long> pairs = new HashSet<>();
        for (long joint : blob.joints()) {
            int a = World.id(world.joints().circle(joint));
            int b = World.id(world.joints().other(joint));
            assertThat(pairs.add((long) Math.min(a, b) << 32 | Math.max(a, b))).isTrue();
        }
    }

    /** All springs are at rest. */
    private static void assertStaysAsItIs(World world, JointedCircles blob) {
        world.step(STEP, 5);
        for (long circle : blob.circles()) {
            assertThat(Math.hypot(world.vx(circle), world.vy(circle))).isLessThan(1e-3);
        }
    }

    @ParameterizedTest
    @CsvSource({"2, 2, 5", "3, 2, 9", "4, 5, 43", "8, 6, 117"})
    void aLatticeJoinsEachToTheSixAround(int columns, int rows, int joints) {
        try (World world = world(0)) {
            JointedCircles block = Blobs.lattice(world, 1, 10, columns, rows, 0.5f, 0.2f, 1, 15, 0.5f);
            assertThat(block.circles()).hasSize(columns * rows).doesNotContain(0);
            assertThat(block.joints()).hasSize(joints).doesNotContain(0);
            assertPairsDiffer(world, block);
            for (long joint : block.joints()) {
                assertThat(world.joints().joint(joint).length()).isCloseTo(0.5f, offset(1e-5f));
            }
            double x = 0;
            double y = 0;
            for (long circle : block.circles()) {
                x += world.x(circle) / block.circles().length;
                y += world.y(circle) / block.circles().length;
            }
            assertThat(y).isCloseTo(10, offset(1e-4));
            assertThat(x).isCloseTo(1, offset(0.13)); // an odd number of rows has one more at the left
            assertStaysAsItIs(world, block);
        }
    }

    @Test
    void aLatticeThatFallsStaysABlock() {
        try (World world = world(-10)) {
            JointedCircles block = Blobs.lattice(world, 0, 5, 8, 6, 0.5f, 0.24f, 0.2f, 20, 0.5f);
            world.step(STEP, 600);
            for (long joint : block.joints()) {
                long a = world.joints().circle(joint);
                long b = world.joints().other(joint);
                assertThat(Math.hypot(world.x(a) - world.x(b), world.y(a) - world.y(b)))
                        .isCloseTo(0.5, offset(0.1));
            }
            for (long circle : block.circles()) {
                assertThat(world.y(circle)).isBetween(0.2f, 3f);
                assertThat(Math.hypot(world.vx(circle), world.vy(circle))).isLessThan(0.1);
            }
        }
    }

    @Test
    void aClothHangsByItsCorners() {
        try (World world = world(-10)) {
            JointedCircles cloth = Blobs.cloth(world, 0, 30, 12, 8, 0.5f, 0.15f, 0.05f, 20, 0.5f);
            int threads = 11 * 8 + 12 * 7;
            assertThat(cloth.circles()).hasSize(96);
            assertThat(cloth.joints()).hasSize(threads + 2 * 11 * 7);
            assertPairsDiffer(world, cloth);
            for (int k = 0; k < 2; k++) {
                long corner = cloth.circles()[96 - 12 + 11 * k];
                world.joints().add(corner, world.x(corner), world.y(corner), Joint.pin());
            }
            float lowest = world.y(cloth.circles()[0]);
            world.step(STEP, 600);
            assertThat(world.y(cloth.circles()[6])).isBetween(lowest - 4, lowest);
            for (int k = 0; k < threads; k++) {
                long joint = cloth.joints()[k];
                long a = world.joints().circle(joint);
                long b = world.joints().other(joint);
                assertThat(Math.hypot(world.x(a) - world.x(b), world.y(a) - world.y(b)))
                        .isBetween(0.1, 0.5 * 1.1);
            }
        }
    }

    @Test
    void allCirclesAreOfTheKindThatTheCallSays() {
        try (World world = world(0)) {
            world.kind(5).setRestitution(0.75f);
            JointedCircles[] all = {
                Blobs.ring(world, 0, 10, 2, 24, 0.2f, 1, 10, 1, 5),
                Blobs.lattice(world, 10, 10, 4, 6, 1, 0.2f, 1, 10, 1, 5),
                Blobs.cloth(world, 20, 10, 6, 4, 1, 0.2f, 1, 10, 1, 5)
            };
            for (JointedCircles made : all) {
                assertThat(made.circles()).hasSize(24);
                for (long circle : made.circles()) {
                    assertThat(world.kindOf(circle)).isEqualTo(5);
                }
                assertThat(world.restitution(made.circles()[23])).isEqualTo(0.75f);
            }
            assertThat(world.kindOf(
                            Blobs.ring(world, 0, 20, 2, 24, 0.2f, 1, 10, 1).circles()[0]))
                    .isZero();
        }
    }

    @Test
    void whatCannotBeIsRefusedAndNothingIsAdded() {
        try (World world = world(0)) {
            refused(world, "radius is 0", () -> Blobs.ring(world, 0, 10, 0, 24, 0.2f, 1, 10, 1));
            refused(world, "radius is NaN", () -> Blobs.ring(world, 0, 10, Float.NaN, 24, 0.2f, 1, 10, 1));
            refused(world, "number of circles", () -> Blobs.ring(world, 0, 10, 2, 2, 0.2f, 1, 10, 1));
            refused(world, "frequency is -1", () -> Blobs.ring(world, 0, 10, 2, 24, 0.2f, 1, -1, 1));
            refused(world, "damping ratio is NaN", () -> Blobs.ring(world, 0, 10, 2, 24, 0.2f, 1, 10, Float.NaN));
            refused(world, "mass", () -> Blobs.ring(world, 0, 10, 2, 24, 0.2f, -1, 10, 1));
            refused(world, "static", () -> Blobs.ring(world, 0, 10, 2, 24, 0.2f, Float.POSITIVE_INFINITY, 10, 1));
            refused(world, "columns is 1", () -> Blobs.lattice(world, 0, 10, 1, 5, 1, 0.2f, 1, 10, 1));
            refused(world, "rows is 0", () -> Blobs.cloth(world, 0, 10, 5, 0, 1, 0.2f, 1, 10, 1));
            refused(world, "must be at most", () -> Blobs.cloth(world, 0, 10, 50_000, 50_000, 1, 0.2f, 1, 10, 1));
            refused(world, "spacing is -1", () -> Blobs.lattice(world, 0, 10, 5, 5, -1, 0.2f, 1, 10, 1));
            refused(world, "the kind is 256", () -> Blobs.ring(world, 0, 10, 2, 24, 0.2f, 1, 10, 1, 256));
            refused(world, "the kind is -1", () -> Blobs.lattice(world, 0, 10, 5, 5, 1, 0.2f, 1, 10, 1, -1));
            refused(world, "the kind is 999", () -> Blobs.cloth(world, 0, 10, 5, 5, 1, 0.2f, 1, 10, 1, 999));
            refused(world, "x is", () -> Blobs.lattice(world, 1e6f, 10, 5, 5, 1, 0.2f, 1, 10, 1));
        }
    }

    private static void refused(World world, String message, Runnable call) {
        int circles = world.size();
        int joints = world.joints().size();
        assertThatIllegalArgumentException().isThrownBy(call::run).withMessageContaining(message);
        assertThat(world.size()).isEqualTo(circles);
        assertThat(world.joints().size()).isEqualTo(joints);
    }
}
