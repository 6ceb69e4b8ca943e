package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.RigidStep.BODY_BODY;
import static io.github.circles2d.world.bodies.RigidStep.BODY_CIRCLE;
import static io.github.circles2d.world.bodies.RigidStep.BODY_PIECE;
import static io.github.circles2d.world.bodies.RigidStep.SENSED;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidExtras;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.jvm.pieces.PieceMeasure;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.TouchRule;
import java.util.Arrays;

/**
 * Finds what bodies only sense, or what senses them, behind the last sub-step, if somebody is told of touches. It changes nothing else. It goes by
 * where a step begins and ends, also for what sleeps.
 */
public final class RigidSensing {
    /** Of the gap at which a pair stays in touch: that at which it begins to touch. */
    private static final double BEGINS = 0.1;

    /** Of a length: points that are nearer have no direction. */
    private static final double COINCIDENT = 1e-9;

    /** More than tolerances and rounding, in half thicknesses and in coordinates. */
    private static final float MARGIN = 0.02f;

    private static final float ROUNDING = 0x1p-20f;

    /** Ids of some, and where they are as the step begins. */
    private static final class Begun {
        private int[] id = new int[16];
        private float[] x = new float[16];
        private float[] y = new float[16];
        private int[] angle = new int[16];
        private int count;

        private void add(int itsId, float atX, float atY, int itsAngle) {
            if (count == id.length) {
                id = Arrays.copyOf(id, 2 * count);
                x = Arrays.copyOf(x, 2 * count);
                y = Arrays.copyOf(y, 2 * count);
                angle = Arrays.copyOf(angle, 2 * count);
            }
            id[count] = itsId;
            x[count] = atX;
            y[count] = atY;
            angle[count++] = itsAngle;
        }
    }

    private final State state;
    private final RigidTree tree = new RigidTree();
    private final RigidTree.Found found = new RigidTree.Found();
    private final float[] circleBox = new float[4];
    private final SensedShape a = new SensedShape();
    private final SensedShape b = new SensedShape();
    private final SensedGap gap = new SensedGap();

    /** Pairs that are near, by type: those of bodies, of pieces and of circles. */
    private final RigidKeys[] near = {new RigidKeys(), new RigidKeys(), null, new RigidKeys()};

    /** By kind: whether it senses some other, or itself. */
    private final boolean[] senses = new boolean[PairTable.KINDS];

    /** Those that do. */
    private final int[] kinds = new int[PairTable.KINDS];

    private int kindCount;
    private int version = -1;

    /** By kind that senses: how many bodies have it; whether such a body looks for others; whether circles of the kind take part. */
    private final int[] many = new int[PairTable.KINDS];

    private final boolean[] looks = new boolean[PairTable.KINDS];
    private final boolean[] meetsBodies = new boolean[PairTable.KINDS];
    private boolean someLook;

    /** The bodies and circles that take part. */
    private final Begun bodies = new Begun();

    private final Begun circles = new Begun();

    /** By id of a circle: which of these it is. */
    private int[] circleAt = new int[0];

    /** Whether circles may sense bodies in the step. */
    private boolean withCircles;

    // within a step
    private RigidStep step;
    private TerrainStep terrain;
    private StepConstants k;
    private int[] responses;

    public RigidSensing(State state) {
        this.state = state;
    }

    /** Whether kinds sense each other. */
    private boolean learn(StepInput of) {
        responses = of.responses;
        if (version != of.responsesVersion) {
            version = of.responsesVersion;
            kindCount = 0;
            for (int kind = 0; kind < PairTable.KINDS; kind++) {
                senses[kind] = false;
                for (int other = 0; other < PairTable.KINDS; other++) {
                    senses[kind] |= senses(kind, other);
                }
                kinds[kindCount] = kind;
                kindCount += senses[kind] ? 1 : 0;
            }
        }
        return kindCount > 0;
    }

    private boolean senses(int kind, int other) {
        return PairTable.get(responses, kind, other) == PairTable.SENSE;
    }

    /** A step begins: notes where all is that takes part. */
    public void begin(RigidStep of, StepInput input) {
        beginWithoutCircles(of, input);
        if (withCircles) {
            noteCircles();
        }
    }

    /** The same, but circles are noted as the step ends. */
    public void beginWithoutCircles(RigidStep of, StepInput input) {
        step = of;
        bodies.count = 0;
        circles.count = 0;
        withCircles = false;
        if (step.listener == null || !state.filtering || !learn(input)) {
            return;
        }
        noteBodies();
        if (bodies.count == 0) {
            return;
        }
        someLook = false;
        for (int n = 0; n < kindCount; n++) {
            int kind = kinds[n];
            looks[kind] = false;
            meetsBodies[kind] = false;
            for (int m = 0; m < kindCount; m++) {
                boolean met = senses(kind, kinds[m]) && many[kinds[m]] > 0;
                meetsBodies[kind] |= met;
                looks[kind] |= met && (kind == kinds[m] || looksFor(kind, kinds[m]));
            }
            withCircles |= meetsBodies[kind];
            someLook |= looks[kind];
        }
    }

    /** Whether circles are to be noted. */
    public boolean seeksCircles() {
        return withCircles;
    }

    /** The kind looks of which there are fewer. */
    private boolean looksFor(int kind, int other) {
        return many[kind] < many[other] || many[kind] == many[other] && kind < other;
    }

    private void noteBodies() {
        Arrays.fill(many, 0);
        for (int id = 0; id < step.end; id++) {
            if (step.outline[id] != null && senses[step.kind[id]]) {
                many[step.kind[id]]++;
                bodies.add(id, step.x[id], step.y[id], step.angle[id]);
            }
        }
    }

    private void noteCircles() {
        for (int slot = 0; slot < state.n; slot++) {
            int s = CircleRow.of(slot);
            noteCircle(state.id[slot], state.circle[s + CircleRow.X], state.circle[s + CircleRow.Y]);
        }
    }

    /** Notes where a circle is as the step begins, if it takes part. */
    public void noteCircle(int id, float x, float y) {
        if (!meetsBodies(state.fields.getInt(CircleField.KIND, id))) {
            return;
        }
        if (circleAt.length < state.slotOf.length) {
            circleAt = Arrays.copyOf(circleAt, state.slotOf.length);
        }
        circleAt[id] = circles.count;
        circles.add(id, x, y, 0);
    }

    private boolean meetsBodies(int kind) {
        return senses[kind] && meetsBodies[kind];
    }

    /** Where the bodies that take part have been in the step, which has ended: four floats each, least x and y, greatest x and y. */
    public float[] boxes() {
        findBoxes();
        return tree.box;
    }

    public int boxCount() {
        return bodies.count;
    }

    /** The step ends: adds what is sensed to its touches. Terrain is null if there is none. */
    public void end(StepConstants constants, TerrainStep ground) {
        boolean alone = !someLook && circles.count == 0 && ground == null;
        if (bodies.count == 0 || alone) {
            return;
        }
        k = constants;
        terrain = ground;
        near[BODY_BODY].count = 0;
        near[BODY_PIECE].count = 0;
        near[BODY_CIRCLE].count = 0;
        findBoxes();
        for (int n = 0; n < bodies.count; n++) {
            if (looks[step.kind[bodies.id[n]]]) {
                findBodies(n);
            }
            if (terrain != null) {
                findPieces(n);
            }
        }
        for (int n = 0; n < circles.count; n++) {
            findBodiesNear(n);
        }
        tell(BODY_BODY);
        tell(BODY_PIECE);
        tell(BODY_CIRCLE);
    }

    // ---- what is near

    private float way(float from, float to, float period) {
        float way = to - from;
        return state.wraps ? CircleMath.shortWay(way, period) : way;
    }

    private void findBoxes() {
        tree.makeRoom(bodies.count);
        for (int n = 0; n < bodies.count; n++) {
            OutlineShape outline = step.outline[bodies.id[n]];
            float r = outline.reach() + MARGIN * outline.halfThickness();
            setBox(tree.box, 4 * n, bodies.x[n], bodies.y[n], wayX(n), wayY(n), r);
        }
        tree.build(bodies.count);
    }

    private static void setBox(float[] to, int at, float x, float y, float wayX, float wayY, float r) {
        float m = r + ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(wayX) + Math.abs(wayY) + r);
        to[at] = x + Math.min(wayX, 0f) - m;
        to[at + 1] = y + Math.min(wayY, 0f) - m;
        to[at + 2] = x + Math.max(wayX, 0f) + m;
        to[at + 3] = y + Math.max(wayY, 0f) + m;
    }

    private float wayX(int n) {
        return way(bodies.x[n], step.x[bodies.id[n]], state.periodX);
    }

    private float wayY(int n) {
        return way(bodies.y[n], step.y[bodies.id[n]], state.periodY);
    }

    /** Finds those that meet a box or one of its images. */
    private void look(float[] of, int at) {
        found.count = 0;
        for (int n = 0; n < state.images.count; n++) {
            float byX = state.images.x[n];
            float byY = state.images.y[n];
            tree.find(tree.box, of[at] + byX, of[at + 1] + byY, of[at + 2] + byX, of[at + 3] + byY, found);
        }
    }

    private void findBodies(int n) {
        look(tree.box, 4 * n);
        int kind = step.kind[bodies.id[n]];
        for (int f = 0; f < found.count; f++) {
            int id = bodies.id[n];
            int other = bodies.id[found.box[f]];
            int itsKind = step.kind[other];
            if (id != other
                    && senses(kind, itsKind)
                    && (kind == itsKind ? id < other : looksFor(kind, itsKind))
                    && !step.isOfGroup(id, step.extras.get(other, RigidExtras.GROUP))) {
                near[BODY_BODY].add(Math.min(id, other), Math.max(id, other));
            }
        }
    }

    private void findPieces(int n) {
        int kind = step.kind[bodies.id[n]];
        for (int image = 0; image < state.images.count; image++) {
            float minX = tree.box[4 * n] + state.images.x[image];
            float minY = tree.box[4 * n + 1] + state.images.y[image];
            float maxX = tree.box[4 * n + 2] + state.images.x[image];
            float maxY = tree.box[4 * n + 3] + state.images.y[image];
            int node = terrain.find(0, minX, minY, maxX, maxY);
            while (node >= 0) {
                int piece = terrain.piece(node);
                if (senses(kind, terrain.traits[PieceRow.traits(piece) + PieceRow.KIND])) {
                    near[BODY_PIECE].add(bodies.id[n], piece);
                }
                node = terrain.find(node + 1, minX, minY, maxX, maxY);
            }
        }
    }

    private void findBodiesNear(int n) {
        int id = circles.id[n];
        float r = state.circle[CircleRow.of(state.slotOf[id]) + CircleRow.RADIUS];
        setBox(circleBox, 0, circles.x[n], circles.y[n], circleWayX(n), circleWayY(n), (1f + MARGIN) * r);
        look(circleBox, 0);
        int kind = state.fields.getInt(CircleField.KIND, id);
        int group = step.extras.areThere() ? state.fields.getInt(CircleField.GROUP, id) : 0;
        for (int f = 0; f < found.count; f++) {
            int body = bodies.id[found.box[f]];
            if (senses(kind, step.kind[body]) && !step.isOfGroup(body, group)) {
                near[BODY_CIRCLE].add(body, id);
            }
        }
    }

    private float circleWayX(int n) {
        int s = CircleRow.of(state.slotOf[circles.id[n]]);
        return way(circles.x[n], state.circle[s + CircleRow.X], state.periodX);
    }

    private float circleWayY(int n) {
        int s = CircleRow.of(state.slotOf[circles.id[n]]);
        return way(circles.y[n], state.circle[s + CircleRow.Y], state.periodY);
    }

    // ---- touches

    /** Tells of the pairs of a type that touch, in order. */
    private void tell(int type) {
        RigidKeys pairs = near[type];
        pairs.sort();
        long before = -1;
        for (int p = 0; p < pairs.count; p++) {
            long key = pairs.keys[p];
            if (key != before) { // else an image
                before = key;
                tell(type, RigidKeys.body(key), RigidKeys.other(key));
            }
        }
    }

    private void tell(int type, int id, int other) {
        int n = Arrays.binarySearch(bodies.id, 0, bodies.count, id);
        OutlineShape outline = step.outline[id];
        a.takeBody(outline);
        a.put(0, 0, wayX(n), wayY(n), bodies.angle[n], step.angle[id] - bodies.angle[n]);
        double length = outline.halfThickness();
        boolean touched = step.listener.touched(type + SENSED, id, other);
        if (type == BODY_PIECE) {
            double tolerance = tolerance(length, touched);
            takePiece(n, other);
            if (!touched && !isTwoSided(other) && !comesFromFront(other, tolerance, length)) {
                return;
            }
        } else if (type == BODY_BODY) {
            int m = Arrays.binarySearch(bodies.id, 0, bodies.count, other);
            length += step.outline[other].halfThickness();
            b.takeBody(step.outline[other]);
            b.put(
                    way(bodies.x[n], bodies.x[m], state.periodX),
                    way(bodies.y[n], bodies.y[m], state.periodY),
                    wayX(m),
                    wayY(m),
                    bodies.angle[m],
                    step.angle[other] - bodies.angle[m]);
        } else {
            float r = state.circle[CircleRow.of(state.slotOf[other]) + CircleRow.RADIUS];
            int m = circleAt[other];
            length += r;
            b.takeDisc(r);
            b.put(
                    way(bodies.x[n], circles.x[m], state.periodX),
                    way(bodies.y[n], circles.y[m], state.periodY),
                    circleWayX(m),
                    circleWayY(m),
                    0,
                    0);
        }
        if (gap.findTouch(a, b, tolerance(length, touched), length)) {
            add(type, id, n, other, length);
        }
    }

    private static double tolerance(double length, boolean touched) {
        return (touched ? 1 : BEGINS) * TouchRule.SLACK * length;
    }

    private boolean isTwoSided(int piece) {
        return PieceMeasure.isTwoSided(terrain, piece, terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE]);
    }

    /** Brings a piece to where it is against the body. */
    private void takePiece(int n, int piece) {
        float[] rows = terrain.rows;
        int row = PieceRow.of(piece);
        int shape = terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE];
        float ox = PieceMeasure.offsetX(state, bodies.x[n], rows, row);
        float oy = PieceMeasure.offsetY(state, bodies.y[n], rows, row);
        int motion = terrain.traits[PieceRow.traits(piece) + PieceRow.MOTION];
        if (motion == 0) {
            b.takePiece(rows, row, shape, 0, 0);
            b.put(0 - ox, 0 - oy, 0, 0, 0, 0);
            return;
        }
        int of = BodyRow.of(motion, k.subSteps);
        int pose = of + BodyRow.pose(k.subSteps);
        double px = rows[row + PieceRow.PIVOT_X];
        double py = rows[row + PieceRow.PIVOT_Y];
        b.takePiece(rows, row, shape, px, py);
        b.put(
                px - ox,
                py - oy,
                terrain.motion[pose + BodyRow.DX],
                terrain.motion[pose + BodyRow.DY],
                0,
                (double) terrain.motion[of + BodyRow.OMEGA] * k.dt / Rotation.RADIANS_PER_UNIT);
    }

    /** Whether a body is beside a piece that has a front, and comes from there. */
    private boolean comesFromFront(int piece, double tolerance, double length) {
        a.setShare(0);
        b.setShare(0);
        if (gap.measure(a, b, length) <= tolerance) {
            return false;
        }
        float[] rows = terrain.rows;
        int row = PieceRow.of(piece);
        int shape = terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE];
        if (PieceRow.form(shape) == PieceRow.ARC) {
            double dx = b.edges[0].centreX;
            double dy = b.edges[0].centreY;
            boolean outside = Math.sqrt(dx * dx + dy * dy) > rows[row + PieceRow.LENGTH];
            return outside == ((shape & PieceRow.SOLID_OUTSIDE) == 0);
        }
        double dx = 0 - b.edges[0].fromX;
        double dy = 0 - b.edges[0].fromY;
        return dx * rows[row + PieceRow.TY] - dy * rows[row + PieceRow.TX] > 0;
    }

    // ---- of a touch

    /** Adds the touch that has been found: its point and normal, and how fast both approach there. */
    private void add(int type, int id, int n, int other, double length) {
        boolean apart = gap.isApart && gap.least > COINCIDENT * length;
        if (!apart) {
            gap.nearToPlace();
        }
        boolean atPlace = !apart && a.reach < b.reach;
        double px = atPlace ? a.nowX : apart ? gap.ax : gap.bx;
        double py = atPlace ? a.nowY : apart ? gap.ay : gap.by;
        double nx = gap.bx - gap.ax;
        double ny = gap.by - gap.ay;
        double d = Math.sqrt(nx * nx + ny * ny);
        boolean up = !(d > COINCIDENT * length);
        nx = up ? 0 : nx / d;
        ny = up ? 1 : ny / d;
        double spin = a.turn * Rotation.RADIANS_PER_UNIT;
        double itsSpin = b.turn * Rotation.RADIANS_PER_UNIT;
        double ux = (a.goX - spin * (py - a.nowY)) - (b.goX - itsSpin * (py - b.nowY));
        double uy = (a.goY + spin * (px - a.nowX)) - (b.goY + itsSpin * (px - b.nowX));
        double speed = Math.max((ux * nx + uy * ny) / k.dt, 0);
        step.addTouch(
                type + SENSED,
                id,
                other,
                (float) (bodies.x[n] + px),
                (float) (bodies.y[n] + py),
                (float) nx + 0f,
                (float) ny + 0f,
                0f,
                (float) speed + 0f);
    }

    public long bytes() {
        return tree.bytes()
                + found.bytes()
                + a.bytes()
                + b.bytes()
                + near[BODY_BODY].bytes()
                + near[BODY_PIECE].bytes()
                + near[BODY_CIRCLE].bytes()
                + 16L * (bodies.id.length + circles.id.length)
                + 4L * circleAt.length;
    }
}
