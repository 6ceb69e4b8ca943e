package io.github.circles2d.world.events;

/** The pairs that touch, on a device that decides itself what a step reports of them. */
public interface RemotePairs {
    /** Hands all pairs over, by {@link ContactEvents#receive}; they stay there, too. */
    void fetchAll();

    /** Hands the pairs of circles over; they stay there, too. */
    void fetchOf(int[] ids, int count);

    /** Forgets the pairs of circles that {@link #fetchOf} has made room for. */
    void forgetOf(int[] ids, int count);
}
