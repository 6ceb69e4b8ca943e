package io.github.circles2d.world.snapshots;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Edge;
import io.github.circles2d.Joint;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.joints.SavedJoints;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointState;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** Joints, and what they keep from step to step, in snapshots: what is kept, and what is refused. */
class JointSectionTest {
    private static final float STEP = 1 / 60f;

    // ids of the joints of build
    private static final int ROPE = 0;
    private static final int WELD = 1;
    private static final int FREE = 2;
    private static final int SPRING = 3;
    private static final int PIN = 4;
    private static final int MOUSE = 5;
    private static final int MOTOR = 6;
    private static final int SERVO = 7;
    private static final int FRICTION = 8;
    private static final int BODY_PIN = 9;
    private static final int RIGID = 10;

    /** A free id of a circle. */
    private static final int GONE = 5;

    private static World world() {
        return WorldScenes.jvm()
                .bounds(0, 0, 100, 100)
                .edges(Edge.WRAP, Edge.OPEN)
                .gravity(0, -10)
                .threads(1)
                .build();
    }

    /** Joints of every kind; some ids are free. */
    private static void build(World world) {
        long a = world.add(50, 50, 1, 1);
        long b = world.add(53, 50, 1, 2);
        long still = world.add(56, 50, 1, Float.POSITIVE_INFINITY);
        long c = world.add(50, 53, 1, 1);
        TerrainBody none = world.terrain().addBody(1, 1, 0);
        TerrainBody body = world.terrain().addBody(70, 20, 1);
        none.remove();
        body.setVelocity(1, 0.5f);
        body.setAngularVelocity(0.5f);
        world.joints().add(a, b, Joint.rope(3.5f).breakingAt(1e6f, Float.POSITIVE_INFINITY));
        world.joints().add(c, a, Joint.weld().colliding(true));
        long gone = world.joints().add(a, c, Joint.distance(3));
        world.joints().add(b, still, Joint.spring(3, 0.5f).withLimits(2.5f, 4));
        world.joints().add(a, 51, 51, Joint.pin(2, 0.25f));
        world.joints().add(b, 52, 51, Joint.mouse(5, 0.75f, 100));
        world.joints().add(a, b, Joint.motor(2, 50));
        world.joints().add(c, Joint.servo(1, 3, 0.5f, 40));
        world.joints().add(c, Joint.friction(3, 2));
        world.joints().add(b, body, 1, -2, Joint.distance(35));
        world.joints().remove(gone);
        world.joints().add(still, b, Joint.limits(0.5f, 30));
        assertThat(world.joints().idLimit()).isEqualTo(BODY_PIN + 1);
        world.joints().add(world.add(40, 50, 1, 1), a, Joint.distance());
        world.joints().remove(world.joints().handle(FREE));
        world.remove(world.add(60, 60, 1, 1));
    }

    @Test
    void aWorldThatIsRestoredHasTheJointsThatItHad() {
        try (World world = world();
                World other = world();
                World third = world()) {
            build(world);
            world.step(STEP, 7);
            ByteBuffer saved = snapshot(world);
            long one = other.add(10, 10, 1, 1);
            other.joints().add(one, other.add(13, 10, 1, 1), Joint.weld());
            other.step(STEP);
            other.restore(saved);
            third.restore(saved.rewind());
            assertThat(snapshot(other)).isEqualTo(saved.rewind());
            assertThat(snapshot(third)).isEqualTo(saved);
            assertThat(other.hash()).isEqualTo(world.hash());
            goOn(world, other);
            goOn(world, third);
            assertThat(other.joints().add(other.handle(0), other.handle(3), Joint.distance()))
                    .isEqualTo(world.joints().add(world.handle(0), world.handle(3), Joint.distance()));
            // once more, where the same joints are there already
            ByteBuffer now = snapshot(world);
            world.step(STEP, 5);
            world.restore(now);
            assertThat(snapshot(world)).isEqualTo(now.rewind());
            other.restore(now);
            goOn(world, other);
        }
    }

    /** Makes three steps in a world, from where it is now, and in another. */
    private static void goOn(World world, World other) {
        ByteBuffer before = snapshot(world);
        for (int k = 0; k < 3; k++) {
            world.step(STEP);
            other.step(STEP);
            assertThat(other.hash()).isEqualTo(world.hash());
        }
        assertThat(snapshot(other)).isEqualTo(snapshot(world));
        assertThat(other.joints().size()).isEqualTo(world.joints().size());
        for (int id = 0; id < world.joints().idLimit(); id++) {
            assertThat(other.joints().handle(id)).isEqualTo(world.joints().handle(id));
        }
        world.restore(before);
    }

    @Test
    void aWorldWithoutJointsHasTheBytesAndTheHashOfBefore() {
        try (World world = world();
                World other = world()) {
            world.add(50, 50, 1, 1);
            other.add(50, 50, 1, 1);
            other.joints().clear();
            assertThat(snapshot(other)).isEqualTo(snapshot(world));
            assertThat(other.hash()).isEqualTo(world.hash());
            other.joints().remove(other.joints().add(other.handle(0), 50, 51, Joint.pin()));
            assertThat(other.hash()).isEqualTo(world.hash());
            assertThat(snapshot(other)).isNotEqualTo(snapshot(world)); // the id's next handle is another
        }
    }

    @Test
    void eachValueIsInTheHash() {
        try (World world = world()) {
            build(world);
            world.step(STEP);
            long hash = world.hash();
            Consumer<Consumer<SavedState>> differs = change -> {
                SavedState s = state(world);
                change.accept(s);
                try (World other = world()) {
                    other.restore(bytes(s));
                    assertThat(other.hash()).isNotEqualTo(hash);
                }
            };
            differs.accept(s -> s.joints.form[ROPE] |= JointRow.COLLIDE);
            differs.accept(s -> s.joints.colour[ROPE] = 9);
            differs.accept(s -> s.joints.colour[ROPE] = JointTable.SPLIT);
            differs.accept(s -> s.joints.a[FRICTION] = 4);
            differs.accept(s -> s.joints.b[ROPE] = 4);
            differs.accept(s -> s.joints.body[BODY_PIN] = 0);
            differs.accept(s -> s.joints.referenceA[WELD]++);
            differs.accept(s -> s.joints.referenceB[WELD]++);
            differs.accept(s -> set(s, PIN, JointRow.ANCHOR_X, 7));
            differs.accept(s -> set(s, PIN, JointRow.ANCHOR_Y, 7));
            differs.accept(s -> set(s, BODY_PIN, JointRow.ANCHOR_Y, 7));
            differs.accept(s -> set(s, BODY_PIN, JointRow.LENGTH, 7));
            differs.accept(s -> set(s, SPRING, JointRow.LENGTH, 7));
            differs.accept(s -> set(s, SPRING, JointRow.MIN_LENGTH, 2));
            differs.accept(s -> set(s, ROPE, JointRow.MAX_LENGTH, 7));
            differs.accept(s -> set(s, MOUSE, JointRow.MAX_FORCE, 7));
            differs.accept(s -> set(s, MOTOR, JointRow.MAX_TORQUE, 7));
            differs.accept(s -> set(s, MOTOR, JointRow.SPEED, 7));
            differs.accept(s -> set(s, ROPE, JointRow.BREAK_FORCE, 1e7f));
            differs.accept(s -> set(s, ROPE, JointRow.BREAK_TORQUE, 7));
            differs.accept(s -> set(s, SPRING, SavedJoints.FREQUENCY, 7));
            differs.accept(s -> set(s, SERVO, SavedJoints.DAMPING_RATIO, 7));
            differs.accept(s -> {
                set(s, WELD, JointRow.DIRECTION_X, 0.6f);
                set(s, WELD, JointRow.DIRECTION_Y, 0.8f);
            });
            differs.accept(s -> keep(s, WELD, JointState.AXIAL, 0.5f));
            differs.accept(s -> keep(s, WELD, JointState.ACROSS, 0.5f));
            differs.accept(s -> keep(s, SPRING, JointState.LOWER, 0.5f));
            differs.accept(s -> keep(s, ROPE, JointState.UPPER, 0.5f));
            differs.accept(s -> keep(s, WELD, JointState.ANGULAR, 0.5f));
            differs.accept(s -> keep(s, WELD, JointState.SUM_X, 0.5f));
            differs.accept(s -> keep(s, WELD, JointState.SUM_Y, 0.5f));
            differs.accept(s -> keep(s, WELD, JointState.SUM_ANGULAR, 0.5f));
        }
    }

    @Test
    void jointsThatNoCallsLeadToAreRefused() {
        refused("no sense", s -> s.joints.form[ROPE] |= 1 << 11);
        refused("no sense", s -> s.joints.form[ROPE] |= JointRow.TURN_SPEED);
        refused("no sense", s -> s.joints.form[RIGID] |= JointRow.ELASTIC);
        refused("no sense", s -> s.joints.form[RIGID] |= JointRow.ACROSS);
        refused("no sense", s -> s.joints.form[WELD] &= ~JointRow.ACROSS);
        refused("no sense", s -> s.joints.form[PIN] &= ~JointRow.ELASTIC);
        refused("no sense", s -> s.joints.form[MOTOR] = JointRow.TURN_ANGLE);
        refused("no sense", s -> s.joints.form[MOTOR] = JointRow.COLLIDE);
        refused("no sense", s -> s.joints.b[WELD] = JointRow.NONE);
        refused("no sense", s -> s.joints.b[PIN] = 1);
        refused("no sense", s -> s.joints.b[FRICTION] = 1);
        refused("colour", s -> s.joints.colour[ROPE] = JointTable.SPLIT + 1);
        refused("one colour", s -> s.joints.colour[ROPE] = s.joints.colour[WELD]);
        refused("one colour", s -> s.joints.colour[FRICTION] = s.joints.colour[SERVO]);
        refused("lacks a circle", s -> s.joints.a[ROPE] = GONE);
        refused("lacks a circle", s -> s.joints.b[ROPE] = GONE);
        refused("lacks a circle", s -> s.joints.a[ROPE] = 100);
        refused("lacks a circle", s -> s.joints.b[ROPE] = -5);
        refused("to itself", s -> s.joints.b[ROPE] = s.joints.a[ROPE]);
        refused("no body", s -> s.joints.body[BODY_PIN] = 1);
        refused("no body", s -> s.joints.body[BODY_PIN] = 3);
        refused("no body", s -> s.joints.body[ROPE] = 2);
        refused("no body", s -> s.joints.body[SERVO] = 2);
        refused("no such angles", s -> s.joints.referenceA[ROPE] = 2);
        refused("no such angles", s -> s.joints.referenceB[SERVO] = 2);
        refused("generation", s -> s.joints.generation[ROPE] = -1);
        refused("a joint breaks", s -> s.joints.form[RIGID] |= JointRow.BREAKABLE);
        refused("no such values", s -> set(s, MOTOR, JointRow.ANCHOR_X, 1));
        refused("no such values", s -> set(s, ROPE, JointRow.ANCHOR_X, 1));
        refused("no such values", s -> set(s, ROPE, JointRow.LENGTH, 1));
        refused("no such values", s -> set(s, RIGID, JointRow.BREAK_FORCE, 1));
        refused("no such values", s -> set(s, ROPE, JointRow.DIRECTION_X, 1));
        refused("no such values", s -> set(s, ROPE, SavedJoints.FREQUENCY, 1));
        refused("an anchor", s -> set(s, PIN, JointRow.ANCHOR_X, Float.NaN));
        refused("an anchor", s -> set(s, PIN, JointRow.ANCHOR_Y, 2e9f));
        refused("out of range", s -> set(s, PIN, JointRow.ANCHOR_X, 101));
        refused("an initial value", s -> set(s, PIN, JointRow.ANCHOR_X, -0f));
        refused("an initial value", s -> set(s, RIGID, JointRow.LENGTH, -0f));
        refused("a length", s -> set(s, RIGID, JointRow.LENGTH, Float.NaN));
        refused("a length", s -> set(s, RIGID, JointRow.LENGTH, -1));
        refused("a length", s -> set(s, RIGID, JointRow.LENGTH, Float.POSITIVE_INFINITY));
        refused("out of order", s -> set(s, SPRING, JointRow.MIN_LENGTH, 5));
        refused("out of order", s -> set(s, SPRING, JointRow.MAX_LENGTH, 2));
        refused("out of order", s -> s.joints.form[ROPE] |= JointRow.LOWER);
        refused("a value", s -> set(s, ROPE, JointRow.MAX_LENGTH, Float.NaN));
        refused("a value", s -> set(s, MOUSE, JointRow.MAX_FORCE, Float.NaN));
        refused("a value", s -> set(s, MOTOR, JointRow.MAX_TORQUE, -1));
        refused("a value", s -> set(s, ROPE, JointRow.BREAK_FORCE, Float.NaN));
        refused("the speed", s -> set(s, MOTOR, JointRow.SPEED, Float.POSITIVE_INFINITY));
        refused("the frequency", s -> set(s, SPRING, SavedJoints.FREQUENCY, 2e4f));
        refused("the damping", s -> set(s, SPRING, SavedJoints.DAMPING_RATIO, Float.NaN));
        refused("direction", s -> set(s, WELD, JointRow.DIRECTION_Y, 0.25f));
        refused("direction", s -> set(s, WELD, JointRow.DIRECTION_X, Float.NaN));
    }

    @Test
    void impulsesThatNoStepsLeadToAreRefused() {
        accepted(s -> keep(s, WELD, JointState.ACROSS, -1e20f));
        refused("an impulse", s -> keep(s, WELD, JointState.AXIAL, Float.NaN));
        refused("an impulse", s -> keep(s, WELD, JointState.ACROSS, Float.POSITIVE_INFINITY));
        refused("an impulse", s -> keep(s, WELD, JointState.ANGULAR, 1e21f));
        refused("an impulse", s -> keep(s, WELD, JointState.SUM_X, Float.NEGATIVE_INFINITY));
        refused("an impulse", s -> keep(s, WELD, JointState.SUM_ANGULAR, Float.NaN));
        refused("an impulse", s -> keep(s, SPRING, JointState.LOWER, -1));
        refused("an impulse", s -> keep(s, ROPE, JointState.UPPER, -1));
        refused("no such impulses", s -> keep(s, ROPE, JointState.LOWER, 1));
        refused("no such impulses", s -> keep(s, ROPE, JointState.AXIAL, 1));
        refused("no such impulses", s -> keep(s, MOTOR, JointState.AXIAL, 1));
        refused("no such impulses", s -> keep(s, MOTOR, JointState.SUM_X, 1));
        refused("no such impulses", s -> keep(s, RIGID, JointState.ACROSS, 1));
        refused("no such impulses", s -> keep(s, RIGID, JointState.ANGULAR, 1));
    }

    @Test
    void cutSectionsAreRefused() {
        try (World world = world()) {
            build(world);
            world.step(STEP, 3);
            ByteBuffer good = snapshot(world).order(ByteOrder.LITTLE_ENDIAN);
            for (int length = SnapshotCodec.HEADER; length < good.limit(); length++) {
                ByteBuffer cut = ByteBuffer.allocate(good.limit()).order(ByteOrder.LITTLE_ENDIAN);
                cut.put(0, good, 0, good.limit()).limit(length).putInt(8, length);
                refused("", cut);
            }
        }
    }

    private static void set(SavedState s, int joint, int value, float to) {
        s.joints.values[SavedJoints.VALUES * joint + value] = to;
    }

    private static void keep(SavedState s, int joint, int what, float impulse) {
        s.jointStates.rows[JointState.of(joint) + what] = impulse;
    }

    private static void accepted(Consumer<SavedState> forge) {
        try (World world = world();
                World other = world()) {
            build(world);
            SavedState s = state(world);
            forge.accept(s);
            other.restore(bytes(s));
        }
    }

    private static void refused(String message, Consumer<SavedState> forge) {
        try (World world = world()) {
            build(world);
            SavedState s = state(world);
            forge.accept(s);
            refused(message, bytes(s));
        }
    }

    private static void refused(String message, ByteBuffer bytes) {
        bytes.putLong(SnapshotCodec.CHECK_AT, SnapshotCodec.check(bytes, bytes.limit()));
        try (World world = world()) {
            build(world);
            world.step(STEP);
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
}
