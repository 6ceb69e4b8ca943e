package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.nio.ByteBuffer;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Calls about many bodies: each equals single calls, and is made for all of them or for none. */
class WorldBodiesBulkTest {
    private static final Outline CRATE = Outline.box(1, 0.5f);
    private static final Outline WHEEL = Outline.capsule(0.2f, 0.3f);

    /** x, y, angle, mass. */
    private static final float[] THREE = {4, 5, 0.5f, 2, 8, 5, -0.25f, 1, 12, 5, 0, 3};

    private static World world() {
        World world =
                WorldScenes.jvm().bounds(0, 0, 20, 10).gravity(0, 0).threads(1).build();
        world.kind(3).setRestitution(0.75f);
        return world;
    }

    /** A call about many bodies with three values for each, of which some use fewer, and the single calls that do the same. */
    private record Bulk(String name, Many many, One one) {
        private interface Many {
            int call(Bodies bodies, long[] handles, int count, float[] values, StaleHandles stale);
        }

        private interface One {
            void call(Bodies bodies, long handle, float a, float b, float c);
        }

        @Override
        public String toString() {
            return name;
        }
    }

    private static float[] pairs(float[] values) {
        float[] pairs = new float[values.length / 3 * 2];
        for (int k = 0; k < pairs.length; k++) {
            pairs[k] = values[k / 2 * 3 + k % 2];
        }
        return pairs;
    }

    private static int[] kinds(float[] values) {
        int[] kinds = new int[values.length / 3];
        for (int k = 0; k < kinds.length; k++) {
            kinds[k] = (int) values[3 * k];
        }
        return kinds;
    }

    static List<Bulk> bulks() {
        return List.of(
                new Bulk("teleportAll", Bodies::teleportAll, Bodies::teleport),
                new Bulk("setVelocities", Bodies::setVelocities, (bodies, h, a, b, c) -> {
                    bodies.setVelocity(h, a, b);
                    bodies.setAngularVelocity(h, c);
                }),
                new Bulk(
                        "applyImpulses",
                        (bodies, h, n, v, s) -> bodies.applyImpulses(h, n, pairs(v), s),
                        (bodies, h, a, b, c) -> bodies.applyImpulse(h, a, b)),
                new Bulk("setForces", Bodies::setForces, (bodies, h, a, b, c) -> {
                    bodies.setForce(h, a, b);
                    bodies.setTorque(h, c);
                }),
                new Bulk(
                        "setKinds",
                        (bodies, h, n, v, s) -> bodies.setKinds(h, n, kinds(v), s),
                        (bodies, h, a, b, c) -> bodies.setKind(h, (int) a)),
                new Bulk(
                        "removeAll",
                        (bodies, h, n, v, s) -> bodies.removeAll(h, n, s),
                        (bodies, h, a, b, c) -> bodies.remove(h)));
    }

    private static long[] add(World world) {
        long[] handles = new long[3];
        world.bodies().addAll(CRATE, THREE, null, handles);
        world.joints().add(handles[0], 0, 0, handles[1], 0, 0, Joint.rope(9));
        return handles;
    }

    @ParameterizedTest
    @MethodSource("bulks")
    void aCallAboutManyEqualsSingleCalls(Bulk bulk) {
        float[] values = {3, 2, 1, 9, 8, 7, 5, 4, 0.5f, 1, 6, 2};
        try (World world = world();
                World other = world()) {
            long[] handles = add(world);
            add(other);
            assertThat(bulk.many.call(world.bodies(), handles, 2, values, StaleHandles.REFUSE))
                    .isZero();
            for (int k = 0; k < 2; k++) {
                bulk.one.call(other.bodies(), handles[k], values[3 * k], values[3 * k + 1], values[3 * k + 2]);
            }
            assertThat(snapshot(world)).isEqualTo(snapshot(other));
            world.step(1 / 60f, 10);
            other.step(1 / 60f, 10);
            assertThat(world.hash()).isEqualTo(other.hash());
        }
    }

    @ParameterizedTest
    @MethodSource("bulks")
    void staleHandlesAreRefusedOrLeftOut(Bulk bulk) {
        float[] values = {3, 2, 1, Float.NaN, Float.NaN, Float.NaN, 5, 4, 0.5f};
        try (World world = world();
                World other = world()) {
            long[] handles = add(world);
            add(other);
            world.bodies().remove(handles[1]);
            other.bodies().remove(handles[1]);
            ByteBuffer before = snapshot(world);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> bulk.many.call(world.bodies(), handles, 3, values, StaleHandles.REFUSE))
                    .withMessageStartingWith("handle 1: ")
                    .withMessageContaining("was removed");
            assertIllegalArgument(
                    "count is 4", () -> bulk.many.call(world.bodies(), handles, 4, values, StaleHandles.SKIP));
            assertThat(snapshot(world)).isEqualTo(before);
            assertThat(bulk.many.call(world.bodies(), handles, 3, values, StaleHandles.SKIP))
                    .isOne();
            bulk.one.call(other.bodies(), handles[0], 3, 2, 1);
            bulk.one.call(other.bodies(), handles[2], 5, 4, 0.5f);
            assertThat(snapshot(world)).isEqualTo(snapshot(other));
        }
    }

    @ParameterizedTest
    @MethodSource("bulks")
    void aBadValueIsNamedAndNobodyHasChanged(Bulk bulk) {
        float[] values = {3, 2, 1, 4, 4, 4, 1e19f, 4, 0.5f};
        try (World world = world()) {
            long[] handles = add(world);
            ByteBuffer before = snapshot(world);
            if (!bulk.name.equals("removeAll")) {
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> bulk.many.call(world.bodies(), handles, 3, values, StaleHandles.SKIP))
                        .withMessageStartingWith("body 2: ");
                assertIllegalArgument(
                        "for each of 3 handles",
                        () -> bulk.many.call(world.bodies(), handles, 3, new float[6], StaleHandles.SKIP));
            }
            long[] twice = {handles[2], handles[0], handles[2]};
            if (bulk.name.equals("removeAll")) {
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> bulk.many.call(world.bodies(), twice, 3, values, StaleHandles.REFUSE))
                        .withMessageStartingWith("handle 2: ")
                        .withMessageContaining("occurs twice");
                assertThat(snapshot(world)).isEqualTo(before);
                assertThat(bulk.many.call(world.bodies(), twice, 3, values, StaleHandles.SKIP))
                        .isOne();
                assertThat(world.bodies().size()).isOne();
            } else {
                assertThat(snapshot(world)).isEqualTo(before);
            }
        }
    }

    @Test
    void manyThatComeEqualThoseThatComeOneByOne() {
        Outline[] outlines = {CRATE, WHEEL, CRATE};
        int[] kinds = {3, 0, 7};
        try (World world = world();
                World other = world()) {
            long[] handles = new long[4];
            long gone = world.bodies().add(WHEEL, 4, 5, 0, 1);
            world.bodies().remove(gone);
            other.bodies().remove(other.bodies().add(WHEEL, 4, 5, 0, 1));
            world.bodies().addAll(outlines, THREE, kinds, handles);
            for (int k = 0; k < 3; k++) {
                long handle = other.bodies()
                        .add(outlines[k], THREE[4 * k], THREE[4 * k + 1], THREE[4 * k + 2], THREE[4 * k + 3], kinds[k]);
                assertThat(handles[k]).isEqualTo(handle);
            }
            assertThat(handles[3]).isZero();
            assertThat(world.bodies().restitution(handles[0])).isEqualTo(0.75f);
            world.bodies().addAll(CRATE, new float[0], null, null);
            assertThat(snapshot(world)).isEqualTo(snapshot(other));
        }
    }

    @Test
    void oneThatIsRefusedKeepsAllAway() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            ByteBuffer before = snapshot(world);
            float[] bad = THREE.clone();
            bad[7] = 0;
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> bodies.addAll(CRATE, bad, null, null))
                    .withMessageStartingWith("body 1: mass");
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> bodies.addAll(CRATE, THREE, new int[] {0, 1, 256}, null))
                    .withMessageStartingWith("body 2: ");
            Outline[] outlines = {CRATE, CRATE, Outline.box(30, 1)};
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> bodies.addAll(outlines, THREE, null, null))
                    .withMessageStartingWith("body 2: the reach");
            outlines[1] = null;
            assertThatNullPointerException()
                    .isThrownBy(() -> bodies.addAll(outlines, THREE, null, null))
                    .withMessageStartingWith("outline 1 ");
            assertIllegalArgument("outlines has 1", () -> bodies.addAll(new Outline[] {CRATE}, THREE, null, null));
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.addAll(CRATE, new float[5], null, null));
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.addAll(CRATE, THREE, new int[2], null));
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.addAll(CRATE, THREE, null, new long[2]));
            float[] many = new float[4 * 65_536];
            for (int k = 0; k < many.length; k++) {
                many[k] = 1;
            }
            bodies.add(CRATE, 4, 5, 0, 1);
            assertIllegalArgument("at most 65536 bodies", () -> bodies.addAll(CRATE, many, null, null));
            bodies.clear();
            assertThat(bodies.size()).isZero();
            assertThat(before.remaining()).isLessThan(snapshot(world).remaining()); // an id has been in use
        }
    }
}
