package io.github.circles2d.world.events;

import io.github.circles2d.world.circles.Commands;

/** Where the pairs that touch are: on the host, on a device that decides itself what a step reports of them, or on both. */
final class PairPlace {
    private final TouchTracker tracker;

    /** The pairs on a device; null if there is none that decides. */
    private RemotePairs remote;

    /** Whether all pairs are here; some are not while only a device knows them. */
    private boolean here = true;

    /** Whether all pairs are on the device, as they are here or as its last step left them. */
    private boolean there;

    /** The circles that the commands remove for which there is room, and whose pairs may be elsewhere. */
    private int[] removed = new int[0];

    private int removedCount;

    PairPlace(TouchTracker tracker) {
        this.tracker = tracker;
    }

    /** Sets who decides what happens to pairs; null if the host does. All pairs are here. */
    void setRemote(RemotePairs pairsElsewhere) {
        remote = pairsElsewhere;
        there = false;
    }

    /** Brings all pairs here; they stay on the device, too. */
    void bringHere() {
        if (!here) {
            tracker.clear();
            remote.fetchAll();
            here = true;
        }
    }

    /** Whether all pairs are on the device; else they are here. */
    boolean areThere() {
        return there;
    }

    /** Takes note that the pairs that are here are on the device too. */
    void sent() {
        there = true;
    }

    /** Takes note that a step changes the pairs, which are on the device. */
    void leave() {
        if (here) {
            here = false;
            tracker.clear();
        }
    }

    /** Takes note that pairs are not as the device knows them. */
    void changedHere() {
        there = false;
    }

    /** Takes note that other pairs take the place of all. */
    void replace() {
        here = true;
        there = false;
    }

    /** Brings the pairs here of the circles that commands remove, for which {@link #forgetRemoved} then has room. */
    void fetchOfRemoved(Commands commands) {
        if (removed.length < commands.count()) {
            removed = new int[commands.count() + (commands.count() >> 1)];
        }
        for (int c = 0; c < commands.count(); c++) {
            if (commands.operation(c) == Commands.REMOVE && remote != null && remote.mayKnow(commands.id(c))) {
                removed[removedCount++] = commands.id(c);
            }
        }
        if (!here) {
            tracker.clear();
            if (removedCount > 0) {
                remote.fetchOf(removed, removedCount);
            }
        }
    }

    /** No circle is removed. */
    void keepAll() {
        removedCount = 0;
    }

    /** The device forgets the pairs of the circles that are removed. */
    void forgetRemoved() {
        if (removedCount > 0) {
            if (there) {
                remote.forgetOf(removed, removedCount);
            }
            removedCount = 0;
        }
    }
}
