package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A world with joints that is saved, restored, recorded or rolled back goes on as if nothing had been. */
class WorldJointStatesTest {
    private static final float STEP = 1 / 60f;
    private static final int PLAYED = 30;

    private static World.Builder builder(Edge x) {
        return builder(x, Backend.JVM).threads(1);
    }

    private static World.Builder builder(Edge x, Backend backend) {
        return World.builder()
                .backend(backend)
                .bounds(0, 0, 60, 40)
                .edges(x, Edge.WALL)
                .gravity(0, -10);
    }

    /** A rope that breaks, a ring of springs, a bridge, a hub with more spokes than colours, pins on a body that moves; balls that fall on all that. */
    private static World world(Edge x) {
        World world = builder(x).build();
        world.kind(0).setFriction(0.5f);
        TerrainBody lift = world.terrain().addBody(30, 30, 0);
        lift.addSegment(-3, 0, 3, 0);
        lift.setVelocity(0.5f, 0.25f);
        lift.setAngularVelocity(0.5f);
        rope(world, 8, 10, 35, Joint.distance().breakingAt(400, Float.POSITIVE_INFINITY));
        rope(world, 15, 14, 30, Joint.rope(1.1f));
        ring(world, 25, 8, 12);
        ring(world, 45, 8, 30);
        long weld = world.add(40, 30, 0.5f, 1);
        world.joints().add(weld, world.add(41.2f, 30, 0.5f, 2), Joint.weld().breakingAt(600, 50));
        world.joints().add(weld, lift, 2, 1, Joint.limits(1, 12));
        world.joints().add(weld, Joint.motor(3, 40));
        for (int k = 0; k < PLAYED; k++) {
            world.add(3 + 1.8f * k, 36 + k % 3, 0.3f + 0.01f * (k % 7), 1);
        }
        return world;
    }

    private static void rope(World world, float x, int links, float y, Joint link) {
        long last = world.add(x, y, 0.3f, 1);
        world.joints().add(last, x, y + 1, Joint.distance(1));
        for (int k = 1; k <= links; k++) {
            long next = world.add(x + k, y - 0.2f * k, 0.3f, k == links ? 30 : 1);
            world.joints().add(last, next, link);
            last = next;
        }
    }

    /** A hub with spokes, more of them than there are colours in the large one, and springs from each rim to the next. */
    private static void ring(World world, float x, float y, int count) {
        long hub = world.add(x, y, 0.6f, 5);
        long[] rim = new long[count];
        float radius = 0.12f * count + 1;
        for (int k = 0; k < count; k++) {
            double angle = 2 * Math.PI * k / count;
            rim[k] = world.add(
                    (float) (x + radius * Math.cos(angle)), (float) (y + radius * Math.sin(angle)), 0.2f, 0.5f);
            world.joints().add(rim[k], hub, Joint.spring(4, 0.5f));
        }
        for (int k = 0; k < count; k++) {
            world.joints().add(rim[k], rim[(k + 1) % count], Joint.distance().breakingAt(250, 400));
        }
    }

    /** What a game does with joints before a step. */
    private static void play(World world, int frame, int known) {
        Random input = new Random(frame <= known ? frame : -1);
        Joints joints = world.joints();
        long some = 0;
        for (int tries = 0; some == 0 && tries < 20; tries++) {
            some = joints.handle(input.nextInt(joints.idLimit()));
        }
        long circle = circle(world, input);
        long other = circle(world, input);
        switch (input.nextInt(10)) {
            case 0 -> remove(joints, some);
            case 1 ->
                join(
                        world,
                        circle,
                        other,
                        Joint.spring(1 + input.nextInt(9), input.nextFloat()).withLimits(0, 9));
            case 2 ->
                join(world, circle, other, Joint.rope(5 + input.nextInt(10)).colliding(input.nextBoolean()));
            case 3 -> joints.add(circle, input.nextInt(60), input.nextInt(40), Joint.mouse(3, 1, 200));
            case 4 -> join(world, circle, other, Joint.motor(input.nextFloat() * 9, 5));
            case 5 -> joints.add(circle, Joint.friction(2, 1).breakingAt(input.nextFloat() * 4, 2));
            case 6 -> world.remove(circle);
            case 7 -> set(joints, some, input);
            case 8 -> world.add(input.nextInt(50) + 5, 37, 0.4f, 2);
            default -> joints.add(circle, Joint.servo(input.nextFloat(), 3, 0.5f, 100));
        }
    }

    private static long circle(World world, Random input) {
        long some = 0;
        while (some == 0) {
            some = world.handle(input.nextInt(world.idLimit()));
        }
        return some;
    }

    private static void join(World world, long a, long b, Joint joint) {
        if (a != b) {
            world.joints().add(a, b, joint);
        }
    }

    private static void remove(Joints joints, long joint) {
        if (joint != 0) {
            joints.remove(joint);
        }
    }

    private static void set(Joints joints, long joint, Random input) {
        if (joint != 0) {
            joints.setBreaking(joint, 50 * input.nextFloat(), 900);
            joints.setColliding(joint, input.nextBoolean());
        }
    }

    @Test
    void aWorldThatIsRestoredGoesOnTheSame() {
        for (Edge edge : Edge.values()) {
            try (World world = world(edge);
                    World other = builder(edge).build()) {
                world.report(Events.BEGIN | Events.END | Events.HIT | Events.WALL);
                other.report(Events.BEGIN | Events.END | Events.HIT | Events.WALL);
                int removed = 0;
                for (int frame = 0; frame < 150; frame++) {
                    if (frame % 20 == 7) {
                        ByteBuffer saved = snapshot(world);
                        other.restore(saved);
                        assertThat(snapshot(other)).isEqualTo(saved.rewind());
                    }
                    play(world, frame, frame);
                    int joints = world.joints().size();
                    world.step(STEP);
                    removed += joints - world.joints().size();
                    if (frame >= 7) {
                        play(other, frame, frame);
                        other.step(STEP);
                        assertThat(other.hash()).as("%s, frame %d", edge, frame).isEqualTo(world.hash());
                    }
                }
                assertThat(snapshot(other)).isEqualTo(snapshot(world));
                assertThat(removed).as("joints that have broken").isPositive();
            }
        }
    }

    /** It goes there and back, and is rolled back there. */
    @OnEachBackend
    @Tag("long")
    void aSnapshotGoesOnTheSameOnEveryBackEnd(Backend backend) {
        try (World world = world(Edge.WRAP);
                World other = builder(Edge.WRAP, backend).build();
                World back = builder(Edge.WRAP).build()) {
            Rewind rewind = new Rewind(other, 5);
            for (int frame = 0; frame < 60; frame++) {
                play(world, frame, frame);
                world.step(STEP);
                if (frame % 20 == 4) {
                    ByteBuffer saved = snapshot(world);
                    other.restore(saved);
                    assertThat(snapshot(other)).isEqualTo(saved.rewind());
                    rewind.save(frame);
                } else if (frame > 4) {
                    play(other, frame, frame);
                    other.step(STEP);
                }
                if (frame % 20 == 9) {
                    rewind.restore(frame - 5);
                    for (int k = frame - 4; k <= frame; k++) {
                        play(other, k, frame);
                        other.step(STEP);
                    }
                }
                if (frame >= 4) {
                    assertThat(other.hash()).as("frame %d", frame).isEqualTo(world.hash());
                }
            }
            ByteBuffer saved = snapshot(other);
            assertThat(saved).isEqualTo(snapshot(world));
            back.restore(saved);
            back.step(STEP, 20);
            world.step(STEP, 20);
            assertThat(snapshot(back)).isEqualTo(snapshot(world));
        }
    }

    @Test
    void rollingBackTenFramesInEachFrameGivesTheBitsOfRunningStraight() {
        StateRuns.rollBack(() -> world(Edge.OPEN), 60, WorldJointStatesTest::play);
    }

    @Test
    void aLogOfJointsIsMadeAgain() throws IOException {
        World player = builder(Edge.WALL).build();
        StateRuns.replay(world(Edge.WALL), player, 100, WorldJointStatesTest::play, world -> world.joints()
                .clear());
    }

    /** Joints break in the middle of a call. */
    @Test
    void manyStepsInOneCallAreThoseOfManyCalls() {
        StateRuns.manySteps(() -> world(Edge.WALL), 90);
    }

    @Test
    void aJointThatHasBrokenIsInNoSnapshot() {
        try (World world = builder(Edge.WALL).build();
                World other = builder(Edge.WALL).build()) {
            long ball = world.add(30, 20, 1, 1);
            long joint = world.joints().add(ball, 30, 22, Joint.distance(2).breakingAt(5, Float.POSITIVE_INFINITY));
            assertThat(world.joints().contains(joint)).isTrue();
            world.step(STEP, 10);
            other.restore(snapshot(world));
            assertThat(other.joints().size()).isZero();
            assertThat(world.joints().contains(joint)).isFalse();
            assertThat(other.hash()).isEqualTo(world.hash());
            assertThat(other.joints().add(ball, 30, 22, Joint.pin()))
                    .isEqualTo(world.joints().add(ball, 30, 22, Joint.pin()));
        }
    }

    /** The world that is restored has other joints, more or less of them, or none. */
    @Test
    void jointsOfBeforeLeaveNothingInARestoredWorld() {
        try (World world = world(Edge.WALL);
                World bare = builder(Edge.WALL).build();
                World other = builder(Edge.WALL).build()) {
            bare.add(30, 20, 1, 1);
            ByteBuffer without = snapshot(bare);
            world.step(STEP, 20);
            ByteBuffer with = snapshot(world);
            world.restore(without);
            assertThat(world.hash()).isEqualTo(bare.hash());
            assertThat(world.joints().size()).isZero();
            world.step(STEP, 20);
            bare.step(STEP, 20);
            assertThat(snapshot(world)).isEqualTo(snapshot(bare));
            other.restore(with);
            world.restore(with.rewind());
            assertThat(snapshot(world)).isEqualTo(with.rewind());
            world.step(STEP, 20);
            other.step(STEP, 20);
            assertThat(snapshot(world)).isEqualTo(snapshot(other));
        }
    }
}
