package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

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
    void whatIsDoneInAPauseIsSeenAtOnce() {
        frames(5);
        session.togglePause();
        frames(1);
        int before = frame.circles;
        session.setTool(ToolKind.WALL);
        session.press(20, 20);
        session.moveMouse(40, 20);
        session.release();
        frames(1);
        assertThat(frame.circles).isGreaterThan(before + 10);
        session.setTool(ToolKind.ERASE);
        session.press(30, 20);
        frames(1);
        assertThat(frame.circles).isLessThan(before + 30).isGreaterThan(before);
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
    void aSwitchSaysThatTheHashIsTheSame() {
        frames(20);
        session.switchTo(Backend.JVM);
        frames(1);
        assertThat(frame.message).contains("JVM goes on from step").endsWith("the same");
    }

    @Test
    void afterALostStateTheStageStartsAgain() {
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
}
