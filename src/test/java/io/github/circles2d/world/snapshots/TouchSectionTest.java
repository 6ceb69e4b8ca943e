package io.github.circles2d.world.snapshots;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Events;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** How fast surfaces slid is in snapshots within a hit, and what no calls lead to is refused. */
class TouchSectionTest {
    private static final float DT = 1 / 60f;

    @Test
    void whatNoCallsLeadToIsRefused() {
        for (float speed : new float[] {-0f, -1}) {
            refused("is out of range", b -> b.putFloat(b.limit() - 4, speed));
        }
        for (float speed : new float[] {Float.POSITIVE_INFINITY, Float.NaN}) {
            refused("a value of an event", b -> b.putFloat(b.limit() - 4, speed));
        }
    }

    @Test
    void theEndOfATouchHasNoSlip() {
        try (World world = withinHit()) {
            world.remove(world.handle(0));
            refused(world, "is no hit", snapshot(world), b -> b.putFloat(b.limit() - 4, 1));
        }
    }

    @Test
    void aHitThatGoesOnKeepsItsSlip() {
        assertKept(false);
    }

    @Test
    void aHitOfARemovedCircleKeepsItsSlip() {
        assertKept(true);
    }

    private static void assertKept(boolean removed) {
        try (World world = withinHit();
                World other = WorldScenes.jvm().build()) {
            float slip = slip(snapshot(world));
            if (removed) {
                world.remove(world.handle(0));
            }
            other.report(1, 0, Events.HIT | Events.END);
            other.restore(snapshot(world));
            assertHit(world, slip);
            assertHit(other, slip);
        }
    }

    private static void assertHit(World world, float slip) {
        assertThat(slip).isPositive();
        world.step(DT);
        Events events = world.events();
        assertThat(events.type(0)).isEqualTo(Events.HIT);
        assertThat(events.slipSpeed(0)).isEqualTo(slip);
    }

    /** Circle 0, which spins, hits a pile; the next step goes on with that hit. */
    private static World withinHit() {
        for (int k = 0; k < 100; k++) {
            World world = WorldScenes.jvm()
                    .bounds(-50, -50, 50, 50)
                    .friction(0.5f)
                    .restitution(0.3f)
                    .gravity(0, -5)
                    .build();
            world.report(1, 0, Events.HIT | Events.END);
            long ball = world.add(4 + 0.01f * k, 20, 1, 1, 0, -40);
            world.setKind(ball, 1);
            world.setAngularVelocity(ball, 6);
            for (int n = 0; n < 25; n++) {
                world.add(n / 5 * 2, n % 5 * 2 - 40, 1, 1);
            }
            for (int step = 0; step < 100; step++) {
                world.step(DT);
                world.events();
                ByteBuffer bytes = snapshot(world);
                SavedState state = new SavedState();
                SnapshotCodec.read(bytes, state);
                if (state.touches.open == 1 && slip(bytes) > 0) {
                    return world;
                }
            }
            world.close();
        }
        throw new AssertionError("no hit goes on");
    }

    /** Of the only hit. */
    private static float slip(ByteBuffer snapshot) {
        return snapshot.getFloat(snapshot.limit() - 4);
    }

    private static ByteBuffer snapshot(World world) {
        ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes()).order(ByteOrder.LITTLE_ENDIAN);
        world.snapshot(bytes);
        bytes.flip();
        return bytes;
    }

    private static void refused(String message, Consumer<ByteBuffer> forge) {
        try (World world = withinHit()) {
            refused(world, message, snapshot(world), forge);
        }
    }

    private static void refused(World world, String message, ByteBuffer bytes, Consumer<ByteBuffer> forge) {
        world.restore(bytes.duplicate());
        forge.accept(bytes);
        bytes.putLong(SnapshotCodec.CHECK_AT, SnapshotCodec.check(bytes, bytes.limit()));
        assertIllegalArgument(message, () -> world.restore(bytes));
    }
}
