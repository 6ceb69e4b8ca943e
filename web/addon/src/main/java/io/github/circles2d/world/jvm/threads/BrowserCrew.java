package io.github.circles2d.world.jvm.threads;

import java.lang.ref.Cleaner;

/** Takes the place of {@link Crew} in browsers: a team has the caller's thread alone, however many are asked for. */
final class BrowserCrew {
    static final Cleaner CLEANER = Cleaner.create();

    BrowserCrew(int most) {}

    static int possible(int workers) {
        return 1;
    }

    int workers(int asked) {
        return 1;
    }

    void run(int workers, Runnable stages) {
        throw new IllegalStateException("a browser has one thread");
    }

    void all(Team.Work stage) {
        throw new IllegalStateException("a browser has one thread");
    }

    void dismiss() {}

    void join() {}
}
