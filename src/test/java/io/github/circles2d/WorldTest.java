package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalState;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import java.util.ConcurrentModificationException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The calls of a World: handles, order, ranges, states. */
class WorldTest {
    private static World.Builder builder() {
        return WorldScenes.jvm().bounds(0, 0, 10, 10).threads(1);
    }

    @Test
    void circlesAreReadInTheOrderOfTheirIdsAndTheLowestFreeIdIsTaken() {
        try (World world = builder().build()) {
            long a = world.add(1, 1, 0.1f, 1);
            long b = world.add(2, 2, 0.2f, 2);
            long c = world.add(3, 3, 0.3f, Float.POSITIVE_INFINITY);
            assertThat(handles(world)).containsExactly(a, b, c);
            assertThat(circles(world)).containsExactly(1, 1, 0.1f, 1, 2, 2, 0.2f, 2, 3, 3, 0.3f, 1 / 0f);
            world.remove(a);
            assertThat(handles(world)).containsExactly(b, c);
            long d = world.add(4, 4, 0.4f, 4);
            assertThat((int) d).isEqualTo((int) a);
            assertThat(d).isNotEqualTo(a);
            assertThat(handles(world)).containsExactly(d, b, c);
            assertThat(circles(world)).startsWith(4, 4, 0.4f, 4, 2, 2);
            long e = world.add(5, 5, 0.5f, 5);
            assertThat(handles(world)).containsExactly(d, b, c, e);
        }
    }

    @Test
    void everyCallRefusesAStaleHandleEvenIfItsIdIsInUseAgain() {
        try (World world = builder().build()) {
            long stale = world.add(1, 1, 0.1f, 1);
            world.remove(stale);
            world.add(2, 2, 0.1f, 1);
            long hash = world.hash();
            for (long handle : new long[] {stale, 0, -1, Long.MIN_VALUE, Long.MAX_VALUE, 1L << 32 | 77, 5}) {
                assertThat(world.contains(handle)).isFalse();
                refused(() -> world.remove(handle));
                refused(() -> world.setPosition(handle, 1, 1));
                refused(() -> world.setVelocity(handle, 1, 1));
                refused(() -> world.setRadius(handle, 1));
                refused(() -> world.grow(handle, 1, 1));
                refused(() -> world.growthSteps(handle));
                refused(() -> world.setMass(handle, 1));
                refused(() -> world.setRestitution(handle, 1));
                refused(() -> world.applyImpulse(handle, 1, 1));
                refused(() -> world.x(handle));
                refused(() -> world.vy(handle));
                refused(() -> world.restitution(handle));
                refused(() -> world.setTag(handle, 1));
                refused(() -> world.tag(handle));
            }
            assertThat(world.hash()).isEqualTo(hash);
        }
    }

    @Test
    void valuesOutOfRangeAreRefusedAndChangeNothing() {
        try (World world = builder().build()) {
            long a = world.add(1, 1, 0.1f, 1);
            long hash = world.hash();
            for (float bad : new float[] {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, 1e30f, -1e30f}) {
                refused(() -> world.add(bad, 1, 0.1f, 1));
                refused(() -> world.add(1, bad, 0.1f, 1));
                refused(() -> world.add(1, 1, bad, 1));
                refused(() -> world.add(1, 1, 0.1f, 1, bad, 0));
                refused(() -> world.add(1, 1, 0.1f, 1, 0, bad));
                refused(() -> world.setPosition(a, bad, 1));
                refused(() -> world.setVelocity(a, 1, bad));
                refused(() -> world.setRadius(a, bad));
                refused(() -> world.grow(a, bad, 1));
                refused(() -> world.setRestitution(a, bad));
                refused(() -> world.applyImpulse(a, bad, 0));
                refused(() -> world.setGravity(0, bad));
                refused(() -> world.setBounds(bad, 0, 1, 1));
                refused(() -> world.step(bad));
                refused(() -> WorldScenes.jvm().bounds(0, 0, bad, 1));
                refused(() -> WorldScenes.jvm().gravity(bad, 0));
                refused(() -> WorldScenes.jvm().restitution(bad));
                if (bad != Float.POSITIVE_INFINITY) {
                    refused(() -> world.add(1, 1, 0.1f, bad));
                    refused(() -> world.setMass(a, bad));
                }
            }
            refused(() -> world.add(11, 1, 0.1f, 1));
            refused(() -> world.add(1, 1, 0, 1));
            refused(() -> world.add(1, 1, -1, 1));
            refused(() -> world.add(1, 1, 5.1f, 1));
            refused(() -> world.add(1, 1, 1e-6f, 1));
            refused(() -> world.add(1, 1, 1, 0));
            refused(() -> world.add(1, 1, 1, -1));
            refused(() -> world.setRestitution(a, 1.01f));
            refused(() -> world.step(0));
            refused(() -> world.step(1.5f));
            refused(() -> world.step(0.1f, 0));
            refused(() -> world.setBounds(0, 0, 0.1f, 0.1f));
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.setBounds(0, 0, 0.1f, 0.1f))
                    .withMessageContaining("the greatest radius of a circle is " + world.radius(a) + ", but")
                    .withMessageEndingWith("to 0.05 in bounds from 0.0, 0.0 to 0.1, 0.1");
            refused(() -> world.setBounds(5, 0, 5, 10));
            refused(() -> WorldScenes.jvm().subSteps(0));
            refused(() -> WorldScenes.jvm().subSteps(17));
            refused(() -> WorldScenes.jvm().threads(0));
            refused(() -> WorldScenes.jvm().threads(257));
            refused(() -> WorldScenes.jvm().capacity(-1));
            assertThat(world.hash()).isEqualTo(hash);
            assertThat(world.size()).isEqualTo(1);
        }
    }

    @Test
    void addsAllOrNone() {
        try (World world = builder().build()) {
            long[] handles = new long[2];
            world.addAll(new float[] {1, 1, 0.1f, 1, 2, 2, 0.2f, 2}, new float[] {3, 4, 5, 6}, handles);
            assertThat(handles(world)).containsExactly(handles);
            assertThat(velocities(world)).containsExactly(3, 4, 5, 6);
            float[] oneBad = {3, 3, 0.1f, 1, 4, 4, Float.NaN, 1};
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.addAll(oneBad, null))
                    .withMessageContaining("circle 1")
                    .withMessageContaining("NaN");
            refused(() -> world.addAll(new float[7], null));
            refused(() -> world.addAll(new float[] {1, 1, 0.1f, 1}, new float[3], null));
            refused(() -> world.addAll(new float[] {1, 1, 0.1f, 1}, new float[] {0, Float.NaN}, null));
            refused(() -> world.addAll(new float[] {1, 1, 0.1f, 1}, new long[0]));
            assertThat(world.size()).isEqualTo(2);
            world.addAll(new float[0], null);
            world.addAll(new float[] {5, 5, 0.5f, 5}, null);
            assertThat(world.size()).isEqualTo(3);
        }
    }

    @Test
    void aBulkAddGivesTheSameWorldAsSingleAdds() {
        Scene scene = Scenes.gas(300, 1);
        try (World one = WorldScenes.world(scene, WorldScenes.builder(scene));
                World all = WorldScenes.builder(scene).build()) {
            all.addAll(circles(one), velocities(one), null);
            one.step(scene.timeStep(), 30);
            all.step(scene.timeStep(), 30);
            assertThat(all.hash()).isEqualTo(one.hash());
        }
    }

    @Test
    void changesTakeEffectInCallOrder() {
        try (World world = builder().gravity(0, -1).build()) {
            long a = world.add(1, 1, 0.1f, 2);
            world.setPosition(a, 3, 4);
            world.setVelocity(a, 1, 2);
            world.applyImpulse(a, 4, -2);
            world.setMass(a, 4);
            world.applyImpulse(a, 4, 4);
            world.setRadius(a, 0.5f);
            assertThat(circles(world)).containsExactly(3, 4, 0.5f, 4);
            assertThat(velocities(world)).containsExactly(4, 2);
            assertThat(new float[] {world.x(a), world.y(a), world.radius(a), world.mass(a), world.vx(a), world.vy(a)})
                    .containsExactly(3, 4, 0.5f, 4, 4, 2);
            world.setMass(a, Float.POSITIVE_INFINITY);
            world.applyImpulse(a, 4, 4);
            world.step(0.5f);
            assertThat(velocities(world)).containsExactly(4, 2);
            assertThat(circles(world)).containsExactly(5, 5, 0.5f, Float.POSITIVE_INFINITY);
        }
    }

    @Test
    void theWorldTellsWhatItWasBuiltWithAndWhatWasChangedSince() {
        try (World world = builder()
                .bounds(-1, -2, 3, 4)
                .gravity(5, -6)
                .restitution(0.25f)
                .subSteps(3)
                .build()) {
            assertThat(parameters(world)).containsExactly(-1, -2, 3, 4, 5, -6, 0.25f, 3);
            world.setGravity(-7, 8);
            world.setBounds(-9, -8, 7, 6);
            assertThat(parameters(world)).containsExactly(-9, -8, 7, 6, -7, 8, 0.25f, 3);
            refused(() -> world.setGravity(0, Float.NaN));
            refused(() -> world.setBounds(0, 0, 0, 0));
            assertThat(parameters(world)).containsExactly(-9, -8, 7, 6, -7, 8, 0.25f, 3);
            ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(snapshot);
            try (World other = builder().build()) {
                other.restore(snapshot.flip());
                assertThat(parameters(other)).containsExactly(-9, -8, 7, 6, -7, 8, 0.25f, 3);
            }
        }
    }

    private static float[] parameters(World world) {
        return new float[] {
            world.minX(),
            world.minY(),
            world.maxX(),
            world.maxY(),
            world.gravityX(),
            world.gravityY(),
            world.defaultRestitution(),
            world.subSteps()
        };
    }

    @Test
    void aCircleKeepsItsTagUntilItIsRemoved() {
        try (World world = builder().build()) {
            long[] handles = new long[300];
            for (int i = 0; i < handles.length; i++) {
                handles[i] = world.add(5, 5, 0.1f, 1);
                assertThat(world.tag(handles[i])).isZero();
            }
            long untagged = world.hash();
            world.setTag(handles[7], Long.MIN_VALUE);
            world.setTag(handles[299], 0xFFFFFFFFL);
            long tagged = world.hash();
            assertThat(tagged).isNotEqualTo(untagged);
            long added = world.add(5, 5, 0.1f, 1);
            assertThat(world.tag(added)).isZero();
            world.setTag(added, -1);
            world.remove(added);
            assertThat(world.hash()).isEqualTo(tagged);
            world.step(0.01f);
            assertThat(world.tag(handles[7])).isEqualTo(Long.MIN_VALUE);
            assertThat(world.tag(handles[299])).isEqualTo(0xFFFFFFFFL);
            world.remove(handles[7]);
            long again = world.add(5, 5, 0.1f, 1);
            assertThat((int) again).isEqualTo((int) handles[7]);
            assertThat(world.tag(again)).isZero();
        }
    }

    @Test
    void noStepAsksForATag() {
        try (World world = builder().build();
                World tagged = builder().build()) {
            for (World each : new World[] {world, tagged}) {
                each.add(5, 5, 0.5f, 1);
                each.add(5.2f, 5, 0.5f, 1);
            }
            tagged.setTag(handles(tagged)[1], 77);
            for (World each : new World[] {world, tagged}) {
                each.step(0.01f, 20);
            }
            assertThat(tagged.hash()).isNotEqualTo(world.hash());
            tagged.setTag(handles(tagged)[1], 0);
            assertThat(tagged.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    void eachCircleHasItsOwnRestitutionThroughChangesAndSnapshots() {
        try (World world = builder().restitution(0.75f).build();
                World other = builder().build()) {
            long[] handles = new long[100];
            float[] circles = new float[400];
            for (int i = 0; i < 100; i++) {
                System.arraycopy(new float[] {5, 5, 0.1f, 1}, 0, circles, 4 * i, 4);
            }
            world.addAll(circles, handles);
            assertThat(world.restitution(handles[99])).isEqualTo(0.75f);
            for (int i = 0; i < 100; i++) {
                world.setRestitution(handles[i], i / 128f);
            }
            refused(() -> world.setRestitution(handles[2], 2));
            world.remove(handles[1]);
            refused(() -> world.restitution(handles[1]));
            long again = world.add(1, 1, 0.1f, 1);
            world.step(0.01f);
            ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(snapshot);
            other.restore(snapshot.flip());
            for (World each : new World[] {world, other}) {
                assertThat(each.restitution(again)).isEqualTo(0.75f);
                assertThat(each.restitution(handles[2])).isEqualTo(2 / 128f);
                assertThat(each.restitution(handles[99])).isEqualTo(99 / 128f);
            }
        }
    }

    @Test
    void singleReadsSeeEveryChange() {
        try (World world = builder().gravity(0, -1).build()) {
            long a = world.add(1, 1, 0.1f, 1);
            long b = world.add(2, 5, 0.1f, 1);
            assertThat(world.x(b)).isEqualTo(2);
            world.remove(a);
            assertThat(world.x(b)).isEqualTo(2);
            world.step(0.01f);
            assertThat(world.y(b)).isLessThan(5);
            assertThat(world.vy(b)).isNegative();
            world.setPosition(b, 7, 7);
            assertThat(world.x(b)).isEqualTo(7);
            world.setBounds(0, 0, 5, 5);
            assertThat(world.x(b)).isEqualTo(4.9f);
        }
    }

    @Test
    void readsIntoBuffersFromTheirPositionOn() {
        try (World world = builder().build()) {
            long a = world.add(1, 2, 0.1f, 1, 5, 6);
            FloatBuffer circles = FloatBuffer.allocate(9);
            circles.position(3);
            world.read(circles);
            assertThat(circles.position()).isEqualTo(7);
            assertThat(circles.array()).containsExactly(0, 0, 0, 1, 2, 0.1f, 1, 0, 0);
            FloatBuffer velocities = ByteBuffer.allocateDirect(8).asFloatBuffer();
            world.readVelocities(velocities);
            assertThat(velocities.get(0)).isEqualTo(5);
            assertThat(velocities.get(1)).isEqualTo(6);
            LongBuffer handles = LongBuffer.allocate(1);
            world.readHandles(handles);
            assertThat(handles.get(0)).isEqualTo(a);
            refused(() -> world.read(new float[3]));
            refused(() -> world.readVelocities(new float[1]));
            refused(() -> world.readHandles(new long[0]));
            refused(() -> world.read(circles));
            refused(() -> world.readVelocities(velocities));
            refused(() -> world.readHandles(handles));
            refused(() -> world.read(FloatBuffer.allocate(4).asReadOnlyBuffer()));
            refused(() -> world.readVelocities(FloatBuffer.allocate(2).asReadOnlyBuffer()));
            refused(() -> world.readHandles(LongBuffer.allocate(1).asReadOnlyBuffer()));
        }
    }

    @Test
    void positionsAreInTheOrderOfIdsAndStayAsTheyAreUntilTheNextLook() {
        FloatBuffer positions;
        try (World world = builder().build()) {
            assertThat(world.positions().remaining()).isZero();
            world.add(1, 2, 0.1f, 1);
            long gone = world.add(3, 4, 0.1f, 1);
            world.add(5, 6, 0.1f, 1);
            world.remove(gone);
            positions = world.positions();
            assertThat(positions.isReadOnly()).isTrue();
            assertThat(floats(positions)).containsExactly(1, 2, 5, 6);
            world.add(7, 8, 0.1f, 1);
            assertThat(circles(world)).hasSize(12);
            assertThat(floats(positions.rewind())).containsExactly(1, 2, 5, 6);
            positions = world.positions();
            assertThat(floats(positions)).containsExactly(1, 2, 7, 8, 5, 6);
        }
        assertThat(floats(positions.rewind())).containsExactly(1, 2, 7, 8, 5, 6);
    }

    @Test
    void requestedPositionsAreThoseOfTheRequestAndStayUntilTheRequestAfterTheNext() {
        FloatBuffer first;
        try (World world = builder().build()) {
            long gone = world.add(1, 2, 0.1f, 1, 3, 0);
            world.add(5, 6, 0.1f, 1);
            world.requestPositions();
            world.remove(gone);
            world.add(7, 8, 0.1f, 1);
            world.step(0.01f);
            first = world.takePositions();
            assertThat(first.isReadOnly()).isTrue();
            assertThat(floats(first)).containsExactly(1, 2, 5, 6);
            world.requestPositions();
            assertThat(floats(world.positions())).containsExactly(7, 8, 5, 6);
            world.add(9, 9, 0.1f, 1);
            FloatBuffer second = world.takePositions();
            assertThat(floats(second)).containsExactly(7, 8, 5, 6);
            assertThat(floats(first.rewind())).containsExactly(1, 2, 5, 6);
            world.requestPositions();
            world.positions();
            assertThat(floats(second.rewind())).containsExactly(7, 8, 5, 6);
            first = world.takePositions();
        }
        assertThat(floats(first)).containsExactly(7, 8, 5, 6, 9, 9);
    }

    @Test
    void positionsAreTakenOnceARequestAndTheLastRequestCounts() {
        try (World world = builder().build()) {
            Runnable refused = () -> assertIllegalState("requestPositions", world::takePositions);
            refused.run();
            world.requestPositions();
            assertThat(world.takePositions().remaining()).isZero();
            refused.run();
            world.requestPositions();
            world.add(1, 2, 0.1f, 1);
            world.requestPositions();
            assertThat(floats(world.takePositions())).containsExactly(1, 2);
            refused.run();
            assertThat(world.size()).isOne(); // and the world is as good as before
        }
    }

    private static float[] floats(FloatBuffer buffer) {
        float[] floats = new float[buffer.remaining()];
        buffer.get(floats);
        return floats;
    }

    @Test
    void circlesThatNewBoundsLeaveOutsideAreBroughtInside() {
        try (World world = builder().build()) {
            world.add(9, 9, 0.5f, 1);
            world.add(9, 1, 0.5f, Float.POSITIVE_INFINITY);
            world.setBounds(0, 0, 5, 8);
            assertThat(circles(world)).containsExactly(4.5f, 7.5f, 0.5f, 1, 5, 1, 0.5f, 1 / 0f);
        }
    }

    @Test
    void statsSayWhatTheLastStepDid() {
        Scene scene = Scenes.thesis(1250, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene).profiling(true))) {
            WorldStats before = world.stats();
            assertThat(before.contacts()).isZero();
            assertThat(before.circles()).isEqualTo(1250);
            world.step(scene.timeStep(), 10);
            WorldStats stats = world.stats();
            assertThat(stats.contacts()).isBetween(1000, 10_000);
            assertThat(stats.candidatePairs()).isGreaterThan(stats.contacts());
            assertThat(stats.greatestContacts()).isBetween(3, 200);
            assertThat(stats.bytesHeld()).isBetween(1250L * 100, 1250L * 4000);
            assertThat(stats.stageMillis()).containsOnlyKeys("Grid", "ContinuousCollision", "Contacts", "Solver");
            assertThat(stats.stageMillis().get("Solver")).isPositive();
            assertThat(stats.backend()).isEqualTo(Backend.JVM);
            assertThat(stats.device()).startsWith("Java ");
            assertThat(stats.reason()).isEqualTo("asked for");
            long[] handles = handles(world);
            for (int k = 0; k < 1200; k++) {
                world.remove(handles[k]);
            }
            assertThat(world.stats().greatestContacts()).isEqualTo(stats.greatestContacts());
            for (int k = 1200; k < 1250; k++) {
                world.remove(handles[k]);
            }
            world.step(scene.timeStep());
            assertThat(world.stats().contacts()).isZero();
            assertThat(world.stats().greatestContacts()).isZero();
        }
    }

    @Test
    void afterCloseOnlyCloseIsAllowed() {
        World world = WorldScenes.onThreads(3, builder());
        long a = world.add(1, 1, 0.1f, 1);
        world.add(1, 2, 0.1f, 1);
        world.add(1, 3, 0.1f, 1);
        world.step(0.01f);
        world.requestPositions();
        world.close();
        world.close();
        Consumer<Runnable> closed =
                call -> assertThatIllegalStateException().isThrownBy(call::run).withMessageContaining("closed");
        closed.accept(() -> world.add(1, 1, 0.1f, 1));
        closed.accept(() -> world.addAll(new float[4], null));
        closed.accept(() -> world.remove(a));
        closed.accept(() -> world.contains(a));
        closed.accept(world::size);
        closed.accept(() -> world.step(0.01f));
        closed.accept(() -> world.read(new float[12]));
        closed.accept(() -> world.x(a));
        closed.accept(world::hash);
        closed.accept(() -> world.restitution(a));
        closed.accept(() -> world.setTag(a, 1));
        closed.accept(() -> world.tag(a));
        closed.accept(() -> world.kindOf(a));
        closed.accept(() -> world.kind(0));
        closed.accept(() -> world.setForces(new long[] {a}, 1, new float[2], StaleHandles.SKIP));
        closed.accept(() -> world.setKinds(new long[] {a}, 1, new int[1], StaleHandles.SKIP));
        closed.accept(() -> world.readKindsById(new int[3], null));
        closed.accept(() -> world.readTagsById(new long[3], null));
        for (Runnable read : List.<Runnable>of(
                world::minX,
                world::minY,
                world::maxX,
                world::maxY,
                world::gravityX,
                world::gravityY,
                world::defaultRestitution,
                world::subSteps)) {
            closed.accept(read);
        }
        closed.accept(world::positions);
        closed.accept(world::requestPositions);
        closed.accept(world::takePositions);
        closed.accept(world::stats);
        closed.accept(world::snapshotBytes);
        closed.accept(() -> world.restore(ByteBuffer.allocate(100)));
        world.close();
    }

    @Test
    @Timeout(30)
    void aSecondThreadIsSentAwayWhileOneIsInside() throws InterruptedException {
        Scene scene = Scenes.packed(5000, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene).threads(1))) {
            CountDownLatch started = new CountDownLatch(1);
            Thread stepping = new Thread(() -> {
                started.countDown();
                stepAsSoonAsNobodyIsInside(world, scene.timeStep(), 300);
            });
            stepping.start();
            started.await();
            int refusals = 0;
            while (stepping.isAlive()) {
                try {
                    world.size();
                } catch (ConcurrentModificationException e) {
                    refusals++;
                    assertThatThrownBy(world::close).isInstanceOf(ConcurrentModificationException.class);
                    break;
                }
            }
            stepping.join();
            assertThat(refusals).isPositive();
            assertThat(world.size()).isEqualTo(5000); // and it is usable again, from any thread
        }
    }

    /** A thread that only asks for the size is inside, too, for a moment. */
    private static void stepAsSoonAsNobodyIsInside(World world, float timeStep, int steps) {
        for (; ; ) {
            try {
                world.step(timeStep, steps);
                return;
            } catch (ConcurrentModificationException e) {
                Thread.onSpinWait();
            }
        }
    }

    private static void refused(Runnable call) {
        assertThatIllegalArgumentException().isThrownBy(call::run).satisfies(e -> assertThat(e.getMessage())
                .isNotBlank());
    }

    private static float[] circles(World world) {
        float[] circles = new float[4 * world.size()];
        world.read(circles);
        return circles;
    }

    private static float[] velocities(World world) {
        float[] velocities = new float[2 * world.size()];
        world.readVelocities(velocities);
        return velocities;
    }

    private static long[] handles(World world) {
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        return handles;
    }
}
