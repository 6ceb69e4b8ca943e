package io.github.circles2d.world.jvm.threads;

import java.lang.ref.Cleaner;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.locks.LockSupport;

/**
 * The threads of a {@link Team}: how they sleep and wake, and their barrier. A thread that waits first looks again and again, then
 * sleeps. Stages are short, and sleeping at each barrier would cost more than they do. But if other programs, or more threads
 * than processors, want to run, a thread that looks for long uses up its share of a processor. A thread that sleeps keeps it, so
 * the system lets it run soon after it has been woken. No thread yields: one that does is put behind the others, for a whole
 * time slice of theirs at each barrier.
 */
final class Crew {
    /** Ends the threads of teams that nobody refers to any more. */
    static final Cleaner CLEANER = Cleaner.create();

    /** How often to look between two looks at the clock: about a microsecond. */
    private static final int LOOKS = 32;

    /** How long to look before going to sleep: longer than most waits if all threads have a processor. */
    private static final long NANOS_OF_LOOKS = 300_000;

    /** The same between two runs, when the caller may be doing something else. */
    private static final long NANOS_BETWEEN_RUNS = 50_000;

    /** Waiting for the others at a barrier. */
    private static final int BARRIER = 0;

    /** Waiting for a run to take part in. */
    private static final int CALL = 1;

    /** Waiting for the others to leave the run. */
    private static final int END = 2;

    private static final AtomicInteger CREWS = new AtomicInteger();

    /** Thrown at a barrier when the crew has come to its end: unwinds the stack, and nobody outside sees it. */
    private static final class Stopped extends RuntimeException {
        private static final long serialVersionUID = 1;
        private static final Stopped INSTANCE = new Stopped();

        private Stopped() {
            super("the threads were told to end", null, false, false);
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

    /** What a worker threw, {@link Stopped} at the end, or null. It is set by no call: a used-up stack has no room for one. */
    private volatile Throwable end;

    /** The number of workers that there can be if so many are asked for. It is a method because in browsers it is 1. */
    static int possible(int workers) {
        return workers;
    }

    Crew(int most) {
        this.most = most;
        threads = new Thread[most];
        asleep = new AtomicIntegerArray(most);
        called = new AtomicIntegerArray(most);
    }

    /** See {@link Team#run}; the workers have been started. */
    void run(int workers, Team.Work what) {
        if (end != null) {
            throw new IllegalStateException("the threads of this team have ended", end);
        }
        try {
            threads[0] = Thread.currentThread();
            work = what;
            size = workers;
            inside.set(workers - 1);
            for (int worker = 1; worker < workers; worker++) {
                called.incrementAndGet(worker);
                wake(worker);
            }
            what.run(0);
            await(0, END, 0);
        } catch (Throwable t) {
            if (end == null) {
                end = t;
            }
        }
        work = null;
        threads[0] = null;
        if (end != null) {
            wakeAll(threads.length);
            if (end instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) end;
        }
    }

    /** See {@link Team#sync}. */
    void sync(int worker) {
        int seen = passed;
        if (end == null) {
            if (arrived.incrementAndGet() == size) {
                arrived.set(0);
                passed = seen + 1;
                wakeAll(size);
            } else {
                await(worker, BARRIER, seen);
            }
        }
        if (end != null) {
            throw Stopped.INSTANCE;
        }
    }

    // ---- waiting
    // -----------------------------------------------------------------------------------------------------

    private void await(int worker, int what, int seen) {
        if (looks(worker, what, seen)) {
            return;
        }
        long nanos = what == CALL ? NANOS_BETWEEN_RUNS : NANOS_OF_LOOKS;
        long begin = System.nanoTime();
        while (size <= processors && System.nanoTime() - begin < nanos) {
            if (looks(worker, what, seen)) {
                return;
            }
        }
        asleep.set(worker, 1); // before it looks again: who ends the wait looks here after having ended it
        while (!isOver(worker, what, seen)) {
            LockSupport.park(this);
        }
        asleep.set(worker, 0);
    }

    /** Looks some times; returns whether the wait is over. */
    private boolean looks(int worker, int what, int seen) {
        for (int k = 0; k < LOOKS; k++) {
            if (isOver(worker, what, seen)) {
                return true;
            }
            Thread.onSpinWait();
        }
        return false;
    }

    private boolean isOver(int worker, int what, int seen) {
        return end != null
                || switch (what) {
                    case BARRIER -> passed != seen;
                    case CALL -> called.get(worker) != seen;
                    default -> inside.get() == 0;
                };
    }

    private void wakeAll(int workers) {
        for (int worker = 0; worker < workers; worker++) {
            wake(worker);
        }
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
            try {
                Thread thread =
                        new Thread(null, () -> live(worker), "circles2d-World-" + number + "-" + worker, 0, false);
                thread.setDaemon(true);
                thread.setContextClassLoader(null);
                threads[worker] = thread;
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
        try {
            for (int seen = 0; ; seen++) {
                await(worker, CALL, seen);
                if (end != null) {
                    return;
                }
                work.run(worker);
                if (inside.decrementAndGet() == 0) {
                    wake(0);
                }
            }
        } catch (Throwable t) {
            if (end == null) {
                end = t;
            }
            wakeAll(threads.length);
        }
    }

    /** Tells the threads to end, also those in a run that worker 0 has left by an error. */
    void dismiss() {
        if (end == null) {
            end = Stopped.INSTANCE;
        }
        wakeAll(threads.length);
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
