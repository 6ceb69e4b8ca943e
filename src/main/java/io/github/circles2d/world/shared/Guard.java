package io.github.circles2d.world.shared;

import java.util.ConcurrentModificationException;
import java.util.concurrent.atomic.AtomicReferenceFieldUpdater;
import java.util.function.Predicate;

/**
 * Lets one thread at a time use a world, until it is closed or its state is lost. A call that needs the state, reads and changes alike, has
 * this form:
 *
 * <pre>{@code
 * guard.enter();
 * try (guard) {
 *     ...
 * }
 * }</pre>
 *
 * <p>A call that only looks into tables of the host, and cannot fail but for its arguments, {@linkplain #check checks} instead.
 */
public final class Guard implements AutoCloseable {
    private static final AtomicReferenceFieldUpdater<Guard, Thread> USER =
            AtomicReferenceFieldUpdater.newUpdater(Guard.class, Thread.class, "user");

    /** The thread that is inside; null if there is none. */
    private volatile Thread user;

    /** Whether the state is being changed. If it stays true, a change has ended half-way, and the state is lost. */
    public boolean changing;

    private boolean closed;

    /** Why the state is lost; null if it is not, or if nobody knows why a change has ended half-way. */
    private Throwable failure;

    /** Says of a failure that has lost the state whether another one may take its place. */
    private final Predicate<Throwable> asked;

    private boolean replaceable;

    Guard(Predicate<Throwable> asked) {
        this.asked = asked;
    }

    /** A device has failed, and with it the state. */
    void lose(Throwable cause) {
        if (failure != cause) {
            failure = cause;
            replaceable = asked.test(cause);
        }
    }

    /** Does nothing, if a call can be made at all. */
    public void check() {
        enter();
        user = null;
    }

    /** Begins a call that needs the state. */
    public void enter() {
        takeTurn();
        requireState(holds());
    }

    /** Begins a call that puts another state in the place of the one that is there, or was lost. {@link #replaced} ends the loss. */
    public void enterToReplace() {
        takeTurn();
        requireState(holds() || !closed && replaceable);
    }

    private void requireState(boolean there) {
        if (!there) {
            user = null;
            String lost = "this World failed earlier and lost its state"
                    + (replaceable ? ": restore a snapshot or a frame, and it goes on on the JVM" : "");
            throw new IllegalStateException(closed ? "this World has been closed" : lost, failure);
        }
    }

    /** Another state has taken the place of all that was. */
    public void replaced() {
        changing = false;
        failure = null;
        replaceable = false;
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

    /** {@link #leave}, at the end of a block. */
    @Override
    public void close() {
        leave();
    }

    /** From now on no call that needs the state is made. */
    public void end() {
        closed = true;
    }

    /** Takes note of what has ended a change half-way, if it has begun, and returns it. */
    public RuntimeException failed(Throwable cause) {
        if (changing) {
            lose(cause);
        }
        if (cause instanceof Error error) {
            throw error;
        }
        return (RuntimeException) cause;
    }
}
