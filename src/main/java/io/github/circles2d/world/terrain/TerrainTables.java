package io.github.circles2d.world.terrain;

import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.TerrainStep;

/** The terrain of a world: pieces, bodies and the tree, and what a step is told of them. Changes have been checked, and there is room. */
public final class TerrainTables {
    public final BodyTable bodies = new BodyTable();
    public final PieceTable pieces = new PieceTable(bodies);
    private final PieceTree tree = new PieceTree();
    private final TerrainStep step;

    /** Where bodies that moved in the last step were then: rows and boxes lag behind the poses. */
    private boolean lags;

    private boolean groundChanged;
    private boolean bodiesChanged;
    private Bounds bounds;

    /** No pieces. The step is told of what there is. */
    public TerrainTables(TerrainStep step, Bounds bounds) {
        this.step = step;
        setBounds(bounds);
    }

    /** Axes that wrap keep their edges. */
    public void setBounds(Bounds to) {
        bounds = to;
        pieces.filler().setBounds(to);
    }

    public Bounds bounds() {
        return bounds;
    }

    /** Whether there are pieces. */
    public boolean isThere() {
        return pieces.ids.size() > 0;
    }

    // ---- pieces

    private void fill(int piece) {
        pieces.filler().setPose(bodies, pieces.body[piece]);
        pieces.filler().fill(piece);
        treeChanged(pieces.body[piece]);
    }

    private void treeChanged(int body) {
        if (body == BodyTable.GROUND) {
            groundChanged = true;
        } else {
            bodiesChanged = true;
        }
    }

    public int addSegment(int body, int kind, float x1, float y1, float x2, float y2, float thickness) {
        int piece = pieces.addLine(body, kind, PieceRow.SEGMENT, x1, y1, x2, y2, thickness);
        fill(piece);
        return piece;
    }

    /** Anticlockwise from an angle in radians; opening: in units, at most a turn. */
    public int addArc(
            int body, int kind, float x, float y, float radius, float from, long opening, boolean solidOutside) {
        int half = (int) (opening >>> 1);
        int middle = Surface.units(from) + half;
        int piece = pieces.addArc(
                body,
                kind,
                arcShape(solidOutside),
                x,
                y,
                (float) Rotation.cos(middle),
                (float) Rotation.sin(middle),
                radius,
                half);
        fill(piece);
        return piece;
    }

    private static int arcShape(boolean solidOutside) {
        return PieceRow.ARC | (solidOutside ? PieceRow.SOLID_OUTSIDE : 0);
    }

    /** Adds the pieces of a chain; handles takes theirs, and may be null. */
    public void addChain(int body, int kind, ChainPath chain, int count, boolean closed, long[] handles) {
        int first = -1;
        int previous = -1;
        for (int k = 0; k < count; k++) {
            int piece = add(body, kind, chain, k);
            if (previous >= 0) {
                pieces.join(previous, piece);
                fill(previous);
            } else {
                first = piece;
            }
            previous = piece;
            if (handles != null) {
                handles[k] = pieces.ids.handle(piece);
            }
        }
        if (closed) {
            pieces.join(previous, first);
        }
        fill(previous);
    }

    private int add(int body, int kind, ChainPath chain, int k) {
        long turn = chain.turn(k);
        if (turn == 0) {
            return pieces.addLine(
                    body, kind, PieceRow.LINE, chain.x(k), chain.y(k), chain.x(k + 1), chain.y(k + 1), 0f);
        }
        // the middle is half the turn on from the start
        float centreX = chain.centreX(k);
        float centreY = chain.centreY(k);
        double dx = (double) chain.x(k) - centreX;
        double dy = (double) chain.y(k) - centreY;
        double radius = Math.sqrt(dx * dx + dy * dy);
        int half = (int) (Math.abs(turn) >>> 1);
        double cos = Rotation.cos(half);
        double sin = turn < 0 ? -1 * Rotation.sin(half) : Rotation.sin(half);
        return pieces.addArc(
                body,
                kind,
                arcShape(turn < 0),
                centreX,
                centreY,
                (float) ((cos * dx - sin * dy) / radius),
                (float) ((sin * dx + cos * dy) / radius),
                chain.radius(k),
                half);
    }

    public void remove(int piece) {
        int body = pieces.body[piece];
        pieces.filler().setPose(bodies, body);
        pieces.remove(piece);
        treeChanged(body);
    }

    // ---- bodies

    public int addBody(float x, float y, int angle) {
        return bodies.add(bounds.placeX(x), bounds.placeY(y), angle);
    }

    /** Removes a body with its pieces, in the order of their ids, in which others are told of them. */
    public void removeBody(int body) {
        for (int piece = 0; bodies.firstPiece[body] >= 0; piece++) {
            if (pieces.ids.lives(piece) && pieces.body[piece] == body) {
                remove(piece);
            }
        }
        bodies.remove(body);
    }

    /** Puts a body somewhere else; contacts with its pieces so far do not count. */
    public void teleport(int body, float x, float y, int angle) {
        bodies.put(body, bounds.placeX(x), bounds.placeY(y), angle);
        for (int piece = bodies.firstPiece[body]; piece >= 0; piece = pieces.nextOfBody(piece)) {
            pieces.renew(piece);
        }
        rest(body);
        bodiesChanged = true;
    }

    public void travel(int body, float x, float y, int angle) {
        bodies.travel(body, bounds.placeX(x), bounds.placeY(y), angle);
    }

    /** Removes all pieces, and all bodies but the ground. */
    public void clear() {
        for (int piece = 0; piece < pieces.ids.end(); piece++) {
            if (pieces.ids.lives(piece)) {
                remove(piece);
            }
        }
        bodies.clear();
    }

    // ---- states

    public long hash() {
        return pieces.hash() + bodies.hash();
    }

    public void save(SavedTerrain to) {
        to.setIds(pieces.ids.end(), bodies.ids.end());
        pieces.save(to);
        bodies.save(to);
    }

    /** Leaves out contacts with pieces that are others now. */
    public void keepPresent(SavedPieceContacts contacts) {
        int kept = 0;
        for (int k = 0; k < contacts.count; k++) {
            if (contacts.serial[k] == pieces.serial(contacts.piece[k])) {
                contacts.move(k, kept++);
            }
        }
        contacts.count = kept;
    }

    /** Makes room for {@link #load}. If there is none, nothing has changed. */
    public void makeRoom(SavedTerrain from) {
        pieces.makeRoom(from.pieceIds);
        bodies.makeRoom(from.bodyIds);
    }

    /** Takes over saved terrain, which has been checked; contacts get the serials of now. There is room. */
    public void load(SavedTerrain from, Bounds to, SavedPieceContacts contacts) {
        boolean wrapsAlike =
                bounds.edgeX() == to.edgeX() && bounds.edgeY() == to.edgeY() && !(to.wraps() && bounds.differs(to));
        setBounds(to);
        if (wrapsAlike && bodies.areThose(from) && pieces.areThose(from)) {
            bodies.loadPoses(from); // as in each rollback: nothing of the ground has changed
            bodiesChanged = true;
        } else {
            bodies.load(from);
            pieces.load(from);
            groundChanged = true;
        }
        for (int body = groundChanged ? 0 : 1; body < bodies.ids.end(); body++) {
            if (bodies.firstPiece[body] >= 0) {
                rest(body);
            }
        }
        for (int k = 0; k < contacts.count; k++) {
            contacts.serial[k] = pieces.serial(contacts.piece[k]);
        }
        lags = false;
    }

    // ---- steps

    /** Makes room for {@link #begin} and {@link #refresh}. If there is none, nothing has changed. */
    public void makeRoom(int subSteps) {
        tree.ensure(pieces.ids.size());
        int needed = BodyRow.of(bodies.movers() + 1, subSteps);
        if (step.motion.length < needed) {
            step.motion = new float[Math.max(needed, step.motion.length + (step.motion.length >> 1))];
        }
    }

    /** Fills the rows of a body's pieces, where it is now, at rest. */
    private void rest(int body) {
        pieces.filler().setPose(bodies, body);
        for (int piece = bodies.firstPiece[body]; piece >= 0; piece = pieces.nextOfBody(piece)) {
            pieces.filler().fill(piece);
        }
    }

    /** Brings rows and boxes to where all is now. Room has been made. */
    public void refresh() {
        if (lags) {
            for (int k = 0; k < bodies.movers(); k++) {
                rest(bodies.mover(k));
            }
            lags = false;
            fitTree(true);
        } else {
            fitTree(false);
        }
        publish();
    }

    /** Tells the next step of the terrain. Room has been made. */
    public void begin(StepConstants constants, KindTable kinds) {
        int rows = 1;
        for (int k = 0; k < bodies.movers(); k++) {
            int body = bodies.mover(k);
            if (bodies.moves(body)) {
                begin(body, rows++, constants);
            } else {
                rest(body);
            }
        }
        boolean moved = bodies.movers() > 0;
        bodies.dropResting();
        if (moved || step.bodies > 1) {
            step.motionVersion++;
        }
        step.bodies = rows;
        lags = false;
        fitTree(moved);
        publish();
        step.kinds.update(kinds, kinds.version());
    }

    private void begin(int body, int row, StepConstants constants) {
        double way = bodies.begin(body, row, constants.dt, constants.subSteps, bounds, step.motion);
        double turned = bodies.turned();
        pieces.filler().setPose(bodies, body);
        for (int piece = bodies.firstPiece[body]; piece >= 0; piece = pieces.nextOfBody(piece)) {
            pieces.filler().fill(piece, row, way, turned);
        }
    }

    private void fitTree(boolean moved) {
        if (groundChanged) {
            tree.buildGround(pieces);
            tree.buildBodies(pieces);
            step.boxesFrom = 0;
            step.groundNodes = tree.groundNodes();
            step.groundVersion++;
            step.linksVersion++;
            step.treeVersion++;
        } else if (bodiesChanged) {
            tree.buildBodies(pieces);
            step.boxesFrom = tree.groundNodes();
            step.linksVersion++;
            step.treeVersion++;
        } else if (moved) {
            boolean worn = tree.refitBodies(pieces);
            if (worn) {
                tree.buildBodies(pieces);
                step.linksVersion++;
            }
            step.boxesFrom = tree.groundNodes();
            step.treeVersion++;
        }
        groundChanged = false;
        bodiesChanged = false;
    }

    private void publish() {
        pieces.publish(step);
        step.nodes = tree.nodes();
        step.boxes = tree.boxes;
        step.links = tree.links;
    }

    /** A step has been made: brings bodies to where they are then. */
    public void end(float timeStep, int subSteps) {
        for (int k = 0; k < bodies.movers(); k++) {
            if (bodies.moves(bodies.mover(k))) {
                bodies.end(bodies.mover(k), timeStep, subSteps, bounds);
                lags = true;
            } else {
                bodies.stay(bodies.mover(k));
            }
        }
    }

    public long bytes() {
        return (long) Integer.BYTES
                * (pieces.rows.length
                        + pieces.traits.length
                        + tree.boxes.length
                        + tree.links.length
                        + step.motion.length);
    }
}
