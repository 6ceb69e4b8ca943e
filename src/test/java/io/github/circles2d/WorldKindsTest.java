package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What kinds and groups do to the circles of a world. */
class WorldKindsTest {
    private static final float STEP = 1 / 60f;

    private final World world = WorldScenes.jvm().bounds(0, 0, 100, 100).build();

    @AfterEach
    void close() {
        world.close();
    }

    /** Shoots a circle at another, and returns whether it went through without a trace. */
    private boolean passes(int kind, int otherKind, int group, int otherGroup, float speed) {
        long target = world.add(50, 50, 1, 1, 0, 0, otherKind);
        long bullet = world.add(50 - 20 * STEP * speed, 50, 0.5f, 1, speed, 0, kind);
        world.setGroup(bullet, group);
        world.setGroup(target, otherGroup);
        world.step(STEP, 40);
        boolean passed = world.vx(bullet) == speed && world.x(target) == 50 && world.x(bullet) > 50;
        boolean met = world.vx(target) > 0;
        assertThat(passed).isNotEqualTo(met);
        world.remove(target);
        world.remove(bullet);
        return passed;
    }

    @Test
    void circlesMeetUnlessKindsOrGroupsSayOtherwiseSlowOnesAndFastOnes() {
        world.kind(1).setCategory(2).setMask(~2);
        world.kind(2).setSensor(true);
        world.setResponse(3, 0, Response.IGNORE);
        world.setResponse(2, 3, Response.SOLID);
        for (float speed : new float[] {6, 120}) {
            assertThat(passes(0, 0, 0, 0, speed)).isFalse();
            assertThat(passes(1, 0, 0, 0, speed)).isFalse();
            assertThat(passes(1, 1, 0, 0, speed)).isTrue();
            assertThat(passes(2, 0, 0, 0, speed)).isTrue();
            assertThat(passes(0, 2, 0, 0, speed)).isTrue();
            assertThat(passes(3, 0, 0, 0, speed)).isTrue();
            assertThat(passes(3, 2, 0, 0, speed)).isFalse();
            assertThat(passes(0, 0, 5, 5, speed)).isTrue();
            assertThat(passes(0, 0, 5, -5, speed)).isFalse();
            assertThat(passes(0, 0, 5, 0, speed)).isFalse();
            assertThat(passes(3, 2, 9, 9, speed)).isTrue();
        }
    }

    @Test
    void circlesThatIgnoreEachOtherStillStopAtWallsAndAtOthers() {
        world.setGravity(0, -10);
        world.setResponse(1, 1, Response.IGNORE);
        long low = world.add(50, 1, 1, 1, 0, 0, 1);
        long same = world.add(50.1f, 1.5f, 1, 1, 0, 0, 1);
        long other = world.add(50.05f, 5, 1, 1, 0, 0, 0);
        world.setRestitution(other, 0);
        world.step(STEP, 300);
        assertThat(world.y(low)).isCloseTo(1, within(0.05f));
        assertThat(world.y(same)).isCloseTo(1, within(0.05f));
        assertThat(world.x(other) < 49 || world.x(other) > 51 || world.y(other) > 2.5f)
                .isTrue();
    }

    @Test
    void aPairThatIsIgnoredFromNowOnSeparatesFreelyAndIsPushedOutSlowlyOnceItIsSolidAgain() {
        world.setGravity(0, -10);
        long[] pile = new long[5];
        for (int k = 0; k < pile.length; k++) {
            pile[k] = world.add(50, 1 + 2 * k, 1, 1, 0, 0, 1);
        }
        world.step(STEP, 200);
        assertThat(world.y(pile[4])).isCloseTo(9, within(0.1f));
        world.setResponse(1, 1, Response.IGNORE);
        world.step(STEP, 15);
        // All fall as nothing carries them, but the lowest, which the floor carries.
        float fallen = 0.5f * 10 * 15 * STEP * 15 * STEP;
        assertThat(world.y(pile[0])).isCloseTo(1, within(0.1f));
        assertThat(world.y(pile[1])).isCloseTo(3 - fallen, within(0.1f));
        assertThat(world.y(pile[4])).isCloseTo(9 - fallen, within(0.1f));
        for (long circle : pile) {
            world.setVelocity(circle, 0, 0);
        }
        world.setResponse(1, 1, Response.BY_MASK);
        float fastest = 0;
        for (int k = 0; k < 200; k++) {
            world.step(STEP);
            fastest = Math.max(fastest, world.vy(pile[4]));
        }
        assertThat(fastest).isBetween(0.05f, 1f);
        assertThat(world.y(pile[4])).isCloseTo(9, within(0.1f));
    }

    @Test
    void aKindGivesItsRestitutionToCirclesThatGetIt() {
        world.kind(1).setRestitution(0.9f);
        long ball = world.add(10, 10, 1, 1, 0, 0, 1);
        assertThat(world.restitution(ball)).isEqualTo(0.9f);
        world.setRestitution(ball, 0.2f);
        assertThat(world.restitution(ball)).isEqualTo(0.2f);
        world.setKind(ball, 2);
        assertThat(world.restitution(ball)).isEqualTo(0.2f);
        world.setKind(ball, 1);
        assertThat(world.restitution(ball)).isEqualTo(0.9f);
        world.kind(1).setRestitution(Float.NaN);
        assertThat(world.restitution(world.add(20, 10, 1, 1, 0, 0, 1))).isEqualTo(0.5f);
        world.kind(0).setRestitution(0.75f);
        long[] handles = new long[1];
        world.addAll(new float[] {30, 10, 1, 1}, handles);
        assertThat(world.restitution(handles[0])).isEqualTo(0.75f);
        assertThat(world.restitution(world.add(40, 10, 1, 1))).isEqualTo(0.75f);
    }

    @Test
    void theNextCircleOfAnIdIsOfKind0AndOfNoGroup() {
        long first = world.add(10, 10, 1, 1, 0, 0, 77);
        world.setGroup(first, 4);
        world.remove(first);
        long second = world.add(10, 10, 1, 1);
        assertThat((int) second).isEqualTo((int) first);
        assertThat(world.kindOf(second)).isZero();
        assertThat(world.group(second)).isZero();
    }

    @Test
    void aSnapshotHasKindsAndGroupsAndAWorldWithoutThemTheSameBytesAsBefore() {
        long ball = world.add(10, 10, 1, 1);
        int plain = world.snapshotBytes();
        long hash = world.hash();
        world.setKind(ball, 9);
        world.setGroup(ball, -2);
        world.kind(9).setMask(3).setSensor(true).setRestitution(0.5f);
        world.setResponse(9, 4, Response.SENSE);
        assertThat(world.hash()).isNotEqualTo(hash);
        ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(snapshot);
        long full = world.hash();

        world.setKind(ball, 0);
        world.setGroup(ball, 0);
        world.kind(9).setMask(-1).setSensor(false).setRestitution(Float.NaN);
        world.setResponse(4, 9, Response.BY_MASK);
        assertThat(world.hash()).isEqualTo(hash);
        assertThat(world.snapshotBytes()).isEqualTo(plain);

        world.restore(snapshot.flip());
        assertThat(world.hash()).isEqualTo(full);
        assertThat(world.kindOf(ball)).isEqualTo(9);
        assertThat(world.group(ball)).isEqualTo(-2);
        assertThat(world.kind(9).mask()).isEqualTo(3);
        assertThat(world.kind(9).category()).isEqualTo(1);
        assertThat(world.kind(9).isSensor()).isTrue();
        assertThat(world.kind(9).restitution()).isEqualTo(0.5f);
        assertThat(world.response(4, 9)).isEqualTo(Response.SENSE);
    }

    @Test
    void badArgumentsAreNamed() {
        long ball = world.add(10, 10, 1, 1);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> world.kind(256))
                .withMessage("the kind is 256, but must be from 0 to 255");
        assertIllegalArgument("-1", () -> world.setKind(ball, -1));
        assertIllegalArgument("300", () -> world.add(1, 1, 1, 1, 0, 0, 300));
        assertIllegalArgument("1000", () -> world.setResponse(0, 1000, Response.SOLID));
        assertIllegalArgument("1.5", () -> world.kind(3).setRestitution(1.5f));
        assertThatIllegalArgumentException().isThrownBy(() -> world.setGroup(12345, 1));
        assertThat(world.size()).isEqualTo(1);
    }

    @Test
    void aCopyOfAKindMeetsAndMovesAsTheOtherDoesAndGoesItsOwnWay() {
        world.kind(3)
                .setCategory(6)
                .setMask(5)
                .setSensor(true)
                .setRestitution(0.25f)
                .setGravityScale(-2)
                .setDamping(3)
                .setGreatestSpeed(40)
                .setFriction(0.5f)
                .setRollingResistance(0.75f)
                .setBeltSpeed(-8)
                .setInertia(Inertia.RING)
                .setAngularDamping(9)
                .setOneWay(true);
        world.setResponse(3, 3, Response.SOLID);
        world.setResponse(3, 7, Response.SENSE);
        world.setResponse(4, 9, Response.IGNORE);
        Kind copy = world.kind(4).copyFrom(world.kind(3));
        assertThat(copy).isSameAs(world.kind(4));
        assertThat(copy.category()).isEqualTo(6);
        assertThat(copy.mask()).isEqualTo(5);
        assertThat(copy.isSensor()).isTrue();
        assertThat(copy.restitution()).isEqualTo(0.25f);
        assertThat(copy.gravityScale()).isEqualTo(-2);
        assertThat(copy.damping()).isEqualTo(3);
        assertThat(copy.greatestSpeed()).isEqualTo(40);
        assertThat(copy.friction()).isEqualTo(0.5f);
        assertThat(copy.rollingResistance()).isEqualTo(0.75f);
        assertThat(copy.beltSpeed()).isEqualTo(-8);
        assertThat(copy.inertia()).isEqualTo(Inertia.RING);
        assertThat(copy.angularDamping()).isEqualTo(9);
        assertThat(copy.isOneWay()).isTrue();
        for (int[] pair : new int[][] {{4, 4}, {4, 3}, {3, 3}}) {
            assertThat(world.response(pair[0], pair[1])).isEqualTo(Response.SOLID);
        }
        assertThat(world.response(4, 7)).isEqualTo(Response.SENSE);
        assertThat(world.response(4, 9)).as("what 3 does to it").isEqualTo(Response.BY_MASK);
        copy.setDamping(0).copyFrom(copy);
        assertThat(copy.damping()).isZero();
        assertThat(world.kind(3).damping()).isEqualTo(3);
        world.kind(4).copyFrom(world.kind(200));
        long hash = world.hash();
        world.kind(3).copyFrom(world.kind(200));
        assertThat(world.hash()).isNotEqualTo(hash);
        try (World empty = WorldScenes.jvm().bounds(0, 0, 100, 100).build()) {
            assertThat(world.hash()).isEqualTo(empty.hash());
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> world.kind(3).copyFrom(empty.kind(5)))
                    .withMessage("kind 5 is of another world");
        }
    }

    @Test
    void aKindIsTheSameObject() {
        assertThat(world.kind(3)).isSameAs(world.kind(3)).hasToString("kind 3");
        assertThat(world.kind(3).number()).isEqualTo(3);
    }
}
