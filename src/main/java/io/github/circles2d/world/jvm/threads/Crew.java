package io.github.circles2d.world.jvm.threads;

import java.lang.ref.Cleaner;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.locks.LockSupport;

/**
 * The threads of a {@link Team}. The caller's thread announces a stage, and each thread claims workers, its own first. So the caller
 * waits only for a thread that is in the middle of a worker's part: it does the part of a thread that has not begun.
 *
 * <p>A thread that waits first looks again and again, then sleeps. Stages are short, and sleeping in each would cost more than they do.
 * But if other programs, or more threads than processors, want to run, a thread that looks for long uses up its share of a processor. A
 * thread that sleeps keeps it, so the system lets it run soon after it has been woken. No thread yields: one that does is put behind the
 * others, for a whole time slice of theirs.
 *
 * <p>If the caller waits for longer than the other threads save, other programs have taken a processor. The caller then goes on alone,
 * and tries again after a pause.
 */
final class Crew {
    /** Ends the threads of teams that nobody refers to any more. */
    static final Cleaner CLEANER = Cleaner.create();

    /** How often to look between two looks at the clock: about a microsecond. */
    private static final int LOOKS = 32;

    /** How long to look before going to sleep: longer than most waits if all threads have a processor. */
    private static final long NANOS_OF_LOOKS = 300_000;

    /** The same of a thread that has looked in vain several times: the caller may wait for the processor on which it looks. */
    private static final long LEAST_NANOS_OF_LOOKS = 5_000;

    /** The same between two runs, when the caller may be doing something else. */
    private static final long NANOS_BETWEEN_RUNS = 50_000;

    /** How long the caller may wait in a run, however short the run is: less than a time slice. */
    private static final long LEAST_PATIENCE = 500_000;

    private static final long SHORTEST_PAUSE = 8_000_000;

    private static final long LONGEST_PAUSE = 1_000_000_000;

    /** How many times as long as the last wait the threads have to work together, or else the next pause is twice as long. */
    private static final int WORTH = 2;

    /** How many times as long as the last wait a pause is at most: tries cost a sixteenth of the time, however busy the machine is. */
    private static final int PAUSE_PER_WAIT = 16;

    /** Ints from a worker's element of {@link #parts} to the next one's, so that they lie in different cache lines. */
    private static final int APART = 32;

    /**
     * What counts as waited for a stage for which threads are woken: the caller may lose its own processor to one. Counted for each of fifteen
     * threads, it would be longer than most steps.
     */
    private static final long NANOS_OF_WAKING = 20_000;

    private static final int ASLEEP = 1;
    private static final int CALLED = 2;

    private static final AtomicInteger CREWS = new AtomicInteger();

    /** Thrown in the caller's thread when the crew has come to its end: unwinds the stack, and nobody outside sees it. */
    private static final class Stopped extends RuntimeException {
        private static final long serialVersionUID = 1;
        private static final Stopped INSTANCE = new Stopped();

        private Stopped() {
            super("the threads were told to end", null, false, false);
        }
    }

    private final int number = CREWS.incrementAndGet();
    private final int processors = Runtime.getRuntime().availableProcessors();

    /** The threads; the caller's is 0, while there is a run. */
    private final Thread[] threads;

    /** By thread: {@link #ASLEEP} if it sleeps or is about to, {@link #CALLED} if another thread has woken it since, else 0. */
    private final AtomicIntegerArray asleep;

    /** By worker: the last stage of which its part is done; 1 more as soon as a thread has claimed the part of the next stage. */
    private final AtomicIntegerArray parts;

    /** Threads that there can be. */
    private int most;

    /** Threads started so far, the caller's included. */
    private int started = 1;

    /** The last stage, an even number. What it is made of is written before that. */
    private volatile int announced;

    private Team.Work work;
    private int size;

    /** How many pauses have ended. */
    private int tries;

    /** Whether another stage is likely to follow soon. */
    private volatile boolean running;

    /** What a thread threw, {@link Stopped} at the end, or null. It is set by no call: a used-up stack has no room for one. */
    private volatile Throwable end;

    // ---- of the caller's thread alone

    /** Whether the caller does what is left of the run alone. */
    private boolean alone;

    /** How long the caller has waited in the run. */
    private long waited;

    /** What counts as waited besides. */
    private long wakes;

    /** How long a run takes without waits. It grows slowly: in some runs the caller's thread itself loses its processor. */
    private long usual = Long.MAX_VALUE >> 1;

    /** How long the runs since the last pause would have taken if all had been as usual. */
    private long together;

    /** Whether there is a pause, when it began, and how long it or the last one is. */
    private boolean pausing;

    private long pausedAt;

    private long pause;

    /** The number of workers that there can be if so many are asked for. It is a method because in browsers it is 1. */
    static int possible(int workers) {
        return workers;
    }

    Crew(int most) {
        this.most = most;
        threads = new Thread[most];
        asleep = new AtomicIntegerArray(most);
        parts = new AtomicIntegerArray(APART * (most + 1));
    }

    // ---- the caller

    /** How many workers a run has if so many are asked for: 1 in a pause, and fewer if the system has no more threads. */
    int workers(int asked) {
        if (end != null) {
            throw new IllegalStateException("the threads of this team have ended", end);
        }
        if (pausing && System.nanoTime() - pausedAt < pause) {
            return 1;
        }
        if (pausing) {
            pausing = false;
            together = 0;
            tries++;
        }
        return start(asked);
    }

    /** See {@link Team#run}; there are as many threads as workers. */
    void run(int workers, Runnable stages) {
        long begun = System.nanoTime();
        try {
            threads[0] = Thread.currentThread();
            begin(workers);
            stages.run();
        } catch (Throwable t) {
            if (end == null) {
                end = t;
            }
        }
        running = false;
        work = null;
        threads[0] = null;
        if (end != null) {
            wakeAll(threads.length);
            if (end instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) end;
        }
        usual = Math.min(System.nanoTime() - begun - waited, 2 * usual);
        together += usual;
    }

    /** Leaves out a stage: so a thread that is late for the last run claims no worker that took no part in it. */
    private void begin(int workers) {
        int before = announced + 2;
        for (int worker = 0; worker < workers; worker++) {
            parts.set(place(worker), before);
        }
        size = workers;
        alone = false;
        waited = 0;
        wakes = 0;
        running = true;
        announced = before;
    }

    /** See {@link Team#all}. */
    void all(Team.Work stage) {
        if (alone) {
            for (int worker = 0; worker < size; worker++) {
                stage.run(worker);
            }
            return;
        }
        int now = announced + 2;
        work = stage;
        announced = now;
        wakes += wakeAll(size) ? NANOS_OF_WAKING : 0;
        for (int worker = 0; worker < size; worker++) {
            if (claims(worker, now)) {
                stage.run(worker);
                parts.lazySet(place(worker), now);
            }
        }
        for (int worker = 0; worker < size; worker++) {
            awaitPart(worker, now);
        }
        if (end != null) {
            throw Stopped.INSTANCE;
        }
        if (waited + wakes > Math.max(LEAST_PATIENCE, (size - 1) * usual)) {
            pause();
        }
    }

    private void awaitPart(int worker, int stage) {
        if (!looks(0, worker, stage)) {
            long begin = System.nanoTime();
            await(0, worker, stage, NANOS_OF_LOOKS);
            waited += System.nanoTime() - begin;
        }
    }

    private void pause() {
        alone = true;
        running = false;
        pausing = true;
        pausedAt = System.nanoTime();
        long lost = waited + wakes;
        long longest = Math.max(SHORTEST_PAUSE, Math.min(LONGEST_PAUSE, PAUSE_PER_WAIT * lost));
        pause = together > WORTH * lost ? SHORTEST_PAUSE : Math.min(longest, Math.max(SHORTEST_PAUSE, 2 * pause));
    }

    // ---- parts

    private static int place(int worker) {
        return APART * (worker + 1);
    }

    private boolean claims(int worker, int stage) {
        int place = place(worker);
        return parts.get(place) == stage - 2 && parts.compareAndSet(place, stage - 2, stage - 1);
    }

    /** The life of a thread. */
    private void live(int thread) {
        try {
            long nanos = NANOS_OF_LOOKS;
            int seen = 0;
            for (int stage = 0; ; ) {
                boolean slept = await(thread, 0, stage, nanos);
                nanos = slept ? Math.max(LEAST_NANOS_OF_LOOKS, nanos / 2) : Math.min(NANOS_OF_LOOKS, 2 * nanos);
                if (end != null) {
                    return;
                }
                stage = announced;
                if (seen != tries) { // who goes on with short looks sleeps in most stages, also on an idle machine
                    seen = tries;
                    nanos = NANOS_OF_LOOKS;
                }
                int workers = size;
                // A thread that was late for the last run may be none of this one's.
                int own = thread < workers ? thread : 0;
                for (int k = 0; k < workers; k++) {
                    int worker = own + k < workers ? own + k : own + k - workers;
                    if (claims(worker, stage)) {
                        work.run(worker);
                        parts.set(place(worker), stage);
                        wake(0);
                    }
                }
            }
        } catch (Throwable t) {
            if (end == null) {
                end = t;
            }
            wakeAll(threads.length);
        }
    }

    // ---- waiting

    /**
     * The caller's thread waits for a worker's part of a stage, another thread for the stage behind one; nanos: how long to look before
     * going to sleep. Returns whether it slept.
     */
    private boolean await(int thread, int worker, int stage, long nanos) {
        if (looks(thread, worker, stage)) {
            return false;
        }
        long begin = System.nanoTime();
        while (size <= processors
                && System.nanoTime() - begin < (running ? nanos : Math.min(nanos, NANOS_BETWEEN_RUNS))) {
            if (looks(thread, worker, stage)) {
                return false;
            }
        }
        asleep.set(thread, ASLEEP); // before it looks again: who ends the wait looks here after having ended it
        while (!isOver(thread, worker, stage)) {
            LockSupport.park(this);
            asleep.set(thread, ASLEEP);
        }
        asleep.set(thread, 0);
        return true;
    }

    /** Looks some times; returns whether the wait is over. */
    private boolean looks(int thread, int worker, int stage) {
        for (int k = 0; k < LOOKS; k++) {
            if (isOver(thread, worker, stage)) {
                return true;
            }
            Thread.onSpinWait();
        }
        return false;
    }

    private boolean isOver(int thread, int worker, int stage) {
        return end != null || (thread == 0 ? parts.get(place(worker)) == stage : announced != stage && thread < size);
    }

    /** Returns whether one of the threads has been asleep. */
    private boolean wakeAll(int many) {
        boolean woken = false;
        for (int thread = 0; thread < many; thread++) {
            woken |= wake(thread);
        }
        return woken;
    }

    private boolean wake(int thread) {
        boolean wakes = asleep.get(thread) == ASLEEP && asleep.compareAndSet(thread, ASLEEP, CALLED);
        if (wakes) {
            LockSupport.unpark(threads[thread]);
        }
        return wakes;
    }

    // ---- threads

    /** Starts threads that are not there yet; returns how many there are then, which is fewer if the system refuses. */
    private int start(int many) {
        for (; started < Math.min(many, most); started++) {
            int next = started;
            try {
                Thread thread = new Thread(null, () -> live(next), "circles2d-World-" + number + "-" + next, 0, false);
                thread.setDaemon(true);
                thread.setContextClassLoader(null);
                threads[next] = thread;
                thread.start();
            } catch (OutOfMemoryError e) {
                threads[next] = null;
                most = started;
                return started;
            }
        }
        return Math.min(many, most);
    }

    /** Tells the threads to end, also those in a run that the caller has left by an error. */
    void dismiss() {
        if (end == null) {
            end = Stopped.INSTANCE;
        }
        wakeAll(threads.length);
    }

    /** Waits for the end of the threads, which have been told to. */
    void join() {
        boolean interrupted = false;
        for (int thread = 1; thread < started; thread++) {
            while (threads[thread].isAlive()) {
                try {
                    threads[thread].join();
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
