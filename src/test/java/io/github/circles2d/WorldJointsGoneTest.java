package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Joints go with what they hold, and when they break; events tell of it. */
class WorldJointsGoneTest {
    private static final float STEP = 1 / 60f;
    private static final float INFINITE = Float.POSITIVE_INFINITY;

    private final World world = builder().build();
    private final Joints joints = world.joints();

    private static World.Builder builder() {
        return WorldScenes.jvm().bounds(-100, -100, 100, 100).gravity(0, -10).threads(1);
    }

    @AfterEach
    void close() {
        world.close();
    }

    private static String text(JointEvents events, int k) {
        return events.joint(k) + " of " + events.circle(k) + " and " + events.other(k) + ": " + events.reason(k);
    }

    private static String text(long joint, long circle, long other, JointEvents.Reason reason) {
        return joint + " of " + circle + " and " + other + ": " + reason;
    }

    private List<String> events() {
        List<String> texts = new ArrayList<>();
        JointEvents events = joints.events();
        for (int k = 0; k < events.size(); k++) {
            texts.add(text(events, k));
        }
        return texts;
    }

    // ---- with what they hold

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void jointsGoWithTheirCircles(boolean many) {
        joints.report(true);
        long hub = world.add(0, 0, 0.5f, 9);
        long[] rim = new long[40];
        long[] spokes = new long[40];
        for (int k = 0; k < rim.length; k++) {
            rim[k] = world.add(-40 + 2 * k, 5, 0.5f, 1);
            spokes[k] = k % 2 == 0
                    ? joints.add(rim[k], hub, Joint.distance())
                    : joints.add(hub, rim[k], Joint.spring(1, 1));
        }
        long tie = joints.add(rim[0], rim[1], Joint.rope(9));
        long pin = joints.add(hub, 0, 0, Joint.pin());
        world.step(STEP, 3);
        if (many) {
            world.removeAll(new long[] {rim[3], hub}, 2, StaleHandles.REFUSE);
        } else {
            world.remove(rim[3]);
            world.remove(hub);
        }
        assertThat(joints.size()).isOne();
        assertThat(joints.contains(tie)).isTrue();
        List<String> expected = new ArrayList<>();
        expected.add(text(spokes[3], hub, rim[3], JointEvents.Reason.CIRCLE_REMOVED));
        for (int k = 0; k < rim.length; k++) {
            if (k != 3) {
                expected.add(text(
                        spokes[k],
                        k % 2 == 0 ? rim[k] : hub,
                        k % 2 == 0 ? hub : rim[k],
                        JointEvents.Reason.CIRCLE_REMOVED));
            }
        }
        expected.add(text(pin, hub, 0, JointEvents.Reason.CIRCLE_REMOVED));
        assertThat(events()).isEqualTo(expected);
        assertThat(events()).isEmpty();
        assertThat(world.contains(rim[0])).isTrue();
        long next = world.add(50, 50, 0.5f, 1); // has an id that a held one had
        assertThat(joints.ofCircle(next, new long[1])).isZero();
        world.step(STEP, 3);
        assertThat(world.y(next)).isLessThan(50);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void jointsGoIfAWorldIsCleared(boolean contacts) {
        if (contacts) {
            world.report(Events.BEGIN);
        }
        joints.report(true);
        long a = world.add(0, 0, 0.5f, 1);
        long b = world.add(3, 0, 0.5f, 1);
        long second = joints.add(b, Joint.motor(1, 1));
        long first = joints.add(b, a, Joint.weld());
        world.step(STEP);
        world.clear();
        assertThat(joints.size()).isZero();
        assertThat(events())
                .containsExactly(
                        text(first, b, a, JointEvents.Reason.CIRCLE_REMOVED),
                        text(second, b, 0, JointEvents.Reason.CIRCLE_REMOVED));
        a = world.add(0, 0, 0.5f, 1);
        world.step(STEP);
        assertThat(joints.contains(first)).isFalse();
        joints.add(a, 0, 0, Joint.pin());
        world.step(STEP, 30);
        assertThat(world.y(a)).isCloseTo(0, within(0.01f));
    }

    @Test
    void jointsGoWithBodiesOfTerrain() {
        joints.report(true);
        long a = world.add(0, 0, 0.5f, 1);
        TerrainBody first = world.terrain().addBody(0, 1, 0);
        TerrainBody second = world.terrain().addBody(0, 2, 0);
        long onFirst = joints.add(a, first, 0, 0, Joint.rope(5));
        long onSecond = joints.add(a, second, 0, 0, Joint.rope(5));
        long alsoOnFirst = joints.add(a, first, 1, 1, Joint.spring(1, 1));
        long inWorld = joints.add(a, 0, 0, Joint.pin(1, 1));
        world.step(STEP);
        first.remove();
        assertThat(events())
                .containsExactly(
                        text(onFirst, a, 0, JointEvents.Reason.BODY_REMOVED),
                        text(alsoOnFirst, a, 0, JointEvents.Reason.BODY_REMOVED));
        TerrainBody third = world.terrain().addBody(0, 3, 0); // has the id of the first one
        world.step(STEP);
        third.remove();
        assertThat(events()).isEmpty();
        assertThat(joints.contains(onSecond)).isTrue();
        world.terrain().clear();
        assertThat(events()).containsExactly(text(onSecond, a, 0, JointEvents.Reason.BODY_REMOVED));
        assertThat(joints.contains(inWorld)).isTrue();
        world.step(STEP);
    }

    @Test
    void aRestoredWorldHasItsOwnJointsAndNoEvents() {
        long a = world.add(0, 0, 0.5f, 1);
        long b = world.add(3, 0, 0.5f, 1);
        ByteBuffer without = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(without);
        joints.report(true);
        long joint = joints.add(a, b, Joint.distance());
        ByteBuffer with = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(with);
        world.remove(b);
        world.restore(with.flip());
        assertThat(joints.contains(joint)).isTrue();
        assertThat(events()).isEmpty();
        world.restore(without.flip());
        assertThat(joints.size()).isZero();
        assertThat(events()).isEmpty();
        world.step(STEP);
        world.remove(a);
        assertThat(events()).isEmpty();
    }

    @Test
    void callsThatRemoveJointsAreNoEventsAndNobodyIsToldUnasked() {
        long a = world.add(0, 0, 0.5f, 1);
        long b = world.add(3, 0, 0.5f, 1);
        joints.add(a, b, Joint.distance());
        world.remove(b);
        joints.report(true);
        assertThat(events()).isEmpty();
        joints.remove(joints.add(a, Joint.motor(1, 1)));
        joints.removeAll(new long[] {joints.add(a, Joint.motor(1, 1))});
        joints.add(a, Joint.motor(1, 1));
        joints.clear();
        assertThat(events()).isEmpty();
        joints.add(a, Joint.motor(1, 1));
        world.remove(a);
        joints.report(false);
        joints.report(true);
        assertThat(events()).isEmpty();
        assertThatThrownBy(() -> joints.events().joint(0))
                .isInstanceOf(IndexOutOfBoundsException.class)
                .hasMessage("there is no event 0 of 0");
    }

    // ---- they break

    @Test
    void aJointBreaksByMoreForceThanItBears() {
        joints.report(true);
        long a = world.add(0, 0, 0.5f, 2);
        long rope = joints.add(a, 0, 10, Joint.rope(10).breakingAt(100, INFINITE));
        world.step(STEP, 100);
        assertThat(joints.contains(rope)).isTrue();
        assertThat(joints.force(rope)).isCloseTo(20, within(0.1f));
        world.setForce(a, 0, -75);
        world.step(STEP, 100);
        assertThat(joints.contains(rope)).isTrue();
        assertThat(joints.force(rope)).isCloseTo(95, within(0.1f));
        world.setForce(a, 0, -85);
        world.step(STEP, 100);
        assertThat(joints.contains(rope)).isFalse();
        assertThat(joints.size()).isZero();
        assertThat(world.y(a)).isLessThan(-10);
        JointEvents events = joints.events();
        assertThat(events.size()).isOne();
        assertThat(text(events, 0)).isEqualTo(text(rope, a, 0, JointEvents.Reason.BROKEN));
        assertThat(events.force(0)).isBetween(100f, 106f);
        assertThat(events.torque(0)).isZero();
    }

    @Test
    void aJointBreaksByMoreTorqueThanItBears() {
        joints.report(true);
        long a = world.add(0, 0, 0.5f, 2);
        joints.add(a, 0, 0, Joint.pin());
        long motor = joints.add(a, Joint.motor(1000, 5).breakingAt(INFINITE, 6));
        world.step(STEP, 2);
        assertThat(joints.torque(motor)).isCloseTo(5, within(0.01f));
        joints.setMaxTorque(motor, 7);
        world.step(STEP);
        assertThat(joints.contains(motor)).isFalse();
        JointEvents events = joints.events();
        assertThat(text(events, 0)).isEqualTo(text(motor, a, 0, JointEvents.Reason.BROKEN));
        assertThat(events.torque(0)).isCloseTo(7, within(0.01f));
        float spin = world.angularVelocity(a);
        world.step(STEP, 10);
        assertThat(world.angularVelocity(a)).isEqualTo(spin);
    }

    @Test
    void aJointThatMayBreakNoMoreDoesNot() {
        long a = world.add(0, 0, 0.5f, 2);
        long rope = joints.add(a, 0, 10, Joint.rope(10).breakingAt(10, INFINITE));
        joints.setBreaking(rope, INFINITE, INFINITE);
        world.step(STEP, 30);
        assertThat(joints.contains(rope)).isTrue();
        joints.setBreaking(rope, 10, INFINITE);
        world.step(STEP, 30);
        assertThat(joints.contains(rope)).isFalse();
    }

    @Test
    void circlesOfABrokenJointCollide() {
        World top = builder().gravity(0, 0).build();
        try (top) {
            long one = top.add(0, 0, 1, 1);
            long other = top.add(1, 0, 1, 1);
            top.joints().add(one, other, Joint.distance().breakingAt(5, INFINITE));
            top.step(STEP, 60);
            assertThat(top.x(other) - top.x(one)).isEqualTo(1);
            top.applyForce(one, -10, 0);
            top.applyForce(other, 10, 0);
            top.step(STEP);
            assertThat(top.joints().size()).isZero();
            assertThat(top.x(other) - top.x(one)).isLessThan(1.1f);
            top.step(STEP, 60);
            assertThat(top.x(other) - top.x(one)).isGreaterThan(1.5f);
        }
    }

    @Test
    void theForceIsThatOfTheStepInWhichAJointBrokeWhateverItsLength() {
        joints.report(true);
        long a = world.add(0, 0, 0.5f, 2);
        joints.add(a, Joint.friction(50, 50).breakingAt(40, INFINITE));
        world.setForce(a, 45, 20);
        world.step(STEP);
        world.step(STEP / 7);
        JointEvents events = joints.events();
        assertThat(events.size()).isOne();
        assertThat(events.force(0)).isCloseTo(45, within(0.5f));
    }

    /** A grid of joints that break, in a crowd; some come and go by calls meanwhile. */
    private static String play(boolean looks, int threads) {
        StringBuilder said = new StringBuilder();
        World.Builder builder = builder();
        try (World world = threads == 0 ? builder.build() : WorldScenes.onThreads(threads, builder)) {
            Joints joints = world.joints();
            joints.report(true);
            Random random = new Random(5);
            long[] grid = new long[400];
            for (int k = 0; k < grid.length; k++) {
                grid[k] = world.add(-20 + k % 20 * 1.5f, k / 20 * 1.5f, 0.5f, 1);
                Joint joint = Joint.distance().breakingAt(120 + random.nextInt(200), INFINITE);
                if (k % 20 > 0) {
                    joints.add(grid[k - 1], grid[k], joint);
                }
                if (k >= 20) {
                    joints.add(grid[k], grid[k - 20], joint);
                }
            }
            joints.add(grid[399], 50, 50, Joint.rope(60).breakingAt(2000, INFINITE));
            for (int step = 0; step < 150; step++) {
                world.step(STEP);
                if (looks) {
                    joints.size();
                    say(joints, said);
                }
                if (step % 20 == 7) {
                    world.remove(grid[step]);
                    joints.add(
                            grid[step + 1], grid[step + 5], Joint.spring(3, 1).breakingAt(50, 50));
                }
                if (step % 20 == 13) {
                    long hit = world.add(-50, 10 + step / 10, 1, 20);
                    world.setVelocity(hit, 60, 0);
                }
            }
            say(joints, said);
            said.append(joints.size()).append(' ').append(joints.idLimit()).append(' ');
            said.append(world.hash());
        }
        return said.toString();
    }

    private static void say(Joints joints, StringBuilder said) {
        JointEvents events = joints.events();
        for (int k = 0; k < events.size(); k++) {
            said.append(text(events, k)).append(' ').append(events.force(k)).append('\n');
        }
    }

    @Test
    void nothingDependsOnWhenACallerLooksNorOnThreads() {
        String quiet = play(false, 0);
        assertThat(quiet).contains("BROKEN").contains("CIRCLE_REMOVED");
        assertThat(quiet.split("\n")).hasSizeGreaterThan(50);
        assertThat(play(true, 0)).isEqualTo(quiet);
        assertThat(play(false, 3)).isEqualTo(quiet);
    }
}
