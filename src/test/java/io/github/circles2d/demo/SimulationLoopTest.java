package io.github.circles2d.demo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.EventQueue;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javax.swing.Action;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
@Tag("each-jdk")
class SimulationLoopTest {
    private volatile TestEngine engine;
    private SimulationLoop loop;

    @AfterEach
    void end() throws Exception {
        if (loop != null) {
            loop.stop();
        }
    }

    @Test
    void theEngineIsOpenedUsedAndClosedOnceOnOneThreadThatIsNotTheCallers() throws Exception {
        start(50, 0);
        loop.join();

        assertThat(engine.callers).hasSize(1).doesNotContain(Thread.currentThread());
        assertThat(engine.loops).isEqualTo(50);
        assertThat(engine.closes).isEqualTo(1);
        assertThat(engine.callers.iterator().next().isAlive()).isFalse();
    }

    @Test
    void framesComeInOrderWithNoneLeftOut() throws Exception {
        List<Long> numbers = Collections.synchronizedList(new ArrayList<>());
        CountDownLatch listening = new CountDownLatch(1);
        loop = new SimulationLoop(() -> open(listening), 20, 0, millis -> {});
        loop.onFrame(() -> numbers.add(loop.latest().number()));
        listening.countDown();
        loop.start();
        loop.join();

        assertThat(numbers).first().isEqualTo(0L);
        assertThat(numbers).last().isEqualTo(20L);
        assertThat(numbers).isSorted().doesNotHaveDuplicates();
    }

    @Test
    void stoppingEndsALoopThatRunsAndOneThatIsPaused() throws Exception {
        start(0, 0);
        await(() -> engine.loops > 3);
        loop.stop();
        loop.join();
        assertThat(engine.closes).isEqualTo(1);

        start(0, 0);
        loop.togglePause();
        await(() -> loop.latest().paused());
        loop.stop();
        loop.join();
        assertThat(engine.closes).isEqualTo(1);
    }

    @Test
    void aPausedLoopComputesNothingUntilItIsAskedForAStep() throws Exception {
        start(0, 0);
        loop.togglePause();
        await(() -> loop.latest().paused());
        int before = engine.loops;
        loop.step();
        loop.step();
        loop.restart();
        await(() -> loop.latest().number() == 0);

        assertThat(engine.loops).isEqualTo(before + 2);
    }

    @Test
    void aPausedLoopGoesOnWhenToldTo() throws Exception {
        start(0, 0);
        loop.togglePause();
        await(() -> loop.latest().paused());
        int before = engine.loops;
        loop.togglePause();

        await(() -> engine.loops > before + 5);
    }

    @Test
    void theStrategyIsSwitchedWhileItRuns() throws Exception {
        start(0, 0);
        loop.switchTo(1);
        await(() -> loop.latest().strategy().equals("1 (two)"));
        loop.nextStrategy();
        await(() -> loop.latest().message().equals("strategy 2 does not fit"));

        assertThat(loop.latest().strategy()).isEqualTo("1 (two)");
    }

    @Test
    void aCommandDoesNotWaitForTheEndOfALongFrame() throws Exception {
        start(0, TimeUnit.HOURS.toNanos(1));
        await(() -> engine.loops == 1);
        loop.switchTo(1);

        await(() -> loop.latest().strategy().equals("1 (two)"));
        assertThat(engine.loops).isEqualTo(1);
    }

    @Test
    void aCommandDoesNotShortenTheFrame() throws Exception {
        start(0, TimeUnit.HOURS.toNanos(1));
        await(() -> engine.loops == 1);
        loop.togglePause();
        loop.togglePause();
        loop.switchTo(1);
        await(() -> loop.latest().strategy().equals("1 (two)"));

        assertThat(engine.loops).isEqualTo(1);
    }

    @Test
    void anEngineThatCannotBeOpenedIsTheFailureOfStart() {
        loop = new SimulationLoop(
                () -> {
                    throw new EngineException("no driver", null);
                },
                0,
                0,
                millis -> {});

        assertThatThrownBy(loop::start).isInstanceOf(EngineException.class).hasMessage("no driver");
    }

    @Test
    void anEngineThatIsTooLargeForTheHeapIsTheFailureOfStart() {
        loop = new SimulationLoop(
                () -> {
                    throw new OutOfMemoryError("Java heap space");
                },
                0,
                0,
                millis -> {});
        assertThatThrownBy(loop::start).isInstanceOf(OutOfMemoryError.class);
    }

    @Test
    void anEngineThatFailsOnTheWayIsTheFailureOfJoinAndIsClosed() throws Exception {
        loop = new SimulationLoop(
                () -> {
                    Engine opened = open(new CountDownLatch(0));
                    engine.failAtLoop = 3;
                    return opened;
                },
                0,
                0,
                millis -> {});
        CountDownLatch ended = new CountDownLatch(1);
        loop.onEnd(ended::countDown);
        loop.start();

        assertThatThrownBy(loop::join).isInstanceOf(EngineException.class).hasMessage("the device is gone");
        assertThat(engine.closes).isEqualTo(1);
        assertThat(ended.await(10, TimeUnit.SECONDS)).isTrue();
    }

    @Test
    void noStepEverRunsOnTheEventThreadWhateverKeysArePressedThere() throws Exception {
        start(0, 1_000_000);
        CountDownLatch quit = new CountDownLatch(1);
        SwingUtilities.invokeAndWait(() -> {
            DemoCanvas canvas = new DemoCanvas(loop, 480, true, quit::countDown);
            for (int round = 0; round < 20; round++) {
                for (Object key : canvas.getActionMap().keys()) {
                    Action action = canvas.getActionMap().get(key);
                    action.actionPerformed(new ActionEvent(canvas, ActionEvent.ACTION_PERFORMED, "key"));
                }
            }
        });
        int before = engine.loops;
        loop.step();
        await(() -> engine.loops > before);
        loop.stop();
        loop.join();

        assertThat(EventQueue.isDispatchThread()).isFalse();
        assertThat(engine.calledOnEventThread).isFalse();
        assertThat(engine.callers).hasSize(1);
        assertThat(quit.await(0, TimeUnit.SECONDS)).isTrue();
    }

    @Test
    void theKeysOfTheHelpTextAreBound() {
        start(0, 0);
        DemoCanvas canvas = new DemoCanvas(loop, 480, true, () -> {});
        List<String> bound = new ArrayList<>();
        for (var key : canvas.getInputMap(javax.swing.JComponent.WHEN_IN_FOCUSED_WINDOW)
                .allKeys()) {
            bound.add(key.toString().replace("pressed ", ""));
        }

        assertThat(bound).contains("SPACE", "P", "S", "R", "T", "O", "Q", "ESCAPE", "0", "1", "2", "3", "9");
    }

    private void start(long frames, long frameNanos) {
        loop = new SimulationLoop(() -> open(new CountDownLatch(0)), frames, frameNanos, millis -> {});
        try {
            loop.start();
        } catch (EngineException | InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    private Engine open(CountDownLatch gate) {
        try {
            gate.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
        engine = new TestEngine(TestEngine.scene(10, 1, 1));
        return engine;
    }

    private static void await(BooleanSupplier condition) throws InterruptedException {
        while (!condition.getAsBoolean()) { // the class's time limit ends a wait that lasts for ever
            Thread.sleep(1);
        }
    }
}
