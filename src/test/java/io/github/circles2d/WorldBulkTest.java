package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Changes of many circles at once: all or nothing, with stale handles refused or skipped; and explosions. */
class WorldBulkTest {
    private static World world() {
        World world = WorldScenes.jvm().bounds(0, 0, 10, 10).threads(1).build();
        world.kind(4).setRestitution(0.75f);
        return world;
    }

    /** A call with many handles and two values for each, of which some use the second, and the call with one that does the same. */
    private record Bulk(String name, Many many, One one) {
        private interface Many {
            int call(World world, long[] handles, int count, float[] values, StaleHandles stale);
        }

        private interface One {
            void call(World world, long handle, float a, float b);
        }

        @Override
        public String toString() {
            return name;
        }
    }

    static List<Bulk> bulks() {
        return List.of(
                new Bulk("setPositions", World::setPositions, World::setPosition),
                new Bulk("setVelocities", World::setVelocities, World::setVelocity),
                new Bulk("applyImpulses", World::applyImpulses, World::applyImpulse),
                new Bulk("setForces", World::setForces, World::setForce),
                new Bulk(
                        "setKinds",
                        (w, h, n, v, s) -> w.setKinds(h, n, kinds(v), s),
                        (w, h, a, b) -> w.setKind(h, (int) b)),
                new Bulk(
                        "setAngularVelocities",
                        (w, h, n, v, s) -> w.setAngularVelocities(h, n, seconds(v), s),
                        (w, h, a, b) -> w.setAngularVelocity(h, b)),
                new Bulk("removeAll", (w, h, n, v, s) -> w.removeAll(h, n, s), (w, h, a, b) -> w.remove(h)));
    }

    private static float[] seconds(float[] values) {
        float[] seconds = new float[values.length / 2];
        for (int k = 0; k < seconds.length; k++) {
            seconds[k] = values[2 * k + 1];
        }
        return seconds;
    }

    private static int[] kinds(float[] values) {
        int[] kinds = new int[values.length / 2];
        for (int k = 0; k < kinds.length; k++) {
            kinds[k] = (int) values[2 * k + 1];
        }
        return kinds;
    }

    private static long[] add(World world, int count) {
        long[] handles = new long[count];
        for (int k = 0; k < count; k++) {
            handles[k] = world.add(1 + k % 8, 1 + k / 8, 0.4f, k % 7 == 3 ? Float.POSITIVE_INFINITY : 1 + k);
        }
        return handles;
    }

    private static float[] values(int count) {
        float[] values = new float[2 * count];
        for (int k = 0; k < values.length; k++) {
            values[k] = 0.5f + k * 0.25f % 9;
        }
        return values;
    }

    @ParameterizedTest
    @MethodSource("bulks")
    void aBulkCallDoesWhatTheCallsOneByOneDo(Bulk bulk) {
        try (World world = world();
                World same = world()) {
            long[] handles = add(world, 20);
            add(same, 20);
            float[] values = values(20);
            assertThat(bulk.many().call(world, handles, 12, values, StaleHandles.REFUSE))
                    .isZero();
            for (int k = 0; k < 12; k++) {
                bulk.one().call(same, handles[k], values[2 * k], values[2 * k + 1]);
            }
            assertThat(world.hash()).isEqualTo(same.hash());
            world.step(1 / 60f);
            same.step(1 / 60f);
            assertThat(world.hash()).isEqualTo(same.hash());
            assertThat(world.size()).isEqualTo(same.size());
            assertThat(world.vx(handles[13])).isEqualTo(same.vx(handles[13]));
        }
    }

    @ParameterizedTest
    @MethodSource("bulks")
    void aStaleHandleIsRefusedBeforeAnythingHasChanged(Bulk bulk) {
        try (World world = world()) {
            long[] handles = add(world, 20);
            world.remove(handles[19]);
            long hash = world.hash();
            for (long stale : new long[] {handles[19], 0, -1, Long.MAX_VALUE}) {
                handles[11] = stale;
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> bulk.many().call(world, handles, 12, values(12), StaleHandles.REFUSE))
                        .withMessageContaining("handle 11")
                        .withMessageContaining("" + stale);
                assertThat(world.hash()).isEqualTo(hash);
                assertThat(world.size()).isEqualTo(19);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("bulks")
    void whereAskedForStaleHandlesAreSkippedWithTheirValuesAndCounted(Bulk bulk) {
        try (World world = world();
                World same = world()) {
            long[] handles = add(world, 20);
            add(same, 20);
            for (int k = 1; k < 20; k += 3) {
                world.remove(handles[k]);
                same.remove(handles[k]);
            }
            float[] values = values(20);
            values[2] = Float.NaN; // of handle 1
            values[3] = 1e30f;
            assertThat(bulk.many().call(world, handles, 20, values, StaleHandles.SKIP))
                    .isEqualTo(7);
            for (int k = 0; k < 20; k++) {
                if (k % 3 != 1) {
                    bulk.one().call(same, handles[k], values[2 * k], values[2 * k + 1]);
                }
            }
            assertThat(world.hash()).isEqualTo(same.hash());
        }
    }

    @ParameterizedTest
    @MethodSource("bulks")
    void lengthsThatDoNotFitAreRefused(Bulk bulk) {
        try (World world = world()) {
            long[] handles = add(world, 4);
            long hash = world.hash();
            for (int count : new int[] {-1, 5, Integer.MIN_VALUE, Integer.MAX_VALUE}) {
                assertIllegalArgument(
                        "" + count, () -> bulk.many().call(world, handles, count, values(4), StaleHandles.SKIP));
            }
            if (!bulk.name().equals("removeAll")) {
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> bulk.many().call(world, handles, 4, new float[7], StaleHandles.SKIP))
                        .withMessageEndingWith(
                                switch (bulk.name()) {
                                    case "setKinds" -> "kinds has 3 elements, but must have 4: 1 for each of 4 handles";
                                    case "setAngularVelocities" ->
                                        "angularVelocities has 3 elements, but must have 4: 1 for each of 4 handles";
                                    default -> " has 7 elements, but must have 8: 2 for each of 4 handles";
                                });
            }
            assertThat(bulk.many().call(world, handles, 0, values(0), StaleHandles.REFUSE))
                    .isZero();
            assertThat(world.hash()).isEqualTo(hash);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "setPositions, 11",
        "setPositions, NaN",
        "setVelocities, 2e9",
        "applyImpulses, 2e18",
        "setForces, 2e18",
        "setForces, NaN",
        "setAngularVelocities, 2e9",
        "setAngularVelocities, NaN",
        "setKinds, 256",
        "setKinds, -1"
    })
    void aValueOutOfRangeIsRefusedWithItsPlaceBeforeAnythingHasChanged(String name, float bad) {
        Bulk bulk = bulks().stream()
                .filter(each -> each.name().equals(name))
                .findFirst()
                .orElseThrow();
        try (World world = world()) {
            long[] handles = add(world, 6);
            long hash = world.hash();
            float[] values = values(6);
            values[9] = bad;
            for (StaleHandles stale : StaleHandles.values()) {
                assertIllegalArgument("circle 4: ", () -> bulk.many().call(world, handles, 6, values, stale));
                assertThat(world.hash()).isEqualTo(hash);
            }
        }
    }

    @Test
    void aHandleThatOccursTwiceIsStaleTheSecondTimeItIsRemoved() {
        try (World world = world()) {
            long[] handles = add(world, 70);
            handles[69] = handles[66];
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.removeAll(handles, 70, StaleHandles.REFUSE))
                    .withMessage("handle 69: the circle with the handle " + handles[66] + " occurs twice");
            assertThat(world.size()).isEqualTo(70);
            assertThat(world.removeAll(handles, 70, StaleHandles.SKIP)).isOne();
            assertThat(world.size()).isOne();
            assertThat(world.removeAll(handles, 70, StaleHandles.SKIP)).isEqualTo(70);
            assertThat(World.id(world.add(1, 1, 0.1f, 1))).isZero();
        }
    }

    @Test
    void aHandleThatOccursTwiceIsPushedTwice() {
        try (World world = world()) {
            long a = world.add(5, 5, 1, 2);
            world.applyImpulses(new long[] {a, a}, 2, new float[] {1, 0, 3, -2}, StaleHandles.REFUSE);
            assertThat(world.vx(a)).isEqualTo(2);
            assertThat(world.vy(a)).isEqualTo(-1);
        }
    }

    @Test
    void circlesAreAddedWithTheirKindsAsOneByOne() {
        try (World world = world();
                World same = world()) {
            add(world, 5);
            add(same, 5);
            float[] circles = {1, 5, 0.2f, 1, 2, 5, 0.3f, 2, 3, 5, 0.4f, 3};
            float[] velocities = {1, 2, 3, 4, 5, 6};
            long[] handles = new long[3];
            world.addAll(circles, velocities, new int[] {4, 0, 255}, handles);
            same.add(1, 5, 0.2f, 1, 1, 2, 4);
            same.add(2, 5, 0.3f, 2, 3, 4);
            same.add(3, 5, 0.4f, 3, 5, 6, 255);
            assertThat(world.hash()).isEqualTo(same.hash());
            assertThat(world.kindOf(handles[0])).isEqualTo(4);
            assertThat(world.restitution(handles[0])).isEqualTo(0.75f);
            assertThat(world.kindOf(handles[1])).isZero();
            assertThat(world.kindOf(handles[2])).isEqualTo(255);
            world.addAll(circles, null, null, null);
            assertThat(world.size()).isEqualTo(11);
            long hash = world.hash();
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.addAll(circles, null, new int[] {0, 256, 0}, null))
                    .withMessage("circle 1: the kind is 256, but must be from 0 to 255");
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.addAll(circles, null, new int[2], null))
                    .withMessage("kinds has 2 elements, but must have one for each of 3");
            assertThat(world.hash()).isEqualTo(hash);
        }
    }

    @Test
    void kindsThatAreGivenAtOnceComeWithTheirRestitutionsAndAreInSnapshots() {
        try (World world = world()) {
            long[] handles = add(world, 3);
            world.setKinds(handles, 3, new int[] {4, 4, 1}, StaleHandles.REFUSE);
            assertThat(world.restitution(handles[1])).isEqualTo(0.75f);
            assertThat(world.restitution(handles[2])).isEqualTo(0.5f);
            ByteBuffer snapshot = snapshot(world);
            try (World restored = world()) {
                restored.restore(snapshot);
                assertThat(restored.kindOf(handles[1])).isEqualTo(4);
                assertThat(restored.hash()).isEqualTo(world.hash());
            }
        }
    }

    @Test
    void moreChangesThanWaitAtATimeAreAllMade() {
        try (World world = world()) {
            long a = world.add(5, 5, 1, 1);
            int n = 100_000;
            long[] handles = new long[n];
            float[] impulses = new float[2 * n];
            for (int k = 0; k < n; k++) {
                handles[k] = a;
                impulses[2 * k] = 0.5f;
            }
            for (int k = 0; k < 3; k++) {
                world.applyImpulses(handles, n, impulses, StaleHandles.REFUSE);
            }
            assertThat(world.vx(a)).isEqualTo(150_000);
        }
    }

    // ---- explosions

    @Test
    void anExplosionPushesWhatIsWithinReachAwayFromItByTheDistanceOfItsEdge() {
        try (World world = world()) {
            long whole = world.add(6, 5, 0.5f, 2); // its edge is 0.5 away
            long half = world.add(5, 7.5f, 0.5f, 1); // its edge is 2 away
            long none = world.add(5, 1, 0.5f, 1); // its edge is 3.5 away
            long slanted = world.add(2, 1, 4, 1); // the point is inside it, 3 and 4 away from its centre
            long post = world.add(4.5f, 5, 0.2f, Float.POSITIVE_INFINITY);
            long centred = world.add(5, 5, 0.1f, 1);
            assertThat(world.explode(5, 5, 1, 10, 2)).isEqualTo(3);
            assertThat(world.vx(whole)).isEqualTo(5);
            assertThat(world.vy(whole)).isZero();
            assertThat(world.vx(half)).isZero();
            assertThat(world.vy(half)).isEqualTo(5);
            assertThat(world.vx(slanted)).isCloseTo(-6, within(1e-5f));
            assertThat(world.vy(slanted)).isCloseTo(-8, within(1e-5f));
            for (long still : new long[] {none, post, centred}) {
                assertThat(world.vx(still)).isZero();
                assertThat(world.vy(still)).isZero();
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 0, 10", "1, 1, 10", "0.5, 1, 5", "0.5, 0.5, 0", "0.99, 0, 0", "0, 0, 0", "0, 2, 5"})
    void theWholeImpulseReachesToTheRadiusAndNoneToItsEndWithTheFalloff(float radius, float falloff, float speed) {
        try (World world = world()) {
            long a = world.add(7, 5, 1, 1); // its edge is 1 away from the point
            long b = world.add(5.5f, 5, 1, 1); // the point is inside it
            assertThat(world.explode(5, 5, radius, 10, falloff)).isEqualTo(speed > 0 ? 2 : 1);
            assertThat(world.vx(a)).isEqualTo(speed);
            assertThat(world.vx(b)).isEqualTo(10);
        }
    }

    @Test
    void anExplosionMayPullAndSeesTheChangesBeforeIt() {
        try (World world = world()) {
            long a = world.add(1, 1, 0.5f, 1);
            assertThat(world.explode(9, 5, 2, -3, 0)).isZero();
            world.setPosition(a, 7, 5);
            assertThat(world.explode(9, 5, 2, -3, 0)).isOne();
            assertThat(world.explode(9, 5, 2, -3, 0)).isOne();
            assertThat(world.vx(a)).isEqualTo(6);
            world.remove(a);
            assertThat(world.explode(9, 5, 2, -3, 0)).isZero();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "NaN, 0, 1, 1, 1",
        "0, 2e9, 1, 1, 1",
        "0, 0, -1, 1, 1",
        "0, 0, 2e10, 1, 1",
        "0, 0, 1, 2e18, 1",
        "0, 0, 1, 1, -1",
        "0, 0, 1, 1, Infinity"
    })
    void anExplosionOutOfRangeIsRefused(float x, float y, float radius, float impulse, float falloff) {
        try (World world = world()) {
            world.add(5, 5, 0.5f, 1);
            long hash = world.hash();
            assertIllegalArgument("of the explosion", () -> world.explode(x, y, radius, impulse, falloff));
            assertThat(world.hash()).isEqualTo(hash);
        }
    }

    @OnEachBackend
    void everyBackEndHasTheSameBitsAfterBulkCallsAndExplosions(Backend backend) {
        try (World world = World.builder()
                        .bounds(0, 0, 10, 10)
                        .gravity(0, -5)
                        .backend(backend)
                        .build();
                World jvm =
                        WorldScenes.jvm().bounds(0, 0, 10, 10).gravity(0, -5).build()) {
            long[] handles = add(world, 40);
            add(jvm, 40);
            for (int frame = 0; frame < 30; frame++) {
                for (World each : new World[] {world, jvm}) {
                    each.explode(0.3f * frame, 1, 1.5f, 7, 2);
                    each.explode(5, 5, 0.5f, -2, 8);
                    each.applyImpulses(handles, 9, values(9), StaleHandles.SKIP);
                    each.removeAll(handles, frame / 4, StaleHandles.SKIP);
                    each.step(1 / 60f);
                }
                assertThat(world.hash()).isEqualTo(jvm.hash());
            }
        }
    }
}
