package io.github.circles2d.world.jvm.threads;

import java.lang.ref.Cleaner;

/**
 * The threads of a step. The caller's thread makes a step's stages one after the other; {@link #all} shares out a stage. A worker is
 * one of the shares, with its own place to work, and not a thread: any thread may do its part. Between two runs the other threads
 * sleep. Nothing here is allocated in a run.
 *
 * <p>Shares are ranges of items, one or several, so the number of workers alone decides which worker does what. The
 * results of the stages do not depend even on that number.
 *
 * <p>The threads know only the {@link Crew}, not this object. So the garbage collector can find a team that nobody refers to any
 * more, and its threads end.
 */
public final class Team implements AutoCloseable {
    /** A stage, or a part of one: what each worker does. */
    public interface Work {
        public void run(int worker);
    }

    /** What each worker does with the items from one to before another, which are its share. */
    public interface Share {
        public void run(int worker, int from, int end);
    }

    /** Rounds in which items are dealt out. More would share them more evenly, but short loops cost more. */
    public static final int ROUNDS = 8;

    private final int most;
    private final Crew crew;

    // the items that are shared out, and what is done with them
    private int items;
    private Share share;
    private final Work doShare = worker -> share.run(worker, part(items, worker), part(items, worker + 1));

    /** Ends the threads; null where there are none. */
    private final Cleaner.Cleanable cleanable;

    private int size = 1;

    /** Whether {@link #all} is done by the caller alone. */
    private boolean few;

    /** Threads beyond the caller's start when they are first needed. */
    public Team(int most) {
        this.most = Crew.possible(most);
        crew = this.most > 1 ? new Crew(this.most) : null;
        cleanable = crew != null ? Crew.CLEANER.register(this, crew::dismiss) : null;
    }

    /** Number of workers of this run, or of the last one. */
    public int size() {
        return size;
    }

    /** Greatest number of workers. */
    public int most() {
        return most;
    }

    /** Where the share of a worker begins, of n equal items; the share of the last ends at part(n, size). */
    public int part(int n, int worker) {
        return (int) ((long) n * worker / size);
    }

    /** Rounds in which items are dealt out whose neighbours are alike, every other round in the opposite order; 1 for one worker. */
    public int rounds() {
        return size == 1 ? 1 : ROUNDS;
    }

    /** Where the piece of a worker in a round begins, of n items. */
    public int from(int n, int worker, int round) {
        return start(n, piece(worker, round));
    }

    /** Where the piece of a worker in a round ends, of n items. */
    public int to(int n, int worker, int round) {
        return start(n, piece(worker, round) + 1);
    }

    /** The number of pieces of all rounds. */
    public int pieces() {
        return rounds() * size;
    }

    /** The number of a worker's piece in a round; pieces follow each other as their items do. */
    public int piece(int worker, int round) {
        return round * size + ((round & 1) == 0 ? worker : size - 1 - worker);
    }

    /** Who has a piece. */
    public int worker(int piece) {
        int place = piece % size;
        return (piece / size & 1) == 0 ? place : size - 1 - place;
    }

    private int start(int n, int piece) {
        return (int) ((long) n * piece / pieces());
    }

    /** Sets whether the stages of {@link #all} are so short that the caller does the parts of all workers, for runs to come. */
    public void setFew(boolean on) {
        few = on;
    }

    /**
     * Runs stages, which call {@link #all}, with so many workers. There are fewer if the system has no more threads or other programs
     * keep the processors busy. What a stage throws is thrown here, as it is; the team is of no use after that.
     */
    public void run(int workers, Runnable stages) {
        size = workers == 1 ? 1 : crew.workers(workers);
        if (size == 1) {
            stages.run();
        } else {
            crew.run(size, stages);
        }
    }

    /** All workers of this run do a stage: each of them sees what any of them did in the stages before. */
    public void all(Work stage) {
        if (few) {
            for (int worker = 0; worker < size; worker++) {
                stage.run(worker);
            }
        } else {
            together(stage);
        }
    }

    /** The same of a stage that is long enough in any case. */
    public void together(Work stage) {
        if (size == 1) {
            stage.run(0);
        } else {
            crew.all(stage);
        }
    }

    /** Shares out so many items; one worker takes all of less than so many for each. */
    public void share(int n, int least, Share work) {
        if (n < least * size) {
            work.run(0, 0, n);
        } else {
            items = n;
            share = work;
            together(doShare);
        }
    }

    /** Ends the threads and waits for their end. May be called again, if it was cut short by an error. */
    @Override
    public void close() {
        if (crew != null) {
            crew.dismiss();
            cleanable.clean();
            crew.join();
        }
    }
}
