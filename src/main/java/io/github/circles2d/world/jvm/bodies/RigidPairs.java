package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.RigidStep.BODY_BODY;
import static io.github.circles2d.world.bodies.RigidStep.BODY_CIRCLE;
import static io.github.circles2d.world.bodies.RigidStep.BODY_PIECE;
import static io.github.circles2d.world.bodies.RigidStep.BODY_WALL;

import io.github.circles2d.world.bodies.OutlineShape;
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
    final RigidPieces pieces = new RigidPieces(things);
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

    int count;
    private int awakeBodies;

    /** Things of each pair; the first is a body. */
    int[] a = new int[0];

    int[] b = new int[0];

    /** By how much the base of the first lies beyond that of the second. */
    float[] ox = new float[0];

    float[] oy = new float[0];

    /** How near they may have contacts. */
    float[] margin = new float[0];

    /** By thing: half of its part of a margin. */
    private float[] near = new float[0];

    private int[] thingOfBody = new int[0];
    private int[] thingOfPiece = new int[0];
    private int[] thingOfCircle = new int[0];
    private final int[] thingOfWall = new int[WallMotion.COUNT];

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
        candidates.update(near);
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
            thingOfBody = new int[step.room()];
        }
        awakeBodies = 0;
        things.truncate(things.bodies);
        int t = 0;
        for (int id = 0; id < step.end; id++) {
            if (step.outline[id] != null) {
                if (!things.isBody(t, id, step.outline[id])) { // else it stays where it is
                    things.truncate(t);
                    things.bodies = t;
                    things.add(BODY_BODY, id, 0f, 0f);
                    things.setShape(step.outline[id]);
                }
                thingOfBody[id] = t++;
                awakeBodies += step.isAsleep(id) ? 0 : 1;
            }
        }
        things.truncate(t);
        things.bodies = things.count;
        ensureNear();
        candidates.ensure(things.bodies);
        team.share(things.bodies, 0, fill);
    }

    private void fill(int worker, int from, int end) {
        for (int t = from; t < end; t++) {
            fillBody(t);
            near[t] = Tuning.MARGIN * things.thin[t] + 0.5f * way(t);
            findBox(t);
        }
    }

    private void fillBody(int t) {
        int id = things.id[t];
        things.x[t] = step.x[id];
        things.y[t] = step.y[id];
        things.turned[t] = 0f;
        things.dx[t] = step.restX[id];
        things.dy[t] = step.restY[id];
        things.angle[t] = step.angle[id];
        things.vx[t] = step.vx[id];
        things.vy[t] = step.vy[id];
        things.omega[t] = step.omega[id];
        things.w[t] = step.inverseMass[id];
        things.i[t] = step.inverseInertia[id];
        things.ownW[t] = things.w[t];
        things.ownI[t] = things.i[t];
        things.restitution[t] = step.restitution[id];
        things.kind[t] = step.kind[id];
        takeSurface(t, KindSurface.of(step.kind[id]));
        things.gainX[t] = 0f;
        things.gainY[t] = 0f;
        if (things.ownW[t] > 0f) {
            float gx = k.gravityStepX;
            float gy = k.gravityStepY;
            if (state.kindMotion != null) {
                int row = KindMotion.of(step.kind[id]);
                gx = state.kindMotion[row + KindMotion.GAIN_X];
                gy = state.kindMotion[row + KindMotion.GAIN_Y];
            }
            things.gainX[t] = Velocity.gain(gx, step.forceX(id), things.ownW[t], k.h);
            things.gainY[t] = Velocity.gain(gy, step.forceY(id), things.ownW[t], k.h);
        }
        things.gainOmega[t] = Velocity.gain(0f, step.torque(id), things.ownI[t], k.h);
        things.asleep[t] = step.isAsleep(id);
        if (things.asleep[t]) {
            things.w[t] = 0f;
            things.i[t] = 0f;
        }
        things.turn(t);
    }

    /** What surfaces of bodies, pieces and walls are; there are none in a world in which nothing turns. */
    private void takeSurface(int t, int row) {
        if (k.turning) {
            takeSurface(t, state.turning.surfaces, row);
        } else {
            things.friction[t] = 0f;
            things.rolling[t] = 0f;
            things.belt[t] = 0f;
        }
    }

    /** Of a static circle at rest, which has no part in the step else. */
    private void takeSurfaceAtRest(int t, int id) {
        takeSurface(t, KindSurface.of(things.kind[t]));
        things.friction[t] = CircleMath.orOfKind(state.fields.getFloat(CircleField.FRICTION, id), things.friction[t]);
        things.rolling[t] =
                CircleMath.orOfKind(state.fields.getFloat(CircleField.ROLLING_RESISTANCE, id), things.rolling[t]);
    }

    private void takeSurface(int t, float[] rows, int row) {
        things.friction[t] = rows[row + KindSurface.FRICTION];
        things.rolling[t] = rows[row + KindSurface.ROLLING_RESISTANCE];
        things.belt[t] = rows[row + KindSurface.BELT];
    }

    private void ensureNear() {
        if (near.length < things.count) {
            near = Arrays.copyOf(near, things.count + (things.count >> 1));
        }
    }

    /** How far a body comes at most in a step. One that comes fast may be hit, and turn then: its other end gets twice as fast at most. */
    private float way(int t) {
        float speed = CircleMath.length(things.vx[t], things.vy[t]);
        float gain = CircleMath.length(things.gainX[t], things.gainY[t]);
        float spin = (Math.abs(things.omega[t]) + Math.abs(things.gainOmega[t]) * k.subSteps) * things.reach[t];
        float way = k.dt * (speed + gain * k.subSteps + spin);
        return way > things.thin[t] ? 2f * way : way;
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
                search.findNear(t);
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
    boolean wallsMoveNear(int t) {
        float[] travel = k.walls.travel;
        float m = 2f * Tuning.MARGIN * things.thin[t];
        float[] box = candidates.box;
        return travel[0] != 0f && box[4 * t] - m - Math.abs(travel[0]) < k.bounds.minX()
                || travel[1] != 0f && box[4 * t + 2] + m + Math.abs(travel[1]) > k.bounds.maxX()
                || travel[2] != 0f && box[4 * t + 1] - m - Math.abs(travel[2]) < k.bounds.minY()
                || travel[3] != 0f && box[4 * t + 3] + m + Math.abs(travel[3]) > k.bounds.maxY();
    }

    /** Whether terrain has pieces that may move. */
    boolean piecesMove() {
        return piecesMove(terrain);
    }

    static boolean piecesMove(TerrainStep of) {
        return of != null && of.groundNodes < of.nodes;
    }

    /** Whether a piece that moves is near to a body, which meets it. */
    boolean piecesMoveNear(int t) {
        float m = 2f * Tuning.MARGIN * things.thin[t];
        float[] box = candidates.box;
        for (int n = 0; n < state.images.count; n++) {
            float minX = box[4 * t] - m + state.images.x[n];
            float minY = box[4 * t + 1] - m + state.images.y[n];
            float maxX = box[4 * t + 2] + m + state.images.x[n];
            float maxY = box[4 * t + 3] + m + state.images.y[n];
            int node = terrain.find(terrain.groundNodes, minX, minY, maxX, maxY);
            while (node >= 0) {
                int traits = PieceRow.traits(terrain.piece(node));
                if (terrain.traits[traits + PieceRow.MOTION] != 0
                        && searches[0].meets(things.kind[t], terrain.traits[traits + PieceRow.KIND])) {
                    return true;
                }
                node = terrain.find(node + 1, minX, minY, maxX, maxY);
            }
        }
        return false;
    }

    /** Puts a pair of a body and what has a type and an id behind all others, without counting it. */
    void probe(int body, int type, int id) {
        ensurePairs(count + 1);
        a[count] = thingOfBody[body];
        b[count] = thing(type, id);
        measurePair(count);
    }

    /** Forgets what pairs have been put behind all others, and their things, of which there were so many before. */
    void forgetProbes(int thingsBefore) {
        things.truncate(thingsBefore);
        for (int wall = 0; wall < thingOfWall.length; wall++) {
            thingOfWall[wall] = thingOfWall[wall] >= thingsBefore ? -1 : thingOfWall[wall];
        }
    }

    /** How many bodies are awake. */
    int awake() {
        return awakeBodies;
    }

    /** The box of a body, with its part of margins. */
    private void findBox(int t) {
        float minX = Float.POSITIVE_INFINITY;
        float minY = Float.POSITIVE_INFINITY;
        float maxX = Float.NEGATIVE_INFINITY;
        float maxY = Float.NEGATIVE_INFINITY;
        for (int c = things.firstCorner[t]; c < things.firstCorner[t] + things.corners[t]; c++) {
            int at = RigidThings.corner(c);
            float r = things.turnedCorner[at + OutlineShape.RADIUS];
            float x = things.turnedCorner[at];
            float y = things.turnedCorner[at + 1];
            minX = CircleMath.min(minX, (x + things.bentX(c, -1f, 0f)) - r);
            minY = CircleMath.min(minY, (y + things.bentY(c, 0f, -1f)) - r);
            maxX = CircleMath.max(maxX, (x + things.bentX(c, 1f, 0f)) + r);
            maxY = CircleMath.max(maxY, (y + things.bentY(c, 0f, 1f)) + r);
        }
        // an eighth more, and the rounding of coordinates
        float m = 2.25f * near[t] + 0x1p-20f * (Math.abs(things.x[t]) + Math.abs(things.y[t]) + things.reach[t]);
        float[] box = candidates.box;
        box[4 * t] = things.x[t] + minX - m;
        box[4 * t + 1] = things.y[t] + minY - m;
        box[4 * t + 2] = things.x[t] + maxX + m;
        box[4 * t + 3] = things.y[t] + maxY + m;
    }

    // ---- pairs

    private void makePairs() {
        count = 0;
        Arrays.fill(thingOfWall, -1);
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
                int id = RigidKeys.other(key);
                a[count] = thingOfBody[RigidKeys.body(key)];
                b[count++] = thing(type, id);
            }
        }
    }

    private int thing(int type, int id) {
        return switch (type) {
            case BODY_BODY -> thingOfBody[id];
            case BODY_PIECE -> pieceThing(id);
            case BODY_WALL -> wallThing(id);
            default -> circleThing(id);
        };
    }

    private void ensurePairs(int needed) {
        if (a.length < needed) {
            int n = Math.max(64, needed + (needed >> 1));
            a = Arrays.copyOf(a, n);
            b = Arrays.copyOf(b, n);
            ox = Arrays.copyOf(ox, n);
            oy = Arrays.copyOf(oy, n);
            margin = Arrays.copyOf(margin, n);
        }
    }

    private void measure(int worker, int from, int end) {
        for (int p = from; p < end; p++) {
            measurePair(p);
        }
    }

    private void measurePair(int p) {
        int t = a[p];
        int other = b[p];
        if (things.type[other] == BODY_PIECE) {
            placePiece(p, t, things.id[other]);
        } else {
            boolean near = state.wraps && things.type[other] != BODY_WALL;
            float x = things.x[t] - things.x[other];
            float y = things.y[t] - things.y[other];
            ox[p] = near ? CircleMath.shortWay(x, state.periodX) : x + 0f;
            oy[p] = near ? CircleMath.shortWay(y, state.periodY) : y + 0f;
        }
        margin[p] = 2f * (near[t] + near[other]);
        if (things.ownW[other] == 0f && things.shape[other] == null) {
            margin[p] += 2f * Tuning.MARGIN * things.thin[t];
        }
    }

    private void placePiece(int p, int t, int piece) {
        int row = PieceRow.of(piece);
        float[] rows = terrain.rows;
        boolean moves = terrain.traits[PieceRow.traits(piece) + PieceRow.MOTION] != 0;
        ox[p] = PieceMeasure.offsetX(state, things.x[t], rows, row) + (moves ? -rows[row + PieceRow.PIVOT_X] : 0f);
        oy[p] = PieceMeasure.offsetY(state, things.y[t], rows, row) + (moves ? -rows[row + PieceRow.PIVOT_Y] : 0f);
    }

    /** The thing of a body. */
    int bodyThing(int id) {
        return thingOfBody[id];
    }

    private boolean isKnown(int[] known, int id, int type) {
        int t = known[id];
        return t >= things.bodies && t < things.count && things.type[t] == type && things.id[t] == id;
    }

    private int pieceThing(int piece) {
        if (thingOfPiece.length <= piece) {
            thingOfPiece = Arrays.copyOf(thingOfPiece, terrain.pieces + (terrain.pieces >> 1));
        }
        if (isKnown(thingOfPiece, piece, BODY_PIECE)) {
            return thingOfPiece[piece];
        }
        int t = pieces.add(BODY_PIECE, piece, terrain, k);
        takeSurface(t, KindSurface.of(things.kind[t]));
        things.restitution[t] = terrain.kinds.rows[KindTerrain.of(things.kind[t]) + KindTerrain.RESTITUTION];
        ensureNear();
        near[t] = 0.5f * terrain.rows[PieceRow.of(piece) + PieceRow.MOST];
        thingOfPiece[piece] = t;
        return t;
    }

    private int wallThing(int wall) {
        if (thingOfWall[wall] < 0) {
            int t = pieces.addWall(BODY_WALL, wall, k);
            takeSurface(t, KindSurface.ofWall(wall));
            // along the tangent of the normal into the arena, and not towards greater coordinates
            things.belt[t] = wall == 1 || wall == 2 ? -things.belt[t] : things.belt[t];
            ensureNear();
            near[t] = 0.5f * searches[0].behind(wall);
            thingOfWall[wall] = t;
        }
        return thingOfWall[wall];
    }

    private int circleThing(int id) {
        if (thingOfCircle.length <= id) {
            thingOfCircle = Arrays.copyOf(thingOfCircle, state.slotOf.length);
        }
        if (isKnown(thingOfCircle, id, BODY_CIRCLE)) {
            return thingOfCircle[id];
        }
        int slot = state.slotOf[id];
        int s = CircleRow.of(slot);
        float r = state.circle[s + CircleRow.RADIUS];
        int t = things.add(BODY_CIRCLE, id, state.circle[s + CircleRow.X], state.circle[s + CircleRow.Y]);
        things.addDisc(0f, 0f, r);
        things.thin[t] = r;
        things.reach[t] = r;
        things.w[t] = state.traits[s + CircleRow.INVERSE_MASS];
        things.ownW[t] = state.ownInverseMass(slot);
        things.restitution[t] = state.traits[s + CircleRow.RESTITUTION];
        things.kind[t] = searches[0].kindOf(slot);
        if (things.w[t] > 0f) {
            things.gainX[t] = state.gainX(slot, k);
            things.gainY[t] = state.gainY(slot, k);
        }
        things.place(t);
        ensureNear();
        near[t] = searches[0].nearOf(slot);
        thingOfCircle[id] = t;
        return t;
    }

    /** What surfaces circles touch with, once a step has begun to turn them. */
    void takeCircleSurfaces() {
        for (int t = things.bodies; t < things.count && k.turning; t++) {
            if (things.type[t] == BODY_CIRCLE) {
                takeCircleSurface(t, state.slotOf[things.id[t]]);
            }
        }
    }

    private void takeCircleSurface(int t, int slot) {
        float r = things.thin[t];
        if (slot < state.awake) {
            takeSurface(t, state.turning.circleSurfaces, KindSurface.of(slot));
            things.i[t] = things.w[t] == 0f
                    ? 0f
                    : state.turning.spin[CircleRow.of(slot) + CircleRow.INVERSE_INERTIA] / (r * r);
            things.ownI[t] = things.i[t];
        } else {
            takeSurfaceAtRest(t, things.id[t]);
            things.ownI[t] = things.ownW[t] == 0f ? 0f : state.turning.ownInverseInertia(slot) / (r * r);
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
                + 20L * a.length
                + 4L * (near.length + thingOfBody.length + thingOfPiece.length + thingOfCircle.length);
    }
}
