package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.opencl.TestDevices;
import java.nio.ByteBuffer;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Calls on bodies that are pushed do what they say; what they have is state. */
class WorldBodiesTest {
    private static final Outline CRATE = Outline.box(1, 0.5f);

    private static World world() {
        return WorldScenes.jvm().bounds(0, 0, 20, 10).gravity(0, 0).threads(1).build();
    }

    /** Of numbers that are not finite a compiled method makes others than one that is interpreted. */
    @Test
    void tinyElasticBodiesAtTheGreatestSpeedHaveTheSameBitsInEveryRun() {
        long first = wildHash();
        for (int run = 0; run < 40; run++) {
            assertThat(wildHash()).isEqualTo(first);
        }
    }

    private static long wildHash() {
        try (World world = WorldScenes.jvm()
                .bounds(-1, -1, 1, 1)
                .restitution(1)
                .friction(1)
                .build()) {
            Random random = new Random(4);
            Outline box = Outline.box(4e-4f, 2e-4f);
            for (int k = 0; k < 30; k++) {
                float x = 2e-3f * random.nextFloat();
                float y = 2e-3f * random.nextFloat();
                long body = world.bodies().add(box, x, y, 6 * random.nextFloat(), 1e-9f + random.nextFloat());
                world.bodies()
                        .setVelocity(body, 1e9f * (random.nextFloat() - 0.5f), 1e9f * (random.nextFloat() - 0.5f));
                world.bodies().setAngularVelocity(body, 1e9f * random.nextFloat());
            }
            long hash = 0;
            for (int step = 0; step < 20; step++) {
                world.step(1 / 60f);
                hash = 31 * hash + world.hash();
            }
            return hash;
        }
    }

    @Test
    void aBodyIsWhatItWasAddedAs() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            world.kind(3).setRestitution(0.75f);
            long body = bodies.add(CRATE, 4, 5, 0.5f, 2, 3);
            assertThat(bodies.size()).isOne();
            assertThat(bodies.contains(body)).isTrue();
            assertThat(bodies.handle(Bodies.id(body))).isEqualTo(body);
            assertThat(bodies.x(body)).isEqualTo(4);
            assertThat(bodies.y(body)).isEqualTo(5);
            assertThat(bodies.angle(body)).isEqualTo(0.5f);
            assertThat(bodies.mass(body)).isEqualTo(2);
            assertThat(bodies.inertia(body)).isEqualTo(CRATE.inertia(2));
            assertThat(bodies.kindOf(body)).isEqualTo(3);
            assertThat(bodies.restitution(body)).isEqualTo(0.75f);
            assertThat(bodies.outline(body).points(0.01f)).isEqualTo(CRATE.points(0.01f));
            assertThat(bodies.vx(body)).isZero();
            assertThat(bodies.angularVelocity(body)).isZero();
        }
    }

    @Test
    void anImpulseAtAPointTurnsABodyToo() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            long body = bodies.add(CRATE, 4, 5, 0, 2);
            bodies.setInertia(body, 0.5f);
            bodies.applyImpulse(body, 3, 0, 4, 5.25f);
            assertThat(bodies.vx(body)).isEqualTo(1.5f);
            assertThat(bodies.vy(body)).isZero();
            assertThat(bodies.angularVelocity(body)).isEqualTo(-1.5f);
            bodies.applyImpulse(body, -3, 1);
            assertThat(bodies.vx(body)).isZero();
            assertThat(bodies.angularVelocity(body)).isEqualTo(-1.5f);
            bodies.applyAngularImpulse(body, 0.75f);
            assertThat(bodies.angularVelocity(body)).isZero();
        }
    }

    @Test
    void aForceThatIsSetActsUntilItIsChanged() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            long body = bodies.add(CRATE, 4, 5, 0, 2);
            long other = bodies.add(CRATE, 4, 8, 0, 2);
            bodies.setInertia(body, 0.5f);
            bodies.setForce(body, 4, -2);
            bodies.setTorque(body, 0.25f);
            assertThat(bodies.forceX(body)).isEqualTo(4);
            assertThat(bodies.forceY(body)).isEqualTo(-2);
            assertThat(bodies.torque(body)).isEqualTo(0.25f);
            assertThat(bodies.forceX(other)).isZero();
            world.step(0.25f, 2);
            assertThat(bodies.vx(body)).isEqualTo(1);
            assertThat(bodies.vy(body)).isEqualTo(-0.5f);
            assertThat(bodies.angularVelocity(body)).isEqualTo(0.25f);
            assertThat(bodies.vx(other)).isZero();
            bodies.setForce(body, 0, 0);
            bodies.setTorque(body, 0);
            world.step(0.25f, 2);
            assertThat(bodies.vx(body)).isEqualTo(1);
            assertThat(bodies.angularVelocity(body)).isEqualTo(0.25f);
            bodies.setForce(body, 4, 0);
            bodies.remove(body);
            assertThat(bodies.forceX(bodies.add(CRATE, 4, 5, 0, 2))).isZero();
        }
    }

    @Test
    void whatIsAppliedActsInOneStepBesidesWhatIsSet() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            long body = bodies.add(CRATE, 4, 5, 0, 2);
            bodies.setInertia(body, 0.5f);
            bodies.setForce(body, 2, 0);
            bodies.applyForce(body, 3, 0, 4, 5.25f);
            bodies.applyForce(body, 3, 0, 4, 4.75f);
            bodies.applyForce(body, 0, 2, 4.5f, 5);
            bodies.applyTorque(body, -0.5f);
            world.step(0.25f, 2);
            assertThat(bodies.vx(body)).isEqualTo(0.25f * (4 + 1));
            assertThat(bodies.vy(body)).isEqualTo(0.25f);
            assertThat(bodies.angularVelocity(body)).isEqualTo(0.25f * (1 - 0.5f) / 0.5f);
            long before = world.hash();
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.setForce(body, Float.NaN, 0));
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.setTorque(body, 2e18f));
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.applyForce(body, 1, 1, Float.NaN, 0));
            assertThat(world.hash()).isEqualTo(before);
        }
    }

    /** Whether what is dropped onto a body that lies on the floor falls through it. */
    private static boolean fallsThrough(boolean circle, int group, int otherGroup) {
        try (World world = world()) {
            world.setGravity(0, -10);
            Bodies bodies = world.bodies();
            long below = bodies.add(Outline.box(4, 1), 10, 0.5f, 0, 4);
            bodies.setGroup(below, group);
            long ball = circle ? world.add(10, 2, 0.5f, 1) : 0;
            long crate = circle ? 0 : bodies.add(CRATE, 10, 2, 0, 1);
            if (circle) {
                world.setGroup(ball, otherGroup);
            } else {
                bodies.setGroup(crate, otherGroup);
                assertThat(bodies.group(crate)).isEqualTo(otherGroup);
            }
            world.step(1 / 60f, 90);
            float fallen = circle ? world.y(ball) - 0.5f : bodies.y(crate) - 0.25f;
            assertThat(fallen).isBetween(-0.02f, 1.02f);
            return fallen < 0.5f;
        }
    }

    @Test
    void bodiesOfOneGroupMeetNeitherEachOtherNorItsCircles() {
        for (boolean circle : new boolean[] {true, false}) {
            assertThat(fallsThrough(circle, 7, 7)).isTrue();
            assertThat(fallsThrough(circle, -7, -7)).isTrue();
            assertThat(fallsThrough(circle, 7, -7)).isFalse();
            assertThat(fallsThrough(circle, 7, 0)).isFalse();
            assertThat(fallsThrough(circle, 0, 7)).isFalse();
            assertThat(fallsThrough(circle, 0, 0)).isFalse();
        }
    }

    @Test
    void aBodyThatLeavesItsGroupMeetsOthersAgain() {
        try (World world = world()) {
            world.setGravity(0, -10);
            Bodies bodies = world.bodies();
            bodies.report(true);
            long below = bodies.add(Outline.box(4, 1), 10, 0.5f, 0, 4);
            long crate = bodies.add(CRATE, 10, 1.25f, 0, 1);
            world.step(1 / 60f, 30);
            bodies.setGroup(below, 3);
            bodies.setGroup(crate, 3);
            bodies.events();
            world.step(1 / 60f);
            BodyEvents events = bodies.events();
            assertThat(events.size()).isOne();
            assertThat(events.isBegin(0)).isFalse();
            bodies.setGroup(crate, 0);
            world.step(1 / 60f, 30);
            assertThat(bodies.y(crate)).isCloseTo(1.25f, within(0.02f));
            bodies.remove(below);
            assertThat(bodies.group(bodies.add(CRATE, 4, 5, 0, 2))).isZero();
        }
    }

    @Test
    void whatNobodyHasIsInNoSnapshotNorHash() {
        try (World world = world()) {
            long body = world.bodies().add(CRATE, 4, 5, 0, 2);
            ByteBuffer before = snapshot(world);
            long hash = world.hash();
            world.bodies().setForce(body, 1, 0);
            assertThat(world.hash()).isNotEqualTo(hash);
            assertThat(world.snapshotBytes()).isGreaterThan(before.remaining());
            world.bodies().setForce(body, -0f, 0);
            world.bodies().setGroup(body, 5);
            assertThat(world.hash()).isNotEqualTo(hash);
            world.bodies().setGroup(body, 0);
            assertThat(world.hash()).isEqualTo(hash);
            assertThat(snapshot(world)).isEqualTo(before);
        }
    }

    @Test
    void handlesGoStaleAndAreOfNothingElse() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            long circle = world.add(1, 1, 0.5f, 1);
            long gone = bodies.add(CRATE, 4, 5, 0, 2);
            bodies.remove(gone);
            long body = bodies.add(CRATE, 4, 5, 0, 2);
            assertThat(Bodies.id(body)).isEqualTo(Bodies.id(gone));
            assertIllegalArgument("was removed", () -> bodies.x(gone));
            assertIllegalArgument("it is of a circle", () -> bodies.x(circle));
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> bodies.x(0))
                    .withMessage("no body has the handle 0: 0 is the handle of nothing");
            assertIllegalArgument("it is of a body of World.bodies. Bodies has its calls", () -> world.x(body));
            assertIllegalArgument("touching in place of contactsOf", () -> world.contactsOf(body, new long[1], null));
            assertIllegalArgument("a kind its gravity scale", () -> world.setGravityScale(body, 0));
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.terrain().remove(body));
            assertThatIllegalArgumentException().isThrownBy(() -> world.joints().remove(body));
            assertThat(world.terrain().contains(body)).isFalse();
            assertThat(world.joints().contains(body)).isFalse();
            assertThat(bodies.contains(world.terrain().ground().handle())).isFalse();
        }
    }

    @Test
    void whatIsTooLargeForTheBoundsIsRefusedWithTheBounds() {
        try (World world = WorldScenes.jvm().build()) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.bodies().add(Outline.box(1, 1), 0.5f, 0.5f, 0, 1))
                    .withMessageStartingWith("the reach of the outline from its centroid is 0.6")
                    .withMessageContaining("to 0.5 in bounds from 0.0, 0.0 to 1.0, 1.0: larger bounds")
                    .withMessageContaining("World.setBounds");
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.add(0.5f, 0.5f, 1, 1))
                    .withMessageStartingWith("radius is 1.0, but must be from")
                    .withMessageContaining("to 0.5 in bounds from 0.0, 0.0 to 1.0, 1.0: larger bounds");
        }
    }

    @Test
    void statsCountBodiesAndPairsWithContacts() {
        try (World world = WorldScenes.jvm()
                        .bounds(0, 0, 20, 10)
                        .gravity(0, -10)
                        .sleep(true)
                        .build();
                World restored = world()) {
            Bodies bodies = world.bodies();
            assertThat(world.stats().bodies()).isZero();
            bodies.add(CRATE, 4, 0.25f, 0, 1);
            bodies.add(CRATE, 4, 0.75f, 0, 1);
            bodies.add(CRATE, 9, 0.25f, 0, 1);
            world.add(9, 1, 0.5f, 1);
            assertThat(world.stats().bodyContacts()).isZero();
            world.step(1 / 60f, 10);
            assertThat(world.stats().bodies()).isEqualTo(3);
            assertThat(world.stats().awakeBodies()).isEqualTo(3);
            assertThat(world.stats().circles()).isOne();
            assertThat(world.stats().contacts()).isZero();
            // two of them lie on the floor, one on another one, a circle on one
            assertThat(world.stats().bodyContacts()).isEqualTo(4);
            restored.restore(snapshot(world));
            assertThat(restored.stats().bodyContacts()).isEqualTo(4);
            world.step(1 / 60f, 300);
            assertThat(world.stats().awakeBodies()).isEqualTo(bodies.awake()).isZero();
            assertThat(world.stats().bodyContacts()).isEqualTo(4);
            bodies.clear();
            assertThat(world.stats().bodyContacts()).isZero();
        }
    }

    @Test
    void badValuesAreRefusedAndChangeNothing() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            long hash = world.hash();
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.add(CRATE, Float.NaN, 5, 0, 2));
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.add(CRATE, 21, 5, 0, 2));
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.add(CRATE, 4, 5, Float.NaN, 2));
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> bodies.add(CRATE, 4, 5, 0, 0))
                    .withMessageContaining("mass is 0.0")
                    .withMessageContaining("World.terrain");
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> bodies.add(CRATE, 4, 5, 0, Float.POSITIVE_INFINITY))
                    .withMessageContaining("World.terrain")
                    .withMessageContaining("Joint.pin");
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> bodies.addAll(
                            CRATE, new float[] {1, 1, 0, 1, 2, 2, 0, Float.POSITIVE_INFINITY}, null, null))
                    .withMessageContaining("body 1")
                    .withMessageContaining("World.terrain");
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> bodies.add(CRATE, 4, 5, 0, -1))
                    .withMessage("mass is -1.0, but must be from 1.0E-9 to 1.0E9");
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.add(CRATE, 4, 5, 0, 2, 256));
            assertIllegalArgument("reach", () -> bodies.add(Outline.box(30, 1), 4, 5, 0, 2));
            assertThat(world.hash()).isEqualTo(hash);
            long body = bodies.add(CRATE, 4, 5, 0, 2);
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.setInertia(body, 0));
            assertThatIllegalArgumentException().isThrownBy(() -> bodies.readById(new float[2], null));
            assertThatIllegalArgumentException().isThrownBy(() -> world.setBounds(0, 0, 0.5f, 0.5f));
        }
    }

    @Test
    void whatGoesRightAfterARestoreTakesItsContactsAlong() {
        try (World world = world();
                World restored = world()) {
            world.setGravity(0, -10);
            long floor = world.terrain().ground().addSegment(2, 1, 6, 1, 0.1f, 0);
            world.bodies().add(CRATE, 4, 1.35f, 0, 1);
            long ball = world.add(4, 1.85f, 0.25f, 1);
            world.step(1 / 60f, 60);
            ByteBuffer saved = snapshot(world);
            restored.restore(saved);
            for (World each : new World[] {world, restored}) {
                each.remove(ball);
                each.terrain().remove(floor);
            }
            assertThat(restored.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    void aCircleKnowsWhichBodiesPressIt() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 20, 10)
                .gravity(0, -10)
                .friction(0.6f)
                .build()) {
            long below = world.bodies().add(Outline.box(4, 1), 10, 0.5f, 0, 4);
            long ball = world.add(10.5f, 1.5f, 0.5f, 1);
            long wedge = world.bodies().add(Outline.polygon(0, 0, 2, 0, 0, 2), 4, 0.7f, 0, 4);
            world.step(1 / 60f, 60);
            long[] partners = new long[4];
            float[] contacts = new float[4 * World.CONTACT_STRIDE];
            assertThat(world.contactsOf(ball, partners, contacts)).isEqualTo(1);
            assertThat(partners[0]).isEqualTo(below);
            assertThat(contacts[World.NORMAL_X]).isCloseTo(0, within(1e-3f));
            assertThat(contacts[World.NORMAL_Y]).isCloseTo(1, within(1e-3f));
            assertThat(contacts[World.DEPTH]).isBetween(0f, 0.02f);
            assertThat(contacts[World.IMPULSE]).as("its weight").isCloseTo(10 / 60f, within(2e-3f));
            assertThat(world.bodies().contains(partners[0])).isTrue();
            world.teleport(ball, world.bodies().x(wedge) + 0.7f, world.bodies().y(wedge) + 0.7f);
            world.step(1 / 60f, 20);
            assertThat(world.contactsOf(ball, partners, contacts)).isEqualTo(1);
            assertThat(partners[0]).isEqualTo(wedge);
            assertThat(contacts[World.NORMAL_X]).as("of the slope").isCloseTo(0.707f, within(0.02f));
            assertThat(contacts[World.NORMAL_Y]).isCloseTo(0.707f, within(0.02f));
        }
    }

    @Test
    void aSnapshotHasBodiesAndTheirOutlineOnce() {
        try (World world = world();
                World other = world()) {
            int without = world.snapshotBytes();
            long first = world.bodies().add(CRATE, 4, 5, 0.5f, 2);
            int one = world.snapshotBytes() - without;
            for (int k = 0; k < 20; k++) {
                world.bodies().add(CRATE, 1 + 0.9f * k, 8, k, 2);
            }
            world.bodies().setVelocity(first, 1, 2);
            world.bodies().setTag(first, -5);
            world.bodies().applyForce(first, 3, 4);
            world.bodies().remove(world.bodies().handle(7));
            assertThat(world.snapshotBytes() - without - one).isLessThan(20 * 50);
            ByteBuffer bytes = snapshot(world);
            other.restore(bytes.duplicate());
            assertThat(other.hash()).isEqualTo(world.hash());
            assertThat(snapshot(other)).isEqualTo(bytes);
            assertThat(other.bodies().tag(first)).isEqualTo(-5);
            world.step(1 / 60f, 10);
            other.step(1 / 60f, 10);
            assertThat(other.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    void theHashHasAllThatStepsDependOn() {
        try (World world = world()) {
            long empty = world.hash();
            long body = world.bodies().add(CRATE, 4, 5, 0.5f, 2);
            long one = world.hash();
            assertThat(one).isNotEqualTo(empty);
            world.bodies().setKind(body, 4);
            assertThat(world.hash()).isNotEqualTo(one);
            world.bodies().setKind(body, 0);
            assertThat(world.hash()).isEqualTo(one);
            world.bodies().clear();
            assertThat(world.hash()).isEqualTo(empty);
            world.bodies().add(Outline.box(1, 0.5f).round(0.02f), 4, 5, 0.5f, 2);
            assertThat(world.hash()).isNotEqualTo(one);
        }
    }

    @Test
    void clearingCirclesLeavesBodies() {
        try (World world = world()) {
            world.add(4, 5.6f, 0.5f, 1);
            world.bodies().add(CRATE, 4, 5, 0, 2);
            world.step(1 / 60f, 3);
            world.clear();
            assertThat(world.size()).isZero();
            assertThat(world.bodies().size()).isOne();
            world.step(1 / 60f, 3);
        }
    }

    @Test
    void aRewindGoesBack() {
        try (World world = world()) {
            long body = world.bodies().add(CRATE, 4, 5, 0, 2);
            world.bodies().setVelocity(body, 3, 1);
            Rewind rewind = new Rewind(world, 3);
            rewind.save(1);
            long before = world.hash();
            world.step(1 / 60f, 4);
            long after = world.hash();
            world.bodies().add(Outline.capsule(1, 0.2f), 10, 5, 0, 2);
            rewind.restore(1);
            assertThat(world.hash()).isEqualTo(before);
            assertThat(world.bodies().size()).isOne();
            world.step(1 / 60f, 4);
            assertThat(world.hash()).isEqualTo(after);
        }
    }

    @Test
    void aLoopGivesPosesBetweenTwoSteps() {
        try (World world = world()) {
            long body = world.bodies().add(CRATE, 4, 5, 0, 2);
            FixedStep loop = new FixedStep(world, 1 / 60f);
            float[] poses = new float[3];
            long[] living = new long[1];
            loop.bodies(poses, living);
            assertThat(poses).containsExactly(4, 5, 0);
            assertThat(living).containsExactly(1);
            loop.advance(1 / 60f, null);
            world.bodies().setVelocity(body, 6, 0);
            loop.advance(1.5f / 60, null);
            float[] now = new float[3];
            world.bodies().readById(now, null);
            loop.bodies(poses, null);
            assertThat(poses[0]).isBetween(4f, now[0]);
        }
    }

    /** Bodies alone make steps, too: circles that have gone end their touches in the first, wherever it is made. */
    @OnEachOpenClBackend
    void circlesThatHaveGoneEndTheirTouchesInTheNextStep(Backend backend) {
        try (World device = World.builder()
                        .bounds(0, 0, 20, 10)
                        .gravity(0, 0)
                        .backend(backend)
                        .build();
                World jvm = world()) {
            for (World each : new World[] {device, jvm}) {
                each.bodies().add(CRATE, 10, 5, 0, 2);
                each.report(Events.BEGIN | Events.END);
                each.add(4, 5, 0.5f, 1);
                each.add(4.9f, 5, 0.5f, 1);
                each.step(1 / 60f, 5);
                each.events();
                each.clear();
                each.step(1 / 60f, 3);
            }
            Events events = device.events();
            Events expected = jvm.events();
            assertThat(events.size()).isEqualTo(expected.size()).isPositive();
            for (int k = 0; k < events.size(); k++) {
                assertThat(events.step(k)).isEqualTo(expected.step(k));
            }
            assertThat(device.stats().contacts()).isZero();
            assertThat(snapshot(device)).isEqualTo(snapshot(jvm));
            for (World each : new World[] {device, jvm}) {
                each.add(4, 5, 0.5f, 1);
                each.add(4.9f, 5, 0.5f, 1);
                each.step(1 / 60f, 2);
            }
            assertThat(device.events().size()).isEqualTo(jvm.events().size());
            assertThat(snapshot(device)).isEqualTo(snapshot(jvm));
        }
    }

    @OnEachOpenClBackend
    void aWorldBuiltForADeviceHasBodiesThatSleep(Backend backend) {
        try (World device = sleeping().backend(backend).build();
                World jvm = sleeping().build()) {
            long ball = 0;
            long crate = 0;
            for (World each : new World[] {device, jvm}) {
                crate = each.bodies().add(CRATE, 10, 0.5f, 0, 2);
                ball = each.add(10, 1.25f, 0.25f, 0.2f);
                each.add(4, 0.5f, 0.5f, 1);
                each.step(1 / 60f, 150);
            }
            assertThat(device.isAwake(ball)).isFalse();
            assertThat(device.bodies().isAwake(crate)).isFalse();
            assertThat(snapshot(device)).isEqualTo(snapshot(jvm));
            for (World each : new World[] {device, jvm}) {
                each.bodies().applyImpulse(crate, 3, 0);
                each.step(1 / 60f, 20);
            }
            assertThat(device.isAwake(ball)).isTrue();
            assertThat(snapshot(device)).isEqualTo(snapshot(jvm));
            assertThat(device.stats().awake()).isEqualTo(jvm.stats().awake());
        }
    }

    private static World.Builder sleeping() {
        return World.builder()
                .bounds(0, 0, 20, 10)
                .gravity(0, -10)
                .friction(0.6f)
                .rollingResistance(0.05f)
                .sleep(true);
    }

    @Test
    @Tag("long")
    void aWorldThatMovesTakesBodiesAlongThatSleep() {
        try (World world = sleeping().backend(Backend.JVM).build();
                World stays = sleeping().backend(Backend.JVM).build()) {
            RandomMoves moves = RandomMoves.of(world, 1, TestDevices.all().get(0), Integer.MAX_VALUE);
            int asleep = 0;
            for (int k = 0; k < 300; k++) {
                for (World each : new World[] {world, stays}) {
                    if (k < 8) {
                        each.bodies().add(CRATE, 2 + 2 * k, 0.5f + k % 3, 0.1f * k, 2);
                        each.add(3 + 2 * k, 1 + k % 2, 0.3f, 1);
                    } else if (k % 40 == 39) {
                        each.bodies().applyImpulse(each.bodies().handle(k % 7), k % 3 - 1, 1);
                        each.applyImpulse(each.handle(k % 5), 0, 2);
                    }
                    each.step(1 / 60f);
                }
                asleep = Math.max(asleep, world.bodies().size() - world.bodies().awake());
                assertThat(world.hash()).as("step %d", k).isEqualTo(stays.hash());
            }
            assertThat(snapshot(world)).isEqualTo(snapshot(stays));
            assertThat(moves.moves()).isPositive();
            assertThat(asleep).isGreaterThan(3);
        }
    }

    @Test
    @Tag("long")
    void aWorldThatMovesTakesItsBodiesAlong() {
        try (World world = world();
                World stays = world()) {
            RandomMoves moves = RandomMoves.of(world, 1, TestDevices.all().get(0), Integer.MAX_VALUE);
            long hinged = 0;
            for (World each : new World[] {world, stays}) {
                each.add(4, 5, 0.5f, 1);
                each.add(9.7f, 7, 0.5f, 1);
                hinged = each.bodies().add(CRATE, 3, 3, 0, 2);
                each.joints().add(hinged, 0.3f, 0.2f, 3, 4, Joint.pin());
                each.joints().add(hinged, -0.4f, 0, each.add(2, 4, 0.3f, 1), Joint.rope(2));
            }
            for (int k = 0; k < 60; k++) {
                for (World each : new World[] {world, stays}) {
                    long body = each.bodies().add(CRATE, 10, 5, 0, 2);
                    each.step(1 / 60f);
                    if (k % 7 == 3) {
                        each.bodies().remove(body);
                    }
                    each.step(1 / 60f, 2);
                }
                assertThat(world.hash()).isEqualTo(stays.hash());
            }
            assertThat(snapshot(world)).isEqualTo(snapshot(stays));
            assertThat(moves.moves()).isPositive();
        }
    }

    @Test
    void readsByIdAreNaNWithoutABody() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            long gone = bodies.add(CRATE, 4, 5, 0, 2);
            long body = bodies.add(CRATE, 6, 5, 0.25f, 2);
            bodies.setVelocity(body, 1, 2);
            bodies.setAngularVelocity(body, 3);
            bodies.remove(gone);
            float[] values = new float[6];
            long[] living = new long[2];
            bodies.readById(values, living);
            assertThat(values).containsExactly(Float.NaN, Float.NaN, Float.NaN, 6, 5, 0.25f);
            assertThat(living).containsExactly(2, 0);
            bodies.readVelocitiesById(values, null);
            assertThat(values).containsExactly(Float.NaN, Float.NaN, Float.NaN, 1, 2, 3);
            long[] handles = new long[1];
            bodies.readHandles(handles);
            assertThat(handles).containsExactly(body);
        }
    }
}
