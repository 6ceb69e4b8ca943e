package io.github.circles2d.world.jvm;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;

/** Records what a step reports, and hands it over: what contacts and walls do, and which pairs are sensed. */
final class Recorder {
    private final State state;
    private final Contacts contacts;
    private final Team team;
    private final ContactEvents events;
    private final Touches touches;
    private final Sensing sensing;

    /** By worker: its records. */
    private final TouchRecords[] records;

    Recorder(State state, Grid grid, GridLevels levels, Contacts contacts, Team team, ContactEvents events) {
        this.state = state;
        this.contacts = contacts;
        this.team = team;
        this.events = events;
        sensing = new Sensing(state, grid, levels, team, events);
        records = new TouchRecords[team.most()];
        for (int worker = 0; worker < records.length; worker++) {
            records[worker] = new TouchRecords();
        }
        touches = new Touches(state, contacts, team, events, records);
    }

    /** What records contacts and walls in such a step; null if nothing does. */
    Touches touches(StepConstants k) {
        return k.recording ? touches : null;
    }

    void ensure(StepConstants k) {
        for (TouchRecords each : records) {
            each.clear();
        }
        if (k.recording && touches.walls != null) {
            touches.walls.ensure();
        }
        if (k.sensing) {
            sensing.ensure(k);
        }
    }

    /** Begins a step, once the circles lie in the order of the grid. */
    void begin(int worker, StepConstants k) {
        if (k.sensing) {
            sensing.begin(team.part(state.n, worker), team.part(state.n, worker + 1));
        }
    }

    /** Ends a step. */
    void end(int worker, StepConstants k) {
        int from = team.part(state.n, worker);
        int to = team.part(state.n, worker + 1);
        if (k.recording) {
            touches.endStep(worker, from, to, k);
        }
        if (k.sensing) {
            sensing.find(worker, records[worker], from, to, k);
        }
        team.sync(worker);
        if (k.recording && events.misses(records)) {
            touches.stamp(team.part(contacts.count, worker), team.part(contacts.count, worker + 1));
        }
        team.sync(worker);
        if (worker == 0) {
            events.endStep(records);
        }
        team.sync(worker);
        if (k.recording) {
            touches.learn(worker);
        }
    }

    /** Memory of the arrays. */
    long bytes() {
        long sum = touches.bytes() + sensing.bytes();
        for (TouchRecords each : records) {
            sum += each.bytes();
        }
        return sum;
    }
}
