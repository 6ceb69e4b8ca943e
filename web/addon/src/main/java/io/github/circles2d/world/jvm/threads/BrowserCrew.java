package io.github.circles2d.world.jvm.threads;

import java.lang.ref.Cleaner;

/** Takes the place of {@link Crew} in browsers: a team has the caller's thread alone, however many are asked for. */
final class BrowserCrew {
    static final Cleaner CLEANER = Cleaner.create();

    BrowserCrew(int most) {}

    static int possible(int workers) {
        return 1;
    }

    int start(int workers) {
        return 1;
    }

    void run(int workers, Team.Work work) {
        throw new IllegalStateException("a browser has one thread");
    }

    void sync(int worker) {
        throw new IllegalStateException("a browser has one thread");
    }

    void dismiss() {}

    void join() {}
}
