package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The times of the stages of a step, which only a world measures whose card is open. */
class StepProfileTest {
    private static final float FRAME = 1 / 60f;

    private final Session session = new Session(Stages.named("pegs"), Backend.JVM);
    private final Frame frame = new Frame();

    @AfterEach
    void close() {
        session.close();
    }

    /** Frames until there are times, or for ten seconds. */
    private void measure() {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(10);
        do {
            session.frame(FRAME, frame);
        } while (frame.profile.isEmpty() && System.nanoTime() < end);
    }

    private static List<String> names(Frame frame) {
        return frame.profile.stream().map(StepProfile.Part::name).toList();
    }

    @Test
    void aWorldIsMeasuredOnlyWhileItsCardIsOpen() {
        session.frame(FRAME, frame);
        assertThat(frame.showsProfile).isFalse();
        assertThat(session.world().stats().stageMillis()).isEmpty();
        session.toggleProfile();
        session.frame(FRAME, frame);
        assertThat(frame.showsProfile).isTrue();
        measure();
        assertThat(names(frame)).containsExactly("grid", "continuous collision", "contacts", "solver");
        double sum =
                frame.profile.stream().mapToDouble(StepProfile.Part::millis).sum();
        assertThat(frame.profile).allMatch(part -> part.millis() >= 0);
        assertThat(sum).isPositive().isLessThan(1000);
        session.toggleProfile();
        session.frame(FRAME, frame);
        assertThat(frame.showsProfile).isFalse();
        assertThat(frame.profile).isEmpty();
        assertThat(session.world().stats().stageMillis()).isEmpty();
    }

    @Test
    void aSingleStepIsSeenAtOnce() {
        session.togglePause();
        session.toggleProfile();
        session.stepOnce();
        session.frame(FRAME, frame);
        assertThat(frame.profile).hasSize(4);
        double stages =
                frame.profile.stream().mapToDouble(StepProfile.Part::millis).sum();
        assertThat(stages).as("no more than the whole step took").isBetween(0.0, frame.stepMillis);
    }

    @Test
    void itChangesNoStepAndStaysOpenInOtherScenes() {
        try (Sandbox unseen = new Sandbox(Stages.named("pegs"), Backend.JVM)) {
            for (int k = 0; k < 60; k++) {
                if (k % 20 == 10) {
                    session.toggleProfile();
                }
                session.stepOnce();
                unseen.stepOnce(() -> {});
            }
            assertThat(session.world().hash()).isEqualTo(unseen.world().hash());
        }
        assertThat(session.sandbox().isProfiling()).isTrue();
        session.load(Stages.named("marbles"));
        session.frame(0, frame);
        assertThat(frame.profile).as("nothing of the scene before").isEmpty();
        session.stepOnce();
        session.frame(0, frame);
        assertThat(frame.profile).hasSize(4);
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.playground.SandboxTest#backends")
    void anotherBackEndHasItsOwnStages(Backend backend) {
        session.toggleProfile();
        session.switchTo(backend);
        measure();
        assertThat(names(frame)).contains("grid", "contacts").doesNotHaveDuplicates();
        assertThat(frame.profile).anyMatch(part -> part.millis() > 0);
        session.toggleProfile();
        assertThat(session.sandbox().stats().backend()).isEqualTo(backend);
        assertThat(session.world().stats().stageMillis()).isEmpty();
    }

    @Test
    void stagesAreWords() {
        assertThat(StepProfile.words("ContinuousCollision")).isEqualTo("continuous collision");
        assertThat(StepProfile.words("Grid")).isEqualTo("grid");
    }

    @Test
    void theCardHasALineForEachStage() {
        session.togglePause();
        session.toggleProfile();
        session.frame(FRAME, frame);
        int empty = ProfileCard.height(frame);
        session.stepOnce();
        session.frame(FRAME, frame);
        assertThat(ProfileCard.height(frame)).isGreaterThan(2 * empty);
    }
}
