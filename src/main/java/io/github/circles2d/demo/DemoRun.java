package io.github.circles2d.demo;

import java.awt.EventQueue;
import java.util.List;
import java.util.function.DoubleConsumer;
import java.util.function.LongSupplier;

/**
 * An engine together with what a person does to it: pause, single step, restart, switch of strategy; and the figures of
 * the overlay.
 *
 * <p>It belongs to one thread, which must not be the event thread: a step may take longer than a person waits for a
 * window.
 */
final class DemoRun {
    /**
     * Weight of the newest time in the running mean that the overlay shows: steady enough to be read at 60 frames a
     * second.
     */
    private static final double NEWEST = 0.1;

    private final Engine engine;
    private final LongSupplier nanoTime;
    private final DoubleConsumer loopTimes;
    private final RateMeter rate = new RateMeter();

    private float[][] circles;
    private long number;
    private long computed;
    private double loopMillis;
    private boolean paused;
    private String trouble = "";

    /**
     * @param nanoTime  the clock, in nanoseconds
     * @param loopTimes told the milliseconds of every call of {@link Engine#loop}
     */
    DemoRun(Engine engine, LongSupplier nanoTime, DoubleConsumer loopTimes) {
        this.engine = engine;
        this.nanoTime = nanoTime;
        this.loopTimes = loopTimes;
        this.circles = engine.circles();
    }

    boolean paused() {
        return paused;
    }

    /** Frames computed so far; a restart does not set it back. */
    long computed() {
        return computed;
    }

    /** Computes one frame, paused or not. */
    void advance() throws EngineException {
        if (EventQueue.isDispatchThread()) {
            throw new IllegalStateException("a simulation step was asked for on the event thread");
        }
        long before = nanoTime.getAsLong();
        circles = engine.loop();
        long after = nanoTime.getAsLong();
        double millis = (after - before) / 1e6;
        loopMillis = loopMillis == 0 ? millis : loopMillis + NEWEST * (millis - loopMillis);
        number++;
        computed++;
        rate.tick(after);
        loopTimes.accept(millis);
    }

    void togglePause() {
        paused = !paused;
        rate.reset();
    }

    /** Computes exactly one frame and waits after it, whether it was running or waiting before. */
    void step() throws EngineException {
        if (!paused) {
            togglePause();
        }
        advance();
        rate.reset();
    }

    /** Goes back to the first frame; a paused simulation stays paused and shows it. */
    void restart() throws EngineException {
        engine.restart();
        circles = engine.circles();
        number = 0;
        trouble = "";
        resetFigures();
    }

    /**
     * Goes on with the strategy of this number; where the engine refuses, the message says why and the old strategy
     * stays.
     */
    void switchTo(int strategy) {
        List<String> known = engine.strategies();
        if (strategy < 0 || strategy >= known.size()) {
            trouble = "no strategy " + strategy + ": there are 0 to " + (known.size() - 1);
            return;
        }
        if (strategy == engine.strategy()) {
            trouble = "";
            return;
        }
        try {
            engine.switchTo(strategy);
            trouble = "";
            resetFigures();
        } catch (EngineException e) {
            trouble = e.getMessage();
        }
    }

    /** The next strategy in turn, the first after the last. */
    void nextStrategy() {
        switchTo((engine.strategy() + 1) % engine.strategies().size());
    }

    DemoFrame frame() {
        return new DemoFrame(
                circles,
                number,
                engine.name(),
                engine.device(),
                engine.strategies().get(engine.strategy()),
                loopMillis,
                rate.perSecond(),
                paused,
                trouble.isEmpty() ? engine.remark() : trouble);
    }

    private void resetFigures() {
        loopMillis = 0;
        rate.reset();
    }
}
