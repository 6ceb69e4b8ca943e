package io.github.circles2d.world;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.EventRows;
import io.github.circles2d.world.model.Limits;

/** The calls on events. */
public final class Reports {
    private final Simulation simulation;
    private final Guard guard;
    private final ContactEvents events;

    Reports(Simulation simulation) {
        this.simulation = simulation;
        guard = simulation.guard;
        events = simulation.events;
    }

    /** Sets which events are reported from the next step on. */
    public void report(int types) {
        guard.enter();
        try {
            if ((types & ~ContactEvents.ALL) != 0) {
                throw new IllegalArgumentException("the types must be a sum of BEGIN, HIT, END and WALL, not " + types);
            }
            simulation.settle();
            events.makeRoom(simulation.handles);
            simulation.snapshots().forget();
            guard.changing = true;
            events.report(types, simulation.handles);
            simulation.pipeline.report(events.isOn() ? events : null);
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Sets the speed from which on a hit counts. */
    public void setHitSpeed(float speed) {
        guard.enter();
        try {
            Limits.within("the hit speed", speed, 0, Limits.SPEED);
            simulation.finishSteps();
            events.setHitSpeed(speed);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The events since the last call. */
    public EventRows take() {
        guard.enter();
        try {
            simulation.finishSteps();
            return events.take();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }
}
