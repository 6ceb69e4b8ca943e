package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.RADIUS;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.Partner;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.jvm.pieces.PieceMeasure;
import io.github.circles2d.world.jvm.pieces.SensedPiece;
import io.github.circles2d.world.jvm.state.Resting;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.state.WrapImages;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.SensorRule;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.StepReports;
import io.github.circles2d.world.model.TerrainStep;

/**
 * Tells of the pieces of bodies that static circles sense, if a kind asks for it. A circle that does not rest looks in the tree of the bodies'
 * boxes. A piece whose kind asks looks for circles that rest. {@code StaticSensing.cl} does the same, but there all circles look.
 */
final class StaticPieces {
    /** An eighth more than needed, for rounding. */
    private static final float SLACK = 1.125f;

    private final State state;
    private final Sensing sensing;
    private final GridLevels levels;
    private final Team team;
    private final ContactEvents events;
    private final SensedPiece[] sensed;
    private final Resting.Found[] resting;

    private int[] table;
    private long[] asking;
    private TerrainStep terrain;
    private StepConstants constants;

    StaticPieces(State state, Sensing sensing, GridLevels levels, Team team, ContactEvents events) {
        this.state = state;
        this.sensing = sensing;
        this.levels = levels;
        this.team = team;
        this.events = events;
        sensed = new SensedPiece[team.most()];
        resting = new Resting.Found[team.most()];
        for (int worker = 0; worker < sensed.length; worker++) {
            sensed[worker] = new SensedPiece(events);
            resting[worker] = new Resting.Found();
        }
    }

    void begin(StepReports reports, TerrainStep step, StepConstants k) {
        table = reports.seeking;
        asking = reports.asking;
        terrain = step;
        constants = k;
    }

    /** A worker tells of the circles of some slots, and of its part of the pieces. */
    void find(int worker, TouchRecords records, int from, int to) {
        for (int slot = from; slot < to; slot++) {
            if (state.isStatic(slot) && !state.isAsleep(slot) && sensing.takesPart(slot)) {
                look(worker, records, slot);
            }
        }
        if (state.awake < state.n) {
            int nodes = terrain.nodes - terrain.groundNodes;
            int end = terrain.groundNodes + team.part(nodes, worker + 1);
            for (int node = terrain.groundNodes + team.part(nodes, worker); node < end; node++) {
                int piece = terrain.links[2 * node + 1];
                if (piece >= 0 && StepReports.asks(asking, kindOf(piece))) {
                    lookAtResting(worker, records, node, piece);
                }
            }
        }
    }

    private int kindOf(int piece) {
        return terrain.traits[PieceRow.traits(piece) + PieceRow.KIND];
    }

    private void look(int worker, TouchRecords records, int slot) {
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        float m = SLACK * Paths.sight(r, CircleMath.length(sensing.pathX(slot), sensing.pathY(slot)));
        float x = sensing.startX(slot);
        float y = sensing.startY(slot);
        int[] links = terrain.links;
        int node = terrain.groundNodes;
        while (node < terrain.nodes) {
            if (meets(4 * node, x, y, m)) {
                int piece = links[2 * node + 1];
                if (piece >= 0) {
                    lookAt(worker, records, slot, piece);
                }
                node++;
            } else {
                node = links[2 * node];
            }
        }
    }

    /** Whether a box meets one around a place, or around an image of it. */
    private boolean meets(int box, float x, float y, float m) {
        boolean some = false;
        for (int n = 0; n < state.images.count; n++) {
            float atX = x + state.images.x[n];
            float atY = y + state.images.y[n];
            float mx = m + WrapImages.rounding(state.images.x[n], x);
            float my = m + WrapImages.rounding(state.images.y[n], y);
            some |= terrain.boxes[box] <= atX + mx
                    && terrain.boxes[box + 1] <= atY + my
                    && terrain.boxes[box + 2] >= atX - mx
                    && terrain.boxes[box + 3] >= atY - my;
        }
        return some;
    }

    /** A piece looks at circles that rest for it: these do not look themselves. */
    private void lookAtResting(int worker, TouchRecords records, int node, int piece) {
        Resting.Found found = resting[worker];
        float[] boxes = terrain.boxes;
        int b = 4 * node;
        state.resting.find(found, levels.bounds, boxes[b], boxes[b + 2], boxes[b + 1], boxes[b + 3], SLACK * SLACK);
        for (int n = 0; n < found.count; n++) {
            int slot = found.slots[n];
            if (!state.isAsleep(slot)) {
                sensing.measureResting(slot);
                lookAt(worker, records, slot, piece);
            }
        }
    }

    private void lookAt(int worker, TouchRecords records, int slot, int piece) {
        int kind = sensing.kind(slot);
        int other = kindOf(piece);
        if (PairTable.get(table, kind, other) == SensorRule.NONE
                || !StepReports.asks(asking, kind) && !StepReports.asks(asking, other)) {
            return;
        }
        int row = PieceRow.of(piece);
        int shape = terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE];
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        float ux = sensing.pathX(slot);
        float uy = sensing.pathY(slot);
        float offsetX = offset(sensing.startX(slot), row + PieceRow.X, row + PieceRow.MID_X, state.periodX);
        float offsetY = offset(sensing.startY(slot), row + PieceRow.Y, row + PieceRow.MID_Y, state.periodY);
        float far = Paths.sight(r, CircleMath.length(ux, uy)) + terrain.rows[row + PieceRow.MOST];
        if (!(PieceGap.distance(terrain.rows, row, shape, offsetX, offsetY) < far)) {
            return;
        }
        int motion = terrain.traits[PieceRow.traits(piece) + PieceRow.MOTION];
        float ox = localX(row, motion, offsetX, offsetY, 0f, 0f, 0);
        float oy = localY(row, motion, offsetX, offsetY, 0f, 0f, 0);
        float endX = localX(row, motion, offsetX, offsetY, ux, uy, constants.subSteps);
        float endY = localY(row, motion, offsetX, offsetY, ux, uy, constants.subSteps);
        int id = state.id[slot];
        float side = events.find(id, Partner.ofPiece(piece)) == ContactEvents.NONE ? 0f : 1f;
        float seen = PieceMeasure.sensedSide(terrain.rows, row, shape, ox, oy, r, side);
        sensed[worker].tell(records, id, piece, ox, oy, endX, endY, r, seen, terrain, constants);
    }

    private float offset(float x, int at, int middle, float period) {
        if (!state.wraps) {
            return x - terrain.rows[at];
        }
        float mid = terrain.rows[middle];
        return CircleMath.shortWay(x - mid, period) + (mid - terrain.rows[at]);
    }

    private float localX(int row, int motion, float ox, float oy, float dx, float dy, int boundary) {
        if (motion == 0) {
            return ox + dx;
        }
        int pose = BodyRow.of(motion, constants.subSteps) + BodyRow.pose(boundary);
        float px = terrain.rows[row + PieceRow.PIVOT_X];
        float x = (ox - px) + (dx - terrain.motion[pose + BodyRow.DX]);
        float y = (oy - terrain.rows[row + PieceRow.PIVOT_Y]) + (dy - terrain.motion[pose + BodyRow.DY]);
        return (terrain.motion[pose + BodyRow.COS] * x + terrain.motion[pose + BodyRow.SIN] * y) + px;
    }

    private float localY(int row, int motion, float ox, float oy, float dx, float dy, int boundary) {
        if (motion == 0) {
            return oy + dy;
        }
        int pose = BodyRow.of(motion, constants.subSteps) + BodyRow.pose(boundary);
        float py = terrain.rows[row + PieceRow.PIVOT_Y];
        float x = (ox - terrain.rows[row + PieceRow.PIVOT_X]) + (dx - terrain.motion[pose + BodyRow.DX]);
        float y = (oy - py) + (dy - terrain.motion[pose + BodyRow.DY]);
        return (terrain.motion[pose + BodyRow.COS] * y - terrain.motion[pose + BodyRow.SIN] * x) + py;
    }
}
