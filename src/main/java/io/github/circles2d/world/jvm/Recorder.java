package io.github.circles2d.world.jvm;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.solver.Contacts;
import io.github.circles2d.world.jvm.solver.Touches;
import io.github.circles2d.world.jvm.state.State;
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

    /** Null as long as static circles have sensed no pieces. */
    private StaticPieces staticPieces;

    private final GridLevels levels;
    private final TouchRecords[] records;

    private final Team.Work beginSensing = this::beginSensing;
    private final Team.Work measureSensed = this::measureSensed;
    private final Team.Work recordAll = this::recordAll;
    private final Team.Work stamp = this::stamp;
    private final Team.Work learn;

    private TerrainStep terrain;
    private StepConstants constants;
    private StepReports reports;

    Recorder(State state, Grid grid, GridLevels levels, Contacts contacts, Team team, ContactEvents events) {
        this.state = state;
        this.contacts = contacts;
        this.team = team;
        this.events = events;
        this.levels = levels;
        sensing = new Sensing(state, grid, levels, team, events);
        records = new TouchRecords[team.most()];
        for (int worker = 0; worker < records.length; worker++) {
            records[worker] = new TouchRecords();
        }
        touches = new Touches(state, contacts, team, events, records);
        learn = touches::learn;
    }

    /** Before the first step of which it tells. */
    void start() {
        touches.recordWalls(events.hasWalls());
    }

    /** Bits by kind, whether its static circles look at others in such a step; null if none do. */
    long[] asking(StepReports ofStep) {
        return ofStep.statics || ofStep.bodies ? ofStep.asking : null;
    }

    /** What records contacts and walls in such a step; null if nothing does. */
    Touches touches(StepReports reports) {
        touches.recordPieces(reports.recording && reports.pieces);
        return reports.recording ? touches : null;
    }

    void ensure(StepReports ofStep) {
        reports = ofStep;
        for (TouchRecords each : records) {
            each.clear();
        }
        if (reports.recording && touches.walls != null) {
            touches.walls.ensure();
        }
        if (reports.sensing) {
            sensing.ensure(reports);
        }
        if (reports.bodies && staticPieces == null) {
            staticPieces = new StaticPieces(state, sensing, levels, team, events);
        }
    }

    /** Begins a step, once the circles lie in the order of the grid. */
    void begin() {
        if (reports.sensing) {
            state.seen = sensing.seen();
            team.all(beginSensing);
        }
    }

    private void beginSensing(int worker) {
        sensing.beginStep(team.part(state.awake, worker), team.part(state.awake, worker + 1));
    }

    void end(TerrainStep step, StepConstants k) {
        terrain = step;
        constants = k;
        if (reports.sensing) {
            team.all(measureSensed);
            sensing.settle();
        }
        if (sensesBodies()) {
            staticPieces.begin(reports, terrain, constants);
        }
        team.all(recordAll);
        if (state.sleepers != null && state.sleepers.count > 0) {
            events.tracker.keep(state);
        }
        if (reports.recording && events.tracker.misses(records)) {
            team.all(stamp);
        }
        events.endStep(records);
        if (reports.recording) {
            team.all(learn);
        }
    }

    private void measureSensed(int worker) {
        sensing.measure(worker, team.part(state.awake, worker), team.part(state.awake, worker + 1));
    }

    private void recordAll(int worker) {
        int from = team.part(state.awake, worker);
        int to = team.part(state.awake, worker + 1);
        if (reports.recording) {
            touches.endStep(worker, from, to, terrain, constants);
        }
        if (reports.sensing) {
            sensing.find(worker, records[worker], from, to, constants);
        }
        if (sensesBodies()) {
            staticPieces.find(worker, records[worker], from, to);
        }
    }

    private boolean sensesBodies() {
        return reports.bodies && constants.terrain && terrain.groundNodes < terrain.nodes;
    }

    private void stamp(int worker) {
        touches.stamp(team.part(contacts.count, worker), team.part(contacts.count, worker + 1));
    }

    long bytes() {
        long sum = touches.bytes() + sensing.bytes();
        for (TouchRecords each : records) {
            sum += each.bytes();
        }
        return sum;
    }
}
