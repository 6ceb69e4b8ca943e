package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** Calls on joints of bodies that are pushed do what they say; these joints are state. */
class WorldJointsOfBodiesTest {
    private static final Outline PLANK = Outline.box(2, 0.4f);
    private static final float DT = 1 / 60f;

    private static World world(int threads) {
        return WorldScenes.jvm()
                .bounds(0, 0, 40, 20)
                .gravity(0, -10)
                .friction(0.5f)
                .threads(threads)
                .build();
    }

    private static byte[] snapshot(World world) {
        ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(bytes);
        return bytes.array();
    }

    /** Joints of all kinds, between bodies, circles and places. */
    private static void fill(World world) {
        Joints joints = world.joints();
        Bodies bodies = world.bodies();
        long last = 0;
        for (int k = 0; k < 6; k++) {
            long plank = bodies.add(PLANK, 3 + 2 * k, 12, 0, 1 + k);
            if (k == 0) {
                joints.add(plank, -1, 0, 2f, 12f, Joint.pin());
            } else {
                joints.add(last, 1, 0, plank, -1, 0, k == 3 ? Joint.weld() : Joint.pin());
            }
            last = plank;
        }
        long ball = world.add(16, 11, 0.5f, 1);
        joints.add(last, 1, 0, ball, Joint.rope(1.5f).breakingAt(400, Float.POSITIVE_INFINITY));
        joints.add(last, Joint.friction(1, 0.1f));
        long cart = bodies.add(PLANK, 25, 1.2f, 0, 2);
        long rear = world.add(24, 0.5f, 0.5f, 1);
        long front = world.add(26, 0.5f, 0.5f, 1);
        joints.add(cart, -1, -0.5f, rear, Joint.spring(8, 0.7f));
        joints.add(cart, 1, -0.5f, front, Joint.pin(10, 0.5f));
        joints.add(rear, cart, Joint.motor(-8, 6));
        joints.add(cart, front, Joint.servo(0.5f, 3, 1, 2));
        TerrainBody lift = world.terrain().addBody(32, 8, 0);
        lift.setVelocity(-0.5f, 0.2f);
        long crate = bodies.add(Outline.box(1, 1), 32, 6, 0.2f, 3);
        joints.add(crate, 0.5f, 0.5f, lift, 0, 0, Joint.limits(1, 2));
        joints.add(crate, 0, 0, 31f, 6f, Joint.mouse(3, 0.7f, 50));
    }

    private static void run(World world, int steps) {
        for (int k = 0; k < steps; k++) {
            world.step(DT);
        }
    }

    @Test
    void anyNumberOfThreadsGivesTheSameBits() {
        try (World one = world(1);
                World more = world(3)) {
            fill(one);
            fill(more);
            for (int k = 0; k < 10; k++) {
                run(one, 20);
                run(more, 20);
                assertThat(more.hash()).isEqualTo(one.hash());
            }
        }
    }

    @Test
    void aSnapshotInTheMiddleGoesOnWithTheSameBits() {
        try (World world = world(2);
                World other = world(1)) {
            fill(world);
            run(world, 50);
            byte[] middle = snapshot(world);
            long then = world.hash();
            run(world, 50);
            other.restore(ByteBuffer.wrap(middle));
            assertThat(other.hash()).isEqualTo(then);
            assertThat(snapshot(other)).isEqualTo(middle);
            run(other, 50);
            assertThat(other.hash()).isEqualTo(world.hash());
            world.restore(ByteBuffer.wrap(middle));
            run(world, 50);
            assertThat(world.hash()).isEqualTo(other.hash());
        }
    }

    @Test
    void aRewindGoesBack() {
        try (World world = world(1)) {
            Rewind rewind = new Rewind(world, 20);
            fill(world);
            run(world, 30);
            rewind.save(0);
            long then = world.hash();
            run(world, 10);
            long later = world.hash();
            rewind.restore(0);
            assertThat(world.hash()).isEqualTo(then);
            run(world, 10);
            assertThat(world.hash()).isEqualTo(later);
        }
    }

    @Test
    void aLogHasThem() throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        long end;
        try (World world = world(1)) {
            try (Recording recording = new Recording(world, log, 10)) {
                fill(world);
                run(world, 30);
                world.joints().setSpeed(world.joints().handle(10), 4);
                world.bodies().remove(world.bodies().handle(2));
                run(world, 30);
                end = world.hash();
                assertThat(recording.hasFailed()).isFalse();
            }
        }
        try (World world = world(2)) {
            Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), world).run();
            assertThat(replay.differs()).isFalse();
            assertThat(world.hash()).isEqualTo(end);
        }
    }

    @Test
    void theHashAndSnapshotsHaveEachPoint() {
        try (World world = world(1);
                World other = world(1)) {
            for (World each : new World[] {world, other}) {
                each.bodies().add(PLANK, 5, 5, 0, 1);
                each.bodies().add(PLANK, 8, 5, 0, 1);
            }
            Bodies bodies = world.bodies();
            long a = bodies.handle(0);
            long b = bodies.handle(1);
            world.joints().add(a, 1, 0, b, -1, 0, Joint.pin());
            other.joints().add(a, 1, 0, b, -1, 0.5f, Joint.pin());
            assertThat(other.hash()).isNotEqualTo(world.hash());
            assertThat(snapshot(other)).isNotEqualTo(snapshot(world));
        }
    }

    @Test
    void aBodyTakesItsJointsAlong() {
        try (World world = world(1)) {
            Joints joints = world.joints();
            joints.report(true);
            long a = world.bodies().add(PLANK, 5, 5, 0, 1);
            long b = world.bodies().add(PLANK, 8, 5, 0, 1);
            long ball = world.add(10, 5, 0.5f, 1);
            long hinge = joints.add(a, 1, 0, b, -1, 0, Joint.pin());
            long rope = joints.add(b, 1, 0, ball, Joint.rope(3));
            long anchor = joints.add(a, -1, 0, 4f, 5f, Joint.pin());
            assertThat(joints.circle(hinge)).isEqualTo(a);
            assertThat(joints.other(hinge)).isEqualTo(b);
            assertThat(joints.other(rope)).isEqualTo(ball);
            assertThat(joints.other(anchor)).isZero();
            long[] some = new long[2];
            assertThat(joints.ofBody(b, some)).isEqualTo(2);
            assertThat(some).containsExactly(hinge, rope);
            assertThat(joints.ofCircle(ball, some)).isOne();
            world.remove(ball);
            assertThat(joints.events().reason(0)).isEqualTo(JointEvents.Reason.CIRCLE_REMOVED);
            world.bodies().remove(b);
            JointEvents events = joints.events();
            assertThat(events.size()).isOne();
            assertThat(events.joint(0)).isEqualTo(hinge);
            assertThat(events.circle(0)).isEqualTo(a);
            assertThat(events.other(0)).isEqualTo(b);
            assertThat(events.reason(0)).isEqualTo(JointEvents.Reason.BODY_REMOVED);
            run(world, 5);
            float force = joints.force(anchor);
            assertThat(force).isPositive();
            world.clear();
            assertThat(joints.size()).isOne();
            assertThat(joints.force(anchor)).isEqualTo(force);
            world.bodies().clear();
            assertThat(joints.size()).isZero();
            assertThat(joints.events().joint(0)).isEqualTo(anchor);
            run(world, 2);
        }
    }

    @Test
    void endsAreWhereBodiesAre() {
        try (World world = world(1)) {
            Joints joints = world.joints();
            long a = world.bodies().add(PLANK, 5, 5, (float) Math.PI / 2, 1);
            long b = world.bodies().add(PLANK, 8, 5, 0, 1);
            long rope = joints.add(a, 1, 0, b, -1, 0.2f, Joint.distance());
            float[] ends = new float[4];
            assertThat(joints.readEnds(ends)).isOne();
            assertThat(ends[0]).isCloseTo(5, within(1e-6f));
            assertThat(ends[1]).isCloseTo(6, within(1e-6f));
            assertThat(ends[2]).isCloseTo(7, within(1e-6f));
            assertThat(ends[3]).isCloseTo(5.2f, within(1e-6f));
            float length = (float) Math.hypot(2, 0.8);
            assertThat(joints.length(rope)).isCloseTo(length, within(1e-6f));
            assertThat(joints.joint(rope).length()).isCloseTo(length, within(1e-6f));
            assertThat(joints.pick(6, 5.7f, 0.2f)).isEqualTo(rope);
            long weld = joints.add(a, 1, 0, b, -1, 0.2f, Joint.weld());
            assertThat(joints.length(weld)).isCloseTo(0, within(1e-6f));
        }
    }

    @Test
    void aLoopGivesEndsBetweenTwoSteps() {
        try (World world = world(1)) {
            world.setGravity(0, 0);
            long body = world.bodies().add(PLANK, 5, 5, 0, 1);
            world.joints().add(body, 1, 0, 10f, 5f, Joint.rope(30));
            world.bodies().setVelocity(body, 0, 6);
            FixedStep loop = new FixedStep(world, 0.125f);
            float[] ends = new float[4];
            loop.jointEnds(ends, null);
            assertThat(ends).containsExactly(6, 5, 10, 5);
            loop.advance(0.1875f, () -> {});
            loop.jointEnds(ends, null);
            assertThat(ends[1]).isCloseTo(5.375f, within(1e-4f));
        }
    }

    @Test
    void badCallsAreRefusedAndChangeNothing() {
        try (World world = world(1)) {
            Joints joints = world.joints();
            long a = world.bodies().add(PLANK, 5, 5, 0, 1);
            long b = world.bodies().add(PLANK, 8, 5, 0, 1);
            long circle = world.add(10, 5, 0.5f, 1);
            long gone = world.bodies().add(PLANK, 8, 8, 0, 1);
            world.bodies().remove(gone);
            long joint = joints.add(a, 1, 0, b, -1, 0, Joint.pin());
            long before = world.hash();
            Joint pin = Joint.pin();
            refused("NaN", j -> j.add(a, Float.NaN, 0, b, 0, 0, pin), joints);
            refused("Infinity", j -> j.add(a, 0, 0, b, 0, Float.POSITIVE_INFINITY, pin), joints);
            refused("110.0", j -> j.add(a, 110, 0, b, 0, 0, pin), joints);
            refused("NaN", j -> j.add(a, 0, 0, 1f, Float.NaN, pin), joints);
            refused("handle " + a, j -> j.add(a, 0, 0, a, 1, 0, pin), joints);
            refused("was removed", j -> j.add(a, 0, 0, gone, 1, 0, pin), joints);
            refused(
                    "a circle is held by its centre, and takes no point",
                    j -> j.add(a, 0, 0, circle, 1, 0, pin),
                    joints);
            String order = "it is of a circle, or of nothing: a body and its point come first, then the circle";
            refused(order, j -> j.add(circle, 0, 0, b, 1, 0, pin), joints);
            refused(order, j -> j.add(circle, b, 0, 0, pin), joints); // the handle is taken for a point
            String point = "it is of a body of World.bodies, which a joint holds at a point: x and y of it";
            refused(point, j -> j.add(a, 0, 0, b, pin), joints);
            refused(point, j -> j.add(a, 1f, 1f, pin), joints);
            refused(point, j -> j.add(a, world.terrain().ground(), 1, 1, pin), joints);
            refused(
                    "it is of a body of World.bodies, but this call takes circles alone: add joints of bodies one by one",
                    j -> j.addAll(new long[] {a}, new long[] {b}, pin, null),
                    joints);
            refused("it is of a joint", j -> j.add(a, 0, 0, joint, pin), joints);
            refused("no circle has the handle 0", j -> j.add(a, 0, pin), joints);
            refused(
                    "a friction joint cannot hold a body to another end, but must hold it to the world",
                    j -> j.add(a, b, Joint.friction(1, 1)),
                    joints);
            refused(
                    "a weld takes no anchor, but must hold a body to another body or a circle",
                    j -> j.add(a, 0, 0, 1f, 1f, Joint.weld()),
                    joints);
            refused(
                    "a motor takes no anchor, but must hold a body to another body, a circle or the world",
                    j -> j.add(a, 0, 0, 1f, 1f, Joint.motor(1, 1)),
                    joints);
            refused("a pin must hold a body to another body, a circle or an anchor", j -> j.add(a, pin), joints);
            refused("holds two things", j -> j.setAnchor(joint, 1, 1), joints);
            refused("holds two things", j -> j.anchorX(joint), joints);
            assertThat(world.hash()).isEqualTo(before);
            assertThat(joints.size()).isOne();
        }
    }

    private static void refused(String why, Consumer<Joints> call, Joints joints) {
        assertIllegalArgument(why, () -> call.accept(joints));
    }

    @Test
    void damagedSnapshotsAreRefusedOrSound() {
        try (World world = world(1);
                World other = world(1)) {
            fill(world);
            run(world, 10);
            byte[] sound = snapshot(world);
            for (int k = 0; k < sound.length; k += 7) {
                byte[] damaged = sound.clone();
                damaged[k] = (byte) (damaged[k] ^ 1 << k % 8);
                assertThatIllegalArgumentException().isThrownBy(() -> other.restore(ByteBuffer.wrap(damaged)));
            }
        }
    }

    /** A circle that a joint holds leaves its path as far as it is pushed: not once the joint has broken, whether or not somebody asks. */
    @Test
    void aJointThatBreaksIsGoneInTheNextStepWhetherOrNotSomebodyAsks() {
        for (int phase = 0; phase < 10; phase++) {
            try (World one = breaking(phase, Backend.JVM);
                    World many = breaking(phase, Backend.JVM)) {
                compareSteps(one, many);
            }
        }
    }

    @OnEachOpenClBackend
    void soItIsOnDevices(Backend backend) {
        for (int phase = 0; phase < 5; phase++) {
            try (World one = breaking(phase, Backend.JVM);
                    World many = breaking(phase, backend)) {
                compareSteps(one, many);
            }
        }
    }

    private static void compareSteps(World one, World many) {
        for (int k = 0; k < 12; k++) {
            one.step(DT);
            assertThat(one.joints().size()).isZero(); // asks who has gone
        }
        many.step(DT, 12);
        assertThat(one.vx(one.handle(0))).isGreaterThan(20);
        assertThat(many.hash()).isEqualTo(one.hash());
    }

    /** The joint of a light circle breaks at once, and a heavy one hits the circle some steps later. */
    private static World breaking(int phase, Backend backend) {
        World world = WorldScenes.jvm()
                .bounds(0, 0, 20, 12)
                .restitution(1)
                .backend(backend)
                .build();
        long circle = world.add(6, 6, 0.4f, 0.1f);
        long crate = world.bodies().add(Outline.box(0.5f, 0.5f), 6, 9, 0, 1);
        world.joints()
                .add(crate, 0, 0, circle, Joint.spring(5, 1).withLength(2.9f).breakingAt(0.01f, 1));
        world.setVelocity(world.add(1 + 0.05f * phase, 6, 0.4f, 10), 30, 0);
        return world;
    }

    /** By the length of the step in which it broke, also where circles are reported and there are none. */
    @Test
    void aJointThatBreaksTellsOfItsForceInThatStep() {
        float[] forces = new float[2];
        for (int k = 0; k < 2; k++) {
            try (World world = WorldScenes.jvm().bounds(0, 0, 40, 20).build()) {
                world.joints().report(true);
                world.report(k == 0 ? 0 : Events.BEGIN);
                long plank = world.bodies().add(PLANK, 10, 10, 0, 1);
                world.step(1 / 30f);
                world.joints()
                        .add(
                                plank,
                                0,
                                0,
                                10f,
                                8f,
                                Joint.spring(2, 1).withLength(1).breakingAt(1, 1));
                world.step(DT);
                JointEvents events = world.joints().events();
                assertThat(events.size()).isOne();
                forces[k] = events.force(0);
            }
        }
        assertThat(forces[1]).isEqualTo(forces[0]).isGreaterThan(1);
    }

    /** Its place is a point of each body, which snapshots check. */
    @Test
    void aWeldOfASmallBodyToOneFarAwayIsRefused() {
        try (World world = world(1);
                World restored = world(1)) {
            Outline small = Outline.box(0.1f, 0.1f);
            long a = world.bodies().add(small, 2, 10, 0, 1);
            long near = world.bodies().add(PLANK, 15, 10, 0, 1);
            long far = world.bodies().add(PLANK, 35, 10, 0, 1);
            long circle = world.add(12, 10, 0.5f, 1);
            long before = world.hash();
            refused("the middle of the weld", j -> j.add(a, far, Joint.weld()), world.joints());
            refused("the middle of the weld", j -> j.add(circle, a, Joint.weld()), world.joints());
            assertThat(world.hash()).isEqualTo(before);
            world.joints().add(a, near, Joint.weld());
            restored.restore(ByteBuffer.wrap(snapshot(world)));
            assertThat(restored.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    void bodiesWithoutJointsHaveTheirHashWithThemToo() {
        try (World world = world(1);
                World other = world(1)) {
            for (World each : new World[] {world, other}) {
                each.bodies().add(PLANK, 5, 5, 0.3f, 1);
            }
            long joint = other.joints().add(other.bodies().handle(0), Joint.motor(1, 1));
            other.joints().remove(joint);
            run(world, 30);
            run(other, 30);
            assertThat(other.hash()).isEqualTo(world.hash());
        }
    }
}
