package io.github.circles2d.world.shared;

import java.util.ConcurrentModificationException;
import java.util.concurrent.atomic.AtomicReferenceFieldUpdater;

/**
 * Lets one thread at a time use a world, until it is closed or its state is lost. Each call of the world goes through {@code read} or
 * {@code change}, which take the call as a function and its values. The function is a constant: it captures nothing, so a call leaves no
 * garbage, and it is linked before memory ends.
 *
 * <p>A few calls have more values than these methods take. They do the same by hand: {@link #enter}, {@link #failed}, {@link #user}.
 */
public final class Guard {
    private static final AtomicReferenceFieldUpdater<Guard, Thread> USER =
            AtomicReferenceFieldUpdater.newUpdater(Guard.class, Thread.class, "user");

    /** Gives an object. */
    @FunctionalInterface
    public interface Read<S, R> {
        R of(S self);
    }

    /** Gives an object for a value. */
    @FunctionalInterface
    public interface ReadWith<S, A, R> {
        R of(S self, A a);
    }

    /** Gives a number, or the bits of one. It may change the state. */
    @FunctionalInterface
    public interface Numbers<S, A> {
        long of(S self, A a, long m, long n);
    }

    /** Changes the state, or fills an array. */
    @FunctionalInterface
    public interface Change<S> {
        void make(S self);
    }

    /** Does so with a value. */
    @FunctionalInterface
    public interface ChangeWith<S, A> {
        void make(S self, A a);
    }

    /** Does so with two values. */
    @FunctionalInterface
    public interface ChangeWithTwo<S, A, B> {
        void make(S self, A a, B b);
    }

    /** Changes a circle. */
    @FunctionalInterface
    public interface CircleChange<S> {
        void make(S self, long handle, int n, float a, float b);
    }

    /** Makes a change that is given by many floats. */
    @FunctionalInterface
    public interface FloatsChange<S> {
        long make(S self, int n, float a, float b, float c, float d, float e, float f);
    }

    private final Pipeline pipeline;

    /** The thread that is inside. A call ends by an assignment, for which a used-up stack still has room. */
    public volatile Thread user;

    /** Whether the state is being changed. If it stays true, a change has ended half-way, and the state is lost. */
    public boolean changing;

    private boolean closed;

    /** Why the state is lost; null if it is not. */
    private Throwable failure;

    public Guard(Pipeline pipeline) {
        this.pipeline = pipeline;
    }

    /** Gives an object that depends on the state. */
    public <S, R> R read(S self, Read<S, R> call) {
        enter();
        try {
            return call.of(self);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /** Gives an object that depends on the state. */
    public <S, A, R> R read(S self, A a, ReadWith<S, A, R> call) {
        enter();
        try {
            return call.of(self, a);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /** Gives a number that depends on the state; values that the call does not have are null or 0. */
    public <S, A> long read(S self, A a, long m, long n, Numbers<S, A> call) {
        enter();
        try {
            return call.of(self, a, m, n);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /** Changes the state, or fills an array. */
    public <S> void change(S self, Change<S> call) {
        enter();
        try {
            call.make(self);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /** Changes the state, or fills an array. */
    public <S, A> void change(S self, A a, ChangeWith<S, A> call) {
        enter();
        try {
            call.make(self, a);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /** Changes the state, or fills arrays. */
    public <S, A, B> void change(S self, A a, B b, ChangeWithTwo<S, A, B> call) {
        enter();
        try {
            call.make(self, a, b);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /** Changes a circle; values that the call does not have are 0. */
    public <S> void change(S self, long handle, int n, float a, float b, CircleChange<S> call) {
        enter();
        try {
            call.make(self, handle, n, a, b);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        } finally {
            user = null;
        }
    }

    /** Changes the state; values that the call does not have are 0. */
    public <S> long change(S self, int n, float a, float b, float c, float d, float e, float f, FloatsChange<S> call) {
        enter();
        try {
            return call.make(self, n, a, b, c, d, e, f);
        } catch (RuntimeException | Error thrown) {
            throw failed(thrown);
        } finally {
            user = null;
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
