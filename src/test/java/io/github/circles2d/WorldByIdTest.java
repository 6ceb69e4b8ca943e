package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import org.junit.jupiter.api.Test;

/** Ids, and reads that lie by id: a circle stays where it is, whichever others are removed. */
class WorldByIdTest {
    private static final float NONE = Float.NaN;

    private static World world(Backend backend) {
        return World.builder()
                .bounds(0, 0, 10, 10)
                .threads(1)
                .backend(backend)
                .capacity(0)
                .build();
    }

    private static World world() {
        return world(Backend.JVM);
    }

    private static float[] of(FloatBuffer buffer) {
        float[] values = new float[buffer.remaining()];
        buffer.get(0, values);
        return values;
    }

    @Test
    void idsAreTheLowerHalfOfHandlesAndTheLimitCountsTheMostThereWereAtATime() {
        try (World world = world()) {
            assertThat(world.idLimit()).isZero();
            long a = world.add(1, 1, 0.1f, 1);
            long b = world.add(2, 2, 0.1f, 1);
            assertThat(World.id(a)).isZero();
            assertThat(World.id(b)).isOne();
            assertThat(world.idLimit()).isEqualTo(2);
            world.remove(a);
            world.remove(b);
            assertThat(world.idLimit()).isEqualTo(2);
            for (int k = 0; k < 100; k++) {
                world.remove(world.add(1, 1, 0.1f, 1));
            }
            assertThat(world.idLimit()).isEqualTo(2);
            assertThat(World.id(world.add(1, 1, 0.1f, 1))).isZero();
        }
    }

    @Test
    void theHandleOfAnIdIsThatOfTheCircleThatHasItNow() {
        try (World world = world()) {
            long a = world.add(1, 1, 0.1f, 1);
            long b = world.add(2, 2, 0.1f, 1);
            assertThat(world.handle(0)).isEqualTo(a);
            assertThat(world.handle(1)).isEqualTo(b);
            world.remove(a);
            assertThat(world.handle(0)).isZero();
            long c = world.add(3, 3, 0.1f, 1);
            assertThat(world.handle(0)).isEqualTo(c).isNotEqualTo(a);
            for (int id : new int[] {-1, 2, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
                assertIllegalArgument("" + id, () -> world.handle(id));
            }
        }
    }

    @OnEachBackend
    void aCircleStaysAtItsIdWhicheverOthersAreRemoved(Backend backend) {
        try (World world = world(backend)) {
            long a = world.add(1, 1.5f, 0.1f, 1);
            world.add(2, 2.5f, 0.2f, 2, 3, 4);
            long c = world.add(3, 3.5f, 0.3f, Float.POSITIVE_INFINITY);
            world.remove(a);
            float[] circles = new float[16];
            float[] velocities = new float[6];
            long[] living = {-1, -1};
            world.readById(circles, living);
            assertThat(circles)
                    .containsExactly(
                            NONE, NONE, NONE, NONE, 2, 2.5f, 0.2f, 2, 3, 3.5f, 0.3f, 1 / 0f, NONE, NONE, NONE, NONE);
            assertThat(living).containsExactly(6, 0);
            world.readVelocitiesById(velocities, living);
            assertThat(velocities).containsExactly(NONE, NONE, 3, 4, 0, 0);
            assertThat(of(world.positionsById(living))).containsExactly(NONE, NONE, 2, 2.5f, 3, 3.5f);
            assertThat(of(world.positions())).containsExactly(2, 2.5f, 3, 3.5f);
            world.remove(c);
            world.add(4, 4.5f, 0.1f, 1);
            assertThat(of(world.positionsById(living))).containsExactly(4, 4.5f, 2, 2.5f, NONE, NONE);
            assertThat(living).containsExactly(3, 0);
            world.readById(circles, null);
            assertThat(circles).startsWith(4, 4.5f, 0.1f, 1, 2, 2.5f).endsWith(NONE, NONE, NONE, NONE);
        }
    }

    @Test
    void kindsAndTagsAreReadByIdWithoutGapsOfOthersShowing() {
        try (World world = world(Backend.JVM)) {
            long a = world.add(1, 1.5f, 0.1f, 1, 0, 0, 7);
            long b = world.add(2, 2.5f, 0.1f, 1);
            long c = world.add(3, 3.5f, 0.1f, 1, 0, 0, 255);
            world.setTag(a, 5);
            world.setTag(c, Long.MIN_VALUE);
            int[] kinds = new int[5];
            long[] tags = {9, 9, 9, 9, 9};
            long[] living = {-1, -1};
            world.readKindsById(kinds, living);
            assertThat(kinds).containsExactly(7, 0, 255, -1, -1);
            assertThat(living).containsExactly(7, 0);
            world.readTagsById(tags, null);
            assertThat(tags).containsExactly(5, 0, Long.MIN_VALUE, 0, 0);
            world.remove(a);
            world.setKind(b, 3);
            world.readKindsById(kinds, null);
            assertThat(kinds).containsExactly(-1, 3, 255, -1, -1);
            world.readTagsById(tags, living);
            assertThat(tags).containsExactly(0, 0, Long.MIN_VALUE, 0, 0);
            assertThat(living).containsExactly(6, 0);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.readKindsById(new int[2], null))
                    .withMessage("kinds has room for 2 elements, but needs 3");
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.readTagsById(new long[2], null))
                    .withMessage("tags has room for 2 elements, but needs 3");
            assertThatIllegalArgumentException().isThrownBy(() -> world.readTagsById(tags, new long[0]));
        }
    }

    @OnEachBackend
    void positionsRequestedAreShownOfTheCirclesThatAreStillThere(Backend backend) {
        try (World world = world(backend)) {
            long a = world.add(1, 1.5f, 0.1f, 1);
            long b = world.add(2, 2.5f, 0.1f, 1, 60, 0);
            world.add(3, 3.5f, 0.1f, 1);
            world.requestPositions();
            world.remove(a);
            world.add(4, 4.5f, 0.1f, 1); // has the id of a
            world.remove(b);
            world.add(5, 5.5f, 0.1f, 1);
            world.add(6, 6.5f, 0.1f, 1);
            world.step(1 / 60f);
            long[] living = {-1};
            assertThatIllegalArgumentException().isThrownBy(() -> world.takePositionsById(new long[0]));
            assertThat(of(world.takePositionsById(living))).containsExactly(NONE, NONE, NONE, NONE, 3, 3.5f);
            assertThat(living).containsExactly(4);
            assertThatIllegalStateException().isThrownBy(() -> world.takePositionsById(null));

            world.requestPositions();
            world.step(1 / 60f);
            assertThat(of(world.takePositionsById(null))).containsExactly(4, 4.5f, 5, 5.5f, 3, 3.5f, 6, 6.5f);
        }
    }

    @OnEachBackend
    void aRestoreShowsOfARequestTheCirclesThatItLeavesThere(Backend backend) {
        try (World world = world(backend)) {
            world.add(1, 1.5f, 0.1f, 1);
            long b = world.add(2, 2.5f, 0.1f, 1);
            ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(snapshot);
            world.remove(b);
            world.add(3, 3.5f, 0.1f, 1); // has the id of b
            world.add(4, 4.5f, 0.1f, 1);
            world.requestPositions();
            world.restore(snapshot.flip());
            long[] living = new long[1];
            assertThat(of(world.takePositionsById(living))).containsExactly(1, 1.5f, NONE, NONE, NONE, NONE);
            assertThat(living).containsExactly(1);
            assertThat(world.idLimit()).isEqualTo(2);
            assertThat(of(world.positionsById(living))).containsExactly(1, 1.5f, 2, 2.5f);
        }
    }

    @OnEachBackend
    void manyGapsInManyWordsAreWhereTheyBelong(Backend backend) {
        try (World world = world(backend)) {
            int n = 1000;
            long[] handles = new long[n];
            for (int k = 0; k < n; k++) {
                handles[k] = world.add(0.01f * k, 5, 0.001f, 1);
            }
            for (int k = 0; k < n; k++) {
                if (k % 7 == 3 || k / 64 == 4 || k == n - 1) {
                    world.remove(handles[k]);
                }
            }
            float[] circles = new float[4 * n];
            long[] living = new long[(n + 63) / 64];
            world.readById(circles, living);
            FloatBuffer positions = world.positionsById(null);
            world.requestPositions();
            FloatBuffer requested = world.takePositionsById(null);
            for (int k = 0; k < n; k++) {
                boolean lives = world.contains(handles[k]);
                assertThat((living[k >> 6] >>> k & 1) != 0).isEqualTo(lives);
                float x = lives ? 0.01f * k : NONE;
                assertThat(new float[] {circles[4 * k], positions.get(2 * k), requested.get(2 * k)})
                        .containsExactly(x, x, x);
            }
        }
    }

    @Test
    void arraysThatAreTooShortAreRefusedWithTheLengthThatIsNeeded() {
        try (World world = world()) {
            for (int k = 0; k < 65; k++) {
                world.add(5, 5, 0.1f, 1);
            }
            assertIllegalArgument("260", () -> world.readById(new float[4 * 65 - 1], null));
            assertIllegalArgument("130", () -> world.readVelocitiesById(new float[2 * 65 - 1], null));
            assertIllegalArgument(
                    "living has room for 1 elements, but needs 2",
                    () -> world.readById(new float[4 * 65], new long[1]));
            assertThatIllegalArgumentException().isThrownBy(() -> world.positionsById(new long[1]));
        }
    }

    @Test
    void aWorldWithoutCirclesHasNothingById() {
        try (World world = world()) {
            float[] circles = {1, 2};
            world.readById(circles, new long[0]);
            assertThat(circles).containsExactly(NONE, NONE);
            assertThat(world.positionsById(null).remaining()).isZero();
            world.requestPositions();
            assertThat(world.takePositionsById(null).remaining()).isZero();
        }
    }
}
