package io.github.circles2d.world.shared;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.BrokenJoints;
import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.model.StepReports;
import io.github.circles2d.world.queries.RemoteSearch;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.terrain.SavedPieceContacts;
import java.nio.FloatBuffer;
import java.util.Map;
import java.util.function.Consumer;

/**
 * The engine behind a World: it holds the state and makes the steps. All pipelines give the same bits. {@code Simulation} has
 * checked the arguments, and lets one thread in at a time.
 */
public interface Pipeline extends AutoCloseable {
    /** Once all steps have been finished: applying the commands then cannot fail. If there is no room, nothing has changed. */
    void makeRoom(Commands commands);

    /** In call order. Room has been made; the object is not kept. */
    void apply(Commands commands);

    /**
     * Makes ready for steps with such contacts and features. Commands, steps and saved states of such worlds come after this. What a
     * pipeline is ready for once, it stays ready for.
     */
    default void prepare(ContactSettings contacts, Features features) {}

    /**
     * Makes ready for rigid bodies, which steps change from now on.
     */
    void prepare(RigidStep bodies);

    /** Whether nothing is compiled for such worlds any more, nor beside their steps. */
    default boolean isReady(Readiness wanted) {
        return true;
    }

    /** Compiles all that {@link #isReady} asks for. Another thread may call this while nobody uses the pipeline. */
    default void compile(Readiness wanted) {}

    /** Makes the pipeline ready for steps of circles that report this, which may take a compiler seconds; changes nothing if it fails. */
    default void prepareSteps(StepReports reports) {}

    /** At least 1. */
    void step(StepInput input, GridLevels levels, int steps);

    /** Makes room for {@link #report}. If there is none, nothing has changed. */
    default void makeRoomToReport(ContactEvents events) {}

    /** Sets who is told of what pairs did in each step to come, with room for all ids, or null. All steps have been finished. */
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
     * Brings circles inside that the next step does not push there. Walls that jumped are where they are now. Circles that sleep wake if they
     * reach out of the calm bounds.
     */
    void confine(Bounds from, Bounds to, Bounds calm);

    /** {@link StateHash}. */
    long hash();

    /** x, y, radius and mass, in the order of ids. */
    void readCircles(HandleTable handles, float[] to);

    /**
     * x and y in the order of ids, or by id and NaN without a circle, from position 0 to the limit, in memory of the pipeline;
     * read-only, valid until the next call.
     */
    FloatBuffer positions(HandleTable handles, boolean byId);

    /** Makes room for {@link #requestPositions}, if that can be known before. If there is none, nothing has changed. */
    default void makeRoomForPositions(HandleTable handles) {}

    /** Asks for x and y of every circle as of now, which come while further steps are made, in place of an earlier request. */
    void requestPositions(HandleTable handles);

    /** False if a step before the request has not been made yet: {@link #finish} makes it, and asks again. */
    boolean positionsArrived();

    /**
     * The positions that were requested last, once a request: in the order of ids if shown is null, else by id, and NaN for ids that
     * are not shown. As {@link #positions}, but valid until the request after the next.
     */
    FloatBuffer takePositions(IdMask shown);

    /** In the order of ids. */
    void readVelocities(HandleTable handles, float[] to);

    /** In the order of ids, in units of a turn's 2^-32; of circles that turn. */
    void readAngles(HandleTable handles, int[] to);

    /** In the order of ids; of circles that turn. */
    void readAngularVelocities(HandleTable handles, float[] to);

    /** About how many of so many circles are awake: as of the last step of which that is known, without waiting for others. */
    default int awake(int circles) {
        return circles;
    }

    /** Whether the circle of an id sleeps. All steps have been finished. */
    default boolean isAsleep(int id) {
        return false;
    }

    /** Sets the bits of the ids of circles that sleep, of bits that are 0. All steps have been finished. */
    default void readAsleep(long[] byId) {}

    /** Saves which ids have a circle here, ascending if there is terrain: changes that wait have not been applied. */
    void saveIds(SavedState into);

    /** Saves circle, motion, traits, what circles turn by, and the impulses that the next step starts from. The ids are there already. */
    void save(SavedState into);

    /**
     * Saves the contacts with pieces of terrain, with their serials. The caller leaves out those of pieces that are others now, and adds them
     * to the hash: {@link #save(SavedState)} and {@link #hash} do not have them.
     */
    default void savePieceContacts(SavedPieceContacts into) {
        into.clear();
    }

    /** Saves what joints keep from step to step. The caller looks at those alone whose serials are of joints that there are. */
    default void saveJoints(SavedJointStates into) {
        into.begin(0);
    }

    /** Hands out the joints that have broken since the last time. All steps have been finished. */
    default void takeBroken(BrokenJoints into) {
        into.begin(0);
    }

    /** Once all steps have been finished: {@link #load} then cannot fail. If there is no room, nothing has changed. */
    void makeRoom(SavedState from);

    /**
     * All goes on as after the steps that led to the state, which has been checked and is not kept. Room has been made. The contacts with pieces
     * have the serials of now.
     */
    void load(SavedState from);

    /** The world has moved elsewhere, from where {@link #load} may bring it back: reports end, and requested positions arrive. */
    void leave();

    /** The world that has left was made up, and another one comes: nothing that is there is taken for its own, nor counted. Nobody watches. */
    default void forget() {
        watch(failure -> {});
    }

    /** Always the same; null if only the host can search the circles. */
    default RemoteSearch search() {
        return null;
    }

    /** Pairs whose distance the broad phase tested in the last step. */
    long candidatePairs();

    /** Of the last step. */
    int contacts();

    /** The greatest number of one circle in the last step. */
    int greatestContacts();

    /** For circles and contacts. */
    long bytesHeld();

    /** Since the start; empty unless profiling. */
    Map<String, Double> stageMillis();

    /** A name for people. */
    String device();

    /** Names whom it tells, before a call throws it, of a device that fails: that loses the state, even if the call is a read. */
    default void watch(Consumer<Throwable> whom) {}

    @Override
    void close();
}
