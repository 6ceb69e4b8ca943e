package io.github.circles2d.world.shared;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.model.StepReports;
import io.github.circles2d.world.snapshots.SavedState;
import java.lang.ref.SoftReference;
import java.util.function.Consumer;

/**
 * Moves a world to another pipeline between two steps. The tables of the host stay; what a pipeline holds travels as a saved state, and pairs
 * that touch by way of the host. No result depends on it. Without a {@link Mover} a world stays where it began.
 */
public final class Moves {
    private final WorldParts world;

    /** Null if the world never moves. */
    private Mover mover;

    private Consumer<SavedState> step;

    private SoftReference<SavedState> memory = new SoftReference<>(null);

    /** What steps needed last. */
    private Readiness wanted = Readiness.USUAL;

    /** What was ready when it was asked last, and for what: to ask before each step would be garbage. */
    private Pipeline asked;

    private Readiness ready;

    /** The pipeline that lost the state; null if none did. */
    private Pipeline failed;

    Moves(WorldParts world) {
        this.world = world;
    }

    /** Names who adds what a pipeline has of the next step alone. */
    public void alsoCarry(Consumer<SavedState> ofStep) {
        step = ofStep;
    }

    /** Lets the world move from now on. */
    public void by(Mover decides) {
        mover = decides;
        world.clock.turnOn();
    }

    /** Before so many steps, once all changes have been applied and it is known what the steps report. */
    public void beforeSteps(int steps) {
        if (mover == null) {
            return;
        }
        Readiness now = wanted(world.settings.contacts(), world.needs.features());
        if (mover.settles()) {
            world.pending.finish();
        }
        double nanos = world.clock.endFrame(steps);
        Pipeline next = choose(now, world.handles.size(), nanos);
        Pipeline before = world.pipeline;
        if (next != before) {
            try {
                moveTo(next, null);
            } catch (RuntimeException | Error e) {
                if (!world.guard.holds()) {
                    throw e; // the device has failed that the world is on
                }
                mover.refused(next, e);
            }
        }
        stayIfReady(now);
        if (next != before) {
            world.clock.endFrame(steps); // a move is no part of a frame
        }
    }

    private Pipeline choose(Readiness now, int circles, double nanos) {
        return mover.choose(world.pipeline, now, circles, world.pipeline.awake(circles), nanos);
    }

    /** Before the pipeline is made ready for features: if it would compile kernels, the world goes home. */
    void beforeFeatures(ContactSettings contacts, Features features) {
        if (mover != null) {
            stayIfReady(wanted(contacts, features));
        }
    }

    /** Before the world reports something else: likewise. */
    public void beforeReports() {
        if (mover != null) {
            stayIfReady(
                    wanted(world.settings.contacts(), world.needs.features()).silent());
        }
    }

    private void stayIfReady(Readiness now) {
        if (now != ready || world.pipeline != asked) {
            if (!world.pipeline.isReady(now)) {
                moveTo(mover.home(), null);
            }
            ready = now;
            asked = world.pipeline;
        }
    }

    /**
     * Goes home, since a pipeline has refused what changes nothing. Throws the refusal if the world never moves, is at home, or has lost its
     * state.
     */
    public void goHome(RuntimeException refusal) {
        if (mover == null || !world.guard.holds() || mover.isHome(world.pipeline)) {
            throw refusal;
        }
        moveTo(mover.home(), refusal);
    }

    /** The state is lost. Returns whether another one may take its place: at home, if a device has failed. An error may have hit anything. */
    boolean lost(Throwable failure) {
        if (mover == null || failure instanceof Error || mover.isHome(world.pipeline)) {
            return false;
        }
        failed = world.pipeline;
        mover.lost(failed, failure);
        return true;
    }

    /** Whether a pipeline is the one that lost the state. */
    public boolean hasFailed(Pipeline pipeline) {
        return pipeline == failed;
    }

    /** Goes home without a state, which the caller makes room for and loads then. */
    public void leaveFailed() {
        if (world.pipeline == failed) {
            Pipeline next = mover.home();
            world.needs.prepare(next);
            report(next);
            world.use(next);
            mover.moved(failed, next, 0, null);
        }
    }

    /** Moves to a pipeline that is ready. If that fails, the world is where it was. */
    private void moveTo(Pipeline next, Throwable cause) {
        long start = System.nanoTime();
        Pipeline from = world.pipeline;
        world.pending.finish();
        SavedState carried = carried();
        world.state.carry(carried);
        step.accept(carried);
        world.events.bringHere();
        ContactEvents.Remote remote = world.events.remote();
        try {
            world.needs.prepare(next);
            next.makeRoom(carried);
            next.load(carried);
            report(next);
        } catch (RuntimeException | Error e) {
            world.events.setRemote(remote);
            throw e;
        }
        world.use(next);
        world.state.forgetFigures();
        Throwable failure = leave(from);
        mover.moved(from, next, System.nanoTime() - start, cause == null ? failure : cause);
    }

    /** Returns what has failed, if anything: the state is not there any more. */
    private static Throwable leave(Pipeline from) {
        try {
            from.leave();
            return null;
        } catch (RuntimeException e) {
            return e;
        }
    }

    /** Memory of the last move, if it is still there; null before the first. */
    public SavedState memory() {
        return memory.get();
    }

    private SavedState carried() {
        SavedState held = mover.takeMemory();
        if (held == null) {
            held = memory.get();
        }
        if (held == null) {
            held = new SavedState();
        }
        if (held != memory.get()) {
            memory = new SoftReference<>(held);
        }
        return held;
    }

    private void report(Pipeline next) {
        ContactEvents events = world.events.isOn() ? world.events : null;
        if (events != null) {
            next.makeRoomToReport(events);
        }
        world.events.setRemote(null);
        next.report(events);
    }

    private Readiness wanted(ContactSettings contacts, Features features) {
        StepReports reports = world.input.reports;
        boolean recording = world.events.isOn() && reports.recording;
        boolean reporting = world.events.isOn() && (reports.recording || reports.sensing);
        if (!wanted.is(contacts.areTuned(), features, reporting, recording)) {
            wanted = new Readiness(contacts.areTuned(), features, reporting, recording);
        }
        return wanted;
    }

    /** Closes the pipeline, or all if the world moves. */
    public void close() {
        if (mover == null) {
            world.pipeline.close();
        } else {
            mover.close();
        }
    }
}
