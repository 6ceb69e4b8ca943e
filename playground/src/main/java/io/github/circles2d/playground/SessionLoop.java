package io.github.circles2d.playground;

import java.util.ArrayDeque;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Runs a session on a thread for it, sixty frames a second or as often as it can. Commands of other threads wait in a queue until the
 * next frame, so nobody waits for a step.
 */
final class SessionLoop {
    private static final long FRAME_NANOS = 1_000_000_000 / 60;

    /** A pause of the machine is not made up for. */
    private static final float LONGEST_FRAME = 0.1f;

    private final Supplier<Session> opener;
    private final FrameExchange frames = new FrameExchange();
    private final ConcurrentLinkedQueue<Consumer<Session>> commands = new ConcurrentLinkedQueue<>();
    /** Commands for the frame after the next; of the loop's thread alone. */
    private final ArrayDeque<Consumer<Session>> later = new ArrayDeque<>();

    private final CompletableFuture<Void> opened = new CompletableFuture<>();
    private final Thread thread = new Thread(this::run, "circles2d-playground");
    private volatile Runnable onFrame = () -> {};
    private volatile Runnable onEnd = () -> {};
    private volatile boolean stopping;

    /** Opens the session on the thread that uses it. */
    SessionLoop(Supplier<Session> opener) {
        this.opener = opener;
    }

    /** Starts, and waits until the session is open; throws what opening it has thrown. */
    void start() {
        thread.start();
        try {
            opened.join();
        } catch (CompletionException e) {
            if (e.getCause() instanceof RuntimeException failure) {
                throw failure;
            }
            throw e;
        }
    }

    /** Makes it do something before its next frame; may be called by any thread. */
    void ask(Consumer<Session> command) {
        commands.add(command);
    }

    /** The same, but a frame later, so that a line that says what comes is seen while it is done. */
    void askLater(Consumer<Session> command) {
        commands.add(session -> later.add(command));
    }

    /** Is told of each frame, by the thread of the loop; it must return at once. */
    void onFrame(Runnable listener) {
        onFrame = listener;
    }

    /** Is told when the loop has ended, by its thread. */
    void onEnd(Runnable listener) {
        onEnd = listener;
    }

    /** The newest frame, for the one thread that shows frames. */
    Frame latest() {
        return frames.latest();
    }

    void stop() {
        stopping = true;
        LockSupport.unpark(thread);
    }

    void join() throws InterruptedException {
        thread.join();
    }

    private void run() {
        try (Session session = opener.get()) {
            publish(session, 0);
            opened.complete(null);
            run(session);
        } catch (RuntimeException | Error e) {
            if (!opened.completeExceptionally(e)) {
                throw e;
            }
        } finally {
            onEnd.run();
        }
    }

    private void run(Session session) {
        long last = System.nanoTime();
        long due = last;
        while (!stopping) {
            long now = System.nanoTime();
            float seconds = Math.min((now - last) / 1e9f, LONGEST_FRAME);
            last = now;
            while (!later.isEmpty()) {
                session.obey(later.poll());
            }
            for (Consumer<Session> command = commands.poll(); command != null; command = commands.poll()) {
                session.obey(command);
            }
            try {
                publish(session, seconds);
            } catch (RuntimeException | OutOfMemoryError e) {
                session.recover(e);
            }
            due = Math.max(due, now - FRAME_NANOS) + FRAME_NANOS; // a frame that was late does not make all others late
            waitUntil(due);
        }
    }

    private void publish(Session session, float seconds) {
        session.frame(seconds, frames.toFill());
        frames.publish();
        onFrame.run();
    }

    private void waitUntil(long deadline) {
        for (long left = deadline - System.nanoTime(); left > 0 && !stopping; left = deadline - System.nanoTime()) {
            LockSupport.parkNanos(left);
        }
    }
}
