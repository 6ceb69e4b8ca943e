package io.github.circles2d.reference;

import io.github.circles2d.Response;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** The pieces of terrain and the bodies that they belong to. */
final class ReferenceTerrain {
    /** The sine of the least angle by which a chain turns to its right; by less it is straight. */
    private static final double STRAIGHT = 0x1p-13;

    /** Of a piece: a share of the coordinates. */
    private static final double LEAST_SHARE = 0x1p-20;

    private static final double LEAST_LENGTH = 0x1p-40;

    private static final long TURN = 1L << 32;

    // bits of handles that are in no id
    private static final int PIECE = 1 << 29;
    private static final int BODY = 1 << 28;

    /** Openings that differ so little from a turn are one. */
    private static final long SLACK = 1 << 14;

    private static final long PIECE_CONTACT = 0x6F6E7069656365L;

    private final List<Piece> pieces = new ArrayList<>();
    private final List<Body> bodies = new ArrayList<>();

    /** By id: how many have had it. */
    private final Map<Integer, Integer> pieceGenerations = new HashMap<>();

    private final Map<Integer, Integer> bodyGenerations = new HashMap<>();
    private int lastSerial;

    ReferenceTerrain() {
        bodies.add(new Body(0, newHandle(0, bodyGenerations, BODY), 0f, 0f, 0));
    }

    /** In the order of their ids. */
    List<Piece> pieces() {
        return pieces.stream().filter(Objects::nonNull).toList();
    }

    /** In the order of their ids; the ground is the first. */
    List<Body> bodies() {
        return bodies.stream().filter(Objects::nonNull).toList();
    }

    Body body(long handle) {
        return bodies.get((int) handle & ~BODY);
    }

    Piece piece(long handle) {
        return pieces.get((int) handle & ~PIECE);
    }

    private static <T> int freeId(List<T> all) {
        if (!all.contains(null)) {
            all.add(null);
        }
        return all.indexOf(null);
    }

    private static long newHandle(int id, Map<Integer, Integer> generations, int mark) {
        return (long) generations.merge(id, 1, Integer::sum) << 32 | mark | id;
    }

    // ---- calls

    long addBody(float x, float y, float angle) {
        int id = freeId(bodies);
        Body body = new Body(id, newHandle(id, bodyGenerations, BODY), x, y, (int) Angles.units(angle));
        bodies.set(id, body);
        return body.handle;
    }

    void removeBody(Body body) {
        pieces().stream().filter(piece -> piece.body == body).forEach(this::remove);
        bodies.set(body.id, null);
    }

    void teleport(Body body, float x, float y, float angle) {
        body.put(x, y, (int) Angles.units(angle));
        pieces().stream().filter(piece -> piece.body == body).forEach(piece -> piece.serial = ++lastSerial);
    }

    private <T extends Piece> T add(T piece) {
        pieces.set(piece.id, piece);
        piece.serial = ++lastSerial;
        return piece;
    }

    private Piece addLine(Body body, float[] from, float[] to, boolean twoSided, float thickness, int kind) {
        int id = freeId(pieces);
        long handle = newHandle(id, pieceGenerations, PIECE);
        return add(new LinePiece(id, handle, body, kind, from, to, twoSided, thickness));
    }

    private Piece addArc(
            Body body, float[] centre, float[] toMiddle, float radius, int half, boolean solidOutside, int kind) {
        int id = freeId(pieces);
        long handle = newHandle(id, pieceGenerations, PIECE);
        return add(new ArcPiece(id, handle, body, kind, centre, toMiddle, radius, half, solidOutside));
    }

    long addSegment(Body body, float x1, float y1, float x2, float y2, float thickness, int kind) {
        return addLine(body, new float[] {x1, y1}, new float[] {x2, y2}, true, thickness, kind).handle;
    }

    long addArc(Body body, float x, float y, float radius, float from, float to, boolean inner, int kind) {
        int half = (int) (opening((double) to - from) >>> 1);
        int middle = (int) Angles.units(from) + half;
        float[] toMiddle = {(float) Angles.cos(middle), (float) Angles.sin(middle)};
        return addArc(body, new float[] {x, y}, toMiddle, radius, half, inner, kind).handle;
    }

    static long opening(double angle) {
        long units = Angles.units(angle);
        return Math.abs(units) > TURN - SLACK ? Long.signum(units) * TURN : units;
    }

    /** Adds the pieces of a chain, and returns their handles. */
    List<Long> addChain(Body body, ChainShape shape, int kind) {
        List<Piece> chain = new ArrayList<>();
        float[] first = {shape.x(), shape.y()};
        float[] at = first;
        for (float[] way : shape.ways()) {
            float[] to = way.length == 2 ? way : endOfArc(at, way);
            chain.add(way.length == 2 ? addLine(body, at, to, false, 0f, kind) : addArc(body, at, way, kind));
            at = to;
        }
        if (shape.closed() && !isTooShort(at, first)) {
            chain.add(addLine(body, at, first, false, 0f, kind));
        }
        for (int k = 0; k + 1 < chain.size(); k++) {
            join(chain.get(k), chain.get(k + 1));
        }
        if (shape.closed()) {
            join(chain.get(chain.size() - 1), chain.get(0));
        }
        return chain.stream().map(piece -> piece.handle).toList();
    }

    private static float[] endOfArc(float[] from, float[] way) {
        long turn = opening(way[2]);
        double dx = (double) from[0] - way[0];
        double dy = (double) from[1] - way[1];
        double cos = Angles.cos((int) turn);
        double sin = Angles.sin((int) turn);
        return new float[] {(float) (way[0] + (cos * dx - sin * dy)), (float) (way[1] + (sin * dx + cos * dy))};
    }

    private Piece addArc(Body body, float[] from, float[] way, int kind) {
        long turn = opening(way[2]);
        double dx = (double) from[0] - way[0];
        double dy = (double) from[1] - way[1];
        double radius = Math.sqrt(dx * dx + dy * dy);
        int half = (int) (Math.abs(turn) >>> 1);
        double cos = Angles.cos(half);
        double sin = turn < 0 ? -Angles.sin(half) : Angles.sin(half);
        float[] toMiddle = {(float) ((cos * dx - sin * dy) / radius), (float) ((sin * dx + cos * dy) / radius)};
        return addArc(body, new float[] {way[0], way[1]}, toMiddle, (float) radius, half, turn < 0, kind);
    }

    static boolean isTooShort(float[] a, float[] b) {
        double dx = (double) b[0] - a[0];
        double dy = (double) b[1] - a[1];
        double most = 0;
        for (float coordinate : new float[] {a[0], a[1], b[0], b[1]}) {
            most = Math.max(most, Math.abs(coordinate));
        }
        return !(Math.sqrt(dx * dx + dy * dy) > Math.max(LEAST_SHARE * most, LEAST_LENGTH));
    }

    /** Joins the end of a piece to the start of another. */
    private static void join(Piece piece, Piece next) {
        piece.after = next;
        next.before = piece;
        double[] a = piece.endDirection();
        double[] b = next.startDirection();
        double cross = a[0] * b[1] - a[1] * b[0];
        double dot = a[0] * b[0] + a[1] * b[1];
        boolean convex = cross >= 0 || dot > 0 && cross > -STRAIGHT;
        piece.endJoint = convex ? Piece.Joint.CONVEX : Piece.Joint.CONCAVE;
        next.startJoint = piece.endJoint;
    }

    /** Removes a piece; its neighbours have free ends then. */
    void remove(Piece piece) {
        if (piece.before != null) {
            piece.before.after = null;
            piece.before.endJoint = Piece.Joint.FREE;
        }
        if (piece.after != null) {
            piece.after.before = null;
            piece.after.startJoint = Piece.Joint.FREE;
        }
        pieces.set(piece.id, null);
    }

    void clear() {
        pieces().forEach(this::remove);
        bodies().stream().filter(body -> body.id != 0).forEach(body -> bodies.set(body.id, null));
    }

    /** Of pieces and bodies. */
    long hash() {
        long sum = 0;
        for (Piece piece : pieces()) {
            sum += piece.hash();
        }
        for (Body body : bodies()) {
            sum += body.id == 0 ? 0 : body.hash();
        }
        return sum;
    }

    /** Of the contacts of a circle with pieces that are still those. */
    long hashOfContacts(Circle c) {
        long sum = 0;
        for (PieceContact contact : c.pieceContacts) {
            Piece piece = contact.piece;
            if (pieces.get(piece.id) == piece && piece.serial == contact.serial) {
                long h = ReferenceWorld.absorb(ReferenceWorld.absorb(PIECE_CONTACT, c.id), piece.id);
                h = ReferenceWorld.absorb(h, (int) contact.side);
                sum += ReferenceWorld.absorb(h, contact.normalImpulse, contact.friction, contact.rolling);
            }
        }
        return sum;
    }

    // ---- a step

    void begin(StepParameters k) {
        bodies().forEach(body -> body.begin(k));
        for (Piece piece : pieces()) {
            piece.place(k.arena());
            piece.most = piece.body.most(piece.farthest());
        }
    }

    /** Finds the pieces that a circle is near to, which is not static. */
    void findContacts(Circle c, Kinds kinds, StepParameters k) {
        Map<Piece, PieceContact> before = new HashMap<>();
        c.pieceContacts.forEach(contact -> before.put(contact.piece, contact));
        c.pieceContacts.clear();
        for (Piece piece : pieces()) {
            switch (kinds.response(c.kind, piece.kind)) {
                case SOLID, SENSE -> {
                    if (PieceContact.isNear(c, piece)) {
                        boolean sensed = kinds.response(c.kind, piece.kind) == Response.SENSE;
                        PieceContact contact = new PieceContact(c, piece, sensed, kinds, k);
                        contact.begin(before.get(piece));
                        c.pieceContacts.add(contact);
                    }
                }
                default -> {
                    // they ignore each other
                }
            }
        }
    }

    /** Of a circle that sleeps, those with which pieces press it, measured. */
    List<PieceContact> contactsAtRest(Circle c, Kinds kinds, StepParameters k) {
        List<PieceContact> kept = List.copyOf(c.pieceContacts);
        findContacts(c, kinds, k);
        List<PieceContact> found = List.copyOf(c.pieceContacts);
        c.pieceContacts.clear();
        c.pieceContacts.addAll(kept);
        PieceContact.measure(found, 0);
        return found.stream()
                .filter(contact -> contact.acts() && contact.normalImpulse > 0f)
                .toList();
    }

    /** Whether a piece that moves may reach a circle. */
    boolean movesNear(Circle c, Kinds kinds) {
        return pieces().stream()
                .anyMatch(piece -> piece.body.motion != null
                        && kinds.response(c.kind, piece.kind) != Response.IGNORE
                        && PieceContact.comesNear(c, piece, Circle.MARGIN * c.radius));
    }

    void end(Arena arena) {
        bodies().forEach(body -> body.end(arena));
    }
}
