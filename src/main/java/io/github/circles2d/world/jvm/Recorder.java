package io.github.circles2d.world.jvm;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.StepReports;

/** Records what a step reports, and hands it over: what contacts and walls do, and which pairs are sensed. */
final class Recorder {
    private final State state;
    private final Team team;
    private final ContactEvents events;
    private final Touches touches;
    private final Sensing sensing;

    /** By worker: its records. */
    private final TouchRecords[] records;

    Recorder(State state, Grid grid, GridLevels levels, Contacts contacts, Team team, ContactEvents events) {
        this.state = state;
        this.team = team;
        this.events = events;
        touches = new Touches(state, contacts, team, events);
        sensing = new Sensing(state, grid, levels, team, events);
        records = new TouchRecords[team.most()];
        for (int worker = 0; worker < records.length; worker++) {
            records[worker] = new TouchRecords();
        }
    }

    /** What records contacts and walls in such a step; null if nothing does. */
    Touches touches(StepReports reports) {
        return reports.recording ? touches : null;
    }

    void ensure(StepReports reports) {
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
            sensing.begin(team.part(state.n, worker), team.part(state.n, worker + 1));
        }
    }

    /** Ends a step. */
    void end(int worker, StepConstants k, StepReports reports) {
        TouchRecords own = records[worker];
        int from = team.part(state.n, worker);
        int to = team.part(state.n, worker + 1);
        own.clear();
        if (reports.recording) {
            touches.endStep(worker, own, from, to, k);
        }
        if (reports.sensing) {
            sensing.find(worker, own, from, to, k);
        }
        team.sync(worker);
        if (worker == 0) {
            for (int idle = team.size(); idle < records.length; idle++) {
                records[idle].clear();
            }
            events.endStep(records);
        }
        team.sync(worker);
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
