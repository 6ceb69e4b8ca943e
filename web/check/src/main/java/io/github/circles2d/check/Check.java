package io.github.circles2d.check;

import io.github.circles2d.Backend;
import io.github.circles2d.Edge;
import io.github.circles2d.Events;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Inertia;
import io.github.circles2d.Queries;
import io.github.circles2d.Replay;
import io.github.circles2d.Rewind;
import io.github.circles2d.Wall;
import io.github.circles2d.World;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Random;

/** What World computes, as lines of text. On every platform they must be the same. */
final class Check {
    private static final float DT = 1 / 60f;

    private final StringBuilder lines = new StringBuilder();

    /** All lines. */
    static String all() {
        Check check = new Check();
        check.lines.append(Numbers.lines());
        for (Edge edge : Edge.values()) {
            check.queries(edge);
        }
        check.eventsAndSnapshots();
        check.recordAndReplay();
        check.rewind();
        check.fixedStep();
        check.turning();
        check.farAndFast();
        check.refusals();
        check.auto();
        return check.lines.toString();
    }

    private void say(String what, Object result) {
        lines.append(what).append(' ').append(result).append('\n');
    }

    /** Circles of many sizes, some static, that fly about. */
    static World world(Edge x, Edge y, int circles, int seed, float speed) {
        World world = World.builder()
                .backend(Backend.JVM)
                .bounds(-50, -40, 50, 40)
                .edges(x, y)
                .gravity(1, -9)
                .build();
        Random random = new Random(seed);
        for (int i = 0; i < circles; i++) {
            float u = random.nextFloat();
            world.add(
                    random.nextFloat() * 90 - 45,
                    random.nextFloat() * 70 - 35,
                    0.2f + 3 * u * u * u,
                    i % 40 == 0 ? Float.POSITIVE_INFINITY : 0.5f + u,
                    (random.nextFloat() - 0.5f) * speed,
                    (random.nextFloat() - 0.5f) * speed,
                    i % 5);
        }
        return world;
    }

    private void queries(Edge edge) {
        Digest digest = new Digest();
        try (World world = world(edge, Edge.WALL, 500, 3, 60)) {
            Random random = new Random(5);
            long[] handles = new long[64];
            float[] hits = new float[64 * Queries.HIT_STRIDE];
            float[] distances = new float[64];
            Queries queries = world.queries();
            for (int step = 0; step < 30; step++) {
                world.step(DT);
                float x = random.nextFloat() * 100 - 50;
                float y = random.nextFloat() * 80 - 40;
                float dx = random.nextFloat() * 60 - 30;
                float dy = random.nextFloat() * 60 - 30;
                digest.add(queries.overlapCircle(x, y, 5, handles)).add(handles);
                digest.add(queries.overlapBox(x - 4, y - 3, x + 4, y + 3, handles))
                        .add(handles);
                digest.add(queries.pick(x, y));
                digest.add(queries.nearest(x, y, 20, 8, handles, distances)).add(distances);
                digest.add(queries.rayCastAll(x, y, dx, dy, handles, hits)).add(hits);
                digest.add(queries.circleCastAll(x, y, 0.7f, dx, dy, handles, hits))
                        .add(hits);
                if (step % 20 == 7) {
                    digest.add(world.explode(x, y, 15, 30, 0.5f));
                }
                digest.add(world.hash());
            }
        }
        say("queries " + edge, digest);
    }

    private void eventsAndSnapshots() {
        Digest digest = new Digest();
        try (World world = world(Edge.WRAP, Edge.WALL, 600, 7, 300)) {
            world.report(0, 1, Events.BEGIN | Events.HIT | Events.END);
            world.reportWalls(0, Events.BEGIN);
            ByteBuffer snapshot = null;
            for (int step = 1; step <= 120; step++) {
                world.step(DT);
                add(world.events(), digest);
                if (step == 60) {
                    snapshot = ByteBuffer.allocate(world.snapshotBytes());
                    world.snapshot(snapshot);
                    digest.add(snapshot.array());
                }
            }
            long hash = world.hash();
            snapshot.position(0);
            world.restore(snapshot);
            for (int step = 61; step <= 120; step++) {
                world.step(DT);
                add(world.events(), digest);
            }
            say("events and snapshots", digest.add(hash).add(world.hash()));
            say("restored", world.hash() == hash);
        }
    }

    private static void add(Events events, Digest digest) {
        for (int i = 0; i < events.size(); i++) {
            digest.add(events.type(i))
                    .add(events.a(i))
                    .add(events.b(i))
                    .add(events.x(i))
                    .add(events.y(i));
            digest.add(events.speed(i)).add(events.impulse(i));
        }
    }

    private void recordAndReplay() {
        byte[] log = Logs.record();
        Digest digest = new Digest().add(log);
        try (World world = World.builder().backend(Backend.JVM).build()) {
            Replay replay = new Replay(new ByteArrayInputStream(log), world).run();
            digest.add(replay.steps()).add(replay.differs() ? 1 : 0).add(world.hash());
            say("replay differs", replay.differs());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        say("record and replay of " + log.length + " bytes", digest);
    }

    private void rewind() {
        Digest digest = new Digest();
        try (World world = world(Edge.WALL, Edge.WRAP, 300, 10, 30)) {
            Rewind rewind = new Rewind(world, 20);
            for (int step = 0; step < 60; step++) {
                rewind.save(step);
                world.step(DT);
            }
            digest.add(world.hash());
            rewind.restore(45);
            digest.add(world.hash());
            for (int step = 45; step < 60; step++) {
                world.step(DT);
            }
            digest.add(world.hash());
        }
        say("rewind", digest);
    }

    private void fixedStep() {
        Digest digest = new Digest();
        try (World world = world(Edge.WALL, Edge.WALL, 200, 11, 30)) {
            FixedStep loop = new FixedStep(world, DT);
            Random random = new Random(1);
            for (int frame = 0; frame < 100; frame++) {
                digest.add(loop.advance(random.nextFloat() / 25, null)).add(loop.alpha());
                FloatBuffer positions = loop.positions(null);
                for (int i = 0; i < positions.limit(); i++) {
                    digest.add(positions.get(i));
                }
            }
        }
        say("fixed step", digest);
    }

    private void turning() {
        Digest digest = new Digest();
        World.Builder builder = World.builder().backend(Backend.JVM).bounds(0, 0, 100, 80);
        builder.gravity(0, -20).friction(0.5f).rollingResistance(0.03f).wallSurface(Wall.MIN_Y, 0.9f, 0.1f, 4);
        try (World world = builder.build()) {
            world.kind(1).setInertia(Inertia.RING).setAngularDamping(0.5f);
            world.kind(2).setInertia(Inertia.NONE).setFriction(0.9f);
            world.kind(3).setBeltSpeed(7);
            Random random = new Random(13);
            for (int i = 0; i < 300; i++) {
                float u = random.nextFloat();
                float x = 5 + 90 * random.nextFloat();
                float y = 5 + 70 * random.nextFloat();
                float mass = i % 30 == 0 ? Float.POSITIVE_INFINITY : 0.5f + u;
                long circle = world.add(x, y, 0.3f + 2 * u * u, mass, 20 * u - 10, 0, i % 4);
                world.setAngularVelocity(circle, 40 * random.nextFloat() - 20);
                if (i % 7 == 0) {
                    world.setTorque(circle, 30 * u);
                }
                if (i % 11 == 0) {
                    world.setGravityScale(circle, 2 * u - 1);
                    world.setDamping(circle, u);
                    world.setGreatestSpeed(circle, 30 * u);
                }
            }
            FixedStep loop = new FixedStep(world, DT);
            float[] velocities = new float[world.idLimit()];
            for (int frame = 0; frame < 150; frame++) {
                loop.advance(random.nextFloat() / 25, null);
                FloatBuffer angles = loop.angles();
                for (int i = 0; i < angles.limit(); i++) {
                    digest.add(angles.get(i));
                }
                world.readAngularVelocitiesById(velocities, null);
                digest.add(velocities).add(world.hash());
            }
        }
        say("turning", digest);
    }

    private void farAndFast() {
        Digest digest = new Digest();
        Random random = new Random(2);
        World.Builder far = World.builder().backend(Backend.JVM).bounds(-1e9f, -1e9f, 1e9f, 1e9f);
        try (World world = far.gravity(0, -1000).build()) {
            for (int i = 0; i < 500; i++) {
                float radius = 2000 + random.nextFloat() * (i % 9 == 0 ? 4e8f : 5000);
                world.add(wide(random), wide(random), radius, 1, wide(random), wide(random));
            }
            for (int step = 0; step < 60; step++) {
                world.step(step % 7 == 0 ? 1 : DT);
                digest.add(world.hash());
            }
        }
        World.Builder open = World.builder().backend(Backend.JVM).edges(Edge.OPEN, Edge.OPEN);
        try (World world = open.gravity(0, -1e6f).build()) {
            for (int i = 0; i < 300; i++) {
                float radius = 1e-6f + 0.01f * random.nextFloat();
                world.add(random.nextFloat(), random.nextFloat(), radius, 1, wide(random), wide(random));
            }
            for (int step = 0; step < 120; step++) {
                world.step(DT);
                digest.add(world.hash());
            }
        }
        say("far and fast", digest);
    }

    private static float wide(Random random) {
        return (random.nextFloat() - 0.5f) * 2e9f;
    }

    private void refusals() {
        World world = world(Edge.WALL, Edge.WALL, 10, 12, 1);
        refused(() -> world.add(Float.NaN, 0, 1, 1));
        refused(() -> world.step(0));
        refused(() -> world.restore(ByteBuffer.allocate(3)));
        refused(() -> world.setMass(7, 1));
        refused(() -> World.builder().backend(Backend.JVM).threads(0));
        world.close();
        refused(() -> world.step(1));
    }

    private void refused(Runnable call) {
        try {
            call.run();
            say("not refused", "");
        } catch (IllegalArgumentException | IllegalStateException e) {
            say("refused:", e.getMessage());
        }
    }

    /** AUTO takes the JVM for a world that is small, or if there is no OpenCL. */
    private void auto() {
        World.Builder builder =
                World.builder().bounds(0, 0, 10, 10).gravity(0, -10).capacity(100);
        try (World world = builder.threads(4).build()) {
            for (int i = 0; i < 50; i++) {
                world.add(i % 7 + 1, i / 7 + 1, 0.4f, 1);
            }
            world.step(DT, 100);
            say("auto " + world.stats().backend(), Long.toHexString(world.hash()));
        }
    }
}
