package io.github.circles2d.world;

import java.util.ConcurrentModificationException;
import java.util.concurrent.atomic.AtomicReferenceFieldUpdater;

/**
 * Lets one thread at a time use a simulation, until it is closed or its state is lost. A call begins with {@link #enter}, reports
 * what it throws to {@link #failed}, and ends by setting {@link #user} to null.
 */
final class Guard {
    private static final AtomicReferenceFieldUpdater<Guard, Thread> USER =
            AtomicReferenceFieldUpdater.newUpdater(Guard.class, Thread.class, "user");

    private final Pipeline pipeline;

    /**
     * The thread that is inside. A call that ends sets it to null by an assignment and no call, for which the stack may have no
     * room.
     */
    volatile Thread user;

    /** Whether the state is being changed. If it stays true, a change has ended half-way, and the state is lost. */
    boolean changing;

    /** Whether the simulation has been closed. */
    boolean closed;

    /** Why the state is lost; null if it is not. */
    private Throwable failure;

    Guard(Pipeline pipeline) {
        this.pipeline = pipeline;
    }

    /** Begins a call that needs the state. */
    void enter() {
        takeTurn();
        if (!holds()) {
            user = null;
            throw new IllegalStateException(
                    closed ? "this World has been closed" : "this World failed earlier and lost its state", failure);
        }
    }

    /** Whether there is a state. */
    boolean holds() {
        return !closed && !changing && failure == null;
    }

    /** Begins a call, whatever has become of the state. */
    void takeTurn() {
        if (!USER.compareAndSet(this, null, Thread.currentThread())) {
            throw new ConcurrentModificationException("a World is used by one thread at a time, but "
                    + Thread.currentThread().getName() + " came in while another was inside");
        }
    }

    /**
     * Takes note of what a call throws. The state is lost if the call was changing it, or if the pipeline has lost it: a read,
     * too, is told of steps that were enqueued before. It is not lost if a read found too little memory.
     *
     * @param cause what the call throws
     * @return the same
     */
    RuntimeException failed(Throwable cause) {
        if (changing || pipeline.isLostBy(cause)) {
            failure = cause;
        }
        if (cause instanceof Error error) {
            throw error;
        }
        return (RuntimeException) cause;
    }
}
