package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.ConcurrentModificationException;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.LongStream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The calls on joints: what they do, and what they refuse. */
class WorldJointsApiTest {
    private static final float STEP = 1 / 60f;
    private static final float INFINITE = Float.POSITIVE_INFINITY;

    private final World world = builder().build();
    private final Joints joints = world.joints();

    private long a;
    private long b;
    private long still;
    private long alsoStill;

    private static World.Builder builder() {
        return WorldScenes.jvm().bounds(-100, -100, 100, 100).gravity(0, -10).threads(1);
    }

    @BeforeEach
    void fill() {
        a = world.add(0, 0, 0.5f, 2);
        b = world.add(3, 4, 0.5f, 2);
        still = world.add(20, 20, 0.5f, INFINITE);
        alsoStill = world.add(24, 20, 0.5f, INFINITE);
    }

    @AfterEach
    void close() {
        world.close();
    }

    private static void refused(ThrowingCallable call, String message) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessage(message);
    }

    /** A call on this world is refused, and changes nothing. */
    private void changesNothing(ThrowingCallable call, String message) {
        long before = world.hash();
        int size = joints.size();
        refused(call, message);
        assertThat(joints.size()).isEqualTo(size);
        assertThat(world.hash()).isEqualTo(before);
    }

    private float distance(long one, long other) {
        return (float) Math.hypot(world.x(one) - world.x(other), world.y(one) - world.y(other));
    }

    // ---- definitions

    @Test
    void definitionsHaveWhatTheyWereGiven() {
        assertThat(Joint.distance().type()).isEqualTo(JointType.DISTANCE);
        assertThat(Joint.distance().length()).isNaN();
        assertThat(Joint.distance(3).length()).isEqualTo(3);
        Joint spring = Joint.spring(5, 0.7f);
        assertThat(spring.type()).isEqualTo(JointType.SPRING);
        assertThat(spring.hertz()).isEqualTo(5);
        assertThat(spring.dampingRatio()).isEqualTo(0.7f);
        assertThat(spring.length()).isNaN();
        assertThat(spring.withLength(2).length()).isEqualTo(2);
        assertThat(spring.maxLength()).isInfinite();
        assertThat(spring.withLimits(1, 4).minLength()).isEqualTo(1);
        assertThat(spring.withLimits(1, 4).maxLength()).isEqualTo(4);
        assertThat(Joint.rope(7).type()).isEqualTo(JointType.LIMITS);
        assertThat(Joint.rope(7).minLength()).isZero();
        assertThat(Joint.rope(7).maxLength()).isEqualTo(7);
        assertThat(Joint.rope(7).length()).isZero();
        assertThat(Joint.limits(2, INFINITE).minLength()).isEqualTo(2);
        assertThat(Joint.weld().type()).isEqualTo(JointType.WELD);
        assertThat(Joint.pin().type()).isEqualTo(JointType.PIN);
        assertThat(Joint.pin().hertz()).isZero();
        assertThat(Joint.pin().withMaxForce(6).maxForce()).isEqualTo(6);
        assertThat(Joint.pin(3, 1).maxForce()).isInfinite();
        assertThat(Joint.mouse(3, 1, 50).type()).isEqualTo(JointType.PIN);
        assertThat(Joint.mouse(3, 1, 50).maxForce()).isEqualTo(50);
        assertThat(Joint.motor(-2, 9).type()).isEqualTo(JointType.MOTOR);
        assertThat(Joint.motor(-2, 9).speed()).isEqualTo(-2);
        assertThat(Joint.motor(-2, 9).maxTorque()).isEqualTo(9);
        Joint servo = Joint.servo(1.5f, 4, 0.5f, 8);
        assertThat(servo.type()).isEqualTo(JointType.SERVO);
        assertThat(servo.angle()).isCloseTo(1.5f, within(1e-6f));
        assertThat(servo.hertz()).isEqualTo(4);
        assertThat(servo.maxTorque()).isEqualTo(8);
        assertThat(Joint.friction(3, 4).type()).isEqualTo(JointType.FRICTION);
        assertThat(Joint.friction(3, 4).maxForce()).isEqualTo(3);
        assertThat(Joint.friction(3, 4).maxTorque()).isEqualTo(4);
        assertThat(spring.breakForce()).isInfinite();
        assertThat(spring.breakTorque()).isInfinite();
        assertThat(spring.breakingAt(5, 6).breakForce()).isEqualTo(5);
        assertThat(spring.breakingAt(5, 6).breakTorque()).isEqualTo(6);
        assertThat(spring.collides()).isFalse();
        assertThat(spring.colliding(true).collides()).isTrue();
        assertThat(spring.colliding(true).colliding(false).collides()).isFalse();
        assertThat(spring).hasToString("spring");
        assertThat(Joint.limits(1, 2)).hasToString("joint with limits");
    }

    @Test
    void definitionsRefuseWhatIsOutOfRange() {
        refused(() -> Joint.distance(-1), "the length is -1.0, but must be from 0.0 to 1.0E9");
        refused(() -> Joint.distance(Float.NaN), "the length is NaN, but must be from 0.0 to 1.0E9");
        refused(() -> Joint.distance(INFINITE), "the length is Infinity, but must be from 0.0 to 1.0E9");
        refused(() -> Joint.rope(-2), "the greatest length is -2.0, but must be from 0.0 to Infinity");
        refused(() -> Joint.limits(5, 3), "the least length is 5.0, but must be at most the greatest length, 3.0");
        refused(() -> Joint.limits(-1, 3), "the least length is -1.0, but must be from 0.0 to 1.0E9");
        refused(() -> Joint.limits(INFINITE, INFINITE), "the least length is Infinity, but must be from 0.0 to 1.0E9");
        refused(() -> Joint.limits(1, Float.NaN), "the greatest length is NaN, but must be from 0.0 to Infinity");
        refused(() -> Joint.spring(1e5f, 1), "the frequency is 100000.0, but must be from 0.0 to 10000.0");
        refused(() -> Joint.spring(-1, 1), "the frequency is -1.0, but must be from 0.0 to 10000.0");
        refused(() -> Joint.pin(1, -1), "the damping ratio is -1.0, but must be from 0.0 to 1000.0");
        refused(() -> Joint.pin(1, Float.NaN), "the damping ratio is NaN, but must be from 0.0 to 1000.0");
        refused(() -> Joint.mouse(1, 1, -1), "the greatest force is -1.0, but must be from 0.0 to Infinity");
        refused(() -> Joint.motor(2e9f, 1), "the speed is 2.0E9, but must be from -1.0E9 to 1.0E9");
        refused(() -> Joint.motor(1, -1), "the greatest torque is -1.0, but must be from 0.0 to Infinity");
        refused(() -> Joint.servo(2e6f, 1, 1, 1), "the angle is 2000000.0, but must be from -1000000.0 to 1000000.0");
        refused(() -> Joint.friction(Float.NaN, 1), "the greatest force is NaN, but must be from 0.0 to Infinity");
        refused(
                () -> Joint.weld().breakingAt(-1, 1),
                "the force that breaks it is -1.0, but must be from 0.0 to Infinity");
        refused(
                () -> Joint.weld().breakingAt(1, Float.NaN),
                "the torque that breaks it is NaN, but must be from 0.0 to Infinity");
    }

    @Test
    void definitionsRefuseWhatTheyDoNotHave() {
        refused(() -> Joint.rope(1).withLength(1), "a joint with limits has no length to set");
        refused(() -> Joint.weld().withLength(1), "a weld has no length to set");
        refused(() -> Joint.pin().withLength(1), "a pin has no length to set");
        refused(() -> Joint.distance().withLimits(1, 2), "a distance joint has no limits");
        refused(() -> Joint.motor(1, 1).withLimits(1, 2), "a motor has no limits");
        refused(() -> Joint.servo(1, 1, 1, 1).withMaxForce(1), "a servo has no greatest force");
        refused(() -> Joint.spring(1, 1).withMaxForce(1), "a spring has no greatest force");
        assertThat(Joint.friction(1, 1).withMaxForce(2).maxForce()).isEqualTo(2);
    }

    // ---- joints come

    @Test
    void circlesThatCannotBeHeldAreRefused() {
        changesNothing(
                () -> joints.add(a, a, Joint.distance()),
                "both circles have the handle " + a + ", but a joint holds two different ones");
        changesNothing(
                () -> joints.add(still, alsoStill, Joint.distance()),
                "the circles with the handles " + still + " and " + alsoStill
                        + " are both static, but one of them must move");
        changesNothing(
                () -> joints.add(still, 1, 1, Joint.pin()),
                "the circle with the handle " + still + " is static, but must move");
        changesNothing(
                () -> joints.add(still, Joint.motor(1, 1)),
                "the circle with the handle " + still + " is static, but must move");
        changesNothing(
                () -> joints.add(a, 77, Joint.distance()),
                "no circle has the handle 77: it was removed, or is none of this world's");
        changesNothing(
                () -> joints.add(77, b, Joint.distance()),
                "no circle has the handle 77: it was removed, or is none of this world's");
        world.remove(b);
        String stale = "no circle has the handle " + b + ": it was removed, or is none of this world's";
        changesNothing(() -> joints.add(a, b, Joint.distance()), stale);
        changesNothing(() -> joints.add(b, 1, 1, Joint.distance()), stale);
        changesNothing(() -> joints.add(b, Joint.motor(1, 1)), stale);
        changesNothing(() -> joints.ofCircle(b, new long[1]), stale);
        assertThat(joints.add(still, a, Joint.distance())).isNotZero();
    }

    @Test
    void joinsThatMakeNoSenseAreRefused() {
        changesNothing(
                () -> joints.add(a, b, Joint.pin()), "a pin cannot hold two circles, but must hold one to an anchor");
        changesNothing(
                () -> joints.add(a, b, Joint.friction(1, 1)),
                "a friction joint cannot hold two circles, but must hold one to the world");
        changesNothing(
                () -> joints.add(a, 1, 1, Joint.weld()),
                "a weld takes no anchor, but must hold a circle to another one");
        changesNothing(
                () -> joints.add(a, 1, 1, Joint.motor(1, 1)),
                "a motor takes no anchor, but must hold a circle to another one or to the world");
        changesNothing(() -> joints.add(a, Joint.pin()), "a pin must hold a circle to an anchor");
        changesNothing(
                () -> joints.add(a, Joint.spring(1, 1)), "a spring must hold a circle to another one or to an anchor");
        changesNothing(() -> joints.add(a, Joint.weld()), "a weld must hold a circle to another one");
        changesNothing(() -> joints.add(a, 2e9f, 1, Joint.pin()), "x is 2.0E9, but must be from -1.0E9 to 1.0E9");
        changesNothing(() -> joints.add(a, 1, Float.NaN, Joint.pin()), "y is NaN, but must be from -1.0E9 to 1.0E9");
    }

    @Test
    void bodiesOfOtherWorldsAndThoseThatHaveGoneAreRefused() {
        TerrainBody body = world.terrain().addBody(1, 1, 0);
        joints.add(a, body, 2, 2, Joint.pin());
        world.terrain().clear();
        changesNothing(
                () -> joints.add(a, body, 2, 2, Joint.pin()),
                "no body of terrain has the handle " + body.handle() + ": it was removed, or is none of this world's");
        try (World other = builder().build()) {
            TerrainBody foreign = other.terrain().addBody(1, 1, 0);
            changesNothing(
                    () -> joints.add(a, foreign, 2, 2, Joint.pin()),
                    "the body with the handle " + foreign.handle() + " is of another world");
        }
    }

    @Test
    void aLengthThatNobodyGaveIsThatOfTheEnds() {
        assertThat(joints.joint(joints.add(a, b, Joint.distance())).length()).isEqualTo(5);
        assertThat(joints.joint(joints.add(a, b, Joint.spring(1, 1))).length()).isEqualTo(5);
        assertThat(joints.joint(joints.add(a, b, Joint.weld())).length()).isEqualTo(5);
        assertThat(joints.joint(joints.add(a, -6, 8, Joint.distance())).length())
                .isEqualTo(10);
        TerrainBody body = world.terrain().addBody(0, 1, (float) Math.PI / 2);
        long joint = joints.add(a, body, 1, 0, Joint.distance());
        assertThat(joints.joint(joint).length()).isCloseTo(2, within(1e-6f));
        assertThat(joints.joint(joints.add(a, b, Joint.distance(1))).length()).isEqualTo(1);
        assertThat(joints.joint(joints.add(a, b, Joint.rope(9))).length()).isZero();
    }

    @Test
    void manyJointsComeAtOnceOrNone() {
        long[] firsts = LongStream.range(0, 50)
                .map(k -> world.add(-50 + k, 50, 0.3f, 1))
                .toArray();
        long[] others = LongStream.range(0, 50)
                .map(k -> world.add(-50 + k, 51 + k / 10, 0.3f, 1))
                .toArray();
        long[] handles = new long[50];
        assertThat(joints.addAll(firsts, others, Joint.distance(), handles)).isEqualTo(50);
        for (int k = 0; k < 50; k++) {
            assertThat(joints.circle(handles[k])).isEqualTo(firsts[k]);
            assertThat(joints.other(handles[k])).isEqualTo(others[k]);
            assertThat(joints.joint(handles[k]).length()).isEqualTo(1 + k / 10);
        }
        assertThat(joints.addAll(others, firsts, Joint.spring(1, 0), null)).isEqualTo(50);
        assertThat(joints.addAll(new long[0], new long[0], Joint.weld(), null)).isZero();
        assertThat(joints.size()).isEqualTo(100);
        long kept = others[7];
        others[7] = 5;
        changesNothing(
                () -> joints.addAll(firsts, others, Joint.weld(), null),
                "joint 7: no circle has the handle 5: it was removed, or is none of this world's");
        others[7] = firsts[7];
        changesNothing(
                () -> joints.addAll(firsts, others, Joint.weld(), null),
                "joint 7: both circles have the handle " + firsts[7] + ", but a joint holds two different ones");
        others[7] = kept;
        changesNothing(
                () -> joints.addAll(firsts, others, Joint.pin(), null),
                "joint 0: a pin cannot hold two circles, but must hold one to an anchor");
        changesNothing(
                () -> joints.addAll(firsts, new long[49], Joint.weld(), null),
                "others has 49 elements, but must have one for each of 50 circles");
        changesNothing(
                () -> joints.addAll(firsts, others, Joint.weld(), new long[49]),
                "handles has 49 elements, but there are 50 joints");
    }

    @Test
    void aServoOfHighFrequencyAndDampingLiftsWhatIsWeldedToItsCircle() {
        long hinge = world.add(-50, 0, 1, 4);
        joints.add(hinge, -50, 0, Joint.pin());
        long servo = joints.add(hinge, Joint.servo(0, 20, 20, INFINITE));
        long end = hinge;
        for (int k = 1; k <= 8; k++) {
            long next = world.add(-50 + 2 * k, 0, 1, 1);
            joints.add(end, next, Joint.weld());
            end = next;
        }
        world.step(STEP, 300);
        assertThat(world.y(end)).as("it hardly sinks").isCloseTo(0, within(0.8f));
        joints.setAngle(servo, 1.2f);
        world.step(STEP, 300);
        assertThat(world.angle(hinge)).isCloseTo(1.2f, within(0.05f));
        assertThat(world.y(end)).isCloseTo(16 * (float) Math.sin(1.2), within(1f));
    }

    @Test
    void manyCirclesGetTheFrictionOfATableInACall() {
        try (World table = builder().gravity(0, 0).build()) {
            long[] pucks = new long[20];
            long[] handles = new long[20];
            for (int k = 0; k < pucks.length; k++) {
                pucks[k] = table.add(4 * k - 40, 0, 1, 2);
                table.setVelocity(pucks[k], 0, 1 + k % 4);
                table.setAngularVelocity(pucks[k], 3);
            }
            float force = 0.1f * 10 * 2;
            Joint friction = Joint.friction(force, 2 / 3f * force);
            assertThat(table.joints().addAll(pucks, friction, handles)).isEqualTo(20);
            for (int k = 0; k < 20; k++) {
                assertThat(table.joints().circle(handles[k])).isEqualTo(pucks[k]);
                assertThat(table.joints().joint(handles[k]).type()).isEqualTo(JointType.FRICTION);
            }
            table.step(STEP, 300);
            for (int k = 0; k < 20; k++) {
                float v = 1 + k % 4;
                assertThat(table.y(pucks[k])).as("v^2 / (2 mu g)").isCloseTo(v * v / 2, within(0.02f * v));
                assertThat(table.vy(pucks[k])).isZero();
                assertThat(table.angularVelocity(pucks[k])).isZero();
            }
        }
        assertThat(joints.addAll(new long[0], Joint.motor(1, 1), null)).isZero();
        changesNothing(
                () -> joints.addAll(new long[] {a, still}, Joint.motor(1, 1), null),
                "joint 1: the circle with the handle " + still + " is static, but must move");
        changesNothing(
                () -> joints.addAll(new long[] {a, b}, Joint.pin(), null),
                "joint 0: a pin must hold a circle to an anchor");
        changesNothing(
                () -> joints.addAll(new long[] {a, b}, Joint.motor(1, 1), new long[1]),
                "handles has 1 elements, but there are 2 joints");
        changesNothing(
                () -> joints.addAll(new long[] {a, 5}, Joint.motor(1, 1), null),
                "joint 1: no circle has the handle 5: it was removed, or is none of this world's");
    }

    @Test
    @Tag("long")
    void aWorldHasAMillionJointsAndNotOneMore() {
        int most = 1 << 20;
        long[] firsts = new long[most - 1];
        long[] others = new long[most - 1];
        Arrays.fill(firsts, a);
        Arrays.fill(others, b);
        joints.addAll(firsts, others, Joint.rope(9), null);
        refused(
                () -> joints.addAll(new long[] {a, a}, new long[] {b, b}, Joint.rope(9), null),
                "a world has at most 1048576 joints, not 1048577");
        joints.add(a, b, Joint.rope(9));
        refused(() -> joints.add(a, Joint.motor(1, 1)), "a world has at most 1048576 joints, not 1048577");
        assertThat(joints.size()).isEqualTo(most);
        world.step(STEP);
        world.remove(a);
        assertThat(joints.size()).isZero();
    }

    // ---- handles

    @Test
    void handlesAreStaleOnceTheirJointsHaveGone() {
        long first = joints.add(a, b, Joint.distance());
        long second = joints.add(a, Joint.motor(1, 1));
        assertThat(joints.size()).isEqualTo(2);
        assertThat(joints.idLimit()).isEqualTo(2);
        assertThat(Joints.id(first)).isZero();
        assertThat(Joints.id(second)).isOne();
        assertThat(joints.handle(1)).isEqualTo(second);
        assertThat(joints.circle(first)).isEqualTo(a);
        assertThat(joints.other(first)).isEqualTo(b);
        assertThat(joints.other(second)).isZero();
        joints.remove(first);
        assertThat(joints.contains(first)).isFalse();
        assertThat(joints.contains(second)).isTrue();
        assertThat(joints.contains(12345)).isFalse();
        assertThat(joints.handle(0)).isZero();
        assertThat(joints.idLimit()).isEqualTo(2);
        refused(() -> joints.handle(2), "the id is 2, but must be at least 0 and less than 2");
        refused(() -> joints.handle(-1), "the id is -1, but must be at least 0 and less than 2");
        String gone = "no joint has the handle " + first + ": it was removed or has broken, or is none of this world's";
        for (ThrowingCallable call : callsOf(first)) {
            refused(call, gone);
        }
        long third = joints.add(b, a, Joint.rope(9));
        assertThat(Joints.id(third)).isZero();
        assertThat(third).isNotEqualTo(first);
        refused(() -> joints.remove(first), gone);
        assertThat(joints.contains(third)).isTrue();
    }

    @Test
    void noCallTakesTheHandleOfACircleForThatOfAJoint() {
        for (int k = 0; k < 4; k++) {
            joints.add(a, Joint.motor(k, 1)); // the ids of joints are those of circles
        }
        for (long circle : new long[] {a, b, still, alsoStill}) {
            assertThat(joints.contains(circle)).isFalse();
            String message = "no joint has the handle " + circle + ": it is of a circle, or of nothing";
            for (ThrowingCallable call : callsOf(circle)) {
                refused(call, message);
            }
            long joint = joints.handle(World.id(circle));
            assertThat(world.contains(joint)).isFalse();
            refused(() -> world.remove(joint), "no circle has the handle " + joint + ": it is of a joint");
            refused(
                    () -> world.removeAll(new long[] {joint}, 1, StaleHandles.REFUSE),
                    "handle 0: no circle has the handle " + joint + ": it is of a joint");
        }
        long piece = world.terrain().addSegment(-50, -50, 50, -50);
        assertThat(joints.contains(piece)).isFalse();
        assertThat(world.terrain().contains(joints.handle(0))).isFalse();
    }

    @Test
    void jointsOfCirclesThatBecomeStaticDoNothingUntilOneMovesAgain() {
        Joint[] all = {
            Joint.distance(4),
            Joint.spring(5, 0.5f).withLength(4),
            Joint.spring(5, 0).withLimits(0, 4),
            Joint.rope(4),
            Joint.limits(6, 8),
            Joint.weld(),
            Joint.motor(3, 10),
            Joint.servo(1, 5, 1, INFINITE)
        };
        for (Joint joint : all) {
            joints.add(a, b, joint.breakingAt(1e6f, 1e6f));
        }
        joints.add(a, 1, 1, Joint.pin());
        joints.add(a, 1, 1, Joint.mouse(5, 1, INFINITE));
        joints.add(a, 9, 0, Joint.distance(3));
        joints.add(a, Joint.motor(3, INFINITE));
        joints.add(a, Joint.servo(1, 5, 1, INFINITE));
        joints.add(a, Joint.friction(INFINITE, INFINITE));
        int size = joints.size();
        world.setMass(a, INFINITE);
        world.setMass(b, INFINITE);
        for (int k = 0; k < 10; k++) {
            world.step(STEP);
        }
        assertThat(joints.size()).as("none breaks").isEqualTo(size);
        assertThat(new float[] {world.x(a), world.y(a), world.angle(a), world.x(b), world.y(b), world.angle(b)})
                .containsExactly(0, 0, 0, 3, 4, 0);
        for (int id = 0; id < size; id++) {
            long joint = joints.handle(id);
            assertThat(new float[] {
                        joints.forceX(joint), joints.forceY(joint), joints.force(joint), joints.torque(joint)
                    })
                    .as(joints.joint(joint).toString())
                    .containsOnly(0);
        }
        joints.clear();
        long rope = joints.add(still, a = world.add(20, 16, 0.5f, 2), Joint.distance());
        world.setMass(a, INFINITE);
        world.step(STEP);
        world.setMass(a, 2);
        for (int k = 0; k < 60; k++) {
            world.step(STEP);
        }
        assertThat(joints.force(rope)).as("it holds the weight again").isCloseTo(20, within(0.5f));
        assertThat(joints.length(rope)).isCloseTo(4, within(0.01f));
    }

    private List<ThrowingCallable> callsOf(long joint) {
        return List.of(
                () -> joints.remove(joint),
                () -> joints.circle(joint),
                () -> joints.other(joint),
                () -> joints.joint(joint),
                () -> joints.anchorX(joint),
                () -> joints.anchorY(joint),
                () -> joints.length(joint),
                () -> joints.force(joint),
                () -> joints.forceX(joint),
                () -> joints.forceY(joint),
                () -> joints.torque(joint),
                () -> joints.setAnchor(joint, 0, 0),
                () -> joints.setLength(joint, 1),
                () -> joints.setLimits(joint, 1, 2),
                () -> joints.setSpring(joint, 1, 1),
                () -> joints.setSpeed(joint, 1),
                () -> joints.setAngle(joint, 1),
                () -> joints.setMaxForce(joint, 1),
                () -> joints.setMaxTorque(joint, 1),
                () -> joints.setBreaking(joint, 1, 1),
                () -> joints.setColliding(joint, true));
    }

    @Test
    void manyJointsGoAtOnceOrNone() {
        long[] some = new long[5];
        for (int k = 0; k < some.length; k++) {
            some[k] = joints.add(a, b, Joint.rope(9 + k));
        }
        changesNothing(
                () -> joints.removeAll(new long[] {some[0], some[3], some[0]}),
                "handle 2: the joint with the handle " + some[0] + " occurs twice");
        changesNothing(
                () -> joints.removeAll(new long[] {some[0], 9}),
                "handle 1: no joint has the handle 9: it is of a circle, or of nothing");
        joints.removeAll(new long[] {some[4], some[0]});
        assertThat(joints.size()).isEqualTo(3);
        assertThat(joints.contains(some[1])).isTrue();
        assertThat(joints.contains(some[4])).isFalse();
        joints.clear();
        assertThat(joints.size()).isZero();
        joints.clear();
        joints.removeAll(new long[0]);
        world.step(STEP);
    }

    // ---- joints change

    @Test
    void whatIsSetIsInTheDefinition() {
        long spring = joints.add(a, b, Joint.spring(1, 1));
        joints.setLength(spring, 2);
        joints.setLimits(spring, 1, 6);
        joints.setSpring(spring, 8, 0.25f);
        joints.setBreaking(spring, 700, 800);
        joints.setColliding(spring, true);
        Joint now = joints.joint(spring);
        assertThat(now.length()).isEqualTo(2);
        assertThat(now.minLength()).isEqualTo(1);
        assertThat(now.maxLength()).isEqualTo(6);
        assertThat(now.hertz()).isEqualTo(8);
        assertThat(now.dampingRatio()).isEqualTo(0.25f);
        assertThat(now.breakForce()).isEqualTo(700);
        assertThat(now.breakTorque()).isEqualTo(800);
        assertThat(now.collides()).isTrue();
        long motor = joints.add(a, b, Joint.motor(1, 2));
        joints.setSpeed(motor, -4);
        joints.setMaxTorque(motor, INFINITE);
        assertThat(joints.joint(motor).speed()).isEqualTo(-4);
        assertThat(joints.joint(motor).maxTorque()).isInfinite();
        long servo = joints.add(a, Joint.servo(1, 1, 1, 1));
        joints.setAngle(servo, -2);
        joints.setSpring(servo, 9, 2);
        joints.setMaxTorque(servo, 6);
        assertThat(joints.joint(servo).angle()).isCloseTo(-2, within(1e-6f));
        assertThat(joints.joint(servo).hertz()).isEqualTo(9);
        assertThat(joints.joint(servo).maxTorque()).isEqualTo(6);
        long mouse = joints.add(a, 1, 2, Joint.mouse(5, 1, 100));
        joints.setMaxForce(mouse, 0);
        joints.setAnchor(mouse, 7, 8);
        assertThat(joints.joint(mouse).maxForce()).isZero();
        assertThat(joints.anchorX(mouse)).isEqualTo(7);
        assertThat(joints.anchorY(mouse)).isEqualTo(8);
        assertThat(joints.length(mouse)).isCloseTo((float) Math.hypot(7, 8), within(1e-5f));
        assertThat(joints.joint(spring).hertz()).isEqualTo(8); // springs of others are others
    }

    @Test
    void whatAJointDoesNotHaveCannotBeSet() {
        long distance = joints.add(a, b, Joint.distance());
        long motor = joints.add(a, Joint.motor(1, 1));
        long pin = joints.add(a, 0, 0, Joint.pin());
        changesNothing(
                () -> joints.setAnchor(distance, 1, 1),
                "the distance joint with the handle " + distance + " holds two circles, and has no anchor");
        changesNothing(() -> joints.setAnchor(motor, 1, 1), "a motor has no anchor");
        changesNothing(() -> joints.setAnchor(pin, INFINITE, 1), "x is Infinity, but must be from -1.0E9 to 1.0E9");
        changesNothing(
                () -> joints.anchorX(distance),
                "the distance joint with the handle " + distance + " holds two circles, and has no anchor");
        changesNothing(() -> joints.anchorY(motor), "a motor has no anchor");
        changesNothing(() -> joints.setLength(pin, 1), "a pin has no length to set");
        changesNothing(() -> joints.setLimits(distance, 1, 2), "a distance joint has no limits");
        changesNothing(() -> joints.setSpring(pin, 1, 1), "a pin has no spring");
        changesNothing(() -> joints.setSpring(distance, 1, 1), "a distance joint has no spring");
        changesNothing(() -> joints.setSpeed(pin, 1), "a pin has no speed");
        changesNothing(() -> joints.setAngle(motor, 1), "a motor has no angle");
        changesNothing(() -> joints.setMaxForce(motor, 1), "a motor has no greatest force");
        changesNothing(() -> joints.setMaxTorque(pin, 1), "a pin has no greatest torque");
        changesNothing(() -> joints.setLength(distance, Float.NaN), "the length is NaN, but must be from 0.0 to 1.0E9");
        changesNothing(() -> joints.setSpeed(motor, -2e9f), "the speed is -2.0E9, but must be from -1.0E9 to 1.0E9");
        changesNothing(
                () -> joints.setBreaking(pin, Float.NaN, 1),
                "the force that breaks it is NaN, but must be from 0.0 to Infinity");
    }

    @Test
    void whatIsSetActsFromTheNextStepOn() {
        long rope = joints.add(a, 0, 10, Joint.distance());
        world.step(STEP, 60);
        assertThat(world.y(a)).isCloseTo(0, within(0.01f));
        joints.setLength(rope, 6);
        world.step(STEP, 300);
        assertThat(world.y(a)).isCloseTo(4, within(0.02f));
        joints.setAnchor(rope, 0, 0);
        world.step(STEP, 2000);
        assertThat(distance(a, a) + Math.hypot(world.x(a), world.y(a))).isCloseTo(6, within(0.02));
        long wheel = joints.add(b, Joint.motor(5, 1000));
        world.step(STEP, 60);
        assertThat(world.angularVelocity(b)).isCloseTo(5, within(1e-3f));
        joints.setSpeed(wheel, -3);
        world.step(STEP, 60);
        assertThat(world.angularVelocity(b)).isCloseTo(-3, within(1e-3f));
    }

    @Test
    void circlesThatAJointHoldsDoNotCollideUnlessItLetsThem() {
        World top = builder().gravity(0, 0).build();
        try (top) {
            long one = top.add(0, 0, 1, 1);
            long other = top.add(1, 0, 1, 1);
            long joint = top.joints().add(one, other, Joint.rope(50));
            top.step(STEP, 60);
            assertThat(top.x(other) - top.x(one)).isEqualTo(1);
            top.joints().setColliding(joint, true);
            top.step(STEP, 60);
            assertThat(top.x(other) - top.x(one)).isGreaterThan(1.5f);
            top.teleport(other, top.x(one) + 1, 0);
            top.setVelocity(one, 0, 0);
            top.setVelocity(other, 0, 0);
            top.joints().setColliding(joint, false);
            float gap = top.x(other) - top.x(one);
            top.step(STEP, 60);
            assertThat(top.x(other) - top.x(one)).isCloseTo(gap, within(1e-5f));
            top.joints().remove(joint);
            top.step(STEP, 60);
            assertThat(top.x(other) - top.x(one)).isGreaterThan(1.5f);
        }
    }

    // ---- where they are, and what they do

    /** Pressed against a floor for ever, it swings about the place under its anchor; it must neither stand still nor get faster and faster. */
    @Test
    void aRopeThatTerrainKeepsTooLongLeavesItsBallSlow() {
        world.terrain().addSegment(-50, 10, 50, 10);
        long ball = world.add(0.5f, 9, 1, 1);
        long rope = joints.add(ball, 0, 20, Joint.rope(9));
        world.step(STEP, 60);
        float furthest = 0;
        for (int k = 0; k < 1140; k++) {
            world.step(STEP);
            furthest = Math.max(furthest, Math.abs(world.x(ball)));
            assertThat(Math.hypot(world.vx(ball), world.vy(ball)))
                    .as("step %d", k)
                    .isLessThan(100);
            assertThat(world.y(ball)).isCloseTo(9, within(0.01f));
        }
        assertThat(furthest).isBetween(0.01f, 0.5f);
        assertThat(joints.length(rope)).isCloseTo(11, within(0.05f));
    }

    /** By at most a fifth of a radius in each of four sub-steps. */
    @Test
    void aRopeThatIsMuchTooShortDoesNotThrowItsBall() {
        long ball = world.add(30, 0, 0.5f, 1);
        long rope = joints.add(ball, 0, 0, Joint.rope(9));
        float before = joints.length(rope);
        for (int k = 0; k < 240; k++) {
            world.step(STEP);
            assertThat(before - joints.length(rope)).as("step %d", k).isLessThan(0.41f);
            before = joints.length(rope);
        }
        assertThat(before).isCloseTo(9, within(0.05f));
    }

    @Test
    void anAnchorOnABodyMovesWithIt() {
        TerrainBody arm = world.terrain().addBody(0, 0, 0);
        long ball = world.add(3, 0, 0.4f, 1);
        long pin = joints.add(ball, arm, 3, 0, Joint.pin());
        arm.setAngularVelocity(1);
        for (int k = 1; k <= 60; k++) {
            world.step(STEP);
            assertThat(joints.anchorX(pin)).isCloseTo(3 * (float) Math.cos(k * STEP), within(1e-5f));
            assertThat(joints.anchorY(pin)).isCloseTo(3 * (float) Math.sin(k * STEP), within(1e-5f));
            assertThat(joints.length(pin)).isLessThan(0.02f);
        }
        arm.setAngularVelocity(0);
        world.step(STEP, 60);
        assertThat(joints.length(pin)).isLessThan(1e-3f);
        arm.teleport(50, 0, 0);
        assertThat(joints.anchorX(pin)).isEqualTo(53);
        world.step(STEP, 240); // joints correct by a fifth of a radius a sub-step
        assertThat(world.x(ball)).isCloseTo(53, within(0.01f));
        joints.setAnchor(pin, 0, 2);
        assertThat(joints.anchorX(pin)).isEqualTo(50);
        world.step(STEP, 120);
        assertThat(world.x(ball)).isCloseTo(50, within(0.01f));
        assertThat(world.y(ball)).isCloseTo(2, within(0.01f));
        arm.moveTo(52, 0, 0);
        world.step(STEP, 120);
        assertThat(world.x(ball)).isCloseTo(52, within(0.01f));
    }

    @Test
    void theGroundIsTheWorld() {
        long pin = joints.add(a, world.terrain().ground(), 1, 2, Joint.pin());
        assertThat(joints.anchorX(pin)).isEqualTo(1);
        world.terrain().clear();
        assertThat(joints.contains(pin)).isTrue();
        joints.setAnchor(pin, 3, 4);
        assertThat(joints.anchorY(pin)).isEqualTo(4);
    }

    @Test
    void forcesAreThoseOfTheLastStepOnTheFirstCircle() {
        long rope = joints.add(a, 0, 10, Joint.rope(10));
        long same = joints.add(b, still, Joint.distance());
        assertThat(joints.force(rope)).isZero();
        world.step(STEP, 200);
        assertThat(joints.forceY(rope)).isCloseTo(20, within(0.1f));
        assertThat(joints.forceX(rope)).isCloseTo(0, within(0.1f));
        assertThat(joints.force(rope)).isCloseTo(20, within(0.1f));
        assertThat(joints.torque(rope)).isZero();
        float sum = (float) Math.hypot(joints.forceX(same), joints.forceY(same));
        assertThat(Math.abs(joints.force(same))).isCloseTo(sum, within(0.05f * sum));
        world.setPosition(a, 0, 5);
        world.setVelocity(a, 0, 0);
        world.step(STEP);
        assertThat(joints.force(rope)).isZero();
        long prop = joints.add(a, 0, -5, Joint.limits(5, INFINITE));
        world.setPosition(a, 0, 0);
        world.setVelocity(a, 0, 0);
        joints.setLimits(rope, 0, 50);
        world.step(STEP, 100);
        assertThat(joints.force(prop)).isCloseTo(-20, within(0.1f));
        long motor = joints.add(a, Joint.motor(100, 0.125f));
        world.step(STEP);
        assertThat(joints.torque(motor)).isCloseTo(0.125f, within(1e-3f));
        assertThat(joints.force(motor)).isZero();
        assertThat(joints.length(motor)).isZero();
    }

    @Test
    void aCircleHasItsJoints() {
        long[] found = new long[4];
        assertThat(joints.ofCircle(a, found)).isZero();
        long first = joints.add(a, b, Joint.rope(9));
        long second = joints.add(b, a, Joint.rope(9));
        long third = joints.add(a, Joint.motor(1, 1));
        assertThat(joints.ofCircle(a, found)).isEqualTo(3);
        assertThat(found).containsExactly(first, second, third, 0);
        joints.remove(first);
        long again = joints.add(b, 0, 0, Joint.pin());
        assertThat(joints.ofCircle(b, found)).isEqualTo(2);
        assertThat(found).containsExactly(again, second, third, 0);
        assertThat(joints.ofCircle(a, new long[0])).isEqualTo(2);
    }

    @Test
    void endsAreReadInTheOrderOfIds() {
        joints.add(a, b, Joint.rope(9));
        joints.add(b, Joint.motor(1, 1));
        joints.add(a, -1, -2, Joint.pin(1, 1));
        float[] ends = new float[13];
        ends[12] = 7;
        assertThat(joints.readEnds(ends)).isEqualTo(3);
        assertThat(ends).containsExactly(0, 0, 3, 4, 3, 4, 3, 4, 0, 0, -1, -2, 7);
        refused(() -> joints.readEnds(new float[11]), "ends has room for 11 elements, but needs 12");
        joints.clear();
        assertThat(joints.readEnds(new float[0])).isZero();
    }

    @Test
    void theNearestLineIsPicked() {
        assertThat(joints.pick(0, 0, INFINITE)).isZero();
        long line = joints.add(a, b, Joint.rope(9));
        long same = joints.add(b, a, Joint.rope(9));
        long far = joints.add(a, -50, 0, Joint.rope(90));
        assertThat(joints.pick(1.5f, 2, 0)).isEqualTo(line);
        assertThat(joints.pick(1.5f, 2.5f, 0.2f)).isZero();
        assertThat(joints.pick(1.5f, 2.5f, 0.4f)).isEqualTo(line);
        assertThat(joints.pick(-30, 1, 2)).isEqualTo(far);
        assertThat(joints.pick(-53, 4, 4.9f)).isZero();
        assertThat(joints.pick(-53, 4, 5)).isEqualTo(far);
        joints.remove(line);
        assertThat(joints.pick(1.5f, 2, 0)).isEqualTo(same);
        refused(() -> joints.pick(Float.NaN, 0, 1), "x is NaN, but must be from -1.0E9 to 1.0E9");
        refused(() -> joints.pick(0, 2e9f, 1), "y is 2.0E9, but must be from -1.0E9 to 1.0E9");
        refused(() -> joints.pick(0, 0, -1), "the greatest distance is -1.0, but must be from 0.0 to Infinity");
    }

    @Test
    void jointsGoAcrossASeam() {
        World ring = builder().gravity(0, 0).edges(Edge.WRAP, Edge.WALL).build();
        try (ring) {
            long left = ring.add(-99, 0, 0.5f, 1);
            long right = ring.add(98, 0, 0.5f, 1);
            long joint = ring.joints().add(left, right, Joint.distance());
            assertThat(ring.joints().length(joint)).isEqualTo(3);
            float[] ends = new float[4];
            ring.joints().readEnds(ends);
            assertThat(ends).containsExactly(-99, 0, -102, 0);
            assertThat(ring.joints().pick(99, 0, 1e-6f)).isEqualTo(joint);
            assertThat(ring.joints().pick(-99.5f, 0, 1e-6f)).isEqualTo(joint);
            assertThat(ring.joints().pick(99 + 200, 0, 1e-6f)).isEqualTo(joint);
            assertThat(ring.joints().pick(0, 0, 90)).isZero();
            long pin = ring.joints().add(left, 101, 0, Joint.pin());
            assertThat(ring.joints().anchorX(pin)).isEqualTo(-99);
            ring.joints().setAnchor(pin, -301, 1);
            assertThat(ring.joints().anchorX(pin)).isEqualTo(99);
            ring.joints().remove(pin);
            ring.setVelocity(left, 1, 0);
            ring.step(STEP, 300);
            assertThat(ring.joints().length(joint)).isCloseTo(3, within(0.01f));
        }
    }

    // ---- rules of all calls

    private List<Consumer<Joints>> allCalls(long joint, TerrainBody body) {
        return List.of(
                all -> all.add(a, b, Joint.rope(9)),
                all -> all.add(a, 0, 0, Joint.pin()),
                all -> all.add(a, body, 0, 0, Joint.pin()),
                all -> all.add(a, Joint.motor(1, 1)),
                all -> all.addAll(new long[] {a}, new long[] {b}, Joint.rope(9), null),
                all -> all.removeAll(new long[] {joint}),
                Joints::clear,
                all -> all.contains(joint),
                Joints::size,
                Joints::idLimit,
                all -> all.handle(0),
                all -> all.ofCircle(a, new long[1]),
                all -> all.pick(0, 0, 1),
                all -> all.readEnds(new float[4]),
                all -> all.report(true),
                Joints::events);
    }

    @Test
    void aClosedWorldRefusesAllCalls() {
        long joint = joints.add(a, b, Joint.spring(1, 1));
        TerrainBody body = world.terrain().addBody(0, 0, 0);
        world.close();
        for (Consumer<Joints> call : allCalls(joint, body)) {
            assertThatThrownBy(() -> call.accept(joints))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("this World has been closed");
        }
        for (ThrowingCallable call : callsOf(joint)) {
            assertThatThrownBy(call).isInstanceOf(IllegalStateException.class).hasMessage("this World has been closed");
        }
        assertThatThrownBy(world::joints).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void oneThreadAtATimeCalls() throws InterruptedException {
        long joint = joints.add(a, b, Joint.spring(1, 1));
        TerrainBody body = world.terrain().addBody(0, 0, 0);
        for (int k = 0; k < 3000; k++) {
            world.add(-90 + k % 60 * 3, -90 + k / 60 * 2, 0.9f, 1);
        }
        Thread stepping = new Thread(this::stepAsSoonAsNobodyIsInside);
        stepping.start();
        while (!somebodyIsInside()) {
            Thread.onSpinWait();
        }
        for (Consumer<Joints> call : allCalls(joint, body)) {
            assertThatThrownBy(() -> call.accept(joints)).isInstanceOf(ConcurrentModificationException.class);
        }
        for (ThrowingCallable call : callsOf(joint)) {
            assertThatThrownBy(call).isInstanceOf(ConcurrentModificationException.class);
        }
        stepping.join();
        assertThat(joints.contains(joint)).isTrue();
    }

    private void stepAsSoonAsNobodyIsInside() {
        for (; ; ) {
            try {
                world.step(STEP, 200);
                return;
            } catch (ConcurrentModificationException e) {
                Thread.onSpinWait();
            }
        }
    }

    private boolean somebodyIsInside() {
        try {
            world.size();
            return false;
        } catch (ConcurrentModificationException e) {
            return true;
        }
    }

    @Test
    void aWorldWithoutJointsHasNoMemoryForThem() {
        try (World never = builder().build()) {
            long before;
            never.add(0, 0, 1, 1);
            never.add(4, 0, 1, 1);
            never.step(STEP, 2);
            before = never.stats().bytesHeld();
            never.joints().size();
            never.joints().report(true);
            never.joints().events();
            never.step(STEP, 2);
            assertThat(never.stats().bytesHeld()).isEqualTo(before);
            never.joints().add(never.handle(0), never.handle(1), Joint.spring(1, 1));
            never.step(STEP, 2);
            assertThat(never.stats().bytesHeld()).isGreaterThan(before);
        }
    }

    @Test
    void jointsGrowInNumberAndGoAgain() {
        long[] chain = new long[4000];
        for (int k = 0; k < chain.length; k++) {
            chain[k] = world.add(-90 + k % 100 * 1.8f, -90 + k / 100, 0.3f, 1);
        }
        for (int round = 0; round < 3; round++) {
            for (int k = 1; k < chain.length; k++) {
                if (k % 100 != 0) {
                    joints.add(chain[k - 1], chain[k], Joint.spring(2 + k % 7, 0.5f));
                }
                if (k % 1000 == 0) {
                    world.step(STEP);
                }
            }
            assertThat(joints.size()).isEqualTo(3960);
            assertThat(joints.idLimit()).isEqualTo(3960);
            for (int id = 0; id < joints.idLimit(); id += 2) {
                joints.remove(joints.handle(id));
            }
            world.step(STEP);
            assertThat(joints.size()).isEqualTo(1980);
            joints.clear();
            world.step(STEP);
        }
    }
}
