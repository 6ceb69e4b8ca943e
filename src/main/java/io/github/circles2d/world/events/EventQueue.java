package io.github.circles2d.world.events;

import io.github.circles2d.world.model.Bounds;
import java.nio.IntBuffer;

/** The events of the steps that have been made, until the caller takes them; all of them, or those of the steps of a request. */
public final class EventQueue {
    private static final long NOT_REQUESTED = -1;

    private EventRows events = new EventRows();
    private EventRows taken = new EventRows();

    /** Steps since events were taken last: those of which there are events, those that have been asked for, and of these those of a request. */
    private long steps;

    private long asked;
    private long requested = NOT_REQUESTED;

    /** Adds the events of the last of some steps; the others have none. */
    void publish(EventRows step, int count) {
        events.addInOrder(step, steps);
        steps += count;
    }

    /** Adds the events of a step that a device has decided, in order. */
    void publishDecided(IntBuffer rows, int first, int count, KnownCircles circles, KnownPieces pieces, Bounds arena) {
        events.addDecided(rows, first, count, steps, circles, pieces, arena);
        steps++;
    }

    /** Takes note that steps have been asked for. */
    public void asked(int count) {
        asked += count;
    }

    /** All events. They stay as they are until the next call; no request is left. */
    public EventRows take() {
        EventRows next = taken;
        taken = events;
        events = next;
        events.clear();
        steps = 0;
        asked = 0;
        requested = NOT_REQUESTED;
        return taken;
    }

    /** Requests the events of the steps that have been asked for. */
    public void request() {
        requested = asked;
    }

    /** Whether events have been requested and not been taken. */
    public boolean isRequested() {
        return requested != NOT_REQUESTED;
    }

    /** Whether there are the events of all steps of the request. */
    public boolean haveArrived() {
        return steps >= requested;
    }

    /** The events of the request, which have arrived. They stay as they are until events are taken again. */
    public EventRows takeRequested() {
        long ofRequest = requested;
        taken.ensure(events.countFrom(ofRequest)); // the list of those that stay: a call that finds no room takes none
        long stepsNow = steps;
        long askedNow = asked;
        EventRows all = take();
        steps = stepsNow - ofRequest;
        asked = askedNow - ofRequest;
        all.moveFrom(ofRequest, events);
        return all;
    }

    /** Drops what has not been taken; a request is left, and is one of no steps. */
    void drop() {
        events.clear();
        steps = 0;
        asked = 0;
        requested = Math.min(requested, 0);
    }

    long bytes() {
        return events.bytes() + taken.bytes();
    }
}
