package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.RigidStep.BODY_BODY;
import static io.github.circles2d.world.bodies.RigidStep.BODY_CIRCLE;
import static io.github.circles2d.world.bodies.RigidStep.BODY_PIECE;
import static io.github.circles2d.world.bodies.RigidStep.BODY_WALL;

import io.github.circles2d.world.bodies.RigidExtras;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.Tuning;

/** Finds what is near to rigid bodies, by their boxes. Each worker has one. */
final class RigidSearch {
    private final State state;
    private final RigidThings things;
    private final RigidCandidates candidates;
    private final RigidKeys[] partners;
    private final RigidTree.Found found = new RigidTree.Found();

    /** By type: the keys of pairs. Those of a body are in order. */
    final RigidKeys[] keys = new RigidKeys[BODY_CIRCLE + 1];

    // within a step
    private RigidStep step;
    private StepConstants k;
    private TerrainStep terrain;

    RigidSearch(State state, RigidThings things, RigidCandidates candidates, RigidKeys[] partners) {
        this.state = state;
        this.things = things;
        this.candidates = candidates;
        this.partners = partners;
        for (int type = 0; type < keys.length; type++) {
            keys[type] = new RigidKeys();
        }
    }

    /** Begins a step, in which nothing has been found. Terrain is null if there is none. */
    void begin(RigidStep bodies, StepConstants constants, TerrainStep ground) {
        step = bodies;
        k = constants;
        terrain = ground;
        for (RigidKeys each : keys) {
            each.count = 0;
        }
    }

    private void add(int type, int body, int other) {
        if (partners[type] == null || !partners[type].has(body, other)) {
            keys[type].add(body, other);
        }
    }

    /** Finds what is near to a body, of two bodies by that of the lower id. */
    void findNear(RigidThing t) {
        findBodies(t);
        if (t.gives()) {
            // what does not move has no thickness of its own
            float m = 2f * Tuning.MARGIN * t.thin;
            int at = 4 * t.number;
            float minX = candidates.box[at] - m;
            float minY = candidates.box[at + 1] - m;
            float maxX = candidates.box[at + 2] + m;
            float maxY = candidates.box[at + 3] + m;
            findWalls(t, minX, minY, maxX, maxY);
            if (terrain != null) {
                int pieces = keys[BODY_PIECE].count;
                findPieces(t, minX, minY, maxX, maxY);
                keys[BODY_PIECE].sortFrom(pieces);
            }
        }
    }

    private void findBodies(RigidThing t) {
        int[] of = candidates.of(t.number);
        int last = candidates.last(t.number);
        for (int k = candidates.first(t.number); k < last; k++) {
            RigidThing other = things.all[of[k]];
            if (candidates.meet(t.number, other.number)
                    && (t.gives() || other.gives())
                    && meets(t.kind, other.kind)
                    && !areOfOneGroup(t, other)) {
                add(BODY_BODY, t.id, other.id);
            }
        }
    }

    boolean meets(int kind, int other) {
        return !state.filtering || PairTable.get(state.responses, kind, other) == PairTable.SOLID;
    }

    private boolean areOfOneGroup(RigidThing t, RigidThing other) {
        return step.extras.areThere() && step.isOfGroup(t.id, step.extras.get(other.id, RigidExtras.GROUP));
    }

    private void findWalls(RigidThing t, float minX, float minY, float maxX, float maxY) {
        int body = t.id;
        if (minX - behind(0) < k.bounds.minX()) {
            add(BODY_WALL, body, 0);
        }
        if (maxX + behind(1) > k.bounds.maxX()) {
            add(BODY_WALL, body, 1);
        }
        if (minY - behind(2) < k.bounds.minY()) {
            add(BODY_WALL, body, 2);
        }
        if (maxY + behind(3) > k.bounds.maxY()) {
            add(BODY_WALL, body, 3);
        }
    }

    /** How far a wall comes inwards. */
    float behind(int wall) {
        return CircleMath.max(k.walls.travel[wall], 0f);
    }

    private void findPieces(RigidThing t, float minX, float minY, float maxX, float maxY) {
        for (int n = 0; n < state.images.count; n++) {
            float ax = state.images.x[n];
            float ay = state.images.y[n];
            int node = terrain.find(0, minX + ax, minY + ay, maxX + ax, maxY + ay);
            while (node >= 0) {
                int piece = terrain.piece(node);
                if (meets(t.kind, terrain.traits[PieceRow.traits(piece) + PieceRow.KIND])) {
                    add(BODY_PIECE, t.id, piece);
                }
                node = terrain.find(node + 1, minX + ax, minY + ay, maxX + ax, maxY + ay);
            }
        }
    }

    /** Finds the bodies near to a circle. */
    void findBodiesNear(int slot) {
        int s = CircleRow.of(slot);
        float r = state.circle[s + CircleRow.RADIUS];
        float x = state.circle[s + CircleRow.X];
        float y = state.circle[s + CircleRow.Y];
        float m = r + 2.25f * nearOf(slot);
        candidates.findNear(x - m, y - m, x + m, y + m, found);
        if (found.count == 0) {
            return;
        }
        int kind = state.filtering ? kindOf(slot) : 0;
        int group = step.extras.areThere() ? state.fields.getInt(CircleField.GROUP, state.id[slot]) : 0;
        for (int f = 0; f < found.count; f++) {
            RigidThing t = things.all[found.box[f]];
            boolean moves = t.gives() || !isStill(slot);
            if (moves && meets(t.kind, kind) && !step.isOfGroup(t.id, group)) {
                add(BODY_CIRCLE, t.id, state.id[slot]);
            }
        }
    }

    /** Whether a circle gives way to nobody, and stays where it is: it sleeps, or is static and has no velocity. */
    boolean isStill(int slot) {
        int s = CircleRow.of(slot);
        return state.isStatic(slot) && state.motion[s + CircleRow.VX] == 0f && state.motion[s + CircleRow.VY] == 0f;
    }

    int kindOf(int slot) {
        return state.fields.getInt(CircleField.KIND, state.id[slot]);
    }

    /** Half of a circle's part of a margin. */
    float nearOf(int slot) {
        int s = CircleRow.of(slot);
        float speed = CircleMath.length(state.motion[s + CircleRow.VX], state.motion[s + CircleRow.VY]);
        float own = state.ownInverseMass(slot);
        float gain = own == 0f ? 0f : CircleMath.length(state.gainX(slot, own, k), state.gainY(slot, own, k));
        return Tuning.MARGIN * state.circle[s + CircleRow.RADIUS] + 0.5f * k.dt * (speed + gain * k.subSteps);
    }

    long bytes() {
        long sum = found.bytes();
        for (RigidKeys each : keys) {
            sum += each.bytes();
        }
        return sum;
    }
}
