package io.github.circles2d;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.Random;

/** A world with what belongs to it, for tests in which memory ends. */
final class MemoryScene implements AutoCloseable {
    private static final float STEP = 1 / 60f;

    final World world;
    final FixedStep fixed;
    final Rewind rewind;

    /** The log of all calls; null if there is none. */
    final Recording recording;

    private final ByteArrayOutputStream log = new ByteArrayOutputStream();
    final ByteBuffer more;
    final ByteBuffer fewer;
    final int frame = 1;

    /**
     * A scene.
     *
     * @param rich with terrain, joints, surfaces and reports, else a few circles
     * @param more the snapshot of a richer world, and fewer that of a poorer one; may be null
     */
    MemoryScene(boolean rich, int threads, boolean records, ByteBuffer more, ByteBuffer fewer) {
        this.more = more;
        this.fewer = fewer;
        world = WorldScenes.onThreads(
                threads, World.builder().bounds(0, 0, 20, 20).gravity(0, -9));
        if (records) {
            recording = record();
        } else {
            recording = null;
        }
        for (int k = 0; k < (rich ? 20 : 3); k++) {
            world.add(2 + k % 8 * 0.9f, 1 + k / 8, 0.4f + k % 3 * 0.05f, 1, k, -k, rich ? k % 3 : 0);
        }
        if (rich) {
            enrich();
        }
        rewind = new Rewind(world, 3);
        rewind.save(frame);
        world.step(STEP);
        fixed = new FixedStep(world, STEP);
        fixed.advance(STEP, null);
    }

    private Recording record() {
        try {
            return new Recording(world, log, 1);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void enrich() {
        world.kind(1).setFriction(0.5f);
        world.setResponse(0, 2, Response.values()[1]);
        world.terrain().addSegments(new float[] {1, 1, 9, 1, 9, 1, 12, 3}, 0, null);
        TerrainBody body = world.terrain().addBody(10, 10, 1);
        body.addSegment(-1, 0, 1, 0);
        body.setAngularVelocity(2);
        world.joints().report(true);
        world.joints().add(world.handle(0), world.handle(1), Joint.weld());
        world.joints().add(world.handle(2), world.handle(3), Joint.spring(3, 1));
        world.joints().add(world.handle(4), body, 0, 0, Joint.spring(2, 1).withLength(1));
        world.joints().add(world.handle(5), world.handle(6), Joint.distance().breakingAt(100, 100));
        world.report(15);
    }

    /** The snapshot of such a world. */
    static ByteBuffer snapshot(boolean rich) {
        try (MemoryScene scene = new MemoryScene(rich, 1, false, null, null)) {
            if (rich) {
                Random random = new Random(1);
                for (int k = 0; k < 100; k++) {
                    scene.world.add(1 + 18 * random.nextFloat(), 1 + 18 * random.nextFloat(), 0.3f, 1);
                    scene.world.joints().add(scene.world.handle(k), scene.world.handle(20 + k), Joint.spring(2, 1 + k));
                    scene.world.terrain().addSegment(k / 9f, 5, k / 9f + 1, 4);
                }
                scene.world.step(STEP);
            }
            ByteBuffer to = ByteBuffer.allocate(scene.world.snapshotBytes());
            scene.world.snapshot(to);
            return to.flip();
        }
    }

    /** Adds circles at any places. */
    void addAnywhere(Random r, int count) {
        for (int k = 0; k < count; k++) {
            world.add(1 + 18 * r.nextFloat(), 1 + 18 * r.nextFloat(), 0.3f, 1);
        }
    }

    long circle(Random r) {
        int limit = world.idLimit();
        int id = limit == 0 ? 0 : r.nextInt(limit);
        for (int k = 0; k < limit; k++) {
            if (world.handle((id + k) % limit) != 0) {
                return world.handle((id + k) % limit);
            }
        }
        return 1L << 32;
    }

    long[] circles(Random r, int count) {
        long[] some = new long[count];
        for (int k = 0; k < count; k++) {
            some[k] = circle(r);
        }
        return Arrays.stream(some).distinct().toArray();
    }

    float[] floats(Random r, int count, float least, float greatest) {
        float[] floats = new float[count];
        for (int k = 0; k < count; k++) {
            floats[k] = least + (greatest - least) * r.nextFloat();
        }
        return floats;
    }

    /** The ground, or the body that the first piece of another body is on. */
    TerrainBody body(Random r) {
        Terrain terrain = world.terrain();
        for (int id = terrain.idLimit() - 1; id >= 0 && r.nextInt(3) > 0; id--) {
            if (terrain.handle(id) != 0) {
                return terrain.bodyOf(terrain.handle(id));
            }
        }
        return terrain.ground();
    }

    long piece(Random r) {
        int limit = world.terrain().idLimit();
        return limit == 0 ? 1L << 32 : world.terrain().handle(r.nextInt(limit));
    }

    long joint(Random r) {
        int limit = world.joints().idLimit();
        return limit == 0 ? 1L << 32 : world.joints().handle(r.nextInt(limit));
    }

    // ---- all that can be seen

    /** All that can be seen of the world, a line each; takes its events. */
    String look() {
        StringBuilder seen = new StringBuilder();
        line(seen, "size", world.size() + " " + world.idLimit());
        line(seen, "hash", world.hash());
        ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(snapshot);
        line(seen, "snapshot", snapshot.position() + " " + Arrays.hashCode(snapshot.array()));
        line(seen, "events", list(world.events()));
        line(seen, "joint events", list(world.joints().events()));
        float[] all = new float[4 * world.size()];
        world.read(all);
        line(seen, "circles", all);
        float[] byId = new float[2 * world.idLimit()];
        world.readLoadsById(byId, null);
        line(seen, "loads", byId);
        line(seen, "positions", list(world.positionsById(null)));
        line(seen, "angles", list(world.angles()));
        for (int id = 0; id < world.idLimit(); id++) {
            long handle = world.handle(id);
            line(seen, "circle " + id, handle);
            if (handle != 0) {
                line(seen, "its", new float[] {
                    world.vx(handle),
                    world.angularVelocity(handle),
                    world.friction(handle),
                    world.forceX(handle),
                    world.torque(handle),
                    world.growthSteps(handle),
                    world.kindOf(handle)
                });
            }
        }
        lookAtJoints(seen);
        lookAtTerrain(seen);
        long[] handles = new long[400];
        line(seen, "touching", world.touching(0, 0, handles));
        line(seen, "those", handles);
        line(seen, "touching pieces", world.touchingPieces(0, 0, handles));
        line(seen, "those", handles);
        line(seen, "in a box", world.queries().overlapBox(2, 0, 10, 10, handles));
        line(seen, "those", handles);
        line(seen, "pieces in a box", world.queries().terrain().overlapBox(2, 0, 10, 10, handles));
        line(seen, "those", handles);
        line(seen, "contacts", world.stats().contacts());
        line(seen, "frames", rewind.size() + " " + rewind.oldest() + " " + rewind.newest());
        return seen.toString();
    }

    private void lookAtJoints(StringBuilder seen) {
        for (int id = 0; id < world.joints().idLimit(); id++) {
            long handle = world.joints().handle(id);
            line(seen, "joint " + id, handle);
            if (handle != 0) {
                line(
                        seen,
                        "its",
                        world.joints().joint(handle) + " " + world.joints().force(handle) + " "
                                + world.joints().torque(handle));
            }
        }
        float[] ends = new float[4 * world.joints().size()];
        world.joints().readEnds(ends);
        line(seen, "ends", ends);
    }

    private void lookAtTerrain(StringBuilder seen) {
        for (int id = 0; id < world.terrain().idLimit(); id++) {
            line(seen, "piece " + id, world.terrain().handle(id));
        }
        float[] pieces = new float[Terrain.PIECE_STRIDE * world.terrain().size()];
        world.terrain().readPieces(pieces, null);
        line(seen, "pieces", pieces);
    }

    private static void line(StringBuilder seen, String name, Object value) {
        seen.append(name).append(' ').append(text(value)).append('\n');
    }

    /** What a call has returned, to compare. */
    static String text(Object value) {
        if (value instanceof float[] floats) {
            return Arrays.toString(floats);
        }
        if (value instanceof long[] longs) {
            return Arrays.toString(longs);
        }
        if (value instanceof Object[] objects) {
            StringBuilder all = new StringBuilder();
            for (Object each : objects) {
                all.append(text(each)).append(' ');
            }
            return all.toString();
        }
        return String.valueOf(value);
    }

    static String list(FloatBuffer floats) {
        StringBuilder all = new StringBuilder();
        for (int k = 0; k < floats.limit(); k++) {
            all.append(floats.get(k)).append(' ');
        }
        return all.toString();
    }

    static String list(Events events) {
        StringBuilder all = new StringBuilder();
        for (int k = 0; k < events.size(); k++) {
            all.append(events.type(k))
                    .append(':')
                    .append(events.step(k))
                    .append(':')
                    .append(events.a(k))
                    .append(':');
            all.append(events.b(k))
                    .append(':')
                    .append(events.piece(k))
                    .append(':')
                    .append(events.side(k))
                    .append(':');
            all.append(events.speed(k)).append(':').append(events.x(k)).append(' ');
        }
        return all.toString();
    }

    static String list(JointEvents events) {
        StringBuilder all = new StringBuilder();
        for (int k = 0; k < events.size(); k++) {
            all.append(events.joint(k))
                    .append(':')
                    .append(events.circle(k))
                    .append(':')
                    .append(events.other(k));
            all.append(':')
                    .append(events.reason(k))
                    .append(':')
                    .append(events.force(k))
                    .append(' ');
        }
        return all.toString();
    }

    /** Ends the log, if there is one, and returns how a replay of it ends. */
    String replay() {
        try {
            recording.close();
            try (World player = WorldScenes.jvm().threads(1).build()) {
                Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), player).run();
                return replay.steps() + " steps, "
                        + (replay.differs() ? replay.difference() : "the same " + player.hash());
            }
        } catch (IOException | IllegalArgumentException e) {
            return e.getMessage();
        }
    }

    @Override
    public void close() {
        world.close();
    }
}
