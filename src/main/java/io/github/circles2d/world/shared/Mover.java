package io.github.circles2d.world.shared;

import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.snapshots.SavedState;

/** Decides where a world that moves makes its steps. The world's thread calls it, but for what it does beside. */
public interface Mover extends AutoCloseable {
    /**
     * Returns who makes the next steps: the pipeline that made the last ones, or another, which is ready and which nobody else uses.
     *
     * @param now who made the last ones
     * @param wanted what the next steps need
     * @param circles how many there are
     * @param awake about how many of them are awake
     * @param nanos what the last step and the reads behind it have taken; 0 if not known
     */
    Pipeline choose(Pipeline now, Readiness wanted, int circles, int awake, double nanos);

    /** Whether steps that have been asked for are waited for before the next call of {@link #choose}: a device has made them then, and its time counts. */
    default boolean settles() {
        return false;
    }

    /** The pipeline that takes any world without compiling anything. */
    Pipeline home();

    /** Whether a pipeline is {@link #home}, without making one. */
    boolean isHome(Pipeline pipeline);

    /** The world has moved. cause: why it had to; null if this object chose so. */
    void moved(Pipeline from, Pipeline to, long nanos, Throwable cause);

    /** A pipeline that was chosen could not take the world over, which stays where it is. */
    void refused(Pipeline chosen, Throwable why);

    /** A pipeline away from home has failed, and with it the state. If another one takes its place, the world moves home. */
    void lost(Pipeline failed, Throwable why);

    /** Memory for a state on the way that has been made since it was asked for last; null if there is none. */
    default SavedState takeMemory() {
        return null;
    }

    /** Closes all pipelines. */
    @Override
    void close();
}
