package io.github.circles2d.world.events;

/** The pairs that touch, on a device that decides itself what a step reports of them. */
public interface RemotePairs {
    /** Hands all pairs over, by {@link ContactEvents#receive}; they stay there, too. */
    void fetchAll();

    /** Whether a circle may have pairs there. A device has no room for the ids of circles that have come since its last step. */
    boolean mayKnow(int id);

    /** Hands the pairs of circles over, which it may know; they stay there, too. */
    void fetchOf(int[] ids, int count);

    /** Forgets the pairs of circles that {@link #fetchOf} has made room for. */
    void forgetOf(int[] ids, int count);
}
