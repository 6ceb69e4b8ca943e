package io.github.circles2d.world.shared;

import java.util.ConcurrentModificationException;
import java.util.concurrent.atomic.AtomicReferenceFieldUpdater;

/**
 * Lets one thread at a time use a world, until it is closed or its state is lost. A call that needs the state, reads and changes alike, has
 * this form:
 *
 * <pre>{@code
 * guard.enter();
 * try {
 *     ...
 * } catch (RuntimeException | Error thrown) {
 *     throw guard.failed(thrown);
 * } finally {
 *     guard.user = null;
 * }
 * }</pre>
 *
 * <p>A call that only looks into tables of the host, and cannot fail but for its arguments, {@linkplain #check checks} instead.
 */
public final class Guard {
    private static final AtomicReferenceFieldUpdater<Guard, Thread> USER =
            AtomicReferenceFieldUpdater.newUpdater(Guard.class, Thread.class, "user");

    private final Pipeline pipeline;

    /** The thread that is inside; null if there is none. */
    public volatile Thread user;

    /** Whether the state is being changed. If it stays true, a change has ended half-way, and the state is lost. */
    public boolean changing;

    private boolean closed;

    /** Why the state is lost; null if it is not. */
    private Throwable failure;

    public Guard(Pipeline pipeline) {
        this.pipeline = pipeline;
    }

    /** Does nothing, if a call can be made at all. */
    public void check() {
        enter();
        user = null;
    }

    /** Begins a call that needs the state. */
    public void enter() {
        takeTurn();
        if (!holds()) {
            user = null;
            throw new IllegalStateException(
                    closed ? "this World has been closed" : "this World failed earlier and lost its state", failure);
        }
    }

    /** Whether there is a state. */
    public boolean holds() {
        return !closed && !changing && failure == null;
    }

    /** Begins a call, whatever has become of the state. */
    public void takeTurn() {
        if (!USER.compareAndSet(this, null, Thread.currentThread())) {
            throw new ConcurrentModificationException("a World is used by one thread at a time, but "
                    + Thread.currentThread().getName() + " came in while another was inside");
        }
    }

    /** Ends a call. */
    public void leave() {
        user = null;
    }

    /** From now on no call that needs the state is made. */
    public void close() {
        takeTurn();
        try {
            closed = true;
            pipeline.close();
        } finally {
            user = null;
        }
    }

    /**
     * Takes note of what a call throws, and returns it. The state is lost if the call was changing it, or if the pipeline has lost it:
     * a read, too, is told of steps that were enqueued before. It is not lost if a read found too little memory.
     */
    public RuntimeException failed(Throwable cause) {
        if (changing || pipeline.isLostBy(cause)) {
            failure = cause;
        }
        if (cause instanceof Error error) {
            throw error;
        }
        return (RuntimeException) cause;
    }
}
