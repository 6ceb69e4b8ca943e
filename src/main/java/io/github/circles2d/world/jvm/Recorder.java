package io.github.circles2d.world.jvm;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.StepReports;
import io.github.circles2d.world.model.TerrainStep;

/** Records what a step reports, and hands it over: what contacts and walls do, and which pairs are sensed. */
final class Recorder {
    private final State state;
    private final Contacts contacts;
    private final Team team;
    private final ContactEvents events;
    private final Touches touches;
    private final Sensing sensing;

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

    /** Before the first step of which it tells. */
    void start() {
        touches.recordWalls(events.hasWalls());
    }

    /** What records contacts and walls in such a step; null if nothing does. */
    Touches touches(StepReports reports) {
        touches.recordPieces(reports.recording && reports.pieces);
        return reports.recording ? touches : null;
    }

    void ensure(StepReports reports) {
        for (TouchRecords each : records) {
            each.clear();
        }
        if (reports.recording && touches.walls != null) {
            touches.walls.ensure();
        }
        if (reports.sensing) {
            sensing.ensure(reports);
        }
    }

    /** Begins a step, once the circles lie in the order of the grid. */
    void begin(int worker, StepReports reports) {
        if (reports.sensing) {
            sensing.begin(team.part(state.awake, worker), team.part(state.awake, worker + 1));
        }
    }

    void end(int worker, TerrainStep terrain, StepConstants k, StepReports reports) {
        int from = team.part(state.awake, worker);
        int to = team.part(state.awake, worker + 1);
        if (reports.recording) {
            touches.endStep(worker, from, to, terrain, k);
        }
        if (reports.sensing) {
            sensing.find(worker, records[worker], from, to, k);
        }
        if (worker == 0 && state.sleepers != null && state.sleepers.count > 0) {
            events.keep(state);
        }
        team.sync(worker);
        if (reports.recording && events.misses(records)) {
            touches.stamp(team.part(contacts.count, worker), team.part(contacts.count, worker + 1));
        }
        team.sync(worker);
        if (worker == 0) {
            events.endStep(records);
        }
        team.sync(worker);
        if (reports.recording) {
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
