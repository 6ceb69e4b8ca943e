package io.github.circles2d.demo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("each-jdk")
class DemoRunTest {
    private final AtomicLong clock = new AtomicLong();
    private final List<Double> times = new ArrayList<>();
    private final TestEngine engine = new TestEngine(TestEngine.scene(20, 1, 1));
    /** A clock that goes on by 5 ms with each look at it: a frame looks twice. */
    private final DemoRun simulation = new DemoRun(engine, () -> clock.addAndGet(5_000_000), times::add);

    @Test
    void theFirstFrameShowsTheStart() {
        DemoFrame frame = simulation.frame();

        assertThat(frame.number()).isZero();
        assertThat(frame.circles()).isDeepEqualTo(TestEngine.scene(20, 1, 1));
        assertThat(frame.loopMillis()).isZero();
        assertThat(frame.framesPerSecond()).isZero();
        assertThat(engine.loops).isZero();
    }

    @Test
    void eachFrameIsOneCallOfTheEngineAndItsTimeIsTold() throws EngineException {
        for (int k = 0; k < 100; k++) {
            simulation.advance();
        }

        assertThat(engine.loops).isEqualTo(100);
        assertThat(times).hasSize(100).allMatch(millis -> millis == 5);
        assertThat(simulation.frame().number()).isEqualTo(100);
        assertThat(simulation.frame().loopMillis()).isCloseTo(5, within(1e-9));
        assertThat(simulation.frame().framesPerSecond()).isCloseTo(100, within(1e-9));
    }

    @Test
    void aStepComputesOneFrameAndPauses() throws EngineException {
        simulation.step();
        assertThat(simulation.paused()).isTrue();
        simulation.step();

        assertThat(simulation.paused()).isTrue();
        assertThat(engine.loops).isEqualTo(2);
    }

    @Test
    void pausingTwiceGoesOn() {
        simulation.togglePause();
        assertThat(simulation.frame().paused()).isTrue();
        simulation.togglePause();
        assertThat(simulation.frame().paused()).isFalse();
    }

    @Test
    void aPauseDoesNotCountAsASlowFrame() throws EngineException {
        simulation.advance();
        simulation.advance();
        simulation.togglePause();
        clock.addAndGet(60_000_000_000L);
        simulation.togglePause();
        simulation.advance();
        simulation.advance();

        assertThat(simulation.frame().framesPerSecond()).isCloseTo(100, within(1e-9));
    }

    @Test
    void aRestartShowsTheStartAgainAndKeepsPauseAndStrategy() throws EngineException {
        simulation.switchTo(1);
        simulation.step();
        simulation.step();
        simulation.restart();

        DemoFrame frame = simulation.frame();
        assertThat(frame.number()).isZero();
        assertThat(frame.circles()).isDeepEqualTo(TestEngine.scene(20, 1, 1));
        assertThat(frame.paused()).isTrue();
        assertThat(engine.strategy()).isEqualTo(1);
        assertThat(simulation.computed()).as("frames computed, restarts or not").isEqualTo(2);
    }

    @Test
    void aSwitchKeepsTheCirclesAndTheFrameNumberAndStartsTheTimesAnew() throws EngineException {
        simulation.advance();
        DemoFrame before = simulation.frame();
        simulation.switchTo(1);

        DemoFrame after = simulation.frame();
        assertThat(after.strategy()).isEqualTo("1 (two)");
        assertThat(after.message()).isEqualTo("strategy 1 is remarkable");
        assertThat(after.circles()).isSameAs(before.circles());
        assertThat(after.number()).isEqualTo(1);
        assertThat(after.loopMillis()).isZero();
    }

    @Test
    void aRefusedSwitchSaysWhyAndKeepsTheStrategyUntilAnotherOneWorks() {
        simulation.switchTo(TestEngine.REFUSED);
        assertThat(simulation.frame().message()).isEqualTo("strategy 2 does not fit");
        assertThat(engine.strategy()).isZero();

        simulation.switchTo(1);
        assertThat(simulation.frame().message()).isEqualTo("strategy 1 is remarkable");
    }

    @Test
    void aStrategyThatDoesNotExistIsRefused() {
        simulation.switchTo(9);

        assertThat(simulation.frame().message()).isEqualTo("no strategy 9: there are 0 to 2");
        assertThat(engine.strategy()).isZero();
    }

    @Test
    void theNextStrategyAfterTheLastIsTheFirst() throws EngineException {
        Engine three = new TestEngine(TestEngine.scene(1, 1, 1)) {
            @Override
            public void switchTo(int wanted) {
                strategy = wanted;
            }
        };
        DemoRun turning = new DemoRun(three, System::nanoTime, millis -> {});
        List<Integer> seen = new ArrayList<>();
        for (int k = 0; k < 4; k++) {
            turning.nextStrategy();
            seen.add(three.strategy());
        }

        assertThat(seen).containsExactly(1, 2, 0, 1);
    }

    @Test
    void aStepOnTheEventThreadIsRefused() throws Exception {
        AtomicReference<Throwable> thrown = new AtomicReference<>();
        SwingUtilities.invokeAndWait(() -> {
            try {
                simulation.advance();
            } catch (Throwable e) {
                thrown.set(e);
            }
        });

        assertThat(thrown.get()).isInstanceOf(IllegalStateException.class).hasMessageContaining("event thread");
        assertThat(engine.loops).isZero();
    }

    @Test
    void aFailureOfTheEngineComesThrough() {
        engine.failAtLoop = 1;

        assertThatThrownBy(simulation::advance)
                .isInstanceOf(EngineException.class)
                .hasMessage("the device is gone");
    }
}
