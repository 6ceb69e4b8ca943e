package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.Refusals.assertIllegalState;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The loop of a game: when it steps, and what it shows in between. */
class FixedStepTest {

    /** A power of two, so that sums of steps are exact. */
    private static final float STEP = 1 / 64f;

    private static final Offset<Float> ROUNDING = within(1e-5f);

    private static World world(Backend backend) {
        return World.builder().bounds(0, 0, 10, 10).threads(1).backend(backend).build();
    }

    private static World world() {
        return world(Backend.JVM);
    }

    private static float x(FixedStep loop, long handle) {
        return loop.positions(null).get(2 * World.id(handle));
    }

    // ---- steps

    @Test
    void timeIsSavedUpUntilItIsEnoughForAStep() {
        try (World world = world()) {
            FixedStep loop = new FixedStep(world, STEP);
            int[] before = new int[1];
            Runnable count = () -> before[0]++;
            assertThat(loop.advance(0.5f * STEP, count)).isZero();
            assertThat(loop.alpha()).isEqualTo(0.5f);
            assertThat(loop.advance(0.75f * STEP, count)).isOne();
            assertThat(loop.alpha()).isEqualTo(0.25f);
            assertThat(loop.advance(2.75f * STEP, count)).isEqualTo(3);
            assertThat(loop.alpha()).isZero();
            assertThat(loop.advance(0, count)).isZero();
            assertThat(before[0]).isEqualTo(4);
            assertThat(loop.droppedSteps()).isZero();
        }
    }

    @Test
    void aLongFrameMakesNoMoreStepsThanAreAllowedAndDropsTheRest() {
        try (World world = world()) {
            FixedStep loop = new FixedStep(world, STEP);
            assertThat(loop.advance(12.5f * STEP, null)).isEqualTo(5);
            assertThat(loop.droppedSteps()).isEqualTo(7);
            assertThat(loop.alpha()).isEqualTo(0.5f);
            loop.setMaxSteps(1);
            assertThat(loop.advance(3600, null)).isOne();
            assertThat(loop.droppedSteps()).isEqualTo(7 + 3600 * 64 - 1);
            assertThat(loop.alpha()).isEqualTo(0.5f);
            assertThat(loop.advance(Float.MAX_VALUE, null)).isOne();
            assertThat(loop.alpha()).isBetween(0f, 1f);
        }
    }

    @Test
    void theNumberOfDroppedStepsStaysAtTheGreatestLong() {
        try (World world = world()) {
            FixedStep loop = new FixedStep(world, STEP);
            loop.advance(1e30f, null);
            loop.advance(1e30f, null);
            loop.advance(10, null);
            assertThat(loop.droppedSteps()).isEqualTo(Long.MAX_VALUE);
        }
    }

    @Test
    void aResetBeforeAStepMakesItTheLastOfTheFrame() {
        try (World world = world()) {
            FixedStep loop = new FixedStep(world, STEP);
            int[] before = new int[1];
            Runnable resetBeforeTheSecond = () -> {
                if (++before[0] == 2) {
                    loop.reset();
                }
            };
            assertThat(loop.advance(4.5f * STEP, resetBeforeTheSecond)).isEqualTo(2);
            assertThat(before[0]).isEqualTo(2);
            assertThat(loop.alpha()).isZero();
            assertThat(loop.advance(2 * STEP, resetBeforeTheSecond)).isEqualTo(2);
        }
    }

    @Test
    void whatRunsBeforeAStepCannotMakeStepsOfItsOwn() {
        try (World world = world()) {
            FixedStep loop = new FixedStep(world, STEP);
            assertIllegalState("cannot make steps", () -> loop.advance(3 * STEP, () -> loop.advance(STEP, null)));
            assertThat(loop.advance(2 * STEP, null)).isEqualTo(2);
        }
    }

    @Test
    void aStepOfTheWorldBeforeAStepIsRefusedUnlessTheLoopIsReset() {
        try (World world = world();
                World other = world()) {
            long a = world.add(1, 5, 0.1f, 1, 4, 0);
            FixedStep loop = new FixedStep(world, STEP);
            assertIllegalState("cannot make steps", () -> loop.advance(3 * STEP, () -> world.step(STEP)));
            assertThat(world.x(a)).as("one step has been made").isEqualTo(1 + 4 * STEP);
            assertThat(loop.advance(2 * STEP, () -> other.step(STEP))).isEqualTo(2);

            Rewind rewind = new Rewind(world, 1);
            rewind.save(0);
            float now = world.x(a);
            Runnable repeats = () -> {
                rewind.restore(0);
                world.step(STEP, 2);
                loop.reset();
            };
            assertThat(loop.advance(3 * STEP, repeats)).isOne();
            assertThat(world.x(a)).isCloseTo(now + 3 * 4 * STEP, ROUNDING);
        }
    }

    @Test
    void slowMotionMakesFewerStepsOfTheSameLength() {
        try (World world = world();
                World same = world()) {
            long a = world.add(1, 5, 0.5f, 1, 16, 0);
            same.add(1, 5, 0.5f, 1, 16, 0);
            FixedStep loop = new FixedStep(world, STEP);
            loop.setSpeed(0.25f);
            for (int frame = 0; frame < 8; frame++) {
                assertThat(loop.advance(STEP, null)).isEqualTo(frame % 4 == 3 ? 1 : 0);
            }
            same.step(STEP, 2);
            assertThat(world.hash()).isEqualTo(same.hash());
            assertThat(x(loop, a)).isCloseTo(1.25f, ROUNDING); // where it was before the last step
            loop.advance(2 * STEP, null);
            assertThat(x(loop, a)).isCloseTo(1.375f, ROUNDING);
            loop.setSpeed(0);
            assertThat(loop.advance(100, null)).isZero();
            assertThat(x(loop, a)).isCloseTo(1.375f, ROUNDING);
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {30, 60, 75, 144, 1000})
    void theStateDependsOnTheStepsAloneAndNotOnTheRateOfFrames(float framesPerSecond) {
        Scene scene = Scenes.thesis(200, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene));
                World same = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            int[] steps = new int[2];
            FixedStep loop = new FixedStep(world, 1 / 60f);
            while (steps[0] < 60) {
                loop.advance(1 / framesPerSecond, () -> steer(world, steps[0]++));
                loop.positions(null);
            }
            while (steps[1] < steps[0]) {
                steer(same, steps[1]++);
                same.step(1 / 60f);
            }
            assertThat(world.hash()).isEqualTo(same.hash());
        }
    }

    private static void steer(World world, int step) {
        world.applyImpulse(world.handle(step), 0.01f * step, 1e-3f);
        if (step % 10 == 9) {
            world.remove(world.handle(100 + step));
            world.explode(0.5f, 0.5f, 0.2f, 1e-3f, 0.2f);
        }
    }

    @Test
    void stepsWithoutAnythingBeforeThemAreTheSameSteps() {
        try (World world = world();
                World same = world()) {
            for (World each : new World[] {world, same}) {
                each.setGravity(0, -9);
                each.add(5, 5, 0.5f, 1, 3, 0);
            }
            assertThat(new FixedStep(world, STEP).advance(4 * STEP, null)).isEqualTo(4);
            assertThat(new FixedStep(same, STEP).advance(4 * STEP, () -> {})).isEqualTo(4);
            assertThat(world.hash()).isEqualTo(same.hash());
        }
    }

    // ---- positions

    @OnEachBackend
    void aCircleMovesEvenlyAtAnyRateOfFrames(Backend backend) {
        try (World world = world(backend)) {
            long a = world.add(1, 5, 0.1f, 1, 4, 0);
            FixedStep loop = new FixedStep(world, STEP);
            assertThat(x(loop, a)).isEqualTo(1);
            loop.advance(STEP, null);
            SplittableRandom random = new SplittableRandom(3);
            float time = 0;
            for (int frame = 0; frame < 60; frame++) {
                float seconds = random.nextInt(1, 30) * STEP / 16;
                loop.advance(seconds, null);
                time += seconds;
                assertThat(x(loop, a)).isCloseTo(1 + 4 * time, ROUNDING);
            }
        }
    }

    @OnEachBackend
    void circlesThatAreMovedOrNewAppearWhereTheyAre(Backend backend) {
        try (World world = world(backend)) {
            long a = world.add(1, 5, 0.1f, 1);
            FixedStep loop = new FixedStep(world, STEP);
            long[] added = new long[1];
            int[] steps = new int[1];
            loop.advance(2.5f * STEP, () -> {
                if (steps[0]++ == 1) { // before the last step
                    world.setPosition(a, 8, 5);
                    added[0] = world.add(6, 5, 0.1f, 1, 1, 0);
                }
            });
            assertThat(x(loop, a)).isEqualTo(8);
            assertThat(x(loop, added[0])).isCloseTo(6 + 0.5f * STEP, ROUNDING);
            world.setPosition(a, 2, 5); // between two frames
            long late = world.add(3, 5, 0.1f, 1);
            FloatBuffer positions = loop.positions(null);
            assertThat(positions.get(0)).isEqualTo(8);
            assertThat(positions.get(2 * World.id(late))).isEqualTo(3);
            loop.advance(STEP, null);
            assertThat(x(loop, a)).isEqualTo(2);
            assertThat(x(loop, late)).isEqualTo(3);
        }
    }

    @OnEachBackend
    void aRemovedCircleIsGoneAtOnceAndANewOneWithItsIdIsAtItsOwnPlace(Backend backend) {
        try (World world = world(backend)) {
            long a = world.add(1, 5, 0.1f, 1);
            long b = world.add(2, 5, 0.1f, 1);
            FixedStep loop = new FixedStep(world, STEP);
            loop.advance(1.5f * STEP, null);
            world.remove(a); // before the positions are taken
            long[] living = {0, -1};
            assertThat(loop.positions(living).get(0)).isNaN();
            assertThat(living).containsExactly(2, 0);
            world.remove(b); // after that
            world.add(7, 5, 0.1f, 1);
            world.add(8, 5, 0.1f, 1);
            FloatBuffer positions = loop.positions(living);
            assertThat(positions.get(0)).isEqualTo(7);
            assertThat(positions.get(2)).isEqualTo(8);
            assertThat(living).containsExactly(3, 0);
            loop.advance(STEP, null);
            positions = loop.positions(living);
            assertThat(positions.get(0)).isEqualTo(7);
            assertThat(positions.get(2)).isEqualTo(8);
            assertThat(living).containsExactly(3, 0);
        }
    }

    // ---- radii

    @OnEachBackend
    void aCircleGrowsEvenlyAtAnyRateOfFrames(Backend backend) {
        try (World world = world(backend)) {
            long a = world.add(2, 5, 0.5f, 1);
            long b = world.add(6, 5, 1, 1);
            FixedStep loop = new FixedStep(world, STEP);
            assertThat(loop.radii()).isEqualTo(FloatBuffer.wrap(new float[] {0.5f, 1}));
            world.grow(a, 0.9f, 40);
            loop.advance(STEP, null);
            SplittableRandom random = new SplittableRandom(5);
            float time = 0;
            while (time < 45) {
                float steps = random.nextInt(1, 30) / 16f;
                loop.advance(steps * STEP, null);
                time += steps;
                assertThat(loop.radii().get(World.id(a))).isCloseTo(0.5f + 0.01f * Math.min(time, 40), ROUNDING);
                assertThat(loop.radii().get(World.id(b))).isEqualTo(1);
            }
        }
    }

    @OnEachBackend
    void aRadiusOrAnAngleThatIsSetShowsAtOnceWithTheNextStepOrAReset(Backend backend) {
        try (World world = world(backend)) {
            long a = world.add(2, 5, 0.5f, 1);
            FixedStep loop = new FixedStep(world, STEP);
            loop.radii();
            loop.angles();
            loop.advance(1.5f * STEP, null);
            world.setRadius(a, 0.75f);
            world.setAngle(a, 2);
            assertThat(loop.radii().get(0)).isEqualTo(0.5f);
            assertThat(loop.angles().get(0)).isZero();
            loop.advance(STEP, null);
            assertThat(loop.alpha()).isEqualTo(0.5f);
            assertThat(loop.radii().get(0)).isEqualTo(0.75f);
            assertThat(loop.angles().get(0)).isEqualTo(2);
            world.grow(a, 1, 10);
            loop.advance(3.5f * STEP, null);
            world.setRadius(a, 2);
            world.setAngle(a, 1);
            loop.reset();
            assertThat(loop.radii().get(0)).isEqualTo(2);
            assertThat(loop.angles().get(0)).isEqualTo(1);
        }
    }

    @OnEachBackend
    void theSameIdsHaveRadiiAndAnglesAsHavePositions(Backend backend) {
        try (World world = world(backend)) {
            FixedStep loop = new FixedStep(world, STEP);
            assertThat(loop.radii().remaining()).isZero();
            assertThat(loop.angles().remaining()).isZero();
            SplittableRandom random = new SplittableRandom(7);
            for (int frame = 0; frame < 120; frame++) {
                long added = world.add(1 + 8 * (float) random.nextDouble(), 5, 0.1f, 1);
                world.grow(added, 0.2f, 9);
                world.setAngle(added, 0.5f);
                if (frame % 40 == 39) {
                    world.clear();
                }
                loop.advance(random.nextInt(1, 40) * STEP / 16, null);
                if (frame % 3 == 0) {
                    world.remove(world.add(5, 5, 0.1f, 1)); // an id that the positions may lack
                }
                long removed = world.handle(random.nextInt(world.idLimit()));
                if (removed != 0 && frame % 2 == 0) {
                    world.remove(removed);
                }
                FloatBuffer positions = loop.positions(null);
                FloatBuffer radii = loop.radii();
                FloatBuffer angles = loop.angles();
                assertThat(2 * radii.limit()).isEqualTo(positions.limit());
                assertThat(2 * angles.limit()).isEqualTo(positions.limit());
                for (int id = 0; id < radii.limit(); id++) {
                    assertThat(Float.isNaN(radii.get(id))).isEqualTo(Float.isNaN(positions.get(2 * id)));
                    assertThat(radii.get(id)).satisfiesAnyOf(r -> assertThat(r).isNaN(), r -> assertThat(r)
                            .isBetween(0.1f, 0.2f));
                    float expected = Float.isNaN(positions.get(2 * id)) ? Float.NaN : 0.5f;
                    assertThat(Float.compare(angles.get(id), expected)).isZero();
                }
            }
        }
    }

    // ---- angles

    private static final float TURN = (float) (2 * Math.PI);

    private static void assertAngle(float angle, float expected) {
        assertThat((float) Math.IEEEremainder(angle - expected, 2 * Math.PI)).isCloseTo(0, within(1e-4f));
    }

    @OnEachBackend
    void aCircleTurnsEvenlyAtAnyRateOfFrames(Backend backend) {
        try (World world = world(backend)) {
            long a = world.add(2, 5, 0.5f, 1);
            long b = world.add(6, 5, 1, 1);
            FixedStep loop = new FixedStep(world, STEP);
            assertThat(loop.angles()).isEqualTo(FloatBuffer.wrap(new float[2]));
            world.setAngularVelocity(a, 0.4f * TURN / STEP);
            loop.advance(STEP, null);
            SplittableRandom random = new SplittableRandom(5);
            float time = 0;
            while (time < 45) {
                float steps = random.nextInt(1, 30) / 16f;
                loop.advance(steps * STEP, null);
                time += steps;
                FloatBuffer angles = loop.angles();
                assertAngle(angles.get(World.id(a)), 0.4f * TURN * time);
                assertThat(angles.get(World.id(a))).isBetween((float) -Math.PI, (float) Math.PI);
                assertThat(angles.get(World.id(b))).isZero();
            }
        }
    }

    /** From 3 to -3 it is 0.28 to the left, and 6 to the right. */
    @OnEachBackend
    void anAngleTakesTheShortWay(Backend backend) {
        try (World world = world(backend)) {
            long a = world.add(2, 5, 0.5f, 1);
            FixedStep loop = new FixedStep(world, STEP);
            loop.angles();
            world.setAngle(a, 3);
            world.setAngularVelocity(a, (TURN - 6) / STEP);
            loop.advance(1.5f * STEP, null);
            assertAngle(loop.angles().get(0), TURN / 2);
            loop.advance(0.25f * STEP, null);
            assertAngle(loop.angles().get(0), 3 + 0.75f * (TURN - 6));
            world.setAngularVelocity(a, -0.4f * TURN / STEP);
            loop.advance(0.75f * STEP, null);
            assertAngle(loop.angles().get(0), -3 - 0.2f * TURN);
        }
    }

    @OnEachBackend
    void aReplayShowsCirclesThatGrowAndTurnAsTheGameDid(Backend backend) throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        float[][] shown = new float[12][];
        try (World world = world(backend);
                Recording recording = new Recording(world, log, 1)) {
            FixedStep loop = new FixedStep(world, STEP);
            loop.radii();
            loop.angles();
            long a = world.add(2, 5, 0.5f, 1);
            world.grow(a, 1, 10);
            world.setAngularVelocity(a, 9);
            for (int frame = 0; frame < shown.length; frame++) {
                loop.advance(0.75f * STEP, null);
                shown[frame] = new float[] {loop.radii().get(0), loop.angles().get(0)};
            }
            assertThat(recording.steps()).isEqualTo(9);
        }
        try (World world = world(backend)) {
            Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), world);
            FixedStep loop = new FixedStep(world, STEP);
            loop.radii();
            loop.angles();
            loop.advanceReplay(0.75f * STEP, replay);
            for (int frame = 1; frame < shown.length; frame++) {
                loop.advanceReplay(0.75f * STEP, replay);
                assertThat(loop.radii().get(0)).isEqualTo(shown[frame][0]);
                assertThat(loop.angles().get(0)).isEqualTo(shown[frame][1]);
            }
        }
    }

    @Test
    void beforeTheFirstStepThePositionsAreThoseOfNow() {
        try (World world = world()) {
            FixedStep loop = new FixedStep(world, STEP);
            assertThat(loop.positions(new long[0]).remaining()).isZero();
            long a = world.add(1, 5, 0.1f, 1);
            assertThat(x(loop, a)).isEqualTo(1);
            world.setPosition(a, 2, 5);
            loop.advance(0.5f * STEP, null);
            assertThat(x(loop, a)).isEqualTo(2);
        }
    }

    @Test
    void aResetShowsTheWorldAsItIsAndForgetsTheTimeSavedUp() {
        try (World world = world()) {
            long a = world.add(1, 5, 0.1f, 1, 2, 0);
            ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(snapshot);
            FixedStep loop = new FixedStep(world, STEP);
            loop.advance(2.5f * STEP, null);
            world.restore(snapshot.flip());
            loop.reset();
            assertThat(loop.alpha()).isZero();
            assertThat(x(loop, a)).isEqualTo(1);
            loop.advance(1.5f * STEP, null);
            assertThat(x(loop, a)).isCloseTo(1 + STEP, ROUNDING);
        }
    }

    @Test
    void frameAfterFrameOfACrowdThatComesAndGoesShowsEveryCircleOnItsWay() {
        try (World world = world()) {
            FixedStep loop = new FixedStep(world, STEP);
            SplittableRandom random = new SplittableRandom(11);
            float[] before = new float[800];
            float[] after = new float[800];
            long[] living = new long[4];
            for (int frame = 0; frame < 300; frame++) {
                for (int k = 0; k < 3; k++) {
                    world.add(1 + 8 * (float) random.nextDouble(), 5, 0.1f, 1, 2, 1);
                    if (random.nextInt(3) > 0 || world.size() > 150) {
                        long handle = world.handle(random.nextInt(world.idLimit()));
                        if (handle != 0) {
                            world.remove(handle);
                        }
                    }
                }
                world.readById(before, null);
                int made = loop.advance(STEP, null);
                assertThat(made).isOne();
                loop.advance(STEP / 4 * (frame % 4 == 0 ? 1 : 0), null);
                world.readById(after, null);
                FloatBuffer positions = loop.positions(living);
                float alpha = loop.alpha();
                for (int id = 0; id < world.idLimit(); id++) {
                    boolean lives = world.handle(id) != 0;
                    assertThat((living[id / 64] >>> id & 1) != 0).isEqualTo(lives);
                    if (lives && alpha < 0.9f) {
                        float way = before[4 * id] + (after[4 * id] - before[4 * id]) * alpha;
                        assertThat(positions.get(2 * id)).isCloseTo(way, ROUNDING);
                    }
                }
                if (frame % 4 == 3) {
                    loop.reset();
                }
            }
        }
    }

    @OnEachBackend
    void everyBackEndShowsTheSame(Backend backend) {
        Scene scene = Scenes.packed(500, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend));
                World jvm = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            FixedStep loop = new FixedStep(world, 1 / 60f);
            FixedStep expected = new FixedStep(jvm, 1 / 60f);
            for (int frame = 0; frame < 40; frame++) {
                float seconds = (1 + frame % 5) / 120f;
                loop.advance(seconds, null);
                expected.advance(seconds, null);
                if (frame % 3 > 0) {
                    assertThat(loop.positions(null)).isEqualTo(expected.positions(null));
                }
                world.remove(world.handle(frame));
                jvm.remove(jvm.handle(frame));
            }
        }
    }

    // ---- replays

    /** A game with changes before its steps, at an uneven rate of frames. */
    private static void steer(World world, long[] balls, int step) {
        world.setVelocity(balls[step % balls.length], step % 7, 3);
        if (step % 5 == 2) {
            world.teleport(balls[step % 3], 1 + step % 8, 8);
        } else if (step % 9 == 4) {
            world.remove(world.handle(balls.length));
            world.add(9, 1 + step % 5, 0.2f, 1, -3, 0);
        }
    }

    @OnEachBackend
    void aReplayShowsTheSamePicturesAsTheGame(Backend backend) throws IOException {
        int frames = 60;
        float[][] shown = new float[frames][];
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        long steps;
        try (World world = world();
                Recording recording = new Recording(world, log, 1)) {
            long[] balls = new long[4];
            world.addAll(new float[] {1, 1, 0.4f, 1, 3, 1, 0.4f, 2, 5, 1, 0.4f, 3, 7, 1, 0.4f, 4}, balls);
            world.add(9, 9, 0.2f, 1);
            FixedStep loop = new FixedStep(world, STEP);
            int[] step = new int[1];
            Runnable steer = () -> steer(world, balls, step[0]++);
            for (int frame = 0; frame < frames; frame++) {
                loop.advance(seconds(frame), steer);
                shown[frame] = copy(loop);
            }
            steps = recording.steps();
        }
        try (World player = world(backend)) {
            Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), player);
            FixedStep loop = new FixedStep(player, STEP);
            int made = 0;
            for (int frame = 0; frame < frames; frame++) {
                made += loop.advanceReplay(seconds(frame), replay);
                if (made > 0) { // before the first step, the log has not added a circle yet
                    assertThat(copy(loop)).as("frame %d", frame).isEqualTo(shown[frame]);
                }
            }
            assertThat(made).isEqualTo((int) steps);
            assertThat(replay.hasEnded()).isFalse();
            assertThat(loop.advanceReplay(2 * STEP, replay)).isZero();
            assertThat(replay.hasEnded()).isTrue();
            assertThat(replay.differs()).isFalse();
            assertThat(loop.alpha()).isZero();
            assertThat(loop.positions(null)).isEqualTo(player.positionsById(null));
            assertThat(loop.advance(STEP, null)).isOne();
        }
    }

    private static float seconds(int frame) {
        return (1 + frame * 5 % 7) * 0.3f * STEP;
    }

    private static float[] copy(FixedStep loop) {
        FloatBuffer positions = loop.positions(null);
        float[] copy = new float[positions.remaining()];
        positions.get(copy);
        return copy;
    }

    @Test
    void aReplayOfAnotherWorldIsRefused() throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (World world = world();
                World other = world()) {
            new Recording(world, log, 1).close();
            Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), other);
            FixedStep loop = new FixedStep(world, STEP);
            assertIllegalArgument("another world", () -> loop.advanceReplay(STEP, replay));
            assertThat(loop.alpha()).isZero();
        }
    }

    // ---- misuse

    @Test
    void valuesOutOfRangeAreRefused() {
        try (World world = world()) {
            FixedStep loop = new FixedStep(world, STEP);
            for (float bad : new float[] {Float.NaN, -1, Float.POSITIVE_INFINITY}) {
                assertThatIllegalArgumentException().isThrownBy(() -> new FixedStep(world, bad));
                assertThatIllegalArgumentException().isThrownBy(() -> loop.advance(bad, null));
                assertThatIllegalArgumentException().isThrownBy(() -> loop.setSpeed(bad));
            }
            assertThatIllegalArgumentException().isThrownBy(() -> new FixedStep(world, 0));
            assertThatIllegalArgumentException().isThrownBy(() -> loop.setSpeed(1001));
            assertThatIllegalArgumentException().isThrownBy(() -> loop.setMaxSteps(0));
            assertThatIllegalArgumentException().isThrownBy(() -> loop.setMaxSteps(1001));
            world.add(5, 5, 1, 1);
            assertIllegalArgument("living", () -> loop.positions(new long[0]));
            assertThat(loop.positions(new long[1]).remaining()).isEqualTo(2);
        }
    }

    /** A level is built, or the game adds circles, between a step and the picture after it. */
    @OnEachBackend
    void aCircleThatIsNewWhileTheGameIsPausedIsDrawn(Backend backend) {
        try (World world = world(backend)) {
            long old = world.add(5, 5, 1, 1);
            FixedStep loop = new FixedStep(world, STEP);
            loop.radii();
            loop.angles();
            loop.advance(STEP, null);
            for (int k = 1; k <= 70; k++) {
                long late = world.add(3, 3, 0.1f, 1);
                world.setAngle(late, 0.5f);
                FloatBuffer positions = loop.positions(null);
                assertThat(positions.limit()).isEqualTo(2 * world.idLimit());
                assertThat(loop.radii().limit()).isEqualTo(world.idLimit());
                assertThat(loop.angles().limit()).isEqualTo(world.idLimit());
                assertThat(positions.get(2 * World.id(late))).isEqualTo(3);
                assertThat(positions.get(2 * World.id(late) + 1)).isEqualTo(3);
                assertThat(loop.radii().get(World.id(late))).isEqualTo(0.1f);
                assertThat(loop.angles().get(World.id(late))).isEqualTo(world.angle(late));
                assertThat(positions.get(2 * World.id(old))).isEqualTo(5);
                assertThat(loop.radii().get(World.id(old))).isEqualTo(1);
            }
            long[] living = {-1, -1};
            loop.positions(living);
            assertThat(living).containsExactly(-1, (1 << 7) - 1);
            assertThatIllegalArgumentException().isThrownBy(() -> loop.positions(new long[1]));
            loop.advance(STEP, null);
            assertThat(loop.positions(living).get(2 * World.id(world.handle(70))))
                    .isEqualTo(3);
            assertThat(living).containsExactly(-1, (1 << 7) - 1);
            assertThat(loop.radii().get(70)).isEqualTo(0.1f);
            assertThat(loop.angles().get(70)).isCloseTo(0.5f, ROUNDING);
        }
    }

    @Test
    void aClosedWorldIsRefused() {
        World world = world();
        FixedStep loop = new FixedStep(world, STEP);
        world.close();
        assertThatIllegalStateException()
                .isThrownBy(() -> new FixedStep(world, STEP))
                .withMessage("this World has been closed");
        for (float seconds : new float[] {0, STEP / 2, STEP}) {
            assertThatIllegalStateException()
                    .isThrownBy(() -> loop.advance(seconds, null))
                    .withMessage("this World has been closed");
        }
        assertThat(loop.alpha()).isZero();
        assertThatIllegalStateException().isThrownBy(() -> loop.positions(null));
    }

    @Test
    void aRequestOfTheGamesOwnIsReportedAndTheNextStepGoesOn() {
        try (World world = world()) {
            long a = world.add(5, 5, 1, 1);
            FixedStep loop = new FixedStep(world, STEP);
            for (boolean taken : new boolean[] {false, true}) {
                loop.advance(STEP, null);
                if (taken) {
                    loop.positions(null);
                }
                world.requestPositions();
                assertIllegalState("requestPositions", () -> loop.positions(null));
                assertThat(world.takePositions().get(0)).isEqualTo(5);
                assertThatIllegalStateException().isThrownBy(() -> loop.positions(null));
                loop.advance(STEP, null);
                assertThat(x(loop, a)).isEqualTo(5);
            }
        }
    }

    @Test
    void whatAGameThrowsBeforeAStepEndsTheFrameAndTheNextOneGoesOn() {
        try (World world = world()) {
            long a = world.add(5, 5, 1, 1);
            FixedStep loop = new FixedStep(world, STEP);
            loop.advance(0.5f * STEP, null);
            Runnable fails = () -> {
                throw new IllegalStateException("the game's own");
            };
            assertThatIllegalStateException()
                    .isThrownBy(() -> loop.advance(STEP, fails))
                    .withMessage("the game's own");
            assertThat(loop.alpha()).isEqualTo(0.5f);
            assertThat(loop.advance(STEP, null)).isOne();
            assertThat(x(loop, a)).isEqualTo(5);
        }
    }

    @Test
    void bodiesOfTerrainAreOnTheWayFromBeforeTheStepToAfterIt() {
        try (World world = world()) {
            Terrain terrain = world.terrain();
            TerrainBody lift = terrain.addBody(2, 3, 0);
            lift.addSegment(-1, 0, 1, 0);
            terrain.addSegment(0, 1, 9, 1);
            lift.setVelocity(0, 6.4f);
            lift.setAngularVelocity(3.2f);
            FixedStep loop = new FixedStep(world, STEP);
            float[] pose = new float[3];
            float[] pieces = new float[2 * Terrain.PIECE_STRIDE];
            loop.pose(lift, pose);
            assertThat(pose[1]).isEqualTo(3);
            loop.advance(1.25f * STEP, null);
            loop.pose(lift, pose);
            assertThat(pose[0]).isEqualTo(2);
            assertThat(pose[1]).isCloseTo(3.025f, ROUNDING);
            assertThat(pose[2]).isCloseTo(0.0125f, ROUNDING);
            long[] handles = new long[2];
            assertThat(loop.pieces(pieces, handles)).isEqualTo(2);
            assertThat(handles[1]).isEqualTo(terrain.handle(1));
            assertThat(pieces[Terrain.X1]).isCloseTo(2 - (float) Math.cos(0.0125), ROUNDING);
            assertThat(pieces[Terrain.Y1]).isCloseTo(3.025f - (float) Math.sin(0.0125), ROUNDING);
            assertThat(pieces[Terrain.PIECE_STRIDE + Terrain.Y1]).isEqualTo(1);

            // what a call puts elsewhere before a step starts from there; what comes after it is where it is
            loop.advance(STEP, () -> lift.teleport(5, 5, 0));
            TerrainBody late = terrain.addBody(7, 7, 1);
            loop.pose(lift, pose);
            assertThat(pose[1]).isCloseTo(5.025f, ROUNDING);
            loop.pose(late, pose);
            assertThat(pose).containsExactly(7, 7, late.angle());
            lift.remove();
            assertThat(loop.pieces(pieces, handles)).isOne();
            assertThatIllegalArgumentException().isThrownBy(() -> loop.pose(lift, pose));
            assertThatIllegalArgumentException().isThrownBy(() -> loop.pose(late, new float[2]));
            try (World other = world()) {
                assertIllegalArgument("is of another world", () -> new FixedStep(other, STEP).pose(late, pose));
            }
        }
    }

    @Test
    void bodiesCrossTheSeamTheShortWay() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 10, 10)
                .edges(Edge.WRAP, Edge.WALL)
                .build()) {
            TerrainBody cart = world.terrain().addBody(9.95f, 3, 0);
            cart.setVelocity(6.4f, 0);
            FixedStep loop = new FixedStep(world, STEP);
            float[] pose = new float[3];
            loop.pose(cart, pose);
            loop.advance(1.25f * STEP, null);
            loop.pose(cart, pose);
            assertThat(pose[0]).isCloseTo(9.975f, ROUNDING);
            loop.advance(0.5f * STEP, null);
            loop.pose(cart, pose);
            assertThat(pose[0]).isCloseTo(0.025f, ROUNDING);
        }
    }

    // ---- joints

    /** Requires that an end lies at a place. */
    private static void requireEnd(float[] ends, int joint, int end, double x, double y) {
        assertThat((double) ends[4 * joint + 2 * end]).isCloseTo(x, within(1e-5));
        assertThat((double) ends[4 * joint + 2 * end + 1]).isCloseTo(y, within(1e-5));
    }

    @OnEachBackend
    @Tag("long")
    void jointsEndWhereCirclesAndBodiesAreDrawn(Backend backend) {
        try (World world = world(backend)) {
            Joints joints = world.joints();
            TerrainBody lift = world.terrain().addBody(7, 2, 0.5f);
            lift.addSegment(-1, 0, 1, 0);
            lift.setVelocity(0, 6.4f);
            lift.setAngularVelocity(3.2f);
            long a = world.add(2, 6, 0.1f, 1, 6.4f, 0);
            long b = world.add(2, 8, 0.1f, 1, 0, -6.4f);
            long c = world.add(7, 5, 0.1f, 1, -3.2f, 3.2f);
            long[] added = {
                joints.add(a, b, Joint.rope(5)),
                joints.add(a, 1, 1, Joint.rope(9)),
                joints.add(c, lift, -1, 0.25f, Joint.rope(9)),
                joints.add(c, Joint.motor(1, 1)),
            };
            FixedStep loop = new FixedStep(world, STEP);
            float[] ends = new float[16];
            long[] handles = new long[4];
            float[] pose = new float[3];
            loop.jointEnds(ends, null); // from here on the loop keeps poses
            requireEnd(ends, 0, 0, 2, 6);
            for (int frame = 0; frame < 12; frame++) {
                loop.advance(1.375f * STEP, null);
                assertThat(loop.jointEnds(ends, handles)).isEqualTo(4);
                assertThat(handles).isEqualTo(added);
                var shown = loop.positions(null);
                int first = 2 * World.id(a);
                int second = 2 * World.id(b);
                int third = 2 * World.id(c);
                requireEnd(ends, 0, 0, shown.get(first), shown.get(first + 1));
                requireEnd(ends, 0, 1, shown.get(second), shown.get(second + 1));
                requireEnd(ends, 1, 0, shown.get(first), shown.get(first + 1));
                requireEnd(ends, 1, 1, 1, 1);
                loop.pose(lift, pose);
                double cos = Math.cos(pose[2]);
                double sin = Math.sin(pose[2]);
                requireEnd(ends, 2, 0, shown.get(third), shown.get(third + 1));
                requireEnd(ends, 2, 1, pose[0] - cos - 0.25 * sin, pose[1] - sin + 0.25 * cos);
                requireEnd(ends, 3, 0, shown.get(third), shown.get(third + 1));
                requireEnd(ends, 3, 1, shown.get(third), shown.get(third + 1));
            }
            loop.reset();
            float[] now = new float[16];
            joints.readEnds(now);
            loop.jointEnds(ends, null);
            for (int k = 0; k < 16; k++) {
                assertThat(ends[k]).as("element " + k).isCloseTo(now[k], ROUNDING);
            }
        }
    }

    @Test
    void jointsOfNewCirclesEndWhereTheseAreAndThoseOfOldOnesGoAtOnce() {
        try (World world = world()) {
            Joints joints = world.joints();
            long a = world.add(2, 6, 0.1f, 1, 6.4f, 0);
            long b = world.add(2, 8, 0.1f, 1, 6.4f, 0);
            joints.add(a, b, Joint.rope(5));
            FixedStep loop = new FixedStep(world, STEP);
            float[] ends = new float[12];
            loop.advance(1.5f * STEP, null);
            long late = world.add(8, 8, 0.1f, 1);
            long mouse = joints.add(late, 9, 9, Joint.rope(5));
            joints.add(a, late, Joint.rope(9));
            assertThat(loop.jointEnds(ends, null)).isEqualTo(3);
            requireEnd(ends, 0, 0, 2.05, 6);
            requireEnd(ends, 1, 0, 8, 8);
            requireEnd(ends, 1, 1, 9, 9);
            requireEnd(ends, 2, 0, 2.05, 6);
            requireEnd(ends, 2, 1, 8, 8);
            joints.setAnchor(mouse, 9, 5);
            loop.jointEnds(ends, null);
            requireEnd(ends, 1, 1, 9, 5);
            world.remove(b);
            assertThat(loop.jointEnds(ends, null)).isEqualTo(2);
            requireEnd(ends, 0, 1, 9, 5);
            assertIllegalArgument("ends", () -> loop.jointEnds(new float[7], null));
            assertIllegalArgument("handles", () -> loop.jointEnds(ends, new long[1]));
            world.requestPositions();
            assertThatIllegalStateException().isThrownBy(() -> loop.jointEnds(ends, null));
        }
    }

    @Test
    void jointsAcrossTheSeamEndAtTheNearerImage() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 10, 10)
                .edges(Edge.WRAP, Edge.WALL)
                .build()) {
            TerrainBody cart = world.terrain().addBody(9.95f, 3, 0);
            cart.setVelocity(6.4f, 0);
            long ball = world.add(9.5f, 2, 0.1f, 1, 6.4f, 0);
            world.joints().add(ball, cart, 0, 0, Joint.rope(5));
            FixedStep loop = new FixedStep(world, STEP);
            float[] ends = new float[4];
            loop.jointEnds(ends, null);
            loop.advance(1.75f * STEP, null);
            loop.jointEnds(ends, null);
            requireEnd(ends, 0, 0, 9.575, 2);
            requireEnd(ends, 0, 1, 10.025, 3);
        }
    }
}
