package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.clamp;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.limitSpeed;

import io.github.circles2d.Response;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/** What bodies that are pushed do in a step, between the passes of the circles. */
final class RigidStep {
    /** Radians by which a body turns at most in a sub-step. */
    private static final float MOST_TURN = 0.785f;

    private static final float COVER = 0.02f;

    /** The cosine of two normals that are one plane. */
    private static final float SAME = 0.9995f;

    private static final int VISITS_OF_BOUNCES = 4;
    private static final int VISITS_OF_HITS = 16;

    /** Share of an impulse by which a visit may change it where contacts agree. */
    private static final float AGREED = 1e-3f;

    /** Far beyond all that bodies reach. */
    private static final float FAR = 1e10f;

    private static final float BOX_OF_PIECE = 0x1p-21f;
    private static final float BOX_OF_BODY = 0x1p-20f;

    private final List<Circle> circles;
    private final ReferenceTerrain terrain;
    private final StepParameters k;
    private final Kinds kinds;
    private final List<RigidThing> bodies;

    /** Those that hold bodies, in the order of their ids, and those of them that do not rest. */
    private final List<ReferenceJoint> allJoints;

    private final List<ReferenceJoint> joints;

    private List<RigidJointVisit> visits = List.of();
    private final List<RigidThing> things = new ArrayList<>();

    /** Those with contacts, in the order of the types and the ids. */
    private List<RigidPair> pairs = new ArrayList<>();

    /** Contacts that stay as they are. */
    private List<RigidContact.Saved> resting = List.of();

    /** Those without circles, in the order in which a pass visits them. */
    private List<RigidPair> coloured = List.of();

    RigidStep(
            List<Rigid> bodies,
            List<Circle> circles,
            ReferenceTerrain terrain,
            ReferenceJoints joints,
            StepParameters k,
            Kinds kinds) {
        this.circles = circles;
        this.terrain = terrain;
        this.k = k;
        this.kinds = kinds;
        this.bodies = bodies.stream().map(this::thing).toList();
        things.addAll(this.bodies);
        allJoints = joints.all().stream().filter(ReferenceJoint::holdsRigid).toList();
        this.joints = allJoints.stream().filter(joint -> !joint.rests()).toList();
    }

    // ---- what takes part

    private RigidThing thing(Rigid body) {
        RigidThing t = new RigidThing(RigidThing.BODY, body.id, body.base.clone());
        t.body = body;
        t.setOutline(body.outline);
        t.way = body.rest.clone();
        t.omega = body.omega;
        t.w = 1f / body.mass;
        t.i = 1f / body.inertia;
        t.ownW = t.w;
        t.ownI = t.i;
        t.restitution = body.restitution;
        takeSurface(t, body.kind);
        float scale = kinds.getFloat(body.kind, Kinds.GRAVITY_SCALE);
        for (int a = 0; a < 2; a++) {
            t.velocity[a] = body.velocity[a];
            t.gain[a] = gain(limitSpeed(k.gravity()[a] * scale) * k.h(), body.force(a), t.w);
        }
        t.angularGain = gain(0f, body.torque(), t.i);
        t.ownGain = t.gain.clone();
        t.ownAngularGain = t.angularGain;
        t.turnBody();
        float speed = length(t.velocity);
        float spin = (Math.abs(t.omega) + Math.abs(t.angularGain) * k.subSteps()) * t.reach;
        float way = k.dt() * (speed + length(t.gain) * k.subSteps() + spin);
        t.near = Circle.MARGIN * t.thin + 0.5f * (way > t.thin ? 2f * way : way);
        if (body.isAsleep()) {
            t.w = 0f;
            t.i = 0f;
            t.gain[0] = 0f;
            t.gain[1] = 0f;
            t.angularGain = 0f;
        }
        t.given = new FixedSum(t.reach * k.inverseH());
        t.givenSpin = new FixedSum(k.inverseH());
        return t;
    }

    private float gain(float byGravity, float force, float w) {
        return force == 0f ? byGravity : limitSpeed(byGravity + force * w * k.h());
    }

    private void takeSurface(RigidThing t, int kind) {
        t.kind = kind;
        t.friction = Turn.friction(Float.NaN, kind, kinds, k.surfaces());
        t.rolling = Turn.rollingResistance(Float.NaN, kind, kinds, k.surfaces());
        t.belt = kinds.getFloat(kind, Kinds.BELT_SPEED);
    }

    private RigidThing thing(Circle c) {
        RigidThing t = new RigidThing(RigidThing.CIRCLE, c.id, c.base.clone());
        t.circle = c;
        t.addDisc(0f, 0f, c.radius);
        t.turn(1f, 0f);
        t.kind = c.kind;
        t.thin = c.radius;
        t.reach = c.radius;
        t.w = c.inverseMass();
        t.i = c.turn.inverseInertia / (c.radius * c.radius);
        t.ownW = c.ownInverseMass();
        t.ownI = c.turn.ownInverseInertia / (c.radius * c.radius);
        t.restitution = c.restitution;
        t.friction = c.turn.friction;
        t.rolling = c.turn.rollingResistance;
        t.belt = c.turn.belt;
        for (int a = 0; a < 2 && !c.isStatic(); a++) {
            t.gain[a] = c.gain[a];
        }
        float speed = length(c.velocity);
        float gain = c.hasInfiniteMass() ? 0f : length(c.gain);
        t.near = Circle.MARGIN * c.radius + 0.5f * k.dt() * (speed + gain * k.subSteps());
        return t;
    }

    /** 0 to 3: left, right, lower, upper. */
    private RigidThing wall(int number) {
        int axis = number / 2;
        boolean lower = number % 2 == 0;
        float side = lower ? 1f : -1f;
        float at = lower ? k.min()[axis] : k.max()[axis];
        RigidThing t = new RigidThing(RigidThing.WALL, number, axis == 0 ? at : 0f, axis == 0 ? 0f : at);
        if (axis == 0) {
            t.addLine(0f, -side * FAR, side, 0f, 2f * FAR, 0f);
        } else {
            t.addLine(side * FAR, 0f, 0f, side, 2f * FAR, 0f);
        }
        t.turn(1f, 0f);
        t.velocity[axis] = side * limitSpeed(in(number) / k.dt());
        t.friction = k.surfaces().wallFriction(number);
        t.rolling = k.surfaces().wallRollingResistance(number);
        float belt = k.surfaces().belt(number);
        t.belt = number == 1 || number == 2 ? -belt : belt;
        t.near = 0.5f * Numbers.max(in(number), 0f);
        move(t, 0);
        return t;
    }

    private float in(int wall) {
        return (wall % 2 == 0 ? k.minIn() : k.maxIn())[wall / 2];
    }

    private RigidThing thing(Piece piece) {
        Body.Motion motion = piece.body.motion;
        RigidThing t = new RigidThing(RigidThing.PIECE, piece.id, piece.origin.clone());
        t.piece = piece;
        t.oneWay = kinds.get(piece.kind, Kinds.ONE_WAY) != 0;
        takeSurface(t, piece.kind);
        t.restitution = kinds.restitution(piece.kind, 0f);
        t.near = 0.5f * piece.most;
        float[] pivot = {0f, 0f};
        if (motion != null) {
            pivot = piece.pivot;
            t.velocity[0] = motion.velocity()[0];
            t.velocity[1] = motion.velocity()[1];
            t.omega = motion.omega();
        }
        piece.addTo(t, pivot);
        t.turn(1f, 0f);
        move(t, 0);
        return t;
    }

    /** Brings a piece or a wall to where it is at a boundary of sub-steps. */
    private void move(RigidThing t, int boundary) {
        if (t.type == RigidThing.WALL) {
            float behind = k.behind(in(t.id), boundary - 1);
            t.way[t.id / 2] = t.id % 2 == 0 ? -behind : behind;
        } else if (t.piece.body.motion != null) {
            Body.Motion motion = t.piece.body.motion;
            t.way = motion.ways()[boundary].clone();
            t.turn(motion.cosines()[boundary], motion.sines()[boundary]);
        }
    }

    // ---- pairs

    /** The box of a body with its part of margins, and some more: least x and y, greatest x and y. */
    private static float[] box(RigidThing t) {
        float[] low = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY};
        float[] high = {Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};
        for (float[] c : t.corners) {
            for (int a = 0; a < 2; a++) {
                float lower = RigidThing.farthest(c, a == 0 ? -1f : 0f, a == 0 ? 0f : -1f)[a];
                float upper = RigidThing.farthest(c, a == 0 ? 1f : 0f, a == 0 ? 0f : 1f)[a];
                low[a] = Numbers.min(low[a], (c[a] + lower) - c[2]);
                high[a] = Numbers.max(high[a], (c[a] + upper) + c[2]);
            }
        }
        float m = 2.25f * t.near + BOX_OF_BODY * (Math.abs(t.place[0]) + Math.abs(t.place[1]) + t.reach);
        return new float[] {
            t.place[0] + low[0] - m, t.place[1] + low[1] - m, t.place[0] + high[0] + m, t.place[1] + high[1] + m
        };
    }

    private static float[] wider(float[] box, float by) {
        return new float[] {box[0] - by, box[1] - by, box[2] + by, box[3] + by};
    }

    private static float[] box(Piece piece) {
        float[] box = new float[4];
        for (int a = 0; a < 2; a++) {
            float reach = piece.halfExtent[a] + piece.most;
            reach += (Math.abs(piece.middle[a]) + reach) * BOX_OF_PIECE;
            box[a] = piece.middle[a] - reach;
            box[2 + a] = piece.middle[a] + reach;
        }
        return box;
    }

    /** Whether a box, or one of its images where an axis wraps, meets another one. */
    private boolean meet(float[] box, float[] other) {
        int x = k.arena().isWrapped(0) ? 1 : 0;
        int y = k.arena().isWrapped(1) ? 1 : 0;
        for (int u = -x; u <= x; u++) {
            for (int v = -y; v <= y; v++) {
                float ax = u == 0 ? 0f : u * k.arena().period(0);
                float ay = v == 0 ? 0f : v * k.arena().period(1);
                if (other[0] <= box[2] + ax
                        && other[1] <= box[3] + ay
                        && other[2] >= box[0] + ax
                        && other[3] >= box[1] + ay) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean meets(RigidThing body, int kind) {
        return kinds.response(body.kind, kind) == Response.SOLID;
    }

    /** Whether a joint keeps two from colliding. */
    private boolean areParted(RigidThing body, RigidThing other) {
        return joints.stream().anyMatch(joint -> joint.parts(body, other));
    }

    private static boolean areOfOneGroup(RigidThing body, int group) {
        return group != 0 && body.body.group == group;
    }

    private float[] way(RigidThing from, RigidThing to) {
        return k.arena().way(from.place, to.place);
    }

    private float[] wayFromPiece(RigidThing piece, RigidThing body) {
        Piece p = piece.piece;
        float[] way = new float[2];
        for (int a = 0; a < 2; a++) {
            boolean wraps = k.arena().isWrapped(0) || k.arena().isWrapped(1);
            float[] fromMiddle = k.arena().way(p.middle, body.place);
            float plain = wraps ? fromMiddle[a] + (p.middle[a] - p.origin[a]) : body.place[a] - p.origin[a];
            way[a] = plain + (p.body.motion == null ? 0f : -p.pivot[a]);
        }
        return way;
    }

    private void findPairs() {
        for (RigidThing t : bodies) {
            for (RigidThing o : bodies) {
                if (o.id > t.id
                        && (t.gives() || o.gives())
                        && meets(t, o.kind)
                        && !areOfOneGroup(t, o.body.group)
                        && !areParted(t, o)
                        && meet(box(t), box(o))) {
                    pairs.add(new RigidPair(t, o, way(o, t), k));
                }
            }
        }
        if (bodies.isEmpty()) {
            return;
        }
        List<RigidThing> pieces = terrain.pieces().stream().map(this::thing).toList();
        for (RigidThing t : bodies) {
            for (RigidThing o : pieces) {
                float[] box = wider(box(t), 2f * Circle.MARGIN * t.thin);
                if (t.gives() && meets(t, o.kind) && meet(box, box(o.piece))) {
                    pairs.add(new RigidPair(t, o, wayFromPiece(o, t), k));
                }
            }
        }
        List<RigidThing> walls = List.of(wall(0), wall(1), wall(2), wall(3));
        for (RigidThing t : bodies) {
            for (RigidThing o : walls) {
                float[] box = wider(box(t), 2f * Circle.MARGIN * t.thin);
                int axis = o.id / 2;
                float behind = Numbers.max(in(o.id), 0f);
                boolean near =
                        o.id % 2 == 0 ? box[axis] - behind < k.min()[axis] : box[2 + axis] + behind > k.max()[axis];
                if (near && t.gives()) {
                    pairs.add(new RigidPair(t, o, Numbers.minus(t.place, o.place), k));
                }
            }
        }
        List<RigidThing> discs = circles.stream().map(this::thing).toList();
        for (RigidThing t : bodies) {
            for (RigidThing o : discs) {
                float m = o.reach + 2.25f * o.near;
                float[] box = wider(new float[] {o.place[0], o.place[1], o.place[0], o.place[1]}, m);
                boolean moves = t.gives() || !isStill(o.circle);
                boolean parted = areOfOneGroup(t, o.circle.group) || areParted(t, o);
                if (moves && meets(t, o.kind) && !parted && meet(box, box(t))) {
                    pairs.add(new RigidPair(t, o, way(o, t), k));
                }
            }
        }
        things.addAll(pairs.stream()
                .map(pair -> pair.b)
                .filter(t -> t.body == null)
                .distinct()
                .toList());
    }

    /** Whether a circle gives way to nobody and has no velocity. */
    private static boolean isStill(Circle c) {
        return c.isStatic() && c.velocity[0] == 0f && c.velocity[1] == 0f;
    }

    // ---- sleep

    List<RigidThing> bodies() {
        return bodies;
    }

    List<ReferenceJoint> joints() {
        return allJoints;
    }

    /** The body at a side of a joint, or null. */
    RigidThing thing(ReferenceJoint joint, int side) {
        return joint.rigids[side] == null ? null : bodyOf(joint.rigids[side].id);
    }

    private boolean isAsleep(int id) {
        return bodies.stream().anyMatch(t -> t.id == id && t.isAsleep());
    }

    /** Whether both things of a contact of the step before rest: it stays as it is. */
    private boolean rests(RigidContact.Saved saved) {
        return isAsleep(saved.body())
                && switch (saved.type()) {
                    case RigidThing.BODY -> isAsleep(saved.other());
                    case RigidThing.CIRCLE -> circles.stream().anyMatch(c -> c.id == saved.other() && isStill(c));
                    default -> true;
                };
    }

    /** What of contacts stays. */
    List<RigidContact.Saved> resting(List<RigidContact.Saved> saved, float warmScale) {
        return saved.stream()
                .filter(this::rests)
                .map(each -> each.times(warmScale))
                .toList();
    }

    /** A contact that stays, as it lies. */
    RigidContact measured(RigidContact.Saved saved) {
        RigidThing t = bodyOf(saved.body());
        RigidThing o =
                switch (saved.type()) {
                    case RigidThing.BODY -> bodyOf(saved.other());
                    case RigidThing.PIECE ->
                        thing(terrain.pieces().stream()
                                .filter(piece -> piece.id == saved.other())
                                .findFirst()
                                .orElseThrow());
                    case RigidThing.WALL -> wall(saved.other());
                    default ->
                        thing(circles.stream()
                                .filter(c -> c.id == saved.other())
                                .findFirst()
                                .orElseThrow());
                };
        float[] offset =
                switch (saved.type()) {
                    case RigidThing.PIECE -> wayFromPiece(o, t);
                    case RigidThing.WALL -> Numbers.minus(t.place, o.place);
                    default -> way(o, t);
                };
        return new RigidPair(t, o, offset, k).measured(saved);
    }

    private RigidThing bodyOf(int id) {
        return bodies.stream().filter(t -> t.id == id).findFirst().orElseThrow();
    }

    /** Whether a wall or a piece moves near to a body that sleeps. */
    boolean movesNear(RigidThing t) {
        float[] box = wider(box(t), 2f * Circle.MARGIN * t.thin);
        boolean near = false;
        for (int wall = 0; wall < 4; wall++) {
            int axis = wall / 2;
            float travel = Math.abs(in(wall));
            near |= in(wall) != 0f
                    && (wall % 2 == 0 ? box[axis] - travel < k.min()[axis] : box[2 + axis] + travel > k.max()[axis]);
        }
        for (Piece piece : terrain.pieces()) {
            near |= piece.body.motion != null && meets(t, piece.kind) && meet(box, box(piece));
        }
        return near;
    }

    /** Finds the contacts as all lies now, with what they have accumulated. */
    List<RigidContact> find(List<RigidContact.Saved> saved, float warmScale) {
        findPairs();
        for (RigidPair pair : pairs) {
            Predicate<RigidContact.Saved> itsOwn =
                    s -> s.type() == pair.b.type && s.body() == pair.a.id && s.other() == pair.b.id;
            pair.find(saved.stream().filter(itsOwn).toList(), warmScale);
        }
        return contacts();
    }

    /** Begins the step. */
    void begin(List<RigidContact.Saved> saved, float warmScale) {
        resting = resting(saved, warmScale);
        find(saved, warmScale);
        leaveOutCovered();
        pairs = pairs.stream().filter(pair -> !pair.contacts.isEmpty()).toList();
        colour();
        takeCircles(false);
        for (RigidThing t : bodies) {
            t.share = 0f;
        }
        for (RigidPair pair : pairs) {
            for (RigidContact c : pair.contacts) {
                if (pair.hasCircle()) {
                    float kb = c.inverseMassOf(c.a == pair.a);
                    pair.a.share += kb / (kb + pair.b.ownW);
                }
            }
        }
        for (RigidThing t : bodies) {
            t.share = Numbers.max(t.share, 1f);
        }
        visits = joints.stream().map(joint -> visit(joint, warmScale)).toList();
        visits.forEach(RigidJointVisit::prepare);
        pushCircles();
    }

    private RigidJointVisit visit(ReferenceJoint joint, float warmScale) {
        return new RigidJointVisit(joint, thing(joint, 0), thing(joint, 1), k, warmScale);
    }

    private List<RigidContact> contacts() {
        return pairs.stream().flatMap(pair -> pair.contacts.stream()).toList();
    }

    /** Contacts do not begin at joints of what a body slides over. */
    private void leaveOutCovered() {
        List<RigidContact> all = contacts();
        List<RigidContact> covered = all.stream()
                .filter(c -> c.impulse == 0f && (isCovered(c, c.a, all) || isCovered(c, c.b, all)))
                .toList();
        pairs.forEach(pair -> pair.contacts.removeAll(covered));
    }

    private static boolean isCovered(RigidContact c, RigidThing t, List<RigidContact> all) {
        float slack = COVER * t.thin;
        return t.type == RigidThing.BODY
                && t.w > 0f
                && all.stream()
                        .anyMatch(p -> p != c
                                && (p.a == t || p.b == t)
                                && p.onLine
                                && p.impulse > 0f
                                && p.gap <= 0.5f * slack
                                && (p.a == t ? p.b : p.a).type != RigidThing.CIRCLE
                                && covers(p, c, t, slack));
    }

    /** Whether what a body meets by c is no higher than the plane of a contact p of it. */
    private static boolean covers(RigidContact p, RigidContact c, RigidThing t, float slack) {
        float side = p.a == t ? 1f : -1f;
        float[] normal = {side * p.nx, side * p.ny};
        float[] point = p.a == t ? new float[] {p.ax, p.ay} : new float[] {p.bx, p.by};
        boolean ownCorner = c.a == t;
        float dot = c.nx * normal[0] + c.ny * normal[1];
        if ((ownCorner ? dot : -dot) > SAME) {
            return false;
        }
        for (float[] corner : t.corners) {
            float[] bend = RigidThing.farthest(corner, -normal[0], -normal[1]);
            float height = (corner[0] - point[0] + bend[0]) * normal[0] + (corner[1] - point[1] + bend[1]) * normal[1];
            if (height - corner[2] < -slack) {
                return false;
            }
        }
        float[] way = c.wayToA();
        float away = ownCorner ? -1f : 1f;
        float x = away * way[0] - point[0];
        float y = away * way[1] - point[1];
        if (!ownCorner || !c.onLine) {
            float[] corner = ownCorner ? c.feature() : c.corner();
            float[] bend = RigidThing.farthest(corner, normal[0], normal[1]);
            return !isHigher(x + bend[0] + corner[0], y + bend[1] + corner[1], normal, slack - corner[2]);
        }
        float[] line = c.feature();
        if (RigidThing.isHollow(line) || c.b.type == RigidThing.WALL) {
            return false;
        }
        float fromX = x + line[0];
        float fromY = y + line[1];
        float toX = fromX - line[3] * line[4];
        float toY = fromY + line[2] * line[4];
        return !isHigher(fromX, fromY, normal, slack - line[5]) && !isHigher(toX, toY, normal, slack - line[5]);
    }

    private static boolean isHigher(float x, float y, float[] normal, float most) {
        return x * normal[0] + y * normal[1] > most;
    }

    /** Pairs without circles choose the least colour that no other pair of their bodies has. */
    private void colour() {
        List<RigidPair> left = pairs.stream().filter(pair -> !pair.hasCircle()).toList();
        List<RigidPair> chosen = new ArrayList<>();
        for (RigidPair pair :
                left.stream().sorted(Comparator.comparingInt(RigidPair::hash)).toList()) {
            pair.colour = 0;
            while (isTaken(pair, chosen)) {
                pair.colour++;
            }
            chosen.add(pair);
        }
        coloured = left.stream()
                .sorted(Comparator.comparingInt(pair -> pair.colour))
                .toList();
    }

    private static boolean isTaken(RigidPair pair, List<RigidPair> chosen) {
        return chosen.stream()
                .anyMatch(other -> other.colour == pair.colour
                        && (pair.a.gives() && (other.a == pair.a || other.b == pair.a)
                                || pair.b.gives() && (other.a == pair.b || other.b == pair.b)));
    }

    // ---- passes

    void integrateVelocities() {
        for (RigidThing t : bodies) {
            float damping = 1f / (1f + kinds.getFloat(t.kind, Kinds.DAMPING) * k.h());
            float most = kinds.getFloat(t.kind, Kinds.GREATEST_SPEED);
            t.velocity[0] += t.gain[0];
            t.velocity[1] += t.gain[1];
            float speed = length(t.velocity[0] * damping, t.velocity[1] * damping);
            float factor = damping * (speed > most ? most / speed : 1f);
            t.velocity[0] *= factor;
            t.velocity[1] *= factor;
            t.omega += t.angularGain;
            t.omega *= 1f / (1f + kinds.getFloat(t.kind, Kinds.ANGULAR_DAMPING) * k.h());
        }
        for (RigidThing t : things) {
            t.velocityBefore = t.velocity.clone();
            t.omegaBefore = t.omega;
        }
        takeCircles(true);
        visits.forEach(RigidJointVisit::warmStart);
        contacts().forEach(RigidContact::warmStart);
    }

    void solve(int subStep) {
        visits.forEach(visit -> visit.solve(subStep));
        coloured.forEach(RigidStep::solve);
    }

    /** A pair that bounces, or comes fast, is visited several times, so that its contacts agree; behind each normal bounces grip. */
    private static void solve(RigidPair pair) {
        int times = 1;
        for (int time = 0; time < times; time++) {
            boolean agree = true;
            for (RigidContact c : pair.contacts) {
                float before = c.impulse;
                c.solve(false);
                if (Math.abs(c.impulse - before) > AGREED * c.impulse) {
                    agree = false;
                }
                times = c.bounce > 0f ? Math.max(times, VISITS_OF_BOUNCES) : times;
                times = c.isHit() ? VISITS_OF_HITS : times;
                for (RigidContact other : pair.contacts) {
                    if (times > 1 && other.bounce > 0f) {
                        other.solveGrip(false);
                    }
                }
            }
            if (time == VISITS_OF_BOUNCES - 1 && times == VISITS_OF_BOUNCES && !agree) {
                times = VISITS_OF_HITS;
            }
        }
    }

    void solveCircles() {
        takeCircles(false);
        passOverCircles(false);
        for (RigidPair pair : pairs) {
            Circle circle = pair.b.circle;
            boolean pushed = pair.contacts.stream().anyMatch(c -> c.impulse > 0f);
            if (circle != null && pushed && !circle.stands && !circle.isPushed) {
                circle.allowance = Float.POSITIVE_INFINITY;
            }
        }
        contacts().forEach(RigidContact::forgetBounce);
    }

    void integratePositions(int subStep) {
        for (RigidThing t : things) {
            switch (t.type) {
                case RigidThing.BODY -> move(t);
                case RigidThing.CIRCLE -> t.way = t.circle.displacement.clone();
                default -> move(t, subStep + 1);
            }
        }
        contacts().forEach(RigidContact::measure);
    }

    private void move(RigidThing t) {
        for (int a = 0; a < 2; a++) {
            t.velocity[a] = limitSpeed(t.velocity[a]);
            t.way[a] += t.velocity[a] * k.h();
        }
        t.omega = clamp(t.omega, -MOST_TURN * k.inverseH(), MOST_TURN * k.inverseH());
        t.turned += t.omega * k.h();
        t.turnBody();
    }

    void relax(int subStep) {
        visits.forEach(visit -> visit.relax(subStep, subStep == k.subSteps() - 1));
        for (RigidPair pair : coloured) {
            for (RigidContact c : pair.contacts) {
                if (!c.isIdle() && !c.bouncesLater()) {
                    c.relax(false);
                }
                pair.contacts.forEach(other -> other.solveGrip(false));
            }
        }
    }

    void relaxCircles(boolean last) {
        takeCircles(false);
        passOverCircles(true);
        if (!last) {
            pushCircles();
        }
    }

    // ---- circles

    private void takeCircles(boolean before) {
        for (RigidThing t : things) {
            if (t.circle != null) {
                Turn turn = t.circle.turn;
                t.velocity[0] = t.circle.velocity[0];
                t.velocity[1] = t.circle.velocity[1];
                t.omega = turn.speed / t.circle.radius;
                if (before) {
                    t.velocityBefore = t.circle.velocityBeforeImpulses.clone();
                    t.omegaBefore = turn.speedBeforeImpulses / t.circle.radius;
                }
            }
        }
    }

    /** Circles see bodies as they were, and bodies take the sum of what circles give them. */
    private void passOverCircles(boolean relaxes) {
        List<RigidPair> withCircles =
                pairs.stream().filter(RigidPair::hasCircle).toList();
        for (RigidPair pair : withCircles) {
            for (RigidContact c : pair.contacts) {
                if (relaxes && c.isIdle() || !pair.a.gives() && !pair.b.gives()) {
                    continue;
                }
                if (relaxes) {
                    c.relax(true);
                } else {
                    c.solve(true);
                }
                if (relaxes || c.bounce > 0f) {
                    c.solveGrip(true);
                }
            }
        }
        if (!withCircles.isEmpty()) {
            bodies.forEach(RigidThing::takeGiven);
        }
        for (RigidThing t : things) {
            if (t.circle != null && t.w > 0f) {
                t.circle.velocity[0] = t.velocity[0];
                t.circle.velocity[1] = t.velocity[1];
                t.circle.turn.speed = t.omega * t.circle.radius;
            }
        }
    }

    /** What contacts of circles have accumulated acts on these in the next sub-step. */
    private void pushCircles() {
        for (RigidPair pair : pairs) {
            Circle circle = pair.b.circle;
            for (RigidContact c : pair.contacts) {
                if (circle != null && !circle.isStatic() && c.impulse > 0f) {
                    float side = c.a == pair.b ? 1f : -1f;
                    circle.impulses[0] += side * (c.nx * c.impulse - c.ny * c.grip);
                    circle.impulses[1] += side * (c.ny * c.impulse + c.nx * c.grip);
                    circle.turn.impulse -= c.grip;
                    circle.loadedNext = true;
                }
            }
        }
    }

    // ---- end

    /** Joints that break. */
    List<ReferenceJoint> broken() {
        return visits.stream()
                .filter(RigidJointVisit::breaks)
                .map(visit -> visit.joint)
                .toList();
    }

    /** What the pairs touched, each by the contact that pressed most. */
    List<RigidTouch> touches() {
        List<RigidTouch> found = new ArrayList<>();
        for (RigidPair pair : pairs) {
            RigidTouch hardest = null;
            for (RigidContact c : pair.contacts) {
                RigidTouch its = c.touch();
                hardest = its != null && (hardest == null || its.impulse() > hardest.impulse()) ? its : hardest;
            }
            if (hardest != null) {
                found.add(hardest);
            }
        }
        return found;
    }

    /** Pairs at rest. */
    Set<RigidTouch.Key> resting() {
        return resting.stream()
                .map(saved -> new RigidTouch.Key(false, saved.type(), saved.body(), saved.other()))
                .collect(Collectors.toSet());
    }

    /** Bodies take what they have become; returns the contacts that the next step starts from. */
    List<RigidContact.Saved> end() {
        for (RigidThing t : bodies) {
            if (t.isAsleep()) {
                t.body.release();
                continue;
            }
            float[] moved = Numbers.minus(t.way, t.body.rest);
            int turned = t.angle() - t.body.angle;
            t.body.arrive(t.way, k.arena(), k.min(), k.max());
            t.body.angle = t.angle();
            for (int a = 0; a < 2; a++) {
                t.body.velocity[a] = limitSpeed(t.velocity[a]);
            }
            t.body.omega = limitSpeed(t.omega);
            if (k.sleep()) {
                boolean driven = joints.stream().anyMatch(joint -> joint.isOf(t.body) && joint.drivesRigids());
                RigidSleep.rest(t, moved, turned, driven, k, kinds);
            }
        }
        List<RigidContact.Saved> kept = new ArrayList<>(resting);
        contacts().forEach(c -> kept.add(c.save()));
        return kept;
    }
}
