package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.reference.Event;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** What comes and goes between two steps leaves no trace, on any back end, whatever takes it away. */
class WorldUnseenTest {
    private static final float STEP = 1 / 60f;
    private static final int STEPS = 60;
    private static final int ALL = Events.BEGIN | Events.HIT | Events.END | Events.WALL;

    /** What a world has, and what comes that no step sees. */
    private enum Scene {
        TERRAIN(5, 20, 50, 200, 1000) {
            @Override
            void build(World world) {
                world.add(30, 30, 1, 1);
                world.terrain().addSegment(10, 10, 50, 12);
                TerrainBody body = world.terrain().addBody(30, 20, 0.1f);
                body.addSegment(-8, 0, 8, 0);
                body.setAngularVelocity(0.5f);
            }

            @Override
            void add(World world, int count) {
                segments(world, count);
            }
        },
        PINNED(1, 2, 5, 20, 100) {
            @Override
            void build(World world) {
                circles(world, 20);
                for (int k = 0; k < 5; k++) {
                    world.joints().add(world.handle(k), 3 + 2 * k, 38, Joint.distance());
                }
            }

            @Override
            void add(World world, int count) {
                for (int k = 0; k < count; k++) {
                    int a = 5 + k % 15;
                    int b = 5 + (a - 5 + 1 + k / 15) % 15;
                    world.joints().add(world.handle(a), world.handle(b), Joint.rope(6));
                }
            }
        },
        CHAIN(3, 6, 12, 24, 48) {
            @Override
            void build(World world) {
                circles(world, 40);
                for (int k = 1; k < 40; k++) {
                    Joint link = k % 2 == 0 ? Joint.distance() : Joint.spring(5, 0.5f);
                    world.joints().add(world.handle(k - 1), world.handle(k), link);
                }
                world.joints().add(world.handle(7), Joint.servo(0.5f, 3, 0.5f, 100));
                world.joints().add(world.handle(0), 5, 30, Joint.pin(2, 0.5f));
                world.terrain().addSegment(2, 3, 50, 1);
            }

            @Override
            void add(World world, int count) {
                segments(world, count);
            }
        };

        final int[] counts;

        Scene(int... counts) {
            this.counts = counts;
        }

        abstract void build(World world);

        abstract void add(World world, int count);

        static void circles(World world, int count) {
            for (int k = 0; k < count; k++) {
                world.add(4 + 2.2f * (k % 20), 20 + 3 * (k / 20) + 0.1f * k, 0.9f, 1 + 0.1f * k);
            }
        }

        static void segments(World world, int count) {
            for (int k = 0; k < count; k++) {
                float x = 1 + k % 50;
                float y = 2 + 0.7f * (k / 50);
                world.terrain().addSegment(x, y, x + 0.8f, y + 0.2f);
            }
        }
    }

    /** What takes away what no step has seen. */
    private enum Way {
        RESTORE,
        REWIND,
        REMOVAL,
        CLEAR
    }

    private static World world(Scene scene, Backend backend) {
        World world = World.builder()
                .backend(backend)
                .bounds(0, 0, 60, 40)
                .gravity(0, -10)
                .build();
        scene.build(world);
        return world;
    }

    private static void assertSame(World world, World jvm, String what) {
        assertThat(world.hash()).as(what).isEqualTo(jvm.hash());
        assertThat(snapshot(world)).as(what).isEqualTo(snapshot(jvm));
    }

    /** Lets a number of pieces or joints come that no step sees, and go. */
    private static void comeAndGo(World world, Scene scene, Way way, int count) {
        Rewind rewind = new Rewind(world, 1);
        rewind.save(0);
        ByteBuffer before = snapshot(world);
        int pieces = world.terrain().idLimit();
        int joints = world.joints().idLimit();
        scene.add(world, count);
        switch (way) {
            case RESTORE -> world.restore(before);
            case REWIND -> rewind.restore(0);
            case REMOVAL -> {
                for (int k = pieces; k < world.terrain().idLimit(); k++) {
                    world.terrain().remove(world.terrain().handle(k));
                }
                for (int k = joints; k < world.joints().idLimit(); k++) {
                    world.joints().remove(world.joints().handle(k));
                }
            }
            case CLEAR -> {
                world.clear();
                world.terrain().clear();
                scene.build(world);
            }
        }
    }

    private static void compare(Scene scene, Backend backend) {
        try (World world = world(scene, backend);
                World jvm = world(scene, Backend.JVM)) {
            world.step(STEP);
            jvm.step(STEP);
            for (int count : scene.counts) {
                for (Way way : Way.values()) {
                    String what = scene + ", " + count + ", " + way;
                    comeAndGo(world, scene, way, count);
                    comeAndGo(jvm, scene, way, count);
                    assertSame(world, jvm, what);
                    for (int step = 0; step < STEPS; step++) {
                        world.step(STEP);
                        jvm.step(STEP);
                    }
                    assertSame(world, jvm, what + ", " + STEPS + " steps on");
                    world.restore(snapshot(world));
                    jvm.restore(snapshot(jvm));
                    assertSame(world, jvm, what + ", restored");
                }
            }
        }
    }

    @OnEachOpenClBackend
    @Tag("long")
    void piecesThatNoStepHasSeenLeaveNoTrace(Backend backend) {
        compare(Scene.TERRAIN, backend);
    }

    @OnEachOpenClBackend
    @Tag("long")
    void jointsThatNoStepHasSeenLeaveNoTrace(Backend backend) {
        compare(Scene.PINNED, backend);
    }

    @OnEachOpenClBackend
    @Tag("long")
    void piecesThatNoStepHasSeenLeaveJointsAlone(Backend backend) {
        compare(Scene.CHAIN, backend);
    }

    /** A game that adds behind each step what no step sees if a late input undoes the frame. */
    private record Adding(World world, Scene scene, int count) implements Rollback.Game {
        @Override
        public void beforeStep(int frame, long[] inputs) {
            world.setVelocity(world.handle(0), inputs[0], 0);
        }

        @Override
        public void afterStep(int frame, Events events) {
            scene.add(world, count);
        }

        @Override
        public void save(ByteBuffer to) {}

        @Override
        public void restore(ByteBuffer from) {}
    }

    @OnEachOpenClBackend
    @Tag("long")
    void aRollbackUndoesThemToo(Backend backend) {
        for (Scene scene : Scene.values()) {
            int count = scene.counts[2];
            try (World world = world(scene, backend);
                    World jvm = world(scene, Backend.JVM)) {
                Rollback ofWorld = new Rollback(world, new Adding(world, scene, count), STEP, 1, 4);
                Rollback ofJvm = new Rollback(jvm, new Adding(jvm, scene, count), STEP, 1, 4);
                for (int frame = 0; frame < 6; frame++) {
                    ofWorld.advance();
                    ofJvm.advance();
                    if (frame > 0) { // an input other than the prediction, two frames late
                        ofWorld.setInput(0, frame - 1, frame);
                        ofJvm.setInput(0, frame - 1, frame);
                        ofWorld.reconcile();
                        ofJvm.reconcile();
                    }
                    assertSame(world, jvm, scene + ", frame " + frame);
                }
                assertThat(ofWorld.rollbacks()).isPositive();
            }
        }
    }

    /** A device has no room for the ids of circles that have come since its last step, and no pairs of theirs. */
    @OnEachOpenClBackend
    @Tag("long")
    void circlesThatNoStepHasSeenGoFromAWorldThatReports(Backend backend) {
        try (World world = world(Scene.PINNED, backend);
                World jvm = world(Scene.PINNED, Backend.JVM)) {
            for (World each : List.of(world, jvm)) {
                each.report(ALL);
                for (int k = 0; k < 8; k++) {
                    each.add(30 + 1.5f * k, 5, 0.9f, 1);
                }
                each.step(STEP, 30);
                int before = each.idLimit();
                for (int k = 0; k < 70_000; k++) {
                    each.add(30 + 0.0001f * k, 39, 0.5f, 1);
                }
                for (int k = before - 5; k < each.idLimit(); k++) {
                    each.remove(each.handle(k));
                }
                each.step(STEP, 30);
            }
            assertThat(Event.of(world.events()))
                    .isEqualTo(Event.of(jvm.events()))
                    .isNotEmpty();
            assertSame(world, jvm, "circles that have gone");
        }
    }

    /** What a device knows of the walls that are reported is that of the edges that there are. */
    @OnEachOpenClBackend
    @Tag("long")
    void wallsOfARestoredStateAreReported(Backend backend) {
        List<List<Event>> all = new ArrayList<>();
        for (Backend each : new Backend[] {backend, Backend.JVM}) {
            try (World open = openWorld(Edge.OPEN, each);
                    World walled = openWorld(Edge.WALL, Backend.JVM)) {
                open.step(STEP, 5);
                open.restore(snapshot(walled));
                open.step(STEP, 30);
                all.add(Event.of(open.events()));
            }
        }
        assertThat(all.get(0)).isEqualTo(all.get(1)).isNotEmpty();
    }

    private static World openWorld(Edge x, Backend backend) {
        World world = World.builder()
                .backend(backend)
                .bounds(0, 0, 60, 40)
                .edges(x, Edge.WALL)
                .build();
        world.report(ALL);
        world.add(3, 20, 1, 1);
        world.setVelocity(world.handle(0), -10, 0);
        return world;
    }

    /** A joint without impulses pulls by 0, of which there is one: new, at rest, and restored. */
    @Test
    void thereIsOneZeroOfForces() {
        checkZeros(Backend.JVM);
    }

    @OnEachOpenClBackend
    @Tag("long")
    void onADeviceItIsTheSame(Backend backend) {
        checkZeros(backend);
    }

    private static void checkZeros(Backend backend) {
        try (World world = World.builder().backend(backend).bounds(0, 0, 60, 40).build()) {
            long a = world.add(30, 30, 1, 1);
            long b = world.add(20, 20, 1, 1);
            long joint = world.joints().add(a, b, Joint.distance());
            long pin = world.joints().add(b, 20, 20, Joint.pin());
            assertZero(world, joint, pin);
            world.step(STEP);
            assertZero(world, joint, pin);
            world.restore(snapshot(world));
            assertZero(world, joint, pin);
            world.step(STEP);
            assertZero(world, joint, pin);
        }
    }

    private static void assertZero(World world, long... handles) {
        for (long joint : handles) {
            Joints joints = world.joints();
            float[] forces = {joints.force(joint), joints.forceX(joint), joints.forceY(joint), joints.torque(joint)};
            for (float force : forces) {
                assertThat(Float.floatToRawIntBits(force)).isZero();
            }
        }
    }
}
