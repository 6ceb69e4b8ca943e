package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Joint;
import io.github.circles2d.Outline;
import io.github.circles2d.Wall;
import io.github.circles2d.World;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The course of time, colours and figures, as a person meets them. */
class PlaygroundSessionTest {
    private static final float FRAME = 1 / 60f;

    private final Session session = new Session(Stages.named("pegs"), Backend.JVM);
    private final Frame frame = new Frame();

    @AfterEach
    void close() {
        session.close();
    }

    private void frames(int count) {
        for (int k = 0; k < count; k++) {
            session.frame(FRAME, frame);
        }
    }

    private int step() {
        return session.sandbox().step();
    }

    @Test
    void slowMotionMakesFewerStepsOfTheSameLengthAndShowsPlacesInBetween() {
        session.slower();
        session.slower();
        frames(40);
        assertThat(step()).isBetween(9, 10);
        long hash = session.world().hash();
        int slowSteps = step();
        try (Sandbox fast = new Sandbox(Stages.named("pegs"), Backend.JVM)) {
            for (int k = 0; k < slowSteps; k++) {
                fast.stepOnce(() -> {});
            }
            assertThat(hash).isEqualTo(fast.world().hash());
        }
        int still = 0;
        float[] before = frame.y.clone();
        for (int k = 0; k < 8; k++) {
            frames(1);
            still += Arrays.equals(before, 0, frame.circles, frame.y, 0, frame.circles) ? 1 : 0;
            before = frame.y.clone();
        }
        assertThat(still).as("frames in which nothing moves").isZero();
    }

    @Test
    void slowMotionGoesDownToASixteenthAndThenBack() {
        for (int k = 0; k < 4; k++) {
            session.slower();
        }
        frames(1);
        assertThat(frame.speed).isEqualTo(1 / 16f);
        session.slower();
        frames(1);
        assertThat(frame.speed).isEqualTo(1);
    }

    @Test
    void aPauseStopsAndAStepIsOneStep() {
        frames(10);
        session.togglePause();
        int paused = step();
        frames(10);
        assertThat(step()).isEqualTo(paused);
        session.stepOnce();
        frames(3);
        assertThat(step()).isEqualTo(paused + 1);
        assertThat(frame.hashStep)
                .as("the hash of a paused world is that of now")
                .isEqualTo(paused + 1);
        session.stepBack();
        frames(1);
        assertThat(step()).isEqualTo(paused);
        assertThat(frame.hash).isEqualTo(session.world().hash());
    }

    @Test
    void timeRunsBackwardsAsFastAsForwardsDownToTheStart() {
        frames(60);
        int most = step();
        session.setRewinding(true);
        frames(20);
        assertThat(most - step()).isBetween(18, 21);
        assertThat(frame.rewinding).isTrue();
        frames(100);
        assertThat(step()).isZero();
        session.setRewinding(false);
        frames(10);
        assertThat(step()).isGreaterThan(5);
    }

    @Test
    void grainsAtRestSleepAndAreDimUntilSleepIsSwitchedOff() {
        session.load(Stages.named("rest"));
        session.frame(0, frame);
        assertThat(frame.circles).isEqualTo(100_001);
        assertThat(frame.awake).isBetween(1, 100);
        assertThat(frame.sleeps).isTrue();
        int asleep = frame.colour[0];
        session.toggleSleep();
        session.frame(0, frame);
        assertThat(frame.sleeps).isFalse();
        assertThat(frame.awake).isEqualTo(100_001);
        assertThat(asleep).isEqualTo(Ramp.mix(Theme.ARENA, frame.colour[0], 0.5));
    }

    @Test
    void aSceneWithoutSleepStartsAgainWithItAndASavedWorldKeepsWhatItIs(@TempDir Path folder) {
        session.load(Stages.named("pyramid"));
        frames(30);
        assertThat(frame.canSleep).isFalse();
        Path file = folder.resolve("pyramid.circles2d");
        session.save(file);
        session.toggleSleep();
        frames(1);
        assertThat(frame.sleeps).isTrue();
        assertThat(step()).isLessThan(2);
        session.restart();
        frames(1);
        assertThat(frame.sleeps).isTrue();
        session.open(file);
        session.toggleSleep();
        frames(1);
        assertThat(frame.canSleep).isFalse();
        assertThat(frame.message).contains("keeps its circles awake");
    }

    @Test
    void whatIsDoneInAPauseIsSeenAtOnce() {
        frames(5);
        session.togglePause();
        frames(1);
        int before = frame.pieces;
        session.setTool(ToolKind.WALL);
        session.press(20, 20);
        for (int x = 21; x <= 40; x++) {
            session.moveMouse(x, 20);
        }
        session.release();
        frames(1);
        int drawn = frame.pieces;
        assertThat(drawn).isGreaterThan(before + 8);
        session.setTool(ToolKind.ERASE);
        session.press(30, 20);
        frames(1);
        assertThat(frame.pieces).isLessThan(drawn).isGreaterThan(before);
    }

    @Test
    void eachModePaintsDifferentlyAndStaticCirclesAlike() {
        frames(120);
        int[][] colours = new int[PaintMode.values().length][];
        for (PaintMode mode : PaintMode.values()) {
            session.setPaint(mode);
            frames(2);
            colours[mode.ordinal()] = Arrays.copyOf(frame.colour, frame.circles);
            assertThat(Arrays.stream(colours[mode.ordinal()]).distinct().count())
                    .as("colours of " + mode)
                    .isGreaterThan(3);
            assertThat(colours[mode.ordinal()]).contains(Theme.STATIC);
        }
        assertThat(colours[0]).isNotEqualTo(colours[1]);
        assertThat(colours[1]).isNotEqualTo(colours[2]);
        assertThat(colours[2]).isNotEqualTo(colours[3]);
    }

    @Test
    void onceTheWorldTurnsEachCircleShowsHowItHasTurned() {
        frames(90);
        assertThat(marked()).isZero();
        session.setFriction(0.4f);
        frames(60);
        assertThat(frame.friction).isEqualTo(0.4f);
        assertThat(marked()).isEqualTo(frame.movable).isLessThan(frame.circles);
        float[] before = frame.angle.clone();
        frames(3);
        int turned = 0;
        for (int k = 0; k < frame.circles; k++) {
            turned += frame.angle[k] != before[k] && frame.angle[k] == frame.angle[k] ? 1 : 0;
        }
        assertThat(turned).as("circles that turn").isGreaterThan(frame.movable / 2);
        session.setPaint(PaintMode.PLAIN);
        frames(1);
        assertThat(marked()).isEqualTo(frame.movable);
    }

    private int marked() {
        int marked = 0;
        for (int k = 0; k < frame.circles; k++) {
            marked += frame.angle[k] == frame.angle[k] ? 1 : 0;
        }
        return marked;
    }

    @Test
    void theSlidersShowTheSurfacesOfTheWorldAlsoBackInTime() {
        frames(10);
        assertThat(frame.friction).isZero();
        session.setFriction(0.5f);
        session.setRollingResistance(0.1f);
        frames(10);
        assertThat(frame.friction).isEqualTo(0.5f);
        assertThat(frame.rollingResistance).isEqualTo(0.1f);
        assertThat(session.world().wallFriction(Wall.MIN_Y)).isEqualTo(0.5f);
        for (int k = 0; k < 15; k++) {
            session.stepBack();
        }
        frames(1);
        assertThat(frame.friction).isZero();
        assertThat(frame.rollingResistance).isZero();
    }

    @Test
    void gravityKeepsItsDirectionAndGoesUpToTwiceThatOfTheScene() {
        frames(1);
        assertThat(frame.gravity).isEqualTo(60);
        assertThat(frame.greatestGravity).isEqualTo(120);
        session.setGravity(15);
        frames(1);
        assertThat(session.world().gravityX()).isZero();
        assertThat(session.world().gravityY()).isEqualTo(-15);
        assertThat(frame.gravity).isEqualTo(15);
        session.setGravity(0);
        session.setGravity(120);
        assertThat(session.world().gravityY()).isEqualTo(-120);
        session.load(Stages.named("gas"));
        session.setGravity(2);
        frames(1);
        assertThat(frame.gravity).as("of a scene that has none").isEqualTo(2);
        assertThat(session.world().gravityY()).isEqualTo(-2);
        assertThat(frame.greatestGravity).isPositive();
    }

    @Test
    void restitutionIsThatOfTheCirclesThatAreThereAndOfThoseToCome() {
        frames(2);
        assertThat(frame.restitution).isEqualTo(0.3f);
        session.setRestitution(0.9f);
        frames(1);
        assertThat(frame.restitution).isEqualTo(0.9f);
        for (int id = 0; id < session.world().idLimit(); id++) {
            long circle = session.world().handle(id);
            assertThat(session.world().restitution(circle)).isEqualTo(0.9f);
        }
        long added = session.world().add(80, 95, 0.7f, 1);
        assertThat(session.world().restitution(added)).isEqualTo(0.9f);
        session.restart();
        frames(1);
        assertThat(frame.restitution).as("of the scene from its start").isEqualTo(0.3f);
    }

    @Test
    void theLegendEndsWithWhatTheLastColourStandsFor() {
        session.setPaint(PaintMode.SPEED);
        frames(1);
        assertThat(frame.legendMost).isEqualTo(session.sandbox().grain().highSpeed());
        session.setPaint(PaintMode.CONTACTS);
        frames(1);
        assertThat(frame.legendMost).isEqualTo(6);
        session.setPaint(PaintMode.PRESSURE);
        frames(120);
        assertThat(frame.legendMost).as("once something presses").isPositive();
    }

    @Test
    void poursCirclesOfTheSizeThatIsSet() {
        session.load(Stages.named("empty"));
        session.setSize(0);
        frames(1);
        assertThat(frame.size).as("not smaller than a quarter").isEqualTo(0.25f);
        session.setSize(3);
        session.setTool(ToolKind.POUR);
        session.press(80, 60);
        frames(10);
        session.release();
        frames(1);
        assertThat(frame.circles).isPositive();
        float usual = session.sandbox().grain().radius();
        for (int k = 0; k < frame.circles; k++) {
            assertThat(frame.radius[k]).isBetween(2.3f * usual, 3.7f * usual);
        }
    }

    @Test
    void aStageThatIsTakenSaysWhatThereIsToSee() {
        for (Stage stage : Stages.all()) {
            assertThat(StageNotes.of(stage.name()))
                    .as(stage.name())
                    .endsWith(".")
                    .hasSizeLessThan(90);
            assertThat(StageNotes.title(stage.name())).matches("[A-Z][\\w' ]+");
            assertThat(Gallery.class.getResource("scenes/" + stage.name() + ".png"))
                    .as(stage.name())
                    .isNotNull();
        }
        assertThat(StageNotes.title("slopes-and-belts")).isEqualTo("Slopes and belts");
        assertThat(StageNotes.title("my-own.circles2d")).as("a file").isEqualTo("my-own.circles2d");
        session.load(Stages.named("drum"));
        frames(1);
        assertThat(frame.message).isEqualTo("A half-full drum with paddles turns.");
    }

    @Test
    void softRingsAreFilledAndTheirSpringsAreHidden() {
        session.load(Stages.named("blobs"));
        frames(1);
        assertThat(frame.blobs.count()).isEqualTo(14);
        assertThat(frame.blobs.from(14)).isEqualTo(frame.circles).isEqualTo(14 * 24);
        assertThat(frame.joints).isZero();
        session.load(Stages.named("cloth"));
        frames(1);
        assertThat(frame.blobs.count()).isZero();
        assertThat(frame.joints).isEqualTo(session.world().joints().size());
    }

    @Test
    void bodiesThatSleepAreDim() {
        try (World world = World.builder()
                .bounds(0, 0, 10, 10)
                .gravity(0, -10)
                .friction(0.5f)
                .sleep(true)
                .build()) {
            world.bodies().add(Outline.box(1, 1), 5, 0.5f, 0, 1);
            FixedStep loop = new FixedStep(world, FRAME);
            BodyShapes bodies = new BodyShapes();
            loop.advance(1.5f * FRAME, () -> {});
            bodies.read(world, loop, new Shades(), PaintMode.PLAIN);
            int awake = bodies.shapes().colour(0);
            for (int frame = 0; frame < 300; frame++) {
                loop.advance(FRAME, () -> {});
            }
            bodies.read(world, loop, new Shades(), PaintMode.PLAIN);
            assertThat(bodies.shapes().colour(0))
                    .isEqualTo(Shades.asleep(awake))
                    .isNotEqualTo(awake);
        }
    }

    @Test
    void bodiesAreDrawnWhereTheyAreAndTheirEnergyCounts() {
        session.load(Stages.named("dominoes"));
        frames(1);
        assertThat(frame.bodies.count()).isEqualTo(66);
        long body = session.world().bodies().handle(0);
        float x = 0;
        float highest = 0;
        for (int k = 0; k < frame.bodies.from(1); k++) {
            x += frame.bodies.x(k) / frame.bodies.from(1);
            highest = Math.max(highest, frame.bodies.y(k));
        }
        assertThat(x).isCloseTo(session.world().bodies().x(body), within(0.1f));
        assertThat(highest).isCloseTo(session.world().bodies().y(body) + 4.5f, within(0.1f));
        double before = frame.energy;
        frames(400);
        assertThat(frame.energy).as("dominoes have fallen").isLessThan(before);
        session.load(Stages.named("pegs"));
        frames(1);
        assertThat(frame.bodies.count()).isZero();
    }

    @Test
    void theJointThatLimitsARopeIsNotDrawnBesideIt() {
        session.load(Stages.named("bridge"));
        frames(1);
        assertThat(frame.joints).isGreaterThan(39);
        for (int k = 0; k < frame.joints; k++) {
            assertThat(Math.hypot(
                            frame.joint[4 * k] - frame.joint[4 * k + 2],
                            frame.joint[4 * k + 1] - frame.joint[4 * k + 3]))
                    .isLessThan(5);
        }
    }

    @Test
    void whatIsRoundedToZeroHasNoSign() {
        assertThat(Figures.format("%.2f, %.2f; %.3g", -0.001, -0.01, -0.0)).isEqualTo("0.00, -0.01; 0.00");
        assertThat(Figures.format("%.0f %.1f", -0.4, -20.0)).isEqualTo("0 -20.0");
    }

    @Test
    void inSlopesAndBeltsBallsRollDownAreCarriedUpAndTheFloorTakesThemToTheRight() {
        session.load(Stages.named("slopes-and-belts"));
        frames(600);
        assertThat(frame.friction).isEqualTo(0.6f);
        assertThat(Arrays.copyOf(frame.pieceColour, frame.pieces)).contains(Theme.BELT, Theme.STATIC);
        int right = 0;
        int low = 0;
        int turning = 0;
        for (int k = 0; k < frame.circles; k++) {
            if (frame.colour[k] != Theme.STATIC && frame.y[k] < 30) {
                low++;
                right += frame.x[k] > 80 ? 1 : 0;
            }
            turning += frame.colour[k] == Theme.STATIC && frame.angle[k] == frame.angle[k] ? 1 : 0;
        }
        assertThat(right).isGreaterThan(low * 3 / 4).isGreaterThan(100);
        assertThat(turning).as("rollers").isEqualTo(7);
        long rightOfTheBelt = session.world().queries().overlapBox(110, 40, 158, 90, new long[0]);
        assertThat(rightOfTheBelt)
                .as("rollers and balls that the belt has carried up")
                .isGreaterThan(20);
        session.setFriction(0);
        frames(1);
        assertThat(session.world().wallBeltSpeed(Wall.MIN_Y)).as("belts stay").isEqualTo(16);
    }

    @Test
    @Tag("long")
    void anHourglassThatIsTurnedOverRunsEmptyAgainAndLosesNoGrain() {
        session.load(Stages.named("hourglass"));
        frames(400);
        int grains = frame.circles;
        assertThat(grains).isGreaterThan(400);
        session.setTool(ToolKind.GRAB);
        for (int turn = 0; turn < 2; turn++) {
            session.press(50, 85);
            session.scaleBrush(12); // notches of 15 degrees
            frames(120);
            assertThat(grainsAbove(50)).as("those that the turn has taken up").isGreaterThan(grains / 2);
            session.release();
            frames(500);
            assertThat(grainsAbove(50)).isZero();
            assertThat(frame.circles).isEqualTo(grains);
            for (int k = 0; k < grains; k++) {
                assertThat(frame.x[k]).isBetween(50f, 110f);
                assertThat(frame.y[k]).isBetween(12f, 50f);
            }
        }
    }

    private int grainsAbove(float height) {
        int count = 0;
        for (int k = 0; k < frame.circles; k++) {
            count += frame.y[k] > height ? 1 : 0;
        }
        return count;
    }

    @Test
    void theMarkIsOnTheSideToWhichTheCircleHasTurned() {
        Frame one = new Frame();
        one.arena = new Arena(0, 0, 100, 100);
        one.ensure(1);
        one.circles = 1;
        one.x[0] = one.y[0] = 50;
        one.radius[0] = 40;
        one.colour[0] = 0xffffff;
        int[][] places = {{130, 100}, {100, 70}, {70, 100}, {100, 130}}; // right, up, left, down
        for (int turned = 0; turned < 4; turned++) {
            one.angle[0] = (float) (turned * Math.PI / 2);
            BufferedImage picture = Playground.picture(one, 200, 200);
            for (int k = 0; k < 4; k++) {
                int expected = k == turned ? Ramp.mark(0xffffff) : 0xffffff;
                assertThat(picture.getRGB(places[k][0], places[k][1]) & 0xffffff)
                        .as("side %d after %d quarters", k, turned)
                        .isEqualTo(expected);
            }
        }
        one.angle[0] = Float.NaN;
        assertThat(Playground.picture(one, 200, 200).getRGB(130, 100) & 0xffffff)
                .isEqualTo(0xffffff);
    }

    @Test
    void theFiguresAreThoseOfTheWorld() {
        frames(30);
        assertThat(frame.stage).isEqualTo("pegs");
        assertThat(frame.backend).isEqualTo(Backend.JVM);
        assertThat(frame.step).isEqualTo(step());
        assertThat(frame.circles).isEqualTo(session.world().size());
        assertThat(frame.stepTimes.length).isBetween(20, 30);
        assertThat(frame.energies.length).isEqualTo(frame.stepTimes.length);
        assertThat(frame.energies[frame.energies.length - 1]).isLessThanOrEqualTo(frame.energies[0] * 1.001f);
        assertThat(frame.energy).isGreaterThan(0);
        frames(2 * History.LENGTH);
        assertThat(frame.stepTimes).hasSize(History.LENGTH);
    }

    @Test
    void aCommandThatFailsIsALineOnTheScreen() {
        session.obey(s -> s.open(Path.of("there-is-no-such-file")));
        frames(1);
        assertThat(frame.message).contains("not done").contains("there-is-no-such-file");
        session.obey(s -> {
            throw new IllegalStateException("first line\nsecond line");
        });
        frames(1);
        assertThat(frame.message).isEqualTo("not done: first line");
        frames(400);
        assertThat(frame.message).isEmpty();
    }

    @Test
    void theHandLetsGoOfThePastAndOfAWorldThatIsSaved(@TempDir Path folder) {
        session.load(Stages.named("marbles"));
        float x = session.world().x(session.world().handle(0));
        float y = session.world().y(session.world().handle(0));
        session.press(x, y);
        frames(5);
        assertThat(frame.joints).isEqualTo(1);
        assertThat(frame.joint[0]).as("an end is where its circle is drawn").isEqualTo(frame.x[0]);
        session.save(folder.resolve("held"));
        frames(5);
        assertThat(frame.joints).isZero();
        for (int k = 0; k < 7; k++) {
            session.stepBack();
            assertThat(session.world().joints().size()).as("step %d", step()).isZero();
        }
        session.open(folder.resolve("held"));
        frames(1);
        assertThat(frame.message).isEqualTo("opened held");
        assertThat(frame.joints).isZero();
    }

    @Test
    void aWorldIsOpenedToTheBitWithJointsWhoseForceHasALimit(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("world");
        World world = session.world();
        long circle = world.add(80, 90, 1, 1);
        world.joints().add(circle, 80, 95, Joint.mouse(4, 1, 50));
        world.joints().add(circle, Joint.friction(1, 1));
        session.save(file);
        long hash = world.hash();
        session.load(Stages.named("empty"));
        session.open(file);
        assertThat(session.world().hash()).isEqualTo(hash);
        session.press(80, 90);
        session.stepOnce();
        session.stepOnce();
        assertThat(session.world().joints().size()).isEqualTo(3);
        session.stepBack();
        assertThat(session.world().joints().size())
                .as("only the hand of then is let go")
                .isEqualTo(2);
        session.release();
        session.switchTo(Backend.JVM);
        session.stepOnce();
        session.stepBack();
        assertThat(session.world().joints().size()).isEqualTo(2);
    }

    @Test
    void jointsThatPullHaveAnotherColourThanLooseOnes() {
        session.load(Stages.named("wrecking-ball"));
        frames(120);
        assertThat(frame.joints).isEqualTo(20);
        assertThat(Arrays.stream(frame.jointColour, 0, 20).distinct().count()).isGreaterThan(1);
    }

    @Test
    void aSwitchSaysThatTheHashIsTheSame() {
        frames(20);
        session.switchTo(Backend.JVM);
        frames(1);
        assertThat(frame.message).contains("JVM goes on from step").endsWith("the same");
    }

    @Test
    void aSwitchWhileTerrainIsHeldLetsItGo() {
        session.load(Stages.named("sandbox"));
        session.press(9, 70.4f); // a ramp
        frames(2);
        assertThat(frame.marks).isNotEmpty();
        session.switchTo(Backend.JVM);
        frames(2);
        assertThat(frame.marks).isEmpty();
        int before = step();
        session.moveMouse(20, 80);
        frames(2);
        assertThat(step()).as("it goes on").isGreaterThan(before);
    }

    @Test
    void afterALostStateTheStageStartsAgain() {
        session.setTool(ToolKind.ROPE);
        session.press(20, 50);
        session.setTool(ToolKind.GRAB);
        session.press(8, 32); // a peg
        frames(20);
        session.world().close();
        session.recover(new IllegalStateException("the device is gone"));
        frames(1);
        assertThat(frame.message).contains("the device is gone");
        assertThat(step()).isLessThan(3);
        assertThat(frame.stage).isEqualTo("pegs");
    }

    @Test
    void ifMemoryIsShortAnEmptyWorldComes() {
        frames(5);
        session.recover(new OutOfMemoryError());
        frames(1);
        assertThat(frame.message).contains("too little memory");
        assertThat(frame.circles).isZero();
    }

    @Test
    void otherSubStepsStartTheSceneAgainAndAnotherSceneHasItsOwn() {
        frames(10);
        session.addSubSteps(2);
        frames(1);
        assertThat(frame.subSteps).isEqualTo(6);
        assertThat(step()).isLessThan(5);
        session.restart();
        frames(1);
        assertThat(frame.subSteps).as("they stay when it starts again").isEqualTo(6);
        session.switchTo(Backend.JVM);
        frames(1);
        assertThat(frame.subSteps).as("and on another back end").isEqualTo(6);
        session.addSubSteps(-20);
        frames(1);
        assertThat(frame.subSteps).isEqualTo(1);
        session.addSubSteps(20);
        frames(1);
        assertThat(frame.subSteps).isEqualTo(16);
        session.load(Stages.named("marbles"));
        frames(1);
        assertThat(frame.subSteps).isEqualTo(4);
    }
}
