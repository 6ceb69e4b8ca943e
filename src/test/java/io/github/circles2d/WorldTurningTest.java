package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Random;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The calls by which circles turn, grip and roll: what they take, what they keep, and what a world that never turned pays for them. */
class WorldTurningTest {
    private static final float STEP = 1 / 60f;
    private static final float TURN = (float) (2 * Math.PI);

    private final World world = WorldScenes.jvm().bounds(0, 0, 100, 100).build();

    @AfterEach
    void close() {
        world.close();
    }

    private long ball() {
        return ball(world);
    }

    private static long ball(World of) {
        return of.add(50, 50, 2, 3);
    }

    // ---- values

    @Test
    void whatIsSetIsRead() {
        long ball = ball();
        long other = world.add(20, 20, 2, 3);
        for (float angle : new float[] {0.5f, -2, 3, 1e-1f, -3.1f}) {
            world.setAngle(ball, angle);
            assertThat(world.angle(ball)).isEqualTo(angle);
        }
        for (float velocity : new float[] {1e9f, -1e9f, 1e-20f, -7.25f}) {
            world.setAngularVelocity(ball, velocity);
            assertThat(world.angularVelocity(ball)).isEqualTo(velocity);
        }
        world.setTorque(ball, -1e18f);
        assertThat(world.torque(ball)).isEqualTo(-1e18f);
        world.setFriction(ball, 1000);
        world.setRollingResistance(ball, 0.125f);
        assertThat(world.friction(ball)).isEqualTo(1000);
        assertThat(world.rollingResistance(ball)).isEqualTo(0.125f);
        assertThat(world.angle(other)).isZero();
        assertThat(world.angularVelocity(other)).isZero();
        assertThat(world.torque(other)).isZero();
        assertThat(world.friction(other)).isZero();
        assertThat(world.rollingResistance(other)).isZero();
    }

    @Test
    void anAngleLosesItsWholeTurns() {
        long ball = ball();
        world.setAngle(ball, 1 + 3 * TURN);
        assertThat(world.angle(ball)).isCloseTo(1, within(1e-5f));
        world.setAngle(ball, -1 - 5 * TURN);
        assertThat(world.angle(ball)).isCloseTo(-1, within(1e-5f));
        world.setAngle(ball, 0.75f * TURN);
        assertThat(world.angle(ball)).isCloseTo(-0.25f * TURN, within(1e-5f));
        world.setAngle(ball, 1e6f);
        assertThat(world.angle(ball)).isCloseTo((float) Math.IEEEremainder(1e6, 2 * Math.PI), within(1e-5f));
    }

    @Test
    void aValueOutOfRangeIsRefusedByItsName() {
        long ball = ball();
        Kind kind = world.kind(0);
        long hash = world.hash();
        refusals((value, message) -> refusal(() -> world.setAngle(ball, value), message), "angle", 1e6f);
        refusals(
                (value, message) -> refusal(() -> world.setAngularVelocity(ball, value), message),
                "angular velocity",
                1e9f);
        refusals(
                (value, message) -> refusal(() -> world.applyAngularImpulse(ball, value), message),
                "angular impulse",
                1e18f);
        refusals((value, message) -> refusal(() -> world.setTorque(ball, value), message), "torque", 1e18f);
        refusals((value, message) -> refusal(() -> world.applyTorque(ball, value), message), "torque", 1e18f);
        refusals(
                (value, message) -> refusal(() -> world.setWallSurface(Wall.MAX_X, 0, 0, value), message),
                "belt speed",
                1e9f);
        refusals((value, message) -> refusal(() -> kind.setBeltSpeed(value), message), "belt speed", 1e9f);
        for (float value : new float[] {-1e-9f, 1000.1f, Float.NEGATIVE_INFINITY}) {
            refusal(() -> world.setFriction(ball, value), "friction is " + value);
            refusal(() -> world.setRollingResistance(ball, value), "rolling resistance is " + value);
            refusal(() -> kind.setFriction(value), "friction is " + value);
            refusal(() -> kind.setRollingResistance(value), "rolling resistance is " + value);
            refusal(() -> kind.setAngularDamping(1000 * value), "angular damping is");
        }
        for (float value : new float[] {-1e-9f, 1000.1f, Float.NaN}) {
            refusal(() -> world.setWallSurface(Wall.MAX_X, value, 0, 0), "friction is " + value);
            refusal(() -> world.setWallSurface(Wall.MAX_X, 0, value, 0), "rolling resistance is " + value);
            refusal(() -> World.builder().friction(value), "friction is " + value);
            refusal(() -> World.builder().rollingResistance(value), "rolling resistance is " + value);
            refusal(() -> World.builder().wallSurface(Wall.MIN_X, value, 0, 0), "friction is " + value);
        }
        refusal(() -> World.builder().wallSurface(Wall.MIN_X, 0, 0, Float.NaN), "belt speed is NaN");
        assertThat(world.hash()).isEqualTo(hash);
        assertThat(world.snapshotBytes())
                .isEqualTo(snapshotOf(WorldTurningTest::ball).limit());
    }

    private static void refusals(BiConsumer<Float, String> call, String what, float most) {
        for (float value : new float[] {Float.NaN, Math.nextUp(most), -Math.nextUp(most), Float.POSITIVE_INFINITY}) {
            call.accept(value, what + " is " + value);
        }
    }

    private static void refusal(ThrowingCallable call, String message) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessageContaining(message);
    }

    @Test
    void aStaleHandleIsRefused() {
        long gone = ball();
        world.remove(gone);
        for (ThrowingCallable call : new ThrowingCallable[] {
            () -> world.setAngle(gone, 1),
            () -> world.setAngularVelocity(gone, 1),
            () -> world.applyAngularImpulse(gone, 1),
            () -> world.setTorque(gone, 1),
            () -> world.applyTorque(gone, 1),
            () -> world.setFriction(gone, 1),
            () -> world.setRollingResistance(gone, 1),
            () -> world.angle(gone),
            () -> world.angularVelocity(gone),
            () -> world.torque(gone),
            () -> world.friction(gone),
            () -> world.rollingResistance(gone)
        }) {
            refusal(call, "no circle has the handle");
        }
    }

    @Test
    void theCirclesOwnFrictionCountsThenThatOfItsKindThenTheWorlds() {
        try (World gripping = WorldScenes.jvm()
                .bounds(0, 0, 100, 100)
                .friction(0.5f)
                .rollingResistance(0.25f)
                .build()) {
            long ball = ball(gripping);
            assertThat(gripping.defaultFriction()).isEqualTo(0.5f);
            assertThat(gripping.defaultRollingResistance()).isEqualTo(0.25f);
            assertThat(gripping.friction(ball)).isEqualTo(0.5f);
            assertThat(gripping.rollingResistance(ball)).isEqualTo(0.25f);
            assertThat(gripping.kind(3).friction()).isNaN();
            assertThat(gripping.kind(3).rollingResistance()).isNaN();
            gripping.kind(3).setFriction(0).setRollingResistance(2);
            gripping.setKind(ball, 3);
            assertThat(gripping.friction(ball)).isZero();
            assertThat(gripping.rollingResistance(ball)).isEqualTo(2);
            gripping.setFriction(ball, 0.125f);
            gripping.setRollingResistance(ball, 0);
            assertThat(gripping.friction(ball)).isEqualTo(0.125f);
            assertThat(gripping.rollingResistance(ball)).isZero();
            gripping.setFriction(ball, Float.NaN);
            gripping.setRollingResistance(ball, Float.NaN);
            gripping.kind(3).setFriction(Float.NaN);
            assertThat(gripping.friction(ball)).isEqualTo(0.5f);
            assertThat(gripping.rollingResistance(ball)).isEqualTo(2);
        }
    }

    @Test
    void aKindHasASurfaceAndAnInertia() {
        Kind kind = world.kind(7);
        assertThat(kind.beltSpeed()).isZero();
        assertThat(kind.inertia()).isEqualTo(Inertia.DISC);
        assertThat(kind.angularDamping()).isZero();
        assertThat(kind.setBeltSpeed(-3).beltSpeed()).isEqualTo(-3);
        assertThat(kind.setAngularDamping(1e6f).angularDamping()).isEqualTo(1e6f);
        for (Inertia inertia : Inertia.values()) {
            assertThat(kind.setInertia(inertia).inertia()).isEqualTo(inertia);
        }
    }

    @Test
    void wallsGripAsCirclesDoUnlessTheyHaveSurfacesOfTheirOwn() {
        World.Builder builder = WorldScenes.jvm()
                .wallSurface(Wall.MAX_Y, 0, 0.5f, -2)
                .friction(0.5f)
                .wallSurface(Wall.MIN_X, 0.125f, 0, 3)
                .rollingResistance(0.25f);
        try (World gripping = builder.build()) {
            assertWall(gripping, Wall.MIN_X, 0.125f, 0, 3);
            assertWall(gripping, Wall.MAX_X, 0.5f, 0.25f, 0);
            assertWall(gripping, Wall.MIN_Y, 0.5f, 0.25f, 0);
            assertWall(gripping, Wall.MAX_Y, 0, 0.5f, -2);
            gripping.setWallSurface(Wall.MIN_Y, 7, 8, 1e9f);
            assertWall(gripping, Wall.MIN_Y, 7, 8, 1e9f);
            assertWall(gripping, Wall.MAX_X, 0.5f, 0.25f, 0);
            world.restore(snapshot(gripping));
            assertWall(world, Wall.MIN_Y, 7, 8, 1e9f);
            assertWall(world, Wall.MAX_Y, 0, 0.5f, -2);
            assertThat(world.defaultFriction()).isEqualTo(0.5f);
            assertThat(world.defaultRollingResistance()).isEqualTo(0.25f);
        }
    }

    private static void assertWall(World of, Wall wall, float friction, float resistance, float belt) {
        assertThat(of.wallFriction(wall)).isEqualTo(friction);
        assertThat(of.wallRollingResistance(wall)).isEqualTo(resistance);
        assertThat(of.wallBeltSpeed(wall)).isEqualTo(belt);
    }

    // ---- motion

    @Test
    void aCircleTurnsByItsAngularVelocityAndKeepsItToTheBit() {
        long ball = ball();
        long roller = world.add(20, 20, 2, Float.POSITIVE_INFINITY);
        world.setAngularVelocity(ball, 3.3f);
        world.setAngularVelocity(roller, -1.7f);
        world.setAngle(roller, 1);
        world.step(STEP, 600);
        assertThat(world.angularVelocity(ball)).isEqualTo(3.3f);
        assertThat(world.angularVelocity(roller)).isEqualTo(-1.7f);
        assertAngle(world.angle(ball), 33);
        assertAngle(world.angle(roller), -16);
        world.setRadius(ball, 1);
        world.setMass(ball, 100);
        world.setMass(roller, 1);
        assertThat(world.angularVelocity(ball)).isEqualTo(3.3f);
        assertThat(world.angularVelocity(roller)).isEqualTo(-1.7f);
    }

    private static void assertAngle(float angle, double expected) {
        assertThat((float) Math.IEEEremainder(angle - expected, 2 * Math.PI)).isCloseTo(0, within(1e-3f));
    }

    @Test
    void impulsesAndTorquesTurnByTheInertiaOfTheKind() {
        world.kind(1).setInertia(Inertia.RING);
        world.kind(2).setInertia(Inertia.NONE);
        float[] inertia = {3 * 2 * 2 / 2f, 3 * 2 * 2, Float.POSITIVE_INFINITY};
        for (int k = 0; k < inertia.length; k++) {
            long pushed = world.add(10 + 20 * k, 10, 2, 3, 0, 0, k);
            long driven = world.add(10 + 20 * k, 20, 2, 3, 0, 0, k);
            long once = world.add(10 + 20 * k, 30, 2, 3, 0, 0, k);
            world.applyAngularImpulse(pushed, 12);
            assertThat(world.angularVelocity(pushed)).isEqualTo(12 / inertia[k]);
            world.setTorque(driven, -12);
            world.applyTorque(once, 5);
            world.applyTorque(once, 7);
            world.step(STEP, 60);
            assertThat(world.angularVelocity(pushed)).isEqualTo(12 / inertia[k]);
            assertThat(world.angularVelocity(driven)).isCloseTo(-12 / inertia[k], within(1e-4f));
            assertThat(world.angularVelocity(once)).isCloseTo(12 / inertia[k] / 60, within(1e-6f));
            assertThat(world.torque(once)).isZero();
        }
    }

    @Test
    void anAppliedTorqueComesBesideTheOneThatIsSetAndIsGoneAfterTheStep() {
        long ball = ball();
        world.setTorque(ball, 6);
        world.applyTorque(ball, 12);
        world.applyForce(ball, 3, 0);
        world.step(STEP);
        assertThat(world.angularVelocity(ball)).isCloseTo(18 / 6f / 60, within(1e-6f));
        assertThat(world.vx(ball)).isCloseTo(1 / 60f, within(1e-6f));
        assertThat(world.torque(ball)).isEqualTo(6);
        world.step(STEP);
        assertThat(world.angularVelocity(ball)).isCloseTo(24 / 6f / 60, within(1e-6f));
        world.setTorque(ball, 0);
        float velocity = world.angularVelocity(ball);
        world.step(STEP, 5);
        assertThat(world.angularVelocity(ball)).isEqualTo(velocity);
    }

    @Test
    void nothingButItsVelocityTurnsAStaticCircle() {
        long roller = world.add(20, 20, 2, Float.POSITIVE_INFINITY);
        world.setAngularVelocity(roller, 2);
        world.applyAngularImpulse(roller, 1e18f);
        world.setTorque(roller, 1e18f);
        world.applyTorque(roller, 1e18f);
        world.kind(0).setAngularDamping(1);
        world.step(STEP, 3);
        assertThat(world.angularVelocity(roller)).isEqualTo(2);
    }

    @Test
    void dampingTakesAShareOfTheAngularVelocityAway() {
        world.kind(1).setAngularDamping(0.5f);
        long ball = world.add(50, 50, 2, 3, 4, 0, 1);
        world.setAngularVelocity(ball, 40);
        world.step(STEP, 120);
        assertThat(world.angularVelocity(ball)).isCloseTo((float) (40 * Math.exp(-1)), within(0.1f));
        assertThat(world.vx(ball)).isEqualTo(4);
    }

    @Test
    void aNewCircleHasNothingOfTheOneWhoseIdItTakes() {
        long before = ball();
        turn(world, before);
        world.remove(before);
        long after = world.add(20, 20, 1, 1);
        assertThat(World.id(after)).isEqualTo(World.id(before));
        assertThat(world.angle(after)).isZero();
        assertThat(world.angularVelocity(after)).isZero();
        assertThat(world.torque(after)).isZero();
        assertThat(world.friction(after)).isZero();
        world.step(STEP);
        assertThat(world.angularVelocity(after)).isZero();
    }

    /** Gives a circle a value of everything by which circles turn. */
    private static void turn(World of, long circle) {
        of.setAngle(circle, 1);
        of.setAngularVelocity(circle, 2);
        of.applyAngularImpulse(circle, 3);
        of.setTorque(circle, 4);
        of.applyTorque(circle, 5);
        of.setFriction(circle, 0.5f);
        of.setRollingResistance(circle, 0.25f);
    }

    // ---- many circles

    @OnEachBackend
    void readsOfAllAreThoseOfEach(Backend backend) {
        try (World world =
                World.builder().bounds(0, 0, 100, 100).backend(backend).build()) {
            long[] handles = new long[70];
            for (int k = 0; k < handles.length; k++) {
                handles[k] = world.add(1 + k, 50, 0.3f, 1);
            }
            assertThat(world.angles()).isEqualTo(FloatBuffer.wrap(new float[70]));
            Random random = new Random(3);
            for (int k = 0; k < handles.length; k += 2) {
                world.setAngle(handles[k], random.nextFloat());
                world.setAngularVelocity(handles[k], random.nextFloat());
            }
            for (int k = 0; k < handles.length; k += 3) {
                world.remove(handles[k]);
            }
            world.step(STEP, 7);
            float[] angles = new float[80];
            float[] velocities = new float[80];
            long[] living = new long[2];
            world.readAnglesById(angles, living);
            world.readAngularVelocitiesById(velocities, null);
            FloatBuffer inOrder = world.angles();
            assertThat(inOrder.isReadOnly()).isTrue();
            assertThat(inOrder.limit()).isEqualTo(world.size());
            for (int id = 0; id < angles.length; id++) {
                if (id < 70 && world.contains(handles[id])) {
                    assertThat(angles[id]).isEqualTo(world.angle(handles[id])).isEqualTo(inOrder.get());
                    assertThat(velocities[id]).isEqualTo(world.angularVelocity(handles[id]));
                    assertThat(velocities[id] > 0).isEqualTo(id % 2 == 0);
                    assertThat(living[id / 64] >>> id & 1).isOne();
                } else {
                    assertThat(angles[id]).isNaN();
                    assertThat(velocities[id]).isNaN();
                    assertThat(living[id / 64] >>> id & 1).isZero();
                }
            }
            refusal(() -> world.readAnglesById(new float[69], null), "needs 70");
            refusal(() -> world.readAngularVelocitiesById(new float[69], null), "needs 70");
            refusal(() -> world.readAnglesById(angles, new long[1]), "needs 2");
        }
    }

    @Test
    void manyCirclesTurnAllOrNone() {
        long a = ball();
        long b = world.add(20, 20, 1, 1);
        long gone = world.add(30, 20, 1, 1);
        world.remove(gone);
        long[] handles = {a, gone, b};
        assertThat(world.setAngularVelocities(handles, 3, new float[] {1, Float.NaN, -0f}, StaleHandles.SKIP))
                .isOne();
        assertThat(world.angularVelocity(a)).isEqualTo(1);
        assertThat(Float.floatToRawIntBits(world.angularVelocity(b))).isZero();
        refusal(() -> world.setAngularVelocities(handles, 3, new float[3], StaleHandles.REFUSE), "handle 1");
        refusal(
                () -> world.setAngularVelocities(handles, 3, new float[] {5, 0, 1.1e9f}, StaleHandles.SKIP),
                "circle 2: angular velocity");
        refusal(
                () -> world.setAngularVelocities(handles, 3, new float[2], StaleHandles.SKIP),
                "angularVelocities has 2 elements, but must have 3");
        assertThat(world.angularVelocity(a)).isEqualTo(1);
    }

    // ---- state

    @Test
    void aWorldThatNeverTurnedKeepsNothingForIt() {
        world.add(20, 20, 1, 1);
        long ball = ball();
        world.kind(0).setInertia(Inertia.RING).setAngularDamping(60); // they act once something turns
        world.step(STEP);
        long bytes = world.stats().bytesHeld();
        assertThat(world.angle(ball) + world.angularVelocity(ball) + world.torque(ball) + world.friction(ball))
                .isZero();
        world.readAnglesById(new float[2], null);
        world.readAngularVelocitiesById(new float[2], null);
        world.step(STEP);
        assertThat(world.stats().bytesHeld()).isEqualTo(bytes);
        world.setAngularVelocity(ball, 1);
        world.step(STEP);
        assertThat(world.stats().bytesHeld()).isGreaterThan(bytes);
        assertThat(world.angularVelocity(ball)).isLessThan(0.5f);
    }

    @Test
    void whatIsBackAtZeroIsAsIfItHadNeverBeen() {
        ByteBuffer expected = snapshotOf(WorldTurningTest::ball);
        ByteBuffer turned = snapshotOf(made -> {
            long ball = ball(made);
            made.setAngle(ball, 2);
            made.setAngularVelocity(ball, -3);
            made.setTorque(ball, 5);
            made.setFriction(ball, 0.5f);
            made.setRollingResistance(ball, 0.5f);
            made.kind(4).setFriction(1).setBeltSpeed(2).setInertia(Inertia.RING).setAngularDamping(1);
            made.setWallSurface(Wall.MIN_X, 1, 1, 1);
            long hash = made.hash();
            made.setAngle(ball, -0f);
            made.setAngularVelocity(ball, -0f);
            made.setTorque(ball, -0f);
            made.setFriction(ball, Float.NaN);
            made.setRollingResistance(ball, Float.NaN);
            made.kind(4)
                    .setFriction(Float.NaN)
                    .setBeltSpeed(-0f)
                    .setInertia(Inertia.DISC)
                    .setAngularDamping(0);
            assertThat(made.hash()).isNotEqualTo(hash);
            made.setWallSurface(Wall.MIN_X, 0, 0, -0f);
        });
        assertThat(turned).isEqualTo(expected);
    }

    private static ByteBuffer snapshotOf(Consumer<World> calls) {
        try (World made = WorldScenes.jvm().bounds(0, 0, 100, 100).build()) {
            calls.accept(made);
            return snapshot(made);
        }
    }

    /** The hash has every value by which circles turn. */
    @Test
    void eachValueIsInTheHashAndInSnapshots() {
        long ball = ball();
        long hash = world.hash();
        int bytes = world.snapshotBytes();
        ByteBuffer start = snapshot(world);
        for (Runnable change : new Runnable[] {
            () -> world.setAngle(ball, 1),
            () -> world.setAngularVelocity(ball, 1),
            () -> world.setTorque(ball, 1),
            () -> world.applyTorque(ball, 1),
            () -> world.setFriction(ball, 0),
            () -> world.setRollingResistance(ball, 0),
            () -> world.kind(0).setFriction(0),
            () -> world.kind(0).setRollingResistance(0),
            () -> world.kind(0).setBeltSpeed(1),
            () -> world.kind(0).setInertia(Inertia.NONE),
            () -> world.kind(0).setAngularDamping(1),
            () -> world.setWallSurface(Wall.MIN_X, 1, 0, 0),
            () -> world.setWallSurface(Wall.MAX_X, 0, 1, 0),
            () -> world.setWallSurface(Wall.MIN_Y, 0, 0, 1)
        }) {
            change.run();
            assertThat(world.hash()).isNotEqualTo(hash);
            assertThat(world.snapshotBytes()).isGreaterThan(bytes);
            ByteBuffer changed = snapshot(world);
            long changedHash = world.hash();
            world.restore(start.duplicate());
            assertThat(world.hash()).isEqualTo(hash);
            world.restore(changed.duplicate());
            assertThat(world.hash()).isEqualTo(changedHash);
            assertThat(snapshot(world)).isEqualTo(changed);
            world.restore(start.duplicate());
        }
    }

    private static Scene scene() {
        return Scenes.thesis(500, 5);
    }

    private static World rolling(int threads) {
        return WorldScenes.load(scene(), WorldScenes.onThreads(threads, rolling()));
    }

    private static World rolling(Backend backend) {
        return WorldScenes.load(scene(), rolling().backend(backend).build());
    }

    private static World.Builder rolling() {
        return WorldScenes.builder(scene())
                .friction(0.6f)
                .rollingResistance(0.1f)
                .wallSurface(Wall.MIN_Y, 0.9f, 0.2f, 0.3f);
    }

    /** A change that depends on the number of the step alone. */
    private static void change(World of, int step) {
        long some = of.handle(step * 7 % of.idLimit());
        if (some == 0) {
            return;
        }
        switch (step % 8) {
            case 0 -> turn(of, some);
            case 1 -> of.kind(1).setInertia(Inertia.RING).setBeltSpeed(0.5f).setFriction(0.3f);
            case 2 -> of.setKind(some, 1);
            case 3 -> of.setMass(some, Float.POSITIVE_INFINITY);
            case 4 -> of.setWallSurface(Wall.MIN_X, 0.1f * (step % 10), 0, 1);
            case 5 -> of.remove(some);
            case 6 -> of.setRadius(some, of.radius(some) * 0.9f);
            default -> of.applyTorque(some, 1e-3f);
        }
    }

    @Test
    void restoredAfterAnyStepANewWorldGoesOnAsTheOldOne() {
        int steps = 40;
        int ahead = 8;
        long[] hashes = new long[steps + ahead];
        ByteBuffer[] snapshots = new ByteBuffer[steps];
        try (World first = rolling(1)) {
            for (int step = 0; step < steps + ahead; step++) {
                hashes[step] = first.hash();
                if (step < steps) {
                    snapshots[step] = snapshot(first);
                }
                change(first, step);
                first.step(STEP);
            }
            int fast = 0;
            for (int id = 0; id < first.idLimit(); id++) {
                long circle = first.handle(id);
                fast += circle != 0 && Math.abs(first.angularVelocity(circle)) > 0.5f ? 1 : 0;
            }
            assertThat(fast).isGreaterThan(50);
        }
        for (int step = 0; step < steps; step++) {
            try (World restored = WorldScenes.onThreads(1 + step % 3, WorldScenes.jvm())) {
                restored.restore(snapshots[step].duplicate());
                assertThat(snapshot(restored)).isEqualTo(snapshots[step]);
                for (int k = step; k < step + ahead; k++) {
                    assertThat(restored.hash())
                            .as("%d, restored at %d", k, step)
                            .isEqualTo(hashes[k]);
                    change(restored, k);
                    restored.step(STEP);
                }
            }
        }
    }

    /** A world that has turned, and then is made one that has not, has nothing left of it. */
    @OnEachBackend
    void aStateThatNeverTurnedGoesOnAsInAWorldThatNeverDid(Backend backend) {
        Scene scene = scene();
        try (World straight = WorldScenes.world(scene, WorldScenes.builder(scene));
                World turned = rolling(backend);
                World cleared =
                        WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend))) {
            straight.step(STEP, 30);
            turned.step(STEP, 30);
            turned.restore(snapshot(straight));
            for (int step = 0; step < 30; step++) {
                straight.step(STEP);
                turned.step(STEP);
                assertThat(turned.hash()).isEqualTo(straight.hash());
            }
            straight.kind(0).setFriction(0.5f);
            turned.kind(0).setFriction(0.5f);
            for (int step = 0; step < 20; step++) {
                straight.step(STEP);
                turned.step(STEP);
                assertThat(turned.hash()).isEqualTo(straight.hash());
            }
            straight.kind(0).setFriction(Float.NaN);
            for (int k = 0; k < 100; k++) {
                turn(cleared, cleared.handle(k));
            }
            cleared.step(STEP, 30);
            cleared.clear();
            straight.clear();
            for (int step = 0; step < 30; step++) {
                if (step < 10) {
                    cleared.add(0.5f, 0.5f, 0.05f, 1);
                    straight.add(0.5f, 0.5f, 0.05f, 1);
                }
                cleared.step(STEP);
                straight.step(STEP);
                assertThat(cleared.hash()).isEqualTo(straight.hash());
            }
            assertThat(cleared.angle(cleared.handle(0))).isZero();
        }
    }

    /** Its circles have not turned yet, so that a snapshot has only their surfaces. */
    @OnEachBackend
    void aWorldThatIsToGripIsRestoredIntoOneThatNeverTurned(Backend backend) {
        try (World gripping = rolling(1);
                World target = World.builder().backend(backend).build()) {
            for (int k = 0; k < 20; k++) {
                gripping.setFriction(gripping.handle(k), 0.1f * k);
            }
            target.add(0.5f, 0.5f, 0.1f, 1);
            target.step(STEP);
            target.restore(snapshot(gripping));
            assertThat(target.hash()).isEqualTo(gripping.hash());
            assertThat(snapshot(target)).isEqualTo(snapshot(gripping));
        }
    }

    @Test
    void aWorldIsTheSameWhetherOrNotItsPipelineIsReadyToTurn() {
        Scene scene = scene();
        try (World never = WorldScenes.world(scene, WorldScenes.builder(scene));
                World ready = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            ready.setAngle(ready.handle(0), 0);
            for (int step = 0; step < 60; step++) {
                never.step(STEP);
                ready.step(STEP);
                assertThat(ready.hash()).isEqualTo(never.hash());
                if (step % 20 == 0) {
                    assertThat(snapshot(ready)).isEqualTo(snapshot(never));
                }
            }
        }
    }

    @OnEachBackend
    @Tag("long")
    void aGameThatRollsBackComesToTheSameBits(Backend backend) {
        try (World straight = rolling(1);
                World game = rolling(backend)) {
            Rewind rewind = new Rewind(game, 10);
            for (int step = 0; step < 40; step++) {
                rewind.save(step);
                change(game, step);
                game.step(STEP);
                if (step % 4 == 3) {
                    rewind.restore(step - 3);
                    for (int again = step - 3; again <= step; again++) {
                        change(game, again);
                        game.step(STEP);
                    }
                }
                change(straight, step);
                straight.step(STEP);
                assertThat(game.hash()).isEqualTo(straight.hash());
            }
        }
    }

    @Test
    void aLogHasAllThatTurns() throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (World game = rolling(1);
                Recording recording = new Recording(game, log, 1)) {
            for (int step = 0; step < 40; step++) {
                change(game, step);
                game.step(STEP);
            }
            assertThat(recording.steps()).isEqualTo(40);
        }
        Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), world).run();
        assertThat(replay.differs()).as(replay.difference()).isFalse();
        assertThat(replay.equalUpTo()).isEqualTo(40);
    }
}
