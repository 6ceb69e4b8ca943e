package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.RigidStep.BODY_BODY;
import static io.github.circles2d.world.bodies.RigidStep.BODY_CIRCLE;
import static io.github.circles2d.world.bodies.RigidStep.BODY_PIECE;
import static io.github.circles2d.world.bodies.RigidStep.BODY_WALL;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.jvm.pieces.PieceMeasure;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.KindMotion;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Velocity;
import io.github.circles2d.world.model.WallMotion;
import java.util.Arrays;

/** Finds the pairs of a rigid body and something near to it, in the order of their keys, and makes things of all that they have. */
final class RigidPairs {
    private final State state;
    final RigidThings things = new RigidThings();
    private final RigidCandidates candidates;

    /** By type: pairs that do not collide, since a joint holds both; of two bodies that of the lower id first. Null of what joints do not hold. */
    final RigidKeys[] partners = {new RigidKeys(), null, null, new RigidKeys()};

    private final Team team;

    /** By worker. */
    private final RigidSearch[] searches;

    /** By type, piece of the work as {@link Team#pieces} has them, and end: where its keys begin and end among those of its worker. */
    private final int[][] found = new int[BODY_CIRCLE + 1][];

    /** Those of circles, which have been looked at as they lie in memory, in order. */
    private final RigidKeys ofCircles = new RigidKeys();

    /** In the order of the keys of {@link RigidStep}. */
    RigidPair[] all = {};

    int count;
    private final RigidPair probed = new RigidPair();
    private int awakeBodies;

    private RigidThing[] thingOfBody = {};
    private RigidThing[] thingOfPiece = {};
    private RigidThing[] thingOfCircle = {};
    private final RigidThing[] thingOfWall = new RigidThing[WallMotion.COUNT];

    // within a step
    private RigidStep step;
    private StepConstants k;
    private TerrainStep terrain;

    private final Team.Share fill = this::fill;
    private final Team.Work findNear = this::findNear;
    private final Team.Share measure = this::measure;

    RigidPairs(State state, Team team) {
        this.state = state;
        this.team = team;
        candidates = new RigidCandidates(state, things, team);
        searches = new RigidSearch[team.most()];
        for (int worker = 0; worker < searches.length; worker++) {
            searches[worker] = new RigidSearch(state, things, candidates, partners);
        }
    }

    /** Makes things of the bodies. */
    void begin(RigidStep bodies, StepConstants constants, TerrainStep ground) {
        step = bodies;
        k = constants;
        terrain = constants.terrain ? ground : null;
        addBodies();
    }

    /** Of the bodies, with their parts of margins. */
    float[] boxes() {
        return candidates.box;
    }

    void find() {
        candidates.update();
        for (int type = 0; type < found.length; type++) {
            if (found[type] == null || found[type].length < 2 * team.pieces()) {
                found[type] = new int[2 * team.pieces()];
            }
        }
        team.together(findNear);
        makePairs();
        team.share(count, 0, measure);
    }

    // ---- bodies

    private void addBodies() {
        if (thingOfBody.length < step.end) {
            thingOfBody = new RigidThing[step.room()];
        }
        awakeBodies = 0;
        things.truncate(things.bodies);
        int n = 0;
        for (int id = 0; id < step.end; id++) {
            if (step.outline[id] != null) {
                if (!isThing(n, id)) { // else it stays where it is
                    things.truncate(n);
                    things.bodies = n;
                    things.add(BODY_BODY, id, 0f, 0f).setShape(step.outline[id]);
                }
                thingOfBody[id] = things.all[n++];
                awakeBodies += step.isAsleep(id) ? 0 : 1;
            }
        }
        things.truncate(n);
        things.bodies = things.count;
        candidates.ensure(things.bodies);
        team.share(things.bodies, 0, fill);
    }

    /** Whether a thing is a body as it is now; nobody else has made its outline. */
    private boolean isThing(int n, int body) {
        return n < things.bodies && things.all[n].id == body && things.all[n].shape == step.outline[body];
    }

    private void fill(int worker, int from, int end) {
        for (int n = from; n < end; n++) {
            RigidThing t = things.all[n];
            fillBody(t);
            t.near = Tuning.MARGIN * t.thin + 0.5f * way(t);
            findBox(t);
        }
    }

    private void fillBody(RigidThing t) {
        int id = t.id;
        t.x = step.x[id];
        t.y = step.y[id];
        t.turned = 0f;
        t.dx = step.restX[id];
        t.dy = step.restY[id];
        t.angle = step.angle[id];
        t.setVelocity(step.vx[id], step.vy[id], step.omega[id]);
        t.setMasses(step.inverseMass[id], step.inverseInertia[id]);
        t.restitution = step.restitution[id];
        t.kind = step.kind[id];
        takeSurface(t, KindSurface.of(step.kind[id]));
        t.gainX = 0f;
        t.gainY = 0f;
        if (t.ownW > 0f) {
            float gx = k.gravityStepX;
            float gy = k.gravityStepY;
            if (state.kindMotion != null) {
                int row = KindMotion.of(step.kind[id]);
                gx = state.kindMotion[row + KindMotion.GAIN_X];
                gy = state.kindMotion[row + KindMotion.GAIN_Y];
            }
            t.gainX = Velocity.gain(gx, step.forceX(id), t.ownW, k.h);
            t.gainY = Velocity.gain(gy, step.forceY(id), t.ownW, k.h);
        }
        t.gainOmega = Velocity.gain(0f, step.torque(id), t.ownI, k.h);
        t.asleep = step.isAsleep(id);
        if (t.asleep) {
            t.w = 0f;
            t.i = 0f;
        }
        t.turn(true);
    }

    /** What surfaces of bodies, pieces and walls are; there are none in a world in which nothing turns. */
    private void takeSurface(RigidThing t, int row) {
        if (k.turning) {
            takeSurface(t, state.turning.surfaces, row);
        } else {
            t.setSurface(0f, 0f, 0f);
        }
    }

    /** Of a static circle at rest, which has no part in the step else. */
    private void takeSurfaceAtRest(RigidThing t) {
        takeSurface(t, KindSurface.of(t.kind));
        t.friction = CircleMath.orOfKind(state.fields.getFloat(CircleField.FRICTION, t.id), t.friction);
        t.rolling = CircleMath.orOfKind(state.fields.getFloat(CircleField.ROLLING_RESISTANCE, t.id), t.rolling);
    }

    private static void takeSurface(RigidThing t, float[] rows, int row) {
        t.setSurface(
                rows[row + KindSurface.FRICTION],
                rows[row + KindSurface.ROLLING_RESISTANCE],
                rows[row + KindSurface.BELT]);
    }

    /** How far a body comes at most in a step. One that comes fast may be hit, and turn then: its other end gets twice as fast at most. */
    private float way(RigidThing t) {
        float speed = CircleMath.length(t.vx, t.vy);
        float spin = (Math.abs(t.omega) + Math.abs(t.gainOmega) * k.subSteps) * t.reach;
        float way = k.dt * (speed + t.gain() * k.subSteps + spin);
        return way > t.thin ? 2f * way : way;
    }

    // ---- what is near

    private void findNear(int worker) {
        RigidSearch search = searches[worker];
        search.begin(step, k, terrain);
        int slots = awakeBodies > 0 ? state.n : state.awake; // what rests has contacts with what is awake alone
        for (int round = 0; round < team.rounds(); round++) {
            int piece = team.piece(worker, round);
            mark(search, piece, 0);
            int end = team.to(things.bodies, worker, round);
            for (int t = team.from(things.bodies, worker, round); t < end; t++) {
                search.findNear(things.all[t]);
            }
            int endSlot = team.to(slots, worker, round);
            for (int slot = team.from(slots, worker, round); slot < endSlot; slot++) {
                search.findBodiesNear(slot);
            }
            mark(search, piece, 1);
        }
    }

    private void mark(RigidSearch search, int piece, int end) {
        for (int type = 0; type < found.length; type++) {
            found[type][2 * piece + end] = search.keys[type].count;
        }
    }

    /** Whether a circle gives way to nobody, and stays where it is: it sleeps, or is static and has no velocity. */
    boolean isStill(int slot) {
        return searches[0].isStill(slot);
    }

    // ---- what moves near to bodies that sleep

    /** Whether a wall moves near to a body. */
    boolean wallsMoveNear(RigidThing t) {
        float[] travel = k.walls.travel;
        float m = 2f * Tuning.MARGIN * t.thin;
        float[] box = candidates.box;
        int at = 4 * t.number;
        return travel[0] != 0f && box[at] - m - Math.abs(travel[0]) < k.bounds.minX()
                || travel[1] != 0f && box[at + 2] + m + Math.abs(travel[1]) > k.bounds.maxX()
                || travel[2] != 0f && box[at + 1] - m - Math.abs(travel[2]) < k.bounds.minY()
                || travel[3] != 0f && box[at + 3] + m + Math.abs(travel[3]) > k.bounds.maxY();
    }

    /** Whether terrain has pieces that may move. */
    boolean piecesMove() {
        return piecesMove(terrain);
    }

    static boolean piecesMove(TerrainStep of) {
        return of != null && of.groundNodes < of.nodes;
    }

    /** Whether a piece that moves is near to a body, which meets it. */
    boolean piecesMoveNear(RigidThing t) {
        float m = 2f * Tuning.MARGIN * t.thin;
        float[] box = candidates.box;
        int at = 4 * t.number;
        for (int n = 0; n < state.images.count; n++) {
            float minX = box[at] - m + state.images.x[n];
            float minY = box[at + 1] - m + state.images.y[n];
            float maxX = box[at + 2] + m + state.images.x[n];
            float maxY = box[at + 3] + m + state.images.y[n];
            int node = terrain.find(terrain.groundNodes, minX, minY, maxX, maxY);
            while (node >= 0) {
                int traits = PieceRow.traits(terrain.piece(node));
                if (terrain.traits[traits + PieceRow.MOTION] != 0
                        && searches[0].meets(t.kind, terrain.traits[traits + PieceRow.KIND])) {
                    return true;
                }
                node = terrain.find(node + 1, minX, minY, maxX, maxY);
            }
        }
        return false;
    }

    /** Makes a pair, which is none of the others, of a body and what has a type and an id. */
    RigidPair probe(int body, int type, int id) {
        probed.a = thingOfBody[body];
        probed.b = thing(type, id);
        measure(probed);
        return probed;
    }

    /** Forgets the things of such pairs, before which there were so many. */
    void forgetProbes(int thingsBefore) {
        things.truncate(thingsBefore);
        for (int wall = 0; wall < thingOfWall.length; wall++) {
            if (thingOfWall[wall] != null && thingOfWall[wall].number >= thingsBefore) {
                thingOfWall[wall] = null;
            }
        }
    }

    /** How many bodies are awake. */
    int awake() {
        return awakeBodies;
    }

    /** The box of a body, with its part of margins. */
    private void findBox(RigidThing t) {
        float minX = Float.POSITIVE_INFINITY;
        float minY = Float.POSITIVE_INFINITY;
        float maxX = Float.NEGATIVE_INFINITY;
        float maxY = Float.NEGATIVE_INFINITY;
        for (int k = 0; k < t.cornerCount; k++) {
            RigidCorner c = t.corners[k];
            minX = CircleMath.min(minX, (c.x + c.bentX(-1f, 0f)) - c.radius);
            minY = CircleMath.min(minY, (c.y + c.bentY(0f, -1f)) - c.radius);
            maxX = CircleMath.max(maxX, (c.x + c.bentX(1f, 0f)) + c.radius);
            maxY = CircleMath.max(maxY, (c.y + c.bentY(0f, 1f)) + c.radius);
        }
        // an eighth more, and the rounding of coordinates
        float m = 2.25f * t.near + 0x1p-20f * (Math.abs(t.x) + Math.abs(t.y) + t.reach);
        float[] box = candidates.box;
        int at = 4 * t.number;
        box[at] = t.x + minX - m;
        box[at + 1] = t.y + minY - m;
        box[at + 2] = t.x + maxX + m;
        box[at + 3] = t.y + maxY + m;
    }

    // ---- pairs

    private void makePairs() {
        count = 0;
        Arrays.fill(thingOfWall, null);
        for (int type = 0; type < BODY_CIRCLE; type++) {
            for (int piece = 0; piece < team.pieces(); piece++) {
                RigidKeys from = searches[team.worker(piece)].keys[type];
                makePairs(type, from.keys, found[type][2 * piece], found[type][2 * piece + 1]);
            }
        }
        ofCircles.count = 0;
        for (int worker = 0; worker < team.size(); worker++) {
            ofCircles.addAll(searches[worker].keys[BODY_CIRCLE]);
        }
        ofCircles.sort();
        makePairs(BODY_CIRCLE, ofCircles.keys, 0, ofCircles.count);
    }

    private void makePairs(int type, long[] keys, int from, int end) {
        ensurePairs(count + (end - from));
        long before = -1;
        for (int at = from; at < end; at++) {
            long key = keys[at];
            if (key != before) { // else an image
                before = key;
                RigidPair pair = all[count++];
                pair.a = thingOfBody[RigidKeys.body(key)];
                pair.b = thing(type, RigidKeys.other(key));
            }
        }
    }

    private RigidThing thing(int type, int id) {
        return switch (type) {
            case BODY_BODY -> thingOfBody[id];
            case BODY_PIECE -> pieceThing(id);
            case BODY_WALL -> wallThing(id);
            default -> circleThing(id);
        };
    }

    private void ensurePairs(int needed) {
        if (all.length < needed) {
            int before = all.length;
            RigidPair[] grown = Arrays.copyOf(all, Math.max(64, needed + (needed >> 1)));
            for (int p = before; p < grown.length; p++) {
                grown[p] = new RigidPair();
            }
            all = grown;
        }
    }

    private void measure(int worker, int from, int end) {
        for (int p = from; p < end; p++) {
            measure(all[p]);
        }
    }

    private void measure(RigidPair pair) {
        RigidThing t = pair.a;
        RigidThing other = pair.b;
        if (other.type == BODY_PIECE) {
            measureFromPiece(pair);
        } else {
            boolean near = state.wraps && other.type != BODY_WALL;
            pair.ox = near ? CircleMath.shortWay(t.x - other.x, state.periodX) : t.x - other.x + 0f;
            pair.oy = near ? CircleMath.shortWay(t.y - other.y, state.periodY) : t.y - other.y + 0f;
        }
        pair.margin = 2f * (t.near + other.near);
        if (other.ownW == 0f && other.shape == null) {
            pair.margin += 2f * Tuning.MARGIN * t.thin;
        }
    }

    private void measureFromPiece(RigidPair pair) {
        int row = PieceRow.of(pair.b.id);
        float[] rows = terrain.rows;
        boolean moves = terrain.traits[PieceRow.traits(pair.b.id) + PieceRow.MOTION] != 0;
        pair.ox = PieceMeasure.offsetX(state, pair.a.x, rows, row) + (moves ? -rows[row + PieceRow.PIVOT_X] : 0f);
        pair.oy = PieceMeasure.offsetY(state, pair.a.y, rows, row) + (moves ? -rows[row + PieceRow.PIVOT_Y] : 0f);
    }

    /** The thing of a body. */
    RigidThing bodyThing(int id) {
        return thingOfBody[id];
    }

    /** Whether something that is no body is a thing of the step. */
    private boolean isKnown(RigidThing t, int type, int id) {
        return t != null && t.number >= things.bodies && t.number < things.count && t.type == type && t.id == id;
    }

    private RigidThing pieceThing(int piece) {
        if (thingOfPiece.length <= piece) {
            thingOfPiece = Arrays.copyOf(thingOfPiece, terrain.pieces + (terrain.pieces >> 1));
        }
        if (!isKnown(thingOfPiece[piece], BODY_PIECE, piece)) {
            RigidThing t = things.addPiece(piece, terrain, k);
            takeSurface(t, KindSurface.of(t.kind));
            t.restitution = terrain.kinds.rows[KindTerrain.of(t.kind) + KindTerrain.RESTITUTION];
            t.near = 0.5f * terrain.rows[PieceRow.of(piece) + PieceRow.MOST];
            thingOfPiece[piece] = t;
        }
        return thingOfPiece[piece];
    }

    private RigidThing wallThing(int wall) {
        if (thingOfWall[wall] == null) {
            RigidThing t = things.addWall(wall, k);
            takeSurface(t, KindSurface.ofWall(wall));
            // along the tangent of the normal into the arena, and not towards greater coordinates
            t.belt = wall == 1 || wall == 2 ? -t.belt : t.belt;
            t.near = 0.5f * searches[0].behind(wall);
            thingOfWall[wall] = t;
        }
        return thingOfWall[wall];
    }

    private RigidThing circleThing(int id) {
        if (thingOfCircle.length <= id) {
            thingOfCircle = Arrays.copyOf(thingOfCircle, state.slotOf.length);
        }
        if (!isKnown(thingOfCircle[id], BODY_CIRCLE, id)) {
            thingOfCircle[id] = addCircle(id);
        }
        return thingOfCircle[id];
    }

    private RigidThing addCircle(int id) {
        int slot = state.slotOf[id];
        int s = CircleRow.of(slot);
        float r = state.circle[s + CircleRow.RADIUS];
        RigidThing t = things.add(BODY_CIRCLE, id, state.circle[s + CircleRow.X], state.circle[s + CircleRow.Y]);
        t.addDisc(0f, 0f, r);
        t.thin = r;
        t.reach = r;
        t.w = state.traits[s + CircleRow.INVERSE_MASS];
        t.ownW = state.ownInverseMass(slot);
        t.restitution = state.traits[s + CircleRow.RESTITUTION];
        t.kind = searches[0].kindOf(slot);
        if (t.w > 0f) {
            t.gainX = state.gainX(slot, k);
            t.gainY = state.gainY(slot, k);
        }
        t.place(true);
        t.near = searches[0].nearOf(slot);
        return t;
    }

    /** What surfaces circles touch with, once a step has begun to turn them. */
    void takeCircleSurfaces() {
        for (int n = things.bodies; n < things.count && k.turning; n++) {
            if (things.all[n].type == BODY_CIRCLE) {
                takeCircleSurface(things.all[n], state.slotOf[things.all[n].id]);
            }
        }
    }

    private void takeCircleSurface(RigidThing t, int slot) {
        float r = t.thin;
        if (slot < state.awake) {
            takeSurface(t, state.turning.circleSurfaces, KindSurface.of(slot));
            t.i = t.w == 0f ? 0f : state.turning.spin[CircleRow.of(slot) + CircleRow.INVERSE_INERTIA] / (r * r);
            t.ownI = t.i;
        } else {
            takeSurfaceAtRest(t);
            t.ownI = t.ownW == 0f ? 0f : state.turning.ownInverseInertia(slot) / (r * r);
        }
    }

    long bytes() {
        long sum = things.bytes() + candidates.bytes() + partners[BODY_BODY].bytes() + partners[BODY_CIRCLE].bytes();
        for (RigidSearch each : searches) {
            sum += each.bytes();
        }
        for (int[] each : found) {
            sum += each == null ? 0 : 4L * each.length;
        }
        return sum
                + ofCircles.bytes()
                + 76L * all.length
                + 4L * (thingOfBody.length + thingOfPiece.length + thingOfCircle.length);
    }
}
