package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.minus;
import static io.github.circles2d.reference.Numbers.plus;

import java.util.List;
import java.util.function.Function;

/** A circle and a piece of terrain near it. The circle counts as one of mass 1, so impulses are speeds. */
final class PieceContact extends Constraint {
    private static final float WALL_STIFFNESS = 2f;
    private static final float COVER = 0.02f;
    private static final float FLUSH = 0.002f;
    private static final float JAMMED = 0.01f;
    private static final int ROUNDS = 6;

    final Circle c;
    final Piece piece;

    /** That of the piece as the contact was found. */
    final int serial;

    /** Whether it pushes nothing. */
    final boolean sensed;

    private final float belt;
    private final float inverseInertia;
    private final boolean oneWay;

    /** 1 in front of the piece, -1 behind it, 0 if the piece has a front and the circle is behind. */
    float side;

    /** As measured last. */
    private Piece.Stand stand;

    private Piece.Feature feature = Piece.Feature.FACE;
    private float[] o = new float[2];
    private float[] normal = new float[2];

    /** The gap as the sub-step begins, if the circle is in the piece; else 0. */
    private float allowed;

    /** The velocity of the piece's surface. */
    private float[] surface = new float[2];

    /** What it does in the step, if it is no sensed one. */
    private final Touch touch = new Touch();

    /** The normal impulse that was applied last. */
    private float applied;

    /** How fast the surface came along the normal when the circle approached fastest. */
    private float surfaceSpeed;

    /** Where the circle was as the step began, in the frame of the piece. */
    private float[] start;

    /** What the normal speed loses in a biased visit, since the piece curves away. */
    private float bend;

    PieceContact(Circle c, Piece piece, boolean sensed, Kinds kinds, StepParameters step) {
        super(
                step,
                WALL_STIFFNESS,
                length(step.gravity()),
                2f * c.radius,
                max(c.restitution, max(kinds.restitution(piece.kind, 0f), 0f)),
                1f);
        this.c = c;
        this.piece = piece;
        serial = piece.serial;
        this.sensed = sensed;
        oneWay = kinds.get(piece.kind, Kinds.ONE_WAY) != 0;
        inverseInertia = c.turn.inverseInertia / c.inverseMass();
        belt = kinds.getFloat(piece.kind, Kinds.BELT_SPEED) + c.turn.belt;
        frictionCoefficient =
                Numbers.sqrt(c.turn.friction * Turn.friction(Float.NaN, piece.kind, kinds, step.surfaces()));
        tangentMass = 1f / (1f + inverseInertia);
        float resistance =
                max(c.turn.rollingResistance, Turn.rollingResistance(Float.NaN, piece.kind, kinds, step.surfaces()));
        rollingCoefficient = inverseInertia > 0f ? resistance : 0f;
        rollingMass = 1f / inverseInertia;
    }

    /** Whether a circle is near enough to a piece for a contact. */
    static boolean isNear(Circle c, Piece piece) {
        float path = length(c.freePath);
        return comesNear(c, piece, path + c.radius);
    }

    /** Whether a piece may come so near to the margin of a circle. */
    static boolean comesNear(Circle c, Piece piece, float far) {
        float sight = (c.radius + Circle.MARGIN * c.radius) + far;
        return piece.distance(offset(c, piece)) < sight + piece.most;
    }

    /** The base against the origin of a piece. */
    private static float[] offset(Circle c, Piece piece) {
        return offset(c, c.base, piece);
    }

    private static float[] offset(Circle c, float[] base, Piece piece) {
        float[] offset = new float[2];
        for (int a = 0; a < 2; a++) {
            offset[a] = base[a] - piece.origin[a];
            if (c.arena.isWrapped(0) || c.arena.isWrapped(1)) {
                float way = base[a] - piece.middle[a];
                offset[a] = (float) c.arena.shortWay(a, way) + (piece.middle[a] - piece.origin[a]);
            }
        }
        return offset;
    }

    /** Goes on from the contact of the step before, if there is one. */
    void begin(PieceContact last) {
        if (last != null && last.serial == serial) {
            side = last.side;
            normalImpulse = last.normalImpulse;
            friction = last.friction;
            rolling = last.rolling;
        }
        if (side == 0f && !noticesFromFront()) {
            float[] at = offset(c, piece);
            boolean front = piece.isInFront(at);
            if (hasTwoSides()) {
                side = front ? 1f : -1f;
            } else if (oneWay) {
                side = front && piece.measure(at, c.radius, 1f).gap() >= 0f ? 1f : 0f;
            } else {
                side = front ? 1f : 0f;
            }
        }
    }

    /** As measured last. */
    float[] normal() {
        return normal;
    }

    boolean acts() {
        return feature != Piece.Feature.NONE && !sensed;
    }

    // ---- where the circle is

    /** From the origin of the piece to a displacement, in the frame of the start of the step. */
    private float[] local(float[] displacement, int boundary) {
        return local(offset(c, piece), displacement, boundary);
    }

    private float[] local(float[] from, float[] displacement, int boundary) {
        Body.Motion motion = piece.body.motion;
        if (motion == null) {
            return plus(from, displacement);
        }
        float[] pivot = piece.pivot;
        float[] d = plus(minus(from, pivot), minus(displacement, motion.ways()[boundary]));
        float cos = motion.cosines()[boundary];
        float sin = motion.sines()[boundary];
        return new float[] {(cos * d[0] + sin * d[1]) + pivot[0], (cos * d[1] - sin * d[0]) + pivot[1]};
    }

    /** Measures all contacts of a circle at a boundary of sub-steps; those that are no constraints forget their impulses. */
    static void measure(List<PieceContact> all, int boundary) {
        all.forEach(contact -> contact.measure(boundary));
        all.forEach(contact -> contact.leaveToFaces(all, boundary));
        all.stream().filter(contact -> contact.feature == Piece.Feature.NONE).forEach(PieceContact::forget);
    }

    private void measure(int boundary) {
        o = local(c.displacement, boundary);
        if (start == null) {
            start = o;
            beginNotice();
        }
        if (side == 0f || noticesFromFront()) {
            feature = Piece.Feature.NONE;
            return;
        }
        stand = piece.measure(o, c.radius, side);
        boolean around =
                stand.feature() == Piece.Feature.FACE && feature != Piece.Feature.FACE && side * stand.height() < 0f;
        if (around) {
            goAround();
        }
        feature = side == 0f ? Piece.Feature.NONE : stand.feature();
        if (side == 0f) {
            return;
        }
        separation = stand.gap();
        normal = stand.normal();
        Body.Motion motion = piece.body.motion;
        if (motion != null) {
            float cos = motion.cosines()[boundary];
            float sin = motion.sines()[boundary];
            normal = new float[] {cos * normal[0] - sin * normal[1], sin * normal[0] + cos * normal[1]};
        }
        if (isAtVertex() && hasTwoSides() && stand.height() != 0f) {
            side = stand.height() > 0f ? 1f : -1f;
        }
    }

    /** Around an end, the circle has come behind the piece. */
    private void goAround() {
        side = hasTwoSides() ? -side : 0f;
        if (side != 0f) {
            stand = piece.measure(o, c.radius, side);
        }
    }

    private boolean hasTwoSides() {
        return piece.hasTwoSides() && !oneWay;
    }

    private boolean isAtVertex() {
        return feature == Piece.Feature.START || feature == Piece.Feature.END;
    }

    /** Whether it notices only circles that come from the front of the piece. */
    private boolean noticesFromFront() {
        return sensed && !hasTwoSides();
    }

    /** Where the circle comes from, if it does not touch the piece as the step begins. */
    private void beginNotice() {
        if (noticesFromFront() && !(piece.distance(start) <= c.radius)) {
            side = piece.isInFront(start) ? 1f : 0f;
        }
    }

    /** A vertex with the face of another piece under it is no constraint. */
    private void leaveToFaces(List<PieceContact> all, int boundary) {
        if (!isAtVertex() || sensed) {
            return;
        }
        boolean atStart = feature == Piece.Feature.START;
        float[] away = minus(o, atStart ? piece.start : piece.end);
        for (PieceContact other : all) {
            float[] there = other.piece.body.motion == piece.body.motion
                    ? away
                    : toFrame(other.piece.body.motion, fromFrame(piece.body.motion, away, boundary), boundary);
            if (other.hides(this, atStart, other.o, there)) {
                feature = Piece.Feature.NONE;
                return;
            }
        }
    }

    /** Whether this piece hides a vertex of another contact from the circle at a place, which is so far away from the vertex. */
    private boolean hides(PieceContact other, boolean atStart, float[] place, float[] away) {
        if (other == this || sensed || side == 0f) {
            return false;
        }
        float slack = COVER * c.radius;
        boolean free = other.piece.joint(atStart) == Piece.Joint.FREE;
        float step = free ? slack : Numbers.clamp(piece.rounding(), FLUSH * c.radius, slack);
        return piece.covers(place, side, minus(place, away), other.piece.thickness(), slack, step);
    }

    private static float[] fromFrame(Body.Motion motion, float[] d, int boundary) {
        return motion == null ? d : turned(d, motion.cosines()[boundary], motion.sines()[boundary]);
    }

    private static float[] toFrame(Body.Motion motion, float[] d, int boundary) {
        return motion == null ? d : turned(d, motion.cosines()[boundary], -motion.sines()[boundary]);
    }

    private static float[] turned(float[] d, float cos, float sin) {
        return new float[] {cos * d[0] - sin * d[1], sin * d[0] + cos * d[1]};
    }

    private void forget() {
        normalImpulse = 0f;
        friction = 0f;
        rolling = 0f;
        bounceSpeed = 0f;
    }

    /** Finds how fast the surface moves where the circle is nearest to it. */
    private void findSurface(int boundary) {
        surface = new float[2];
        Body.Motion motion = piece.body.motion;
        if (motion != null) {
            float reach = c.radius + separation;
            float[] pivot = piece.pivot;
            float[] d = plus(minus(offset(c, piece), pivot), minus(c.displacement, motion.ways()[boundary]));
            float x = d[0] - normal[0] * reach;
            float y = d[1] - normal[1] * reach;
            surface[0] = motion.velocity()[0] - motion.omega() * y;
            surface[1] = motion.velocity()[1] + motion.omega() * x;
        }
    }

    // ---- visits

    void warmStart() {
        allowed = acts() ? Numbers.min(separation, 0f) : 0f;
        normalImpulse = allowed < -JAMMED * c.radius ? 0f : normalImpulse;
        if (!acts() || !(normalImpulse > 0f)) {
            friction = 0f;
            rolling = 0f;
            return;
        }
        apply(normalImpulse);
        if (friction != 0f || rolling != 0f) {
            forgetGrips();
            applyAlong(friction);
            c.turn.speed += inverseInertia * (rolling - friction);
        }
    }

    /** The biased visit. */
    void solve(int boundary) {
        findSurface(boundary);
        bounceSpeed = 0f;
        float[] u = minus(c.velocity, surface);
        float[] way = {u[0] * step.h(), u[1] * step.h()};
        float most = Circle.CAP * c.radius;
        if (separation > Circle.MARGIN * c.radius && normalImpulse == 0f && dot(way, way) > most * most) {
            return; // its move ends at the piece
        }
        float along = tangentSpeed();
        float mostBend = Math.abs(along);
        bend = Numbers.clamp(0.5f * stand.curve() * along * along * step.h(), -mostBend, mostBend);
        float vn = normalVelocity(circle -> circle.velocity) - bend;
        float v0 = normalVelocity(circle -> circle.velocityBeforeImpulses);
        boolean staysClear = separation > 0f
                && normalImpulse == 0f
                && separation * step.inverseH() + vn >= 0f
                && separation + v0 * step.h() >= 0f;
        if (!staysClear) {
            float before = normalImpulse;
            float slip = slip(tangentSpeed(c.velocityBeforeImpulses), c.turn.speedBeforeImpulses);
            float[] place = place(c.displacement);
            applied = 0f;
            solve();
            look(v0, slip, place, before + applied);
        }
        bend = 0f;
    }

    void relax(int boundary) {
        findSurface(boundary);
        if (separation > 0f && normalImpulse == 0f && bounceSpeed == 0f && friction == 0f && rolling == 0f) {
            return;
        }
        float vn = normalVelocity(circle -> circle.velocity);
        float slip = slip(tangentSpeed(), c.turn.speed);
        float[] place = place(c.displacement);
        applied = 0f;
        relax();
        look(vn, slip, place, applied);
    }

    // ---- touches

    /** Half-way between the surfaces. */
    private float[] place(float[] displacement) {
        float[] place = new float[2];
        for (int a = 0; a < 2; a++) {
            place[a] = (c.base[a] + displacement[a]) + -normal[a] * (c.radius + 0.5f * separation);
        }
        return place;
    }

    /** Looks at the touch after a visit, by what was before it, and what it gave the circle along the normal. */
    private void look(float vn, float slip, float[] place, float impulse) {
        touch.impulse += impulse;
        float approach = max(-vn, 0f);
        if ((impulse > 0f || separation <= 0f) && approach > touch.approach) {
            touch.approach = approach;
            touch.slip = frictionCoefficient > 0f ? Math.abs(slip) : 0f;
            surfaceSpeed = dot(normal, surface);
            note(normal, place);
        }
    }

    private void note(float[] fromPiece, float[] place) {
        touch.normal = new float[] {-fromPiece[0], -fromPiece[1]};
        touch.point = place;
    }

    /** What there was in the step; null if they were not near each other. */
    Touch touchAfterStep() {
        touch.slack = Touch.SLACK * radii;
        if (sensed) {
            return sense();
        }
        touch.separation = separation;
        if (touch.approach < 0f) {
            if (feature == Piece.Feature.NONE || !touch.staysInTouch()) {
                return null;
            }
            note(normal, place(new float[2]));
        }
        touch.impulse = c.mass * touch.impulse;
        touch.normalVelocity = -dot(touch.normal, c.velocity) - surfaceSpeed;
        touch.threshold = squaredHitSpeed();
        return touch;
    }

    /** The same of a static circle, which no visit measures; touched: in the step before. */
    Touch touchOfStatic(boolean touched) {
        float[] from = offset(c, c.start, piece);
        float[] path = c.arena.way(c.start, c.base);
        float sight = (c.radius + Circle.MARGIN * c.radius) + (length(path) + c.radius);
        if (!(piece.distance(from) < sight + piece.most)) {
            return null;
        }
        start = local(from, new float[2], 0);
        o = local(from, path, step.subSteps());
        side = touched ? 1f : 0f;
        beginNotice();
        return touchAfterStep();
    }

    /** The circle has moved evenly, in the frame of the piece. */
    private Touch sense() {
        float[] u = minus(o, start);
        boolean fromBehind = !hasTwoSides() && side != 1f;
        float time = fromBehind ? piece.timeOfReturn(start, u, c.radius) : piece.timeOfNotice(start, u, c.radius);
        if (fromBehind && !(time <= 1f)) {
            return null;
        }
        touch.separation = time <= 1f ? 0f : piece.distance(o) - c.radius;
        if (!touch.staysInTouch()) {
            return null;
        }
        time = Numbers.min(time, 1f);
        float[] at = {start[0] + time * u[0], start[1] + time * u[1]};
        Piece.Stand then = piece.measure(at, c.radius, hasTwoSides() && !piece.isInFront(start) ? -1f : 1f);
        float vn = dot(then.normal(), u) / step.dt();
        touch.sensedSpeed = max(-vn, 0f);
        float away = c.radius + 0.5f * then.gap();
        float[] place = {at[0] - away * then.normal()[0], at[1] - away * then.normal()[1]};
        Body.Motion motion = piece.body.motion;
        if (motion == null) {
            note(then.normal(), plus(piece.origin, place));
            return touch;
        }
        int last = step.subSteps();
        float cos = motion.cosines()[last];
        float sin = motion.sines()[last];
        float[] p = minus(place, piece.pivot);
        float[] pivot = plus(plus(piece.origin, piece.pivot), motion.ways()[last]);
        float[] n = then.normal();
        note(
                new float[] {cos * n[0] - sin * n[1], sin * n[0] + cos * n[1]},
                new float[] {pivot[0] + (cos * p[0] - sin * p[1]), pivot[1] + (sin * p[0] + cos * p[1])});
        return touch;
    }

    @Override
    float bend() {
        return bend;
    }

    @Override
    float normalVelocity(Function<Circle, float[]> velocity) {
        return dot(normal, minus(velocity.apply(c), surface));
    }

    @Override
    boolean isLoaded() {
        return c.loaded;
    }

    @Override
    void apply(float impulse) {
        applied = impulse;
        c.velocity[0] += normal[0] * impulse;
        c.velocity[1] += normal[1] * impulse;
    }

    /** As off a wall. */
    @Override
    void applyFreeBounce(float impulse) {
        float vn = normalVelocity(circle -> circle.velocity) - bend;
        boolean fliesOn = separation > 0f && vn < 0f && -vn * step.dt() <= c.radius;
        float behind = fliesOn ? impulse * (separation / -vn) : 0f;
        c.displacement[0] -= normal[0] * behind;
        c.displacement[1] -= normal[1] * behind;
        apply(impulse);
    }

    @Override
    float tangentSpeed() {
        return tangentSpeed(c.velocity);
    }

    private float tangentSpeed(float[] velocity) {
        float[] u = minus(velocity, surface);
        return normal[0] * u[1] - normal[1] * u[0];
    }

    @Override
    float slip(float speed) {
        return slip(speed, c.turn.speed);
    }

    private float slip(float speed, float spin) {
        return (speed - spin) - belt;
    }

    @Override
    float rollingSpeed() {
        return c.turn.speed;
    }

    private void applyAlong(float impulse) {
        c.velocity[0] += -normal[1] * impulse;
        c.velocity[1] += normal[0] * impulse;
    }

    @Override
    void applyFriction(float impulse) {
        applyAlong(impulse);
        c.turn.speed += inverseInertia * -impulse;
    }

    @Override
    void applyRolling(float impulse) {
        c.turn.speed += inverseInertia * impulse;
    }

    // ---- the move

    /** Where a piece stops a circle on its move. */
    private record Stop(PieceContact contact, float share, float[] place) {}

    /**
     * Ends the move of a circle in a sub-step, so that no piece is passed, or entered: there it slides on, and a piece that moves takes it along. Then it measures the contacts there. */
    static void move(Circle c, float[] from, int subStep) {
        Stop first = firstStop(c, from, subStep, true);
        boolean stopped = first != null;
        if (stopped && first.contact.piece.body.motion != null) {
            first.contact.takeAlong(first.place, subStep + 1);
            first = firstStop(c, from, subStep, false);
        }
        float[] left = new float[2];
        for (int a = 0; a < 2 && first != null; a++) {
            float to = c.displacement[a];
            c.displacement[a] = from[a] + first.share * (to - from[a]);
            left[a] = to - c.displacement[a];
        }
        measure(c.pieceContacts, subStep + 1);
        if (first != null && first.contact.acts() && first.contact.feature == Piece.Feature.FACE) {
            slide(c, first.contact.normal, left, subStep);
        }
        keepOut(c, subStep);
        c.pieceContacts.stream()
                .filter(contact -> stopped && contact.separation <= Piece.GRAZE * c.radius)
                .forEach(contact -> contact.separation = Numbers.min(contact.separation, 0f));
    }

    private static void keepOut(Circle c, int subStep) {
        for (int round = 0; round < ROUNDS; round++) {
            float[] out = new float[2];
            for (PieceContact contact : c.pieceContacts) {
                float missing = contact.allowed - (contact.separation + dot(contact.normal, out));
                if (missing > 0f && contact.acts()) {
                    out[0] += contact.normal[0] * missing;
                    out[1] += contact.normal[1] * missing;
                }
            }
            if (out[0] == 0f && out[1] == 0f) {
                return;
            }
            c.displacement[0] += out[0];
            c.displacement[1] += out[1];
            measure(c.pieceContacts, subStep + 1);
        }
    }

    /** Goes on along a tangent, a short way. */
    private static void slide(Circle c, float[] n, float[] left, int subStep) {
        float most = Circle.CAP * c.radius;
        float way = Numbers.clamp(n[0] * left[1] - n[1] * left[0], -most, most);
        if (way != 0f) {
            c.displacement[0] -= n[1] * way;
            c.displacement[1] += n[0] * way;
            measure(c.pieceContacts, subStep + 1);
        }
    }

    private static Stop firstStop(Circle c, float[] from, int subStep, boolean alsoMoving) {
        Stop first = null;
        for (PieceContact contact : c.pieceContacts) {
            boolean looks = alsoMoving || contact.piece.body.motion == null;
            if (contact.side == 0f || contact.sensed || !looks) {
                continue;
            }
            Way way = contact.way(from, subStep);
            float most = Circle.CAP * c.radius;
            if (dot(way.u, way.u) > most * most) {
                first = contact.firstStop(way, from, subStep, first);
            }
        }
        return first;
    }

    /** A move in the frame of a piece. */
    private record Way(float[] from, float[] u) {
        float[] at(float share) {
            return new float[] {from[0] + share * u[0], from[1] + share * u[1]};
        }
    }

    /** From a displacement to that of the circle. */
    private Way way(float[] from, int subStep) {
        float[] first = local(from, subStep);
        boolean rests = piece.body.motion == null;
        return new Way(first, rests ? minus(c.displacement, from) : minus(local(c.displacement, subStep + 1), first));
    }

    /** The face, and the ends that are not covered. */
    private Stop firstStop(Way way, float[] from, int subStep, Stop before) {
        Stop first = before;
        float time = piece.timeOfFace(way.from, way.u, c.radius, side);
        if (time < (first == null ? 1f : first.share)) {
            first = new Stop(this, time, way.at(time));
        }
        for (boolean atStart : new boolean[] {true, false}) {
            time = piece.timeOfEnd(atStart, way.from, way.u, c.radius);
            if (time < (first == null ? 1f : first.share) && !isHidden(atStart, way, time, from, subStep)) {
                first = new Stop(this, time, way.at(time));
            }
        }
        return first;
    }

    /** Whether the circle touches an end under which there is a face, of a body whose frame stays parallel to that of this one. */
    private boolean isHidden(boolean atStart, Way way, float time, float[] from, int subStep) {
        float[] away = minus(way.at(time), atStart ? piece.start : piece.end);
        for (PieceContact other : c.pieceContacts) {
            boolean oneFrame = other.piece.body.motion == piece.body.motion
                    || !turns(other.piece.body.motion) && !turns(piece.body.motion);
            if (oneFrame && other.hides(this, atStart, other.way(from, subStep).at(time), away)) {
                return true;
            }
        }
        return false;
    }

    private static boolean turns(Body.Motion motion) {
        return motion != null && motion.omega() != 0f;
    }

    /** Brings the circle to a place in the piece's frame, as the piece stands at a boundary. */
    private void takeAlong(float[] to, int boundary) {
        Body.Motion motion = piece.body.motion;
        float[] pivot = piece.pivot;
        float[] at = minus(to, pivot);
        float[] from = minus(offset(c, piece), pivot);
        float cos = motion.cosines()[boundary];
        float sin = motion.sines()[boundary];
        float[] way = motion.ways()[boundary];
        c.displacement[0] = ((cos * at[0] - sin * at[1]) - from[0]) + way[0];
        c.displacement[1] = ((sin * at[0] + cos * at[1]) - from[1]) + way[1];
    }
}
