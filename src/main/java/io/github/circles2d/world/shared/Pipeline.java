package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.queries.RemoteSearch;
import java.nio.FloatBuffer;
import java.util.Map;

/**
 * The engine behind a World: it holds the state and makes the steps. All pipelines give the same bits. {@link Simulation} has
 * checked the arguments, and lets one thread in at a time.
 */
public interface Pipeline extends AutoCloseable {
    /**
     * Makes room for what the caller asked for, so that applying it does not run out of memory. Where this fails, nothing has
     * changed. All steps have been finished.
     *
     * @param commands the commands
     */
    void makeRoom(Commands commands);

    /**
     * Applies what the caller asked for, in call order. Does not keep the object.
     *
     * @param commands the commands, for which room has been made
     */
    void apply(Commands commands);

    /**
     * Makes ready for steps with such contacts and edges, however they were before.
     *
     * @param contacts how contacts will be
     * @param edged whether an axis will have no walls
     */
    default void prepare(ContactSettings contacts, boolean edged) {}

    /**
     * Makes steps.
     *
     * @param input what the step needs
     * @param levels shape of the grids
     * @param steps number of steps, at least 1
     */
    void step(StepInput input, GridLevels levels, int steps);

    /**
     * Sets who is told of what pairs did in each step to come. All steps have been finished.
     *
     * @param events has room for all ids; null if nobody is told
     */
    void report(ContactEvents events);

    /** Publishes the events of all steps asked for; waits for these if they may have some. */
    default void finishEvents() {
        finish();
    }

    /** Asks for the events of all steps so far, without waiting for them. A request before this one ends. */
    default void requestEvents() {}

    /** Publishes the events that were requested last; those of later steps may come, too. */
    default void finishRequestedEvents() {
        finish();
    }

    /** Waits until all steps asked for have been made. */
    void finish();

    /**
     * Brings circles that have been left outside to the nearest place inside, if the next step does not push them there.
     *
     * @param from where the walls were; where they are now if they jumped
     * @param to the new bounds
     */
    void confine(Bounds from, Bounds to);

    /**
     * The hash of the state, by {@link StateHash}.
     *
     * @return 64 bits
     */
    long hash();

    /**
     * Reads x, y, radius and mass of every circle.
     *
     * @param handles which ids live
     * @param to 4 floats a circle, in ascending order of ids
     */
    void readCircles(HandleTable handles, float[] to);

    /**
     * Reads x and y of every circle into memory of the pipeline's own.
     *
     * @param handles which ids live
     * @param byId whether the positions lie by id
     * @return 2 floats a circle, in ascending order of ids, or 2 floats an id, NaN without a circle, from position 0 to the limit;
     *     read-only; valid until the next call
     */
    FloatBuffer positions(HandleTable handles, boolean byId);

    /**
     * Asks for x and y of every circle as of now, which come while further steps are made. Takes the place of an earlier
     * request that has not been taken.
     *
     * @param handles which ids live; not kept
     */
    void requestPositions(HandleTable handles);

    /**
     * Waits for the positions that were requested last.
     *
     * @return false if a step before the request has not been made yet: {@link #finish} makes it, and asks again
     */
    boolean positionsArrived();

    /**
     * Gives the positions that were requested last. Once a request.
     *
     * @param shown null for positions in ascending order of ids; else they lie by id, and those of other ids are NaN
     * @return 2 floats a circle, or an id, from position 0 to the limit; read-only; valid until the request after the next
     */
    FloatBuffer takePositions(IdMask shown);

    /**
     * Reads velocities.
     *
     * @param handles which ids live
     * @param to 2 floats a circle, in ascending order of ids
     */
    void readVelocities(HandleTable handles, float[] to);

    /**
     * Saves the circles and the cached impulses: those that the next step would start from, and no others.
     *
     * @param into has the ids of all circles already; takes circle, motion, traits and the impulses
     */
    void save(SavedState into);

    /**
     * Makes room for a saved state, so that taking it over does not run out of memory. Where this fails, nothing has changed.
     * All steps have been finished.
     *
     * @param from the state
     */
    void makeRoom(SavedState from);

    /**
     * Takes over a saved state instead of its own: from now on all is as if it had made the steps that led there. The values
     * have been checked.
     *
     * @param from the state, for which room has been made; not kept
     */
    void load(SavedState from);

    /**
     * What searches the circles where they are.
     *
     * @return always the same; null if only the host can search them
     */
    default RemoteSearch search() {
        return null;
    }

    /**
     * Pairs whose distance the broad phase tested in the last step.
     *
     * @return at least 0
     */
    long candidatePairs();

    /**
     * Contacts listed in the last step.
     *
     * @return at least 0
     */
    int contacts();

    /**
     * Greatest number of contacts of one circle in the last step.
     *
     * @return at least 0
     */
    int greatestContacts();

    /**
     * Memory held for circles and contacts.
     *
     * @return bytes
     */
    long bytesHeld();

    /**
     * Time spent in each stage since the start.
     *
     * @return milliseconds by the stage's name; empty unless profiling
     */
    Map<String, Double> stageMillis();

    /**
     * What the pipeline runs on.
     *
     * @return a name for people
     */
    String device();

    /**
     * Whether the state is lost if any call throws this, be it a read.
     *
     * @param cause what a call has thrown
     * @return true for failures of a device, which takes the state with it
     */
    default boolean isLostBy(Throwable cause) {
        return false;
    }

    @Override
    void close();
}
