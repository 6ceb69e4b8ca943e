package io.github.circles2d.demo;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.DoubleConsumer;

/**
 * Runs a {@link DemoRun} on a thread of its own, one frame every 17 ms or as often as the engine can, and lets other
 * threads steer it.
 *
 * <p>The engine is opened, used and closed on that thread. Commands wait in a queue and are carried out between two
 * frames, so steering never blocks the caller.
 */
final class SimulationLoop {
    /** The pace of the thesis's test program. */
    static final long FRAME_NANOS = TimeUnit.MILLISECONDS.toNanos(17);

    /** Opens the engine, on the loop's thread. */
    @FunctionalInterface
    interface EngineOpener {
        Engine open() throws EngineException;
    }

    /** What another thread asks of the simulation. */
    @FunctionalInterface
    private interface Command {
        void applyTo(DemoRun simulation) throws EngineException;
    }

    private static final Command WAKE_UP = simulation -> {};

    private final EngineOpener opener;
    private final long frames;
    private final long frameNanos;
    private final DoubleConsumer loopTimes;
    private final BlockingQueue<Command> commands = new LinkedBlockingQueue<>();
    private final CompletableFuture<Void> opened = new CompletableFuture<>();
    private final CompletableFuture<Void> ended = new CompletableFuture<>();
    private final Thread thread = new Thread(this::run, "circles2d-simulation");
    private volatile Runnable onFrame = () -> {};
    private volatile DemoFrame latest;
    private volatile boolean stopping;

    /**
     * @param frames     the loop ends by itself after this many frames; 0: it runs until {@link #stop}
     * @param frameNanos least time from one frame to the next
     * @param loopTimes  told the milliseconds of every call of {@link Engine#loop}, on the loop's thread
     */
    SimulationLoop(EngineOpener opener, long frames, long frameNanos, DoubleConsumer loopTimes) {
        this.opener = opener;
        this.frames = frames;
        this.frameNanos = frameNanos;
        this.loopTimes = loopTimes;
    }

    /** Starts the thread and waits until the engine is open, so that a failure to open it is this call's exception. */
    void start() throws EngineException, InterruptedException {
        thread.start();
        await(opened);
    }

    /**
     * Waits until the loop has ended and the engine is closed; a failure of the engine on the way is this call's
     * exception.
     */
    void join() throws EngineException, InterruptedException {
        await(ended);
        thread.join();
    }

    /** Told, on the loop's thread, after every new frame; it must return at once. */
    void onFrame(Runnable listener) {
        onFrame = listener;
    }

    /** Told, on the loop's thread, when the loop is over and the engine is closed. */
    void onEnd(Runnable listener) {
        ended.whenComplete((nothing, failure) -> listener.run());
    }

    /** The newest frame; never null once {@link #start} has returned. */
    DemoFrame latest() {
        return latest;
    }

    void togglePause() {
        commands.add(DemoRun::togglePause);
    }

    void step() {
        commands.add(DemoRun::step);
    }

    void restart() {
        commands.add(DemoRun::restart);
    }

    void switchTo(int strategy) {
        commands.add(simulation -> simulation.switchTo(strategy));
    }

    void nextStrategy() {
        commands.add(DemoRun::nextStrategy);
    }

    /** Asks the loop to end after the present frame; {@link #join} waits for it. */
    void stop() {
        stopping = true;
        commands.add(WAKE_UP);
    }

    private void run() {
        try {
            try (Engine engine = opener.open()) {
                DemoRun simulation = new DemoRun(engine, System::nanoTime, loopTimes);
                publish(simulation);
                opened.complete(null);
                run(simulation);
            }
            ended.complete(null);
        } catch (Throwable e) { // whatever it is, it belongs to the thread that waits in start or join
            opened.completeExceptionally(e);
            ended.completeExceptionally(e);
        }
    }

    private void run(DemoRun simulation) throws EngineException, InterruptedException {
        while (goesOn(simulation)) {
            long deadline = System.nanoTime() + frameNanos;
            if (!simulation.paused()) {
                simulation.advance();
                publish(simulation);
            }
            obeyUntil(deadline, simulation);
        }
    }

    /**
     * Sleeps what is left of the frame, or for as long as the simulation is paused, and carries out the commands that
     * come in.
     */
    private void obeyUntil(long deadline, DemoRun simulation) throws EngineException, InterruptedException {
        while (goesOn(simulation)) {
            long left = deadline - System.nanoTime();
            Command command =
                    simulation.paused() ? commands.take() : commands.poll(Math.max(left, 0), TimeUnit.NANOSECONDS);
            if (command == null) {
                return;
            }
            command.applyTo(simulation);
            publish(simulation);
        }
    }

    private boolean goesOn(DemoRun simulation) {
        return !stopping && (frames == 0 || simulation.computed() < frames);
    }

    private void publish(DemoRun simulation) {
        latest = simulation.frame();
        onFrame.run();
    }

    private static void await(CompletableFuture<Void> future) throws EngineException, InterruptedException {
        try {
            future.get();
        } catch (ExecutionException e) {
            if (e.getCause() instanceof EngineException failure) {
                throw failure;
            }
            if (e.getCause() instanceof OutOfMemoryError tooLarge) {
                throw tooLarge;
            }
            throw new IllegalStateException("the simulation thread failed", e.getCause());
        }
    }
}
