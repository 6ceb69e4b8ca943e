package io.github.circles2d.world;

import java.lang.ref.Cleaner;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;

/**
 * The sleeping and waking side of a {@link Team}: its threads, and a barrier for them. Who waits looks again and again, then
 * goes on doing so while it offers the processor to others, then sleeps. Stages are short: to sleep at each barrier would
 * cost more than they do. But where other programs, or more threads than processors, want to run, looking for long keeps
 * those from their work that are waited for: twenty times as many looks made steps of 5,000 circles on two busy processors
 * take twice as long.
 */
final class Crew {
    /** Ends the threads of teams that nobody refers to any more. */
    static final Cleaner CLEANER = Cleaner.create();

    /** How often to look: some microseconds. */
    private static final int LOOKS = 100;

    /** How often to look after that, giving the processor to others in between, before going to sleep. */
    private static final int YIELDS = 200;

    /** Waiting for the others at a barrier. */
    private static final int BARRIER = 0;

    /** Waiting for a run to take part in. */
    private static final int CALL = 1;

    /** Waiting for the others to leave the run. */
    private static final int END = 2;

    private static final AtomicInteger CREWS = new AtomicInteger();

    /** Thrown at a barrier where another worker has failed: unwinds the stack, and nobody outside sees it. */
    private static final class Stopped extends RuntimeException {
        private static final long serialVersionUID = 1;
        private static final Stopped INSTANCE = new Stopped();

        private Stopped() {
            super("another worker failed", null, false, false);
        }
    }

    private final int number = CREWS.incrementAndGet();
    private final int processors = Runtime.getRuntime().availableProcessors();

    /** By worker: its thread; the caller's for worker 0, while there is a run. */
    private final Thread[] threads;

    /** By worker: 1 if it sleeps, or is about to. */
    private final AtomicIntegerArray asleep;

    /** By worker: the number of runs that it was called to. What a run is made of is written before that. */
    private final AtomicIntegerArray called;

    /** Workers that there can be. */
    private int most;

    /** Threads started so far, the caller's included. */
    private int started = 1;

    private Team.Work work;
    private int size;

    /** Workers that have come to the next barrier. */
    private final AtomicInteger arrived = new AtomicInteger();

    /** Barriers passed so far. */
    private volatile int passed;

    /** Workers that have still to leave the run, worker 0 aside. */
    private final AtomicInteger inside = new AtomicInteger();

    /** What the first worker to fail threw. */
    private final AtomicReference<Throwable> failure = new AtomicReference<>();

    private volatile boolean dismissed;

    Crew(int most) {
        this.most = most;
        threads = new Thread[most];
        asleep = new AtomicIntegerArray(most);
        called = new AtomicIntegerArray(most);
    }

    /** See {@link Team#run}; the workers have been started. */
    void run(int workers, Team.Work what) {
        if (dismissed || failure.get() != null) {
            throw new IllegalStateException("the threads of this team have ended", failure.get());
        }
        threads[0] = Thread.currentThread();
        work = what;
        size = workers;
        inside.set(workers - 1);
        for (int worker = 1; worker < workers; worker++) {
            called.incrementAndGet(worker);
            wake(worker);
        }
        work(0);
        await(0, END, 0);
        work = null;
        threads[0] = null;
        if (failure.get() != null) {
            dismiss();
            if (failure.get() instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) failure.get();
        }
    }

    private void work(int worker) {
        try {
            work.run(worker);
        } catch (Stopped e) {
            // the one that failed has said why
        } catch (Throwable t) {
            failure.compareAndSet(null, t);
            for (int other = 0; other < size; other++) {
                wake(other);
            }
        }
    }

    /** See {@link Team#sync}. */
    void sync(int worker) {
        int seen = passed;
        if (failure.get() != null) {
            throw Stopped.INSTANCE;
        }
        if (arrived.incrementAndGet() == size) {
            arrived.set(0);
            passed = seen + 1;
            for (int other = 0; other < size; other++) {
                wake(other);
            }
        } else {
            await(worker, BARRIER, seen);
            if (failure.get() != null) {
                throw Stopped.INSTANCE;
            }
        }
    }

    // ---- waiting
    // -----------------------------------------------------------------------------------------------------

    private void await(int worker, int what, int seen) {
        int looks = size <= processors ? LOOKS : 1;
        for (int k = 0; k < looks; k++) {
            if (isOver(worker, what, seen)) {
                return;
            }
            Thread.onSpinWait();
        }
        for (int k = 0; k < YIELDS; k++) {
            if (isOver(worker, what, seen)) {
                return;
            }
            Thread.yield();
        }
        asleep.set(worker, 1); // before it looks again: who ends the wait looks here after having ended it
        while (!isOver(worker, what, seen)) {
            LockSupport.park(this);
        }
        asleep.set(worker, 0);
    }

    private boolean isOver(int worker, int what, int seen) {
        return switch (what) {
            case BARRIER -> passed != seen || failure.get() != null;
            case CALL -> called.get(worker) != seen || dismissed;
            default -> inside.get() == 0;
        };
    }

    private void wake(int worker) {
        if (asleep.get(worker) != 0) {
            LockSupport.unpark(threads[worker]);
        }
    }

    // ---- threads
    // -----------------------------------------------------------------------------------------------------

    /** Starts threads that are not there yet; returns how many workers there are then, which is fewer if the system refuses. */
    int start(int workers) {
        for (; started < Math.min(workers, most); started++) {
            int worker = started;
            Thread thread = new Thread(null, () -> live(worker), "circles2d-World-" + number + "-" + worker, 0, false);
            thread.setDaemon(true);
            thread.setContextClassLoader(null);
            threads[worker] = thread;
            try {
                thread.start();
            } catch (OutOfMemoryError e) {
                threads[worker] = null;
                most = started;
                return started;
            }
        }
        return Math.min(workers, most);
    }

    /** The life of a worker's thread. */
    private void live(int worker) {
        for (int seen = 0; ; seen++) {
            await(worker, CALL, seen);
            if (dismissed) {
                return;
            }
            work(worker);
            if (inside.decrementAndGet() == 0) {
                wake(0);
            }
        }
    }

    /** Tells the threads to end. */
    void dismiss() {
        dismissed = true;
        for (int worker = 1; worker < threads.length; worker++) {
            LockSupport.unpark(threads[worker]);
        }
    }

    /** Waits for the end of the threads, which have been told to. */
    void join() {
        boolean interrupted = false;
        for (int worker = 1; worker < started; worker++) {
            while (threads[worker].isAlive()) {
                try {
                    threads[worker].join();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
