package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import io.github.circles2d.WorldStats;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Where a world is can be seen, and a move is told once. */
class WhereaboutsTest {
    private static WorldStats world(Backend backend, int moves, double millis) {
        return new WorldStats(
                1, 0, 0, 0, 1, 0, 0, 0, 0, Map.of(), backend, "a device", "frames are shorter here", moves, millis);
    }

    @Test
    void aMoveIsToldOnce() {
        Whereabouts where = new Whereabouts();
        where.start(world(Backend.JVM, 0, 0));
        assertThat(where.news(world(Backend.JVM, 0, 0))).isEmpty();
        assertThat(where.news(world(Backend.OPENCL_GPU, 1, 2)))
                .isEqualTo("the world goes on on OPENCL_GPU; the move took 2.0 ms: frames are shorter here");
        assertThat(where.news(world(Backend.OPENCL_GPU, 1, 2))).isEmpty();
        assertThat(where.news(world(Backend.JVM, 2, 5))).contains("on JVM; the move took 3.0 ms");
    }

    @Test
    void aWorldThatMayMoveShowsWhereItIs() {
        assertThat(Whereabouts.words(Backend.AUTO, Backend.JVM)).isEqualTo("AUTO on JVM");
        assertThat(Whereabouts.words(Backend.JVM, Backend.JVM)).isEqualTo("JVM");
    }

    @Test
    void aMoveIsMarkedInTheGraphOfStepTimes() {
        Gauges gauges = new Gauges();
        gauges.noteStep(2, false);
        gauges.noteStep(1, true);
        gauges.noteStep(1, false);
        Frame frame = new Frame();
        gauges.show(frame);
        assertThat(frame.stepTimes).containsExactly(2, 1, 1);
        assertThat(frame.stepMoves).containsExactly(0, 1, 0);
    }

    @Test
    void aWorldByAutoStaysOneWhateverIsDoneWithIt() {
        try (Session session = new Session(Stages.named("empty"), Backend.AUTO)) {
            Frame frame = new Frame();
            session.frame(0.1f, frame);
            assertThat(frame.asked).isEqualTo(Backend.AUTO);
            session.restart();
            session.toggleProfile();
            session.addSubSteps(1);
            session.load(Stages.named("sandbox"));
            session.frame(0.1f, frame);
            assertThat(frame.asked).isEqualTo(Backend.AUTO);
            session.switchTo(Backend.JVM);
            session.frame(0.1f, frame);
            assertThat(frame.asked).isEqualTo(Backend.JVM);
            session.switchTo(Backend.AUTO);
            session.frame(0.1f, frame);
            assertThat(frame.asked).isEqualTo(Backend.AUTO);
            assertThat(frame.message).contains("the same");
        }
    }
}
