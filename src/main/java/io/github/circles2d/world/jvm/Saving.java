package io.github.circles2d.world.jvm;

import io.github.circles2d.world.circles.SavedCircles;
import io.github.circles2d.world.jvm.state.ImpulseCache;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.snapshots.SavedState;

/** Saves circles and the impulses that the next step starts from; many circles by several threads. */
final class Saving {
    private final State state;
    private final ImpulseCache impulses;
    private final Team team;
    private final Runnable counts = this::countAll;
    private final Runnable copies = this::copyAll;
    private final Team.Work count = this::count;
    private final Team.Work copy = this::copy;

    /** By part of the circles: how many impulses it has, then where the first of them goes. */
    private final int[] places = new int[SavedCircles.PARTS];

    private SavedState into;

    /** Whether {@link #places} have the numbers of impulses. */
    private boolean counted;

    Saving(State state, ImpulseCache impulses, Team team) {
        this.state = state;
        this.impulses = impulses;
        this.team = team;
    }

    /** Saves the circles whose ids are given, by at most so many threads. */
    void save(SavedState to, int workers) {
        into = to;
        if (workers < JvmPipeline.LEAST_SAVERS || state.sleepers != null) {
            saveAlone();
        } else {
            team.run(workers, counts);
            if (counted) {
                into.placeImpulses(places); // here, since a team is of no use after an error in a run
                team.run(workers, copies);
            }
        }
        into = null;
    }

    private void saveAlone() {
        into.impulses = 0;
        saveRows(0, into.circles);
        if (state.sleepers == null) {
            if (into.normalImpulse.length == 0) {
                into.ensureImpulses(count(0, into.circles)); // memory that grew bit by bit would be copied
            }
            into.impulses = saveImpulses(0, into.circles, 0);
            return;
        }
        int slot = -1;
        for (int k = 0; k < into.circles; k++) {
            slot = slot(slot, k);
            into.impulses = impulses.save(slot, into, into.impulses);
            state.sleepers.saveImpulses(into.id[k], into);
        }
    }

    /** How many impulses a range of circles has. */
    private int count(int from, int to) {
        int sum = 0;
        int slot = -1;
        for (int k = from; k < to; k++) {
            slot = slot(slot, k);
            sum += impulses.count(slot);
        }
        return sum;
    }

    /** Saves the impulses of a range of circles from a place on, and returns the place behind them. */
    private int saveImpulses(int from, int to, int place) {
        int at = place;
        int slot = -1;
        for (int k = from; k < to; k++) {
            slot = slot(slot, k);
            at = impulses.save(slot, into, at);
        }
        return at;
    }

    /** The slot of circle k: mostly that behind the slot of the circle before, where a processor finds it at once. */
    private int slot(int before, int k) {
        int next = before + 1;
        return next < state.n && state.id[next] == into.id[k] ? next : state.slotOf[into.id[k]];
    }

    /** Circles whose slots follow each other, as most do on the way to another pipeline, are copied at once. */
    private void saveRows(int from, int to) {
        for (int k = from; k < to; ) {
            int slot = state.slotOf[into.id[k]];
            int count = 1;
            while (k + count < to && slot + count < state.n && state.id[slot + count] == into.id[k + count]) {
                count++;
            }
            state.save(slot, into, k, count);
            k += count;
        }
    }

    /** Saves all at once if other programs keep the processors busy. */
    private void countAll() {
        counted = team.size() >= JvmPipeline.LEAST_SAVERS;
        if (counted) {
            team.all(count);
        } else {
            saveAlone();
        }
    }

    private void copyAll() {
        team.all(copy);
    }

    private void count(int worker) {
        for (int part = worker; part < SavedCircles.PARTS; part += team.size()) {
            places[part] = count(into.part(part), into.part(part + 1));
        }
    }

    private void copy(int worker) {
        for (int part = worker; part < SavedCircles.PARTS; part += team.size()) {
            int from = into.part(part);
            int to = into.part(part + 1);
            saveRows(from, to);
            saveImpulses(from, to, places[part]);
        }
    }
}
