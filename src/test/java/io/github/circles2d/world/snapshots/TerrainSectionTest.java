package io.github.circles2d.world.snapshots;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Chain;
import io.github.circles2d.Edge;
import io.github.circles2d.Terrain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import io.github.circles2d.world.model.PieceRow;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** Terrain, and contacts with it, in snapshots: what is kept, and what is refused. */
class TerrainSectionTest {
    private static final float PI = (float) Math.PI;

    private static World world() {
        return WorldScenes.jvm()
                .bounds(0, 0, 100, 100)
                .edges(Edge.WRAP, Edge.OPEN)
                .threads(1)
                .build();
    }

    /** Every field of a piece and of a body has a value; some ids are free. */
    private static void build(World world) {
        world.add(50, 50, 1, 1);
        world.add(60, 50, 1, Float.POSITIVE_INFINITY);
        world.terrain().addSegment(0, 1, 2, 3);
        world.terrain().addSegment(10, 10, 20, 10, 0.5f, 200);
        world.terrain().remove(world.terrain().addSegment(0, 0, 1, 1));
        world.terrain().addArc(30, 30, 5, 1, 2, ArcSide.INNER);
        TerrainBody gone = world.terrain().addBody(1, 1, 1);
        TerrainBody body = world.terrain().addBody(70, 20, -2);
        gone.remove();
        body.addChain(Chain.of(1, 0, 0, 0).arcTo(0, 2, -1).lineTo(-9, 3).close());
        body.addArc(0, 0, 3, 0, 2 * PI, ArcSide.OUTER, 3);
        body.setVelocity(1, -2);
        body.setAngularVelocity(3);
        body.moveTo(71, 22, 1);
        world.terrain().addBody(3, 4, 5).addSegment(0, 0, 1, 0);
    }

    @Test
    void aWorldThatIsRestoredHasTheTerrainThatItHad() {
        try (World world = world();
                World other = world();
                World third = world()) {
            build(world);
            ByteBuffer saved = snapshot(world);
            other.terrain().addSegment(0, 0, 7, 7);
            other.terrain().addBody(0, 0, 0).setVelocity(4, 4);
            other.restore(saved);
            assertThat(snapshot(other)).isEqualTo(saved.rewind());
            assertThat(other.hash()).isEqualTo(world.hash()).isNotEqualTo(third.hash());
            assertThat(pieces(other)).isEqualTo(pieces(world));
            for (int k = 0; k < 3; k++) {
                world.step(1 / 60f);
                other.step(1 / 60f);
            }
            assertThat(snapshot(other)).isEqualTo(snapshot(world));
            assertThat(pieces(other)).isEqualTo(pieces(world));
            assertThat(other.terrain().addSegment(0, 0, 1, 1))
                    .isEqualTo(world.terrain().addSegment(0, 0, 1, 1));
            assertThat(other.terrain().addBody(0, 0, 1).handle())
                    .isEqualTo(world.terrain().addBody(0, 0, 1).handle());
            // once more, where the same terrain is there already
            ByteBuffer now = snapshot(world);
            world.step(1 / 60f, 5);
            world.restore(now);
            assertThat(snapshot(world)).isEqualTo(now.rewind());
            assertThat(pieces(other)).isEqualTo(pieces(world));
        }
    }

    private static float[] pieces(World world) {
        float[] pieces = new float[Terrain.PIECE_STRIDE * world.terrain().size()];
        world.terrain().readPieces(pieces, null);
        return pieces;
    }

    @Test
    void aWorldWithoutTerrainHasTheBytesAndTheHashOfBefore() {
        try (World world = world();
                World other = world()) {
            world.add(50, 50, 1, 1);
            other.add(50, 50, 1, 1);
            other.terrain().clear();
            assertThat(snapshot(other)).isEqualTo(snapshot(world));
            assertThat(other.hash()).isEqualTo(world.hash());
            other.terrain().remove(other.terrain().addSegment(0, 0, 1, 1));
            assertThat(other.hash()).isEqualTo(world.hash());
            assertThat(snapshot(other)).isNotEqualTo(snapshot(world)); // the id's next handle is another
        }
    }

    @Test
    void eachValueIsInTheHash() {
        try (World world = world()) {
            build(world);
            long hash = world.hash();
            Consumer<Consumer<SavedState>> differs = change -> {
                SavedState s = state(world);
                change.accept(s);
                try (World other = world()) {
                    other.restore(bytes(s));
                    assertThat(other.hash()).isNotEqualTo(hash);
                }
            };
            differs.accept(s -> s.terrain.form[0] = 0.5f);
            differs.accept(s -> s.terrain.form[9] = 0.25f);
            differs.accept(s -> s.terrain.kind[1] = 7);
            differs.accept(s -> s.terrain.half[2]++);
            differs.accept(s -> s.terrain.after[3] = -1);
            differs.accept(s -> s.terrain.bodies.x[2] = 70.5);
            differs.accept(s -> s.terrain.bodies.y[2] = 20.5);
            differs.accept(s -> s.terrain.bodies.angle[2]++);
            differs.accept(s -> s.terrain.bodies.vx[2] = 5);
            differs.accept(s -> s.terrain.bodies.vy[2] = 5);
            differs.accept(s -> s.terrain.bodies.omega[2] = 5);
            differs.accept(s -> s.terrain.bodies.travels[2] = false);
            differs.accept(s -> s.terrain.bodies.targetX[2] = 5);
            differs.accept(s -> s.terrain.bodies.targetY[2] = 5);
            differs.accept(s -> s.terrain.bodies.targetAngle[2]++);
        }
    }

    @Test
    void terrainThatNoCallsLeadToIsRefused() {
        refused("no body", s -> s.terrain.body[0] = 3);
        refused("no body", s -> s.terrain.body[0] = 7);
        refused("kind of 0", s -> {}, b -> b.put(find(s -> s.terrain.kind[1] = 1), (byte) 0));
        refused("x1 is NaN", s -> s.terrain.form[0] = Float.NaN);
        refused("must be longer", s -> s.terrain.form[0] = s.terrain.form[2] = s.terrain.form[1] = s.terrain.form[3]);
        refused("wraps", s -> s.terrain.form[2] = 51);
        refused("radius is", s -> s.terrain.form[14] = -1);
        refused("radius is", s -> s.terrain.form[14] = 0);
        refused("direction", s -> s.terrain.form[12] = 1.5f);
        refused("direction", s -> s.terrain.form[12] = Float.NaN);
        refused("opening", s -> s.terrain.half[2] = 0);
        refused("opening", s -> s.terrain.half[2] = -5);
        refused("no such flags", s -> s.terrain.shape[0] = PieceRow.SEGMENT | PieceRow.SOLID_OUTSIDE);
        refused("no such flags", s -> s.terrain.after[0] = 3);
        refused("followed by none", s -> s.terrain.after[3] = 100);
        refused("cannot follow", s -> s.terrain.after[3] = 0);
        refused("cannot follow", s -> s.terrain.after[3] = 2);
        refused("cannot follow", s -> s.terrain.after[4] = s.terrain.after[3]);
        refused("out of range", s -> s.terrain.bodies.x[2] = 100.5);
        refused("out of range", s -> s.terrain.bodies.y[2] = Double.NaN);
        refused("out of range", s -> s.terrain.bodies.y[2] = 2e9);
        refused("velocity", s -> s.terrain.bodies.vx[2] = Float.POSITIVE_INFINITY);
        refused("velocity", s -> s.terrain.bodies.omega[2] = -0f);
        refused("velocity", s -> s.terrain.bodies.lastVx[2] = Float.NaN);
        refused("velocity", s -> s.terrain.bodies.lastOmega[2] = 2e9f);
        refused("out of range", s -> s.terrain.bodies.targetX[2] = -1);
        refused("generation", s -> s.terrain.pieceGeneration[0] = -1);
        refused("generation", s -> s.terrain.bodyGeneration[2] = -1);
    }

    @Test
    void contactsThatNoCallsLeadToAreRefused() {
        accepted(s -> contact(s, 0, 0, -1, 1, -2, 3));
        accepted(s -> contact(s, 0, 3, 0, 0, 0, 0));
        refused("no circle", s -> contact(s, 1, 0, 1, 1, 0, 0));
        refused("no circle", s -> contact(s, 2, 0, 1, 1, 0, 0));
        refused("no piece", s -> contact(s, 0, 99, 1, 1, 0, 0));
        refused("no such flags", s -> contact(s, 0, 3, -1, 1, 0, 0));
        refused("no such flags", s -> contact(s, 0, 3, 0, 1, 0, 0));
        refused("no such flags", s -> contact(s, 0, 3, 2, 1, 0, 0));
        refused("an impulse", s -> contact(s, 0, 3, 1, -1, 0, 0));
        refused("an impulse", s -> contact(s, 0, 3, 1, Float.NaN, 0, 0));
        refused("an impulse", s -> contact(s, 0, 3, 1, 2e15f, 0, 0));
        refused("an impulse", s -> contact(s, 0, 3, 1, 1, -2e15f, 0));
        refused("an impulse", s -> contact(s, 0, 3, 1, 1, 0, Float.NaN));
        refused("not in order", s -> {
            contact(s, 0, 3, 1, 1, 0, 0);
            contact(s, 0, 3, 1, 1, 0, 0);
        });
    }

    private static void contact(
            SavedState s, int circle, int piece, int side, float impulse, float friction, float rolling) {
        s.pieceContacts.ensure(s.pieceContacts.count + 1);
        s.pieceContacts.add(circle, piece, 0, side, impulse, new float[] {friction, rolling}, 0);
    }

    @Test
    void cutSectionsAreRefused() {
        try (World world = world()) {
            build(world);
            SavedState s = state(world);
            contact(s, 0, 0, 1, 1, 2, 3);
            contact(s, 0, 5, 1, 1, 2, 3);
            ByteBuffer good = bytes(s);
            accepted(good);
            for (int length = SnapshotCodec.HEADER; length < good.limit(); length++) {
                ByteBuffer cut = copy(good);
                cut.limit(length).putInt(8, length);
                refused("", cut);
            }
        }
    }

    /** Where the first byte is that a change changes. */
    private static int find(Consumer<SavedState> change) {
        try (World world = world()) {
            build(world);
            SavedState s = state(world);
            ByteBuffer one = bytes(s);
            change.accept(s);
            ByteBuffer other = bytes(s);
            for (int k = SnapshotCodec.HEADER; k < one.limit(); k++) {
                if (one.get(k) != other.get(k)) {
                    return k;
                }
            }
            throw new AssertionError("no byte differs");
        }
    }

    private static void accepted(Consumer<SavedState> forge) {
        try (World world = world()) {
            build(world);
            SavedState s = state(world);
            forge.accept(s);
            accepted(bytes(s));
        }
    }

    private static void accepted(ByteBuffer bytes) {
        try (World world = world()) {
            world.restore(bytes);
        }
        bytes.rewind();
    }

    private static void refused(String message, Consumer<SavedState> forge) {
        refused(message, forge, b -> {});
    }

    private static void refused(String message, Consumer<SavedState> forge, Consumer<ByteBuffer> forgeBytes) {
        try (World world = world()) {
            build(world);
            SavedState s = state(world);
            forge.accept(s);
            ByteBuffer bytes = bytes(s);
            forgeBytes.accept(bytes);
            refused(message, bytes);
        }
    }

    private static void refused(String message, ByteBuffer bytes) {
        bytes.putLong(SnapshotCodec.CHECK_AT, SnapshotCodec.check(bytes, bytes.limit()));
        try (World world = world()) {
            build(world);
            world.step(1 / 60f);
            long hash = world.hash();
            assertIllegalArgument(message, () -> world.restore(bytes));
            assertThat(world.hash()).isEqualTo(hash);
        }
    }

    private static SavedState state(World world) {
        SavedState s = new SavedState();
        SnapshotCodec.read(snapshot(world), s);
        return s;
    }

    private static ByteBuffer bytes(SavedState state) {
        ByteBuffer bytes = SnapshotCodec.encode(state, ByteBuffer.allocate(0).order(ByteOrder.LITTLE_ENDIAN));
        SnapshotCodec.addCheck(bytes);
        return bytes;
    }

    private static ByteBuffer copy(ByteBuffer from) {
        ByteBuffer copy = ByteBuffer.allocate(from.limit()).order(ByteOrder.LITTLE_ENDIAN);
        return copy.put(0, from, 0, from.limit());
    }
}
