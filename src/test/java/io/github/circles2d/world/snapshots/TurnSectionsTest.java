package io.github.circles2d.world.snapshots;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Wall;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import io.github.circles2d.world.model.ContactRows;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** What circles turn by, and surfaces that grip, in snapshots: what is refused of them. */
class TurnSectionsTest {
    /** Where the header has the number of sections. */
    private static final int SECTIONS_AT = 60;

    /** Of one circle: number, count, the id's varint, flags, the angle, the angular velocity. */
    private static final int TURNS = 4 + 4 + 1 + 1 + 4 + 4;

    /** Of surfaces: number, length, values. */
    private static final int SURFACES = 4 + 4 + 4 * 14;

    @Test
    void turnsThatNoCallsLeadToAreRefused() {
        Consumer<World> turn = world -> {
            long first = world.handle(0);
            world.setAngle(first, 1);
            world.setAngularVelocity(first, 2);
        };
        refused(turn, "not in order", b -> b.putInt(b.limit() - TURNS, 0));
        refused(turn, "0 values", b -> b.putInt(b.limit() - TURNS + 4, 0));
        refused(turn, "2 values", b -> b.putInt(b.limit() - TURNS + 4, 2));
        refused(turn, "-1 values", b -> b.putInt(b.limit() - TURNS + 4, -1));
        refused(turn, "has no circle", b -> b.put(b.limit() - 10, (byte) 0));
        refused(turn, "has no circle", b -> b.put(b.limit() - 10, (byte) 2));
        refused(turn, "no such flags", b -> b.put(b.limit() - 9, (byte) 0));
        refused(turn, "no such flags", b -> b.put(b.limit() - 9, (byte) 64));
        refused(turn, "ends early", b -> b.put(b.limit() - 9, (byte) 7));
        refused(turn, "do not fit", b -> b.put(b.limit() - 9, (byte) 1));
        refused(turn, "an angle of 0", b -> b.putInt(b.limit() - 8, 0));
        refused(turn, "a 0 of what turns", b -> b.putInt(b.limit() - 4, 0));
        refused(turn, "an angular velocity is", b -> b.putFloat(b.limit() - 4, Math.nextUp(1e9f)));
        refused(turn, "an angular velocity is NaN", b -> b.putFloat(b.limit() - 4, Float.NaN));
        refused(turn, "ends early", b -> b.putInt(SECTIONS_AT, 2));
        refused(turn, "do not fit", b -> b.putInt(SECTIONS_AT, 0));
    }

    @Test
    void surfacesThatNoCallsLeadToAreRefused() {
        Consumer<World> grip = world -> world.setWallSurface(Wall.MAX_Y, 0.5f, 0.25f, -3);
        refused(grip, "number 1010", b -> b.putInt(b.limit() - SURFACES, 1010).putInt(b.limit() - SURFACES + 4, 4));
        refused(grip, "not its length", b -> b.putInt(b.limit() - SURFACES + 4, 13));
        refused(grip, "friction is -1.0", b -> b.putFloat(b.limit() - 12, -1));
        refused(grip, "rolling resistance is NaN", b -> b.putFloat(b.limit() - 8, Float.NaN));
        refused(grip, "belt speed is", b -> b.putFloat(b.limit() - 4, 2e9f));
        refused(grip, "friction is 1001.0", b -> b.putFloat(b.limit() - SURFACES + 8, 1001));
        refused(grip, "do not grip", b -> b.putLong(b.limit() - 12, 0).putInt(b.limit() - 4, 0));
        refused(grip, "ends early", b -> b.limit(b.limit() - 1).putInt(8, b.limit()));
    }

    /** Of two circles on each other, both sections of which are known: numbers, counts, what is in them. */
    @Test
    void impulsesOfRowsThatNoCallsLeadToAreRefused() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 10, 10)
                .gravity(2, -9)
                .restitution(0)
                .threads(1)
                .build()) {
            world.kind(0).setFriction(1).setRollingResistance(0.5f);
            world.add(5, 1, 1, Float.POSITIVE_INFINITY);
            world.add(5.2f, 2.9f, 1, 1);
            world.step(1 / 60f, 5);
            SavedState state = new SavedState();
            SnapshotCodec.read(snapshot(world), state);
            assertThat(state.turns).isTrue();
            assertThat(state.impulses).isOne();
            assertThat(state.rows[ContactRows.FRICTION]).isNotZero();
            assertThat(state.rows[ContactRows.ROLLING]).isNotZero();
            refusedOf(state, "a friction impulse is", s -> s.rows[ContactRows.FRICTION] = Float.POSITIVE_INFINITY);
            refusedOf(state, "a friction impulse is", s -> s.rows[ContactRows.FRICTION] = -2e24f);
            refusedOf(state, "a rolling impulse by radius is", s -> s.rows[ContactRows.ROLLING] = Float.NaN);
            refusedOf(state, "a rolling impulse by radius is", s -> s.rows[ContactRows.ROLLING] = 2e33f);
            refusedOf(state, "an impulse along a wall is", s -> s.wallRows[ContactRows.ofWalls(1)] = 2e15f);
            ByteBuffer good = bytes(state);
            int grip = good.limit() - 9; // the varint, friction, rolling impulse
            refused(good, "no impulse", b -> b.put(grip, (byte) (2 << 2 | 3)));
            refused(good, "no impulse", b -> b.put(grip, (byte) 3));
            refused(good, "no impulse", b -> b.put(grip, (byte) (1 << 2)));
            refused(good, "do not fit", b -> b.put(grip, (byte) (1 << 2 | 1)));
            refused(good, "a 0 of what turns", b -> b.putInt(grip + 1, 0));
            refused(good, "a 0 of what turns", b -> b.putInt(grip + 5, 0));
            refused(good, "2 values", b -> b.putInt(grip - 4, 2));
            world.restore(good);
            assertThat(snapshot(world)).isEqualTo(good.rewind());
        }
    }

    private static void refusedOf(SavedState good, String message, Consumer<SavedState> forge) {
        SavedState forged = new SavedState();
        SnapshotCodec.read(bytes(good), forged);
        forge.accept(forged);
        refused(bytes(forged), message, b -> {});
    }

    private static ByteBuffer bytes(SavedState state) {
        ByteBuffer bytes = SnapshotCodec.encode(state, ByteBuffer.allocate(0).order(ByteOrder.LITTLE_ENDIAN));
        SnapshotCodec.addCheck(bytes);
        return bytes;
    }

    /** Of a world with the circle 0 and the free id 1. */
    private static void refused(Consumer<World> turn, String message, Consumer<ByteBuffer> forge) {
        try (World world = WorldScenes.jvm().threads(1).build()) {
            world.add(0.5f, 0.5f, 0.1f, 1);
            world.remove(world.add(0.6f, 0.5f, 0.1f, 1));
            turn.accept(world);
            refused(snapshot(world), message, forge);
        }
    }

    private static void refused(ByteBuffer good, String message, Consumer<ByteBuffer> forge) {
        ByteBuffer bytes = ByteBuffer.allocate(good.limit()).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(0, good, 0, good.limit());
        try (World world = WorldScenes.jvm().threads(1).build()) {
            world.setAngle(world.add(0.5f, 0.5f, 0.1f, 1), 1);
            long hash = world.hash();
            forge.accept(bytes);
            bytes.putLong(SnapshotCodec.CHECK_AT, SnapshotCodec.check(bytes, bytes.limit()));
            assertIllegalArgument(message, () -> world.restore(bytes));
            assertThat(world.hash()).isEqualTo(hash);
        }
    }
}
