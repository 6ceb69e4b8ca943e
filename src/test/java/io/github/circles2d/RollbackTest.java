package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Frames that are made with predictions and again come out as those of a game that knew all inputs. */
class RollbackTest {
    private static final int FRAMES = 150;
    private static final int WINDOW = 8;

    /** The confirmed frames of a game without predictions, which does not use Rollback. */
    private static List<String> straight() {
        return straight(new RollbackGame(Backend.JVM));
    }

    private static List<String> straight(RollbackGame game) {
        SplittableRandom random = new SplittableRandom(42);
        game.random = bound -> (int) ((random.nextLong() >>> 32) * bound >>> 32);
        try (game.world) {
            for (int frame = 0; frame < FRAMES; frame++) {
                game.beforeStep(frame, new long[] {RollbackGame.input(0, frame), RollbackGame.input(1, frame)});
                game.world.step(RollbackGame.STEP);
                Events events = game.world.events();
                game.afterStep(frame, events);
                JointEvents gone = game.world.joints().events();
                game.afterStep(frame, gone);
                BodyEvents touches = game.world.bodies().events();
                game.afterStep(frame, touches);
                game.confirmed(frame, events);
                game.confirmed(frame, gone);
                game.confirmed(frame, touches);
            }
        }
        return game.frames;
    }

    @OnEachBackend
    @Tag("each-jdk")
    void confirmedFramesAreThoseOfAStraightRunOnEveryBackEnd(Backend backend) {
        RollbackGame game = new RollbackGame(backend);
        Rollback rollback = play(game, game, 1, Integer.MAX_VALUE);
        assertThat(game.frames).isEqualTo(straight());
        assertThat(rollback.rollbacks()).isGreaterThan(20);
        assertThat(rollback.repeatedFrames()).isGreaterThan(2 * rollback.rollbacks());
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 5, 6, 7})
    void confirmedFramesAreThoseOfAStraightRunHoweverInputsAreLate(int seed) {
        RollbackGame game = new RollbackGame(Backend.JVM);
        play(game, game, seed, Integer.MAX_VALUE);
        assertThat(game.frames).isEqualTo(straight());
    }

    @Test
    void confirmedFramesAreThoseOfAStraightRunWhileTheWorldMoves() {
        RollbackGame game = new RollbackGame(Backend.JVM);
        RandomMoves moves = RandomMoves.of(game.world, 3, 1);
        play(game, game, 2, Integer.MAX_VALUE);
        assertThat(game.frames).isEqualTo(straight());
        assertThat(moves.moves()).isGreaterThan(20);
    }

    /** Any of its methods throws now and then, when it has begun, or when it is done. */
    @ParameterizedTest
    @ValueSource(ints = {11, 12, 13})
    void aGameThatThrowsLosesNothing(int seed) {
        RollbackGame game = new RollbackGame(Backend.JVM);
        Throwing throwing = new Throwing(game, seed);
        play(game, throwing, seed, 20_000);
        assertThat(game.frames).isEqualTo(straight());
        assertThat(throwing.thrown).isGreaterThan(50);
    }

    @ParameterizedTest
    @ValueSource(ints = {21, 22})
    void jointsThatGoAreToldOfOnceInTheFrameInWhichTheyWent(int seed) {
        JointedGame game = new JointedGame();
        Throwing throwing = new Throwing(game, seed);
        play(game, throwing, seed, 20_000);
        List<String> straight = straight(new JointedGame());
        assertThat(game.frames).isEqualTo(straight);
        assertThat(straight.toString()).contains("BROKEN", "CIRCLE_REMOVED");
        assertThat(throwing.thrown).isGreaterThan(50);
    }

    /** A game with joints, some of which break. */
    private static final class JointedGame extends RollbackGame {
        private int gone;

        JointedGame() {
            super(Backend.JVM);
            world.joints().report(true);
            for (int k = 0; k < 60; k++) {
                world.joints()
                        .add(
                                world.handle(k),
                                world.handle(k + 1 + k % 13),
                                Joint.rope(2 + k % 3).breakingAt(20 + 5 * k, Float.POSITIVE_INFINITY));
            }
        }

        @Override
        public void beforeStep(int frame, long[] inputs) {
            super.beforeStep(frame, inputs);
            for (long input : inputs) {
                long one = world.handle((int) (input % world.idLimit()));
                long other = world.handle((int) (input / 7 % world.idLimit()));
                if (input % 5 == 1) {
                    world.joints().report(input % 3 != 0);
                }
                if (input != 0 && one != 0 && other != 0 && one != other) {
                    world.joints().add(one, other, Joint.spring(2, 0.5f).breakingAt(30 + gone, 9));
                }
            }
        }

        @Override
        public void afterStep(int frame, JointEvents events) {
            gone += events.size();
        }

        @Override
        public void save(ByteBuffer to) {
            super.save(to);
            to.putInt(gone);
        }

        @Override
        public void restore(ByteBuffer from) {
            super.restore(from);
            gone = from.getInt();
        }

        @Override
        public void confirmed(int frame, JointEvents events) {
            for (int i = 0; i < events.size(); i++) {
                frames.add(frame + ": " + events.reason(i) + " " + events.joint(i) + " " + events.circle(i) + " "
                        + events.other(i) + " " + events.force(i) + " " + events.torque(i));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {31, 32})
    void touchesOfBodiesAreToldOfOnceInTheFrameInWhichTheyBeganOrEnded(int seed) {
        BodiesGame game = new BodiesGame();
        Throwing throwing = new Throwing(game, seed);
        play(game, throwing, seed, 20_000);
        List<String> straight = straight(new BodiesGame());
        assertThat(game.frames).isEqualTo(straight);
        assertThat(straight.toString())
                .contains("begin BODY", "end BODY", "begin CIRCLE", "end CIRCLE", "begin WALL", "end WALL");
        assertThat(throwing.thrown).isGreaterThan(50);
    }

    /** A game with bodies, whose touches decide what it does. */
    private static final class BodiesGame extends RollbackGame {
        private int begun;

        BodiesGame() {
            super(Backend.JVM);
            world.bodies().report(true);
            for (int k = 0; k < 12; k++) {
                world.bodies().add(Outline.box(1, 0.5f + 0.1f * k), 2 + 1.5f * k, 18, 0.2f * k, 1);
            }
        }

        @Override
        public void beforeStep(int frame, long[] inputs) {
            super.beforeStep(frame, inputs);
            for (long input : inputs) {
                if (input % 13 == 1) {
                    world.bodies().report(input % 3 != 0);
                }
                if (input != 0) {
                    long body = world.bodies().handle((int) (input % 12));
                    if (body == 0) {
                        world.bodies().add(Outline.box(1, 1), 2 + input % 16, 18, begun, 1);
                    } else if (input % 5 == 1) {
                        world.bodies().remove(body);
                    } else {
                        world.bodies().setVelocity(body, begun % 20 - 10, 12);
                    }
                }
            }
        }

        @Override
        public void afterStep(int frame, BodyEvents touches) {
            for (int i = 0; i < touches.size(); i++) {
                begun += touches.isBegin(i) ? 1 : 0;
            }
        }

        @Override
        public void save(ByteBuffer to) {
            super.save(to);
            to.putInt(begun);
        }

        @Override
        public void restore(ByteBuffer from) {
            super.restore(from);
            begun = from.getInt();
        }

        @Override
        public void confirmed(int frame, BodyEvents touches) {
            for (int i = 0; i < touches.size(); i++) {
                frames.add(frame + ": " + (touches.isBegin(i) ? "begin " : "end ") + touches.partner(i) + " "
                        + touches.body(i) + " " + touches.other(i) + " " + touches.speed(i) + " " + touches.impulse(i));
            }
        }
    }

    /** Plays with a network that delays, repeats and reorders inputs. Calls that a game has made fail are made again. */
    private static Rollback play(RollbackGame game, Rollback.Game rules, int seed, int mostFailures) {
        Random network = new Random(seed);
        Rollback rollback = new Rollback(game.world, rules, RollbackGame.STEP, RollbackGame.PLAYERS, WINDOW);
        rollback.seed(42);
        game.random = rollback::randomInt;
        List<int[]> packets = new ArrayList<>(); // tick of arrival, player, frame
        int failures = 0;
        try (game.world) {
            for (int tick = 0; rollback.confirmedFrames() < FRAMES; tick++) {
                assertThat(tick).isLessThan(mostFailures);
                for (int player = 0; player < RollbackGame.PLAYERS; player++) {
                    for (int copy = 0; copy < 2; copy++) {
                        packets.add(new int[] {tick + network.nextInt(1 + 9 * player), player, tick});
                    }
                }
                for (int[] packet : List.copyOf(packets)) {
                    if (packet[0] <= tick) {
                        rollback.setInput(packet[1], packet[2], RollbackGame.input(packet[1], packet[2]));
                        packets.remove(packet);
                    }
                }
                boolean done = false;
                while (!done) {
                    try {
                        if (rollback.frame() < FRAMES && rollback.frame() <= tick && rollback.canAdvance()) {
                            rollback.advance();
                        } else {
                            rollback.reconcile();
                            done = true;
                        }
                    } catch (Thrown e) {
                        assertThat(failures++).isLessThan(mostFailures);
                    }
                }
            }
            assertThat(rollback.frame()).isEqualTo(FRAMES);
        }
        return rollback;
    }

    private static final class Thrown extends RuntimeException {
        private static final long serialVersionUID = 1;
    }

    private static final class Throwing implements Rollback.Game {
        private final Rollback.Game game;
        private final Random random;
        int thrown;

        Throwing(Rollback.Game game, int seed) {
            this.game = game;
            random = new Random(seed);
        }

        private void mayThrow() {
            if (random.nextInt(25) == 0) {
                thrown++;
                throw new Thrown();
            }
        }

        @Override
        public void beforeStep(int frame, long[] inputs) {
            mayThrow();
            game.beforeStep(frame, inputs);
            mayThrow();
        }

        @Override
        public void afterStep(int frame, Events events) {
            mayThrow();
            game.afterStep(frame, events);
            mayThrow();
        }

        @Override
        public void afterStep(int frame, JointEvents gone) {
            game.afterStep(frame, gone);
            mayThrow();
        }

        @Override
        public void afterStep(int frame, BodyEvents touches) {
            game.afterStep(frame, touches);
            mayThrow();
        }

        @Override
        public void save(ByteBuffer to) {
            mayThrow();
            game.save(to);
            mayThrow();
        }

        @Override
        public void restore(ByteBuffer from) {
            mayThrow();
            game.restore(from);
            mayThrow();
        }

        @Override
        public void confirmed(int frame, Events events) {
            mayThrow();
            game.confirmed(frame, events);
        }

        @Override
        public void confirmed(int frame, JointEvents gone) {
            mayThrow();
            game.confirmed(frame, gone);
        }

        @Override
        public void confirmed(int frame, BodyEvents touches) {
            mayThrow();
            game.confirmed(frame, touches);
        }
    }

    /** A small game for what follows: the inputs of both players add up. */
    private static class Sum implements Rollback.Game {
        final World world = WorldScenes.jvm().build();
        final List<String> calls = new ArrayList<>();
        long sum;

        @Override
        public void beforeStep(int frame, long[] inputs) {
            sum = 10 * sum + inputs[0] + inputs[1];
        }

        @Override
        public void save(ByteBuffer to) {
            to.putLong(sum);
        }

        @Override
        public void restore(ByteBuffer from) {
            sum = from.getLong();
        }

        @Override
        public void confirmed(int frame, Events events) {
            calls.add("confirmed " + frame);
        }

        Rollback rollback(int window) {
            return new Rollback(world, this, 1 / 60f, 2, window);
        }
    }

    @Test
    void anInputThatHasNotComeIsThatOfTheFrameBefore() {
        Sum game = new Sum();
        try (game.world) {
            Rollback rollback = game.rollback(4);
            rollback.advance();
            assertThat(game.sum).as("nothing in frame 0").isZero();
            rollback.setInput(0, 0, 1);
            rollback.setInput(1, 1, 3);
            rollback.advance();
            rollback.advance();
            assertThat(game.sum).isEqualTo(144);
            assertThat(rollback.rollbacks()).isEqualTo(1);
            assertThat(rollback.confirmedFrames()).isZero();
            rollback.setInput(1, 0, 2);
            rollback.setInput(0, 1, 0);
            assertThat(game.sum).as("nothing happens yet").isEqualTo(144);
            rollback.reconcile();
            assertThat(game.sum).isEqualTo(333);
            assertThat(rollback.rollbacks()).isEqualTo(2);
            assertThat(rollback.repeatedFrames()).isEqualTo(1 + 3);
            assertThat(rollback.confirmedFrames()).isEqualTo(2);
            rollback.setInput(0, 2, 0);
            rollback.setInput(1, 2, 3);
            rollback.reconcile();
            assertThat(rollback.rollbacks()).as("it was predicted").isEqualTo(2);
            assertThat(game.calls).containsExactly("confirmed 0", "confirmed 1", "confirmed 2");
            rollback.advance();
            assertThat(game.sum).as("behind frames that are all confirmed").isEqualTo(3333);
        }
    }

    @Test
    void aFrameThatIsTooFarAheadIsRefusedAndMayBeMadeWhenInputsHaveCome() {
        Sum game = new Sum();
        try (game.world) {
            Rollback rollback = game.rollback(2);
            rollback.setInput(0, 0, 5);
            rollback.advance();
            rollback.advance();
            assertThat(rollback.canAdvance()).isFalse();
            assertThatIllegalStateException()
                    .isThrownBy(rollback::advance)
                    .withMessage(
                            "frame 2 would be 2 frames ahead of frame 0, which lacks an input: call canAdvance first");
            rollback.reconcile();
            assertThat(game.sum).isEqualTo(55);
            assertThat(rollback.frame()).isEqualTo(2);
            rollback.setInput(1, 0, 1);
            assertThat(rollback.canAdvance()).isTrue();
            rollback.advance();
            assertThat(game.sum).isEqualTo(666);
            assertThat(rollback.frame()).isEqualTo(3);
        }
    }

    @Test
    void anInputThatCannotBeIsRefusedAndChangesNothing() {
        Sum game = new Sum();
        try (game.world) {
            Rollback rollback = game.rollback(2);
            refused(() -> rollback.setInput(2, 0, 1), "the player is 2, but must be from 0 to 1");
            refused(() -> rollback.setInput(0, -1, 1), "the frame is -1, but must be from 0 to 7");
            refused(() -> rollback.setInput(0, 8, 1), "the frame is 8, but must be from 0 to 7");
            rollback.setInput(0, 7, 1);
            for (int frame = 0; frame < 7; frame++) {
                rollback.setInput(0, frame, 1);
                rollback.setInput(1, frame, 2);
                rollback.advance();
            }
            rollback.reconcile();
            refused(
                    () -> rollback.setInput(0, 7, 2),
                    "player 0 has the input 1 in frame 7 already, and cannot have 2 too");
            refused(() -> rollback.setInput(0, 15, 1), "the frame is 15, but must be from 0 to 14");
            rollback.setInput(0, 7, 1); // once more
            rollback.setInput(0, 3, 99); // of a frame that is confirmed, and counts no more
            rollback.setInput(1, 7, 0);
            rollback.advance();
            assertThat(game.sum).isEqualTo(33333331);
            assertThat(rollback.rollbacks()).isZero();
        }
    }

    private static void refused(ThrowingCallable call, String message) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessage(message);
    }

    @Test
    void valuesOutOfRangeAreRefused() {
        Sum game = new Sum();
        try (game.world) {
            World world = game.world;
            assertIllegalArgument("the time step", () -> new Rollback(world, game, 0, 2, 8));
            assertIllegalArgument("the number of players", () -> new Rollback(world, game, 1, 65, 8));
            assertIllegalArgument("the window", () -> new Rollback(world, game, 1, 1, 0));
        }
    }

    @Test
    void whatIsReportedAndTheHitSpeedComeBackWithAFrame() {
        class Reports extends Sum {
            final long ball = world.add(0.5f, 0.5f, 0.1f, 1, 0, 0);
            final List<Integer> types = new ArrayList<>();

            @Override
            public void beforeStep(int frame, long[] inputs) {
                if (frame == 1 && inputs[0] != 0) {
                    world.report(Events.HIT | Events.WALL);
                    world.reportWalls(1, 0);
                    world.setHitSpeed(1000);
                }
                if (frame == 2) {
                    world.setPosition(ball, 0.1f, 0.5f);
                    world.setVelocity(ball, -1, 0);
                }
            }

            @Override
            public void afterStep(int frame, Events events) {
                for (int i = 0; i < events.size(); i++) {
                    types.add(frame * 10 + events.type(i));
                }
            }
        }
        Reports game = new Reports();
        try (game.world) {
            game.world.reportWalls(0, Events.BEGIN);
            Rollback rollback = game.rollback(8);
            rollback.setInput(0, 0, 1);
            for (int frame = 0; frame < 4; frame++) {
                rollback.advance();
            }
            assertThat(game.types).as("no hit is so fast").isEmpty();
            rollback.setInput(0, 1, 0); // the prediction was wrong: it goes on to report begins of walls
            rollback.reconcile();
            assertThat(game.types).containsExactly(20 + Events.BEGIN);
        }
    }

    @Test
    void whetherBodiesReportComesBackWithAFrameAndTouchesFromBeforeAreDropped() {
        class Reports extends Sum {
            final long body = world.bodies().add(Outline.box(0.1f, 0.1f), 0.04f, 0.5f, 0, 1);
            final List<Integer> begins = new ArrayList<>();

            @Override
            public void beforeStep(int frame, long[] inputs) {
                if (frame == 1 && inputs[0] != 0) {
                    world.bodies().report(false);
                }
                if (frame == 2) {
                    world.bodies().teleport(body, 0.5f, 0.04f, 0);
                }
            }

            @Override
            public void afterStep(int frame, BodyEvents touches) {
                for (int i = 0; i < touches.size(); i++) {
                    if (touches.isBegin(i)) {
                        begins.add(frame);
                    }
                }
            }
        }
        Reports game = new Reports();
        try (game.world) {
            game.world.bodies().report(true);
            game.world.step(1 / 60f); // in the left wall: a begin that nobody takes
            game.world.bodies().teleport(game.body, 0.5f, 0.5f, 0);
            Rollback rollback = game.rollback(8);
            rollback.setInput(0, 0, 1);
            for (int frame = 0; frame < 4; frame++) {
                rollback.advance();
            }
            assertThat(game.begins).as("they are not reported").isEmpty();
            rollback.setInput(0, 1, 0); // the prediction was wrong
            rollback.reconcile();
            assertThat(game.begins).containsExactly(2);
        }
    }

    @Test
    void randomNumbersAreThoseOfTheSeedAndComeBack() {
        class Dice extends Sum {
            Rollback rollback;

            @Override
            public void beforeStep(int frame, long[] inputs) {
                long number = rollback.randomLong();
                for (long k = 0; k < inputs[0]; k++) {
                    rollback.randomFloat(); // a wrong prediction takes more of them
                }
                sum = 31 * sum + number;
            }
        }
        Dice game = new Dice();
        try (game.world) {
            game.rollback = game.rollback(8);
            game.rollback.seed(5);
            game.rollback.setInput(0, 0, 2);
            for (int frame = 0; frame < 4; frame++) {
                game.rollback.advance();
            }
            game.rollback.setInput(0, 1, 0);
            game.rollback.reconcile();
            SplittableRandom random = new SplittableRandom(5);
            long sum = random.nextLong();
            random.nextLong();
            random.nextLong();
            for (int frame = 1; frame < 4; frame++) {
                sum = 31 * sum + random.nextLong();
            }
            assertThat(game.sum).isEqualTo(sum);
            String message = "no frame is being made: random numbers belong into beforeStep and afterStep";
            assertThatIllegalStateException()
                    .isThrownBy(game.rollback::randomLong)
                    .withMessage(message);
            assertThatIllegalStateException()
                    .isThrownBy(() -> game.rollback.seed(1))
                    .withMessage(message);
            assertIllegalArgument("the bound", () -> game.rollback.randomInt(0));
        }
    }

    @Test
    void aMethodOfTheGameMayNotMakeFramesOrGiveInputs() {
        class Nested extends Sum {
            Rollback rollback;
            Runnable call;
            int refusals;

            private void nest() {
                for (Runnable each : new Runnable[] {
                    rollback::advance, rollback::reconcile, () -> rollback.setInput(0, rollback.frame(), 1)
                }) {
                    assertThatIllegalStateException()
                            .isThrownBy(each::run)
                            .withMessage("a method of the game is running: it cannot give inputs or make frames");
                    refusals++;
                }
            }

            @Override
            public void beforeStep(int frame, long[] inputs) {
                nest();
            }

            @Override
            public void afterStep(int frame, Events events) {
                nest();
            }

            @Override
            public void confirmed(int frame, Events events) {
                nest();
            }
        }
        Nested game = new Nested();
        try (game.world) {
            game.rollback = game.rollback(8);
            game.rollback.setInput(0, 0, 1);
            game.rollback.setInput(1, 0, 1);
            game.rollback.advance();
            game.rollback.reconcile();
            assertThat(game.refusals).isEqualTo(9);
        }
    }

    @Test
    void aGameThatDoesNotReadAllThatItWroteIsTold() {
        Sum game = new Sum() {
            @Override
            public void restore(ByteBuffer from) {
                from.getInt();
            }
        };
        try (game.world) {
            Rollback rollback = game.rollback(8);
            rollback.advance();
            rollback.setInput(0, 0, 1);
            assertThatIllegalStateException()
                    .isThrownBy(rollback::reconcile)
                    .withMessage("restore has read 4 of the 8 bytes that save has written");
        }
    }

    @Test
    void aClosedWorldIsRefused() {
        Sum game = new Sum();
        Rollback rollback = game.rollback(8);
        rollback.advance();
        game.world.close();
        assertThatThrownBy(rollback::advance).hasMessage("this World has been closed");
        assertThatThrownBy(rollback::reconcile).hasMessage("this World has been closed");
        assertThatThrownBy(() -> game.rollback(8)).hasMessage("this World has been closed");
        assertThat(rollback.frame()).isEqualTo(1);
    }

    /** Events that nobody has taken when a frame begins would be there the first time, and not when it is made again. */
    @Test
    void eventsOfStepsBetweenFramesAreInNoFrame() {
        List<Integer> sizes = new ArrayList<>();
        Sum game = new Sum() {
            @Override
            public void afterStep(int frame, Events events) {
                sizes.add(events.size());
            }
        };
        try (game.world) {
            game.world.add(0.1f, 0.5f, 0.1f, 1);
            game.world.report(Events.BEGIN | Events.WALL);
            game.world.step(1 / 60f);
            Rollback rollback = game.rollback(8);
            rollback.advance();
            rollback.setInput(0, 0, 1);
            rollback.reconcile();
            assertThat(sizes).containsExactly(0, 0);
        }
    }

    @Test
    void memoryDoesNotGrowWithTime() {
        RollbackGame game = new RollbackGame(Backend.JVM);
        try (game.world) {
            Rollback rollback = new Rollback(game.world, new Forgetful(game), RollbackGame.STEP, 2, WINDOW);
            game.random = rollback::randomInt;
            long bytes = 0;
            for (int frame = 0; frame < 900; frame++) {
                rollback.setInput(0, frame, 0);
                if (frame >= 5) {
                    rollback.setInput(1, frame - 5, frame % 2 << 30);
                }
                rollback.advance();
                if (frame == 600) {
                    bytes = rollback.bytes();
                }
            }
            assertThat(rollback.rollbacks()).isGreaterThan(800);
            assertThat(bytes).isGreaterThan(WINDOW * 33L * game.world.size());
            assertThat(rollback.bytes()).as("a pile may still grow").isLessThan(bytes + bytes / 20);
        }
    }

    /** The same rules, without what is written down. */
    private record Forgetful(RollbackGame game) implements Rollback.Game {
        @Override
        public void beforeStep(int frame, long[] inputs) {
            if (inputs[1] != 0) {
                long[] handles = new long[game.world.size()];
                game.world.readHandles(handles);
                game.world.setVelocity(handles[0], 1, 1);
            }
        }

        @Override
        public void save(ByteBuffer to) {
            game.save(to);
        }

        @Override
        public void restore(ByteBuffer from) {
            game.restore(from);
        }
    }
}
