package io.github.circles2d.world.bodies;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Velocity;
import java.util.Arrays;

/**
 * The rigid bodies of a world: which ids are in use, and what steps do not read of them. {@link RigidStep} has the rest. Changes have been checked,
 * and there is room.
 */
public final class RigidTable {
    public final IdTable ids = new IdTable(Handle.RIGID);

    public final RigidStep step = new RigidStep();

    public final RigidEvents events;

    /** Where points of bodies are, for a caller to look at. */
    public final RigidPlaces places;

    /** Ids of pieces of terrain. */
    private final IdTable pieces;

    // by id
    private float[] mass = new float[0];
    private float[] inertia = new float[0];
    private long[] tag = new long[0];

    /** Of {@link #outlines}. */
    private int[] outline = new int[0];

    private final Outlines outlines = new Outlines();

    /** By number of an outline: its number in a saved state. */
    private int[] savedNumbers = new int[0];

    /** Whether a force or a torque acts in the next step, on any body. */
    private boolean pushed;

    private long version;

    /** Circles and pieces that have gone since the last step, by id: their contacts go with the next {@link #settle}. */
    private long[] goneCircles = new long[0];

    private long[] gonePieces = new long[0];
    private boolean someGone;

    /** No bodies. */
    public RigidTable(HandleTable circles, IdTable pieces) {
        this.pieces = pieces;
        places = new RigidPlaces(this);
        events = new RigidEvents(step, ids, circles, pieces);
    }

    /** Whether there are bodies. */
    public boolean isThere() {
        return step.isThere();
    }

    /** Makes room for more bodies. If there is none, nothing has changed. */
    public void ensure(int more) {
        int needed = ids.size() + more;
        if (needed > ids.room()) {
            setRoom(Math.max(Math.max(16, needed), ids.room() * 3 / 2));
        }
    }

    /** Makes room for an outline, which {@link #add} then finds. If there is none, nothing has changed. */
    public void prepare(OutlineShape shape) {
        outlines.prepare(shape);
    }

    private void setRoom(int bodies) {
        mass = Arrays.copyOf(mass, bodies);
        inertia = Arrays.copyOf(inertia, bodies);
        tag = Arrays.copyOf(tag, bodies);
        outline = Arrays.copyOf(outline, bodies);
        step.setRoom(bodies);
        ids.setRoom(bodies);
    }

    // ---- what there is

    public float mass(int body) {
        return mass[body];
    }

    public float inertia(int body) {
        return inertia[body];
    }

    public long tag(int body) {
        return tag[body];
    }

    /** Whether something moves or turns a body. */
    public boolean moves(int body) {
        return step.inverseMass[body] > 0f || step.inverseInertia[body] > 0f;
    }

    /** Whether a force or a torque acts in the next step, which is made alone then. */
    public boolean pushes() {
        return pushed;
    }

    /** Another number once bodies have come, gone or moved. */
    public long version() {
        return version;
    }

    // ---- changes

    /** A body at rest. */
    public int add(OutlineShape shape, float x, float y, int angle, float itsMass, int kind, float restitution) {
        int body = ids.add();
        setOutline(body, shape);
        count();
        step.x[body] = x;
        step.y[body] = y;
        step.restX[body] = 0f;
        step.restY[body] = 0f;
        step.angle[body] = angle;
        step.vx[body] = 0f;
        step.vy[body] = 0f;
        step.omega[body] = 0f;
        step.kind[body] = kind;
        step.restitution[body] = restitution;
        release(body);
        step.extras.clear(body);
        mass[body] = itsMass;
        step.inverseMass[body] = CircleMath.inverseMass(itsMass);
        setInertia(body, itsMass * shape.inertia());
        tag[body] = 0;
        return body;
    }

    private void setOutline(int body, OutlineShape shape) {
        outline[body] = outlines.take(shape);
        step.outline[body] = outlines.shape(outline[body]);
    }

    private void count() {
        version++;
        step.changes++;
        step.end = ids.end();
        step.count = ids.size();
    }

    public void remove(int body) {
        dropContactsOf(body);
        events.bodyGoes(body);
        step.outline[body] = null;
        outlines.release(outline[body]);
        ids.remove(body);
        count();
    }

    /** Removes all bodies. */
    public void clear() {
        for (int body = 0; body < ids.end(); body++) {
            if (ids.lives(body)) {
                step.outline[body] = null;
                ids.remove(body);
            }
        }
        outlines.releaseAll();
        outlines.dropUnused();
        count();
        events.bodiesGo();
        step.contacts.count = 0;
        pushed = false;
    }

    /** Infinite if nothing turns the body. */
    public void setInertia(int body, float to) {
        inertia[body] = to;
        step.inverseInertia[body] = 1f / to;
    }

    public void setTag(int body, long to) {
        tag[body] = to;
    }

    public void setVelocity(int body, float vx, float vy) {
        step.wake(body);
        step.vx[body] = vx + 0f;
        step.vy[body] = vy + 0f;
    }

    public void setOmega(int body, float to) {
        step.wake(body);
        step.omega[body] = to + 0f;
    }

    /** Puts a body somewhere else; its contacts so far do not count. */
    public void teleport(int body, float x, float y, int angle) {
        version++;
        step.x[body] = x;
        step.y[body] = y;
        step.restX[body] = 0f;
        step.restY[body] = 0f;
        step.angle[body] = angle;
        step.wake(body);
        dropContactsOf(body);
    }

    /** The arm from the centroid to a point of the world, the short way round. */
    private float armX(int body, float pointX, Bounds bounds) {
        return CircleMath.shortWay(bounds.placeX(pointX) - step.x[body], bounds.periodX());
    }

    private float armY(int body, float pointY, Bounds bounds) {
        return CircleMath.shortWay(bounds.placeY(pointY) - step.y[body], bounds.periodY());
    }

    /** An impulse at a point of the world. */
    public void push(int body, float x, float y, float pointX, float pointY, Bounds bounds) {
        float armX = armX(body, pointX, bounds);
        float armY = armY(body, pointY, bounds);
        step.vx[body] = Velocity.afterImpulse(step.vx[body], step.inverseMass[body], x) + 0f;
        step.vy[body] = Velocity.afterImpulse(step.vy[body], step.inverseMass[body], y) + 0f;
        pushAround(body, CircleMath.clamp(armX * y - armY * x, -Limits.ANGULAR_IMPULSE, Limits.ANGULAR_IMPULSE));
    }

    public void pushAround(int body, float impulse) {
        step.wake(body);
        step.omega[body] = Velocity.afterImpulse(step.omega[body], step.inverseInertia[body], impulse) + 0f;
    }

    /** The restitution is that which the body has from now on. */
    public void setKind(int body, int kind, float restitution) {
        step.wake(body);
        step.kind[body] = kind;
        step.restitution[body] = restitution;
    }

    /** A force and a torque are to act in the next step, too. */
    public void applyForce(int body, float forceX, float forceY, float torque) {
        step.forceX[body] = RigidLimits.sum(step.forceX[body], forceX);
        step.forceY[body] = RigidLimits.sum(step.forceY[body], forceY);
        step.torque[body] = RigidLimits.sum(step.torque[body], torque);
        pushed |= acts(body);
    }

    /** The same of a force at a point of the world, where that is now. */
    public void applyForceAt(int body, float x, float y, float pointX, float pointY, Bounds bounds) {
        float turning = armX(body, pointX, bounds) * y - armY(body, pointY, bounds) * x;
        applyForce(body, x, y, CircleMath.clamp(turning, -Limits.TORQUE, Limits.TORQUE));
    }

    /** Makes room to set what few bodies have. If there is none, nothing has changed. */
    public void ensureExtras() {
        step.extras.ensure(ids.room());
    }

    /** A force is to act until another one is set. There is room. */
    public void setForce(int body, float x, float y) {
        step.extras.set(body, RigidExtras.FORCE_X, Float.floatToRawIntBits(x + 0f));
        step.extras.set(body, RigidExtras.FORCE_Y, Float.floatToRawIntBits(y + 0f));
    }

    /** A torque likewise. */
    public void setTorque(int body, float torque) {
        step.extras.set(body, RigidExtras.TORQUE, Float.floatToRawIntBits(torque + 0f));
    }

    /** A body is to be in an exclusion group; 0 for none. There is room. */
    public void setGroup(int body, int group) {
        step.wake(body);
        step.extras.set(body, RigidExtras.GROUP, group);
    }

    private boolean acts(int body) {
        return step.forceX[body] != 0f || step.forceY[body] != 0f || step.torque[body] != 0f;
    }

    private void release(int body) {
        step.forceX[body] = 0f;
        step.forceY[body] = 0f;
        step.torque[body] = 0f;
    }

    /** A step is made: bodies move. */
    public void steps() {
        version++;
    }

    /** The step has been made in which forces and torques acted. */
    public void releaseAll() {
        for (int body = 0; pushed && body < ids.end(); body++) {
            release(body);
        }
        step.changes += pushed ? 1 : 0; // who sleeps in a force notices its end
        pushed = false;
    }

    /** Refuses bounds in which an outline of a body has no room. */
    public void requireRoom(Bounds bounds) {
        for (int k = 0; k < outlines.end(); k++) {
            if (outlines.isUsed(k)) {
                RigidLimits.reach(outlines.shape(k), bounds);
            }
        }
    }

    /** Whether a body would be somewhere else within bounds, whose walls are given. */
    public boolean moveIn(Bounds bounds, Bounds walls) {
        boolean move = false;
        for (int body = 0; body < ids.end(); body++) {
            move |= ids.lives(body)
                    && (bounds.placeX(CircleMath.clamp(step.x[body], walls.minX(), walls.maxX())) != step.x[body]
                            || bounds.placeY(CircleMath.clamp(step.y[body], walls.minY(), walls.maxY()))
                                    != step.y[body]);
        }
        return move;
    }

    /** Brings bodies inside new bounds, whose walls are given. */
    public void confine(Bounds bounds, Bounds walls) {
        version++;
        for (int body = 0; body < ids.end(); body++) {
            if (ids.lives(body)) {
                float x = bounds.placeX(CircleMath.clamp(step.x[body], walls.minX(), walls.maxX()));
                float y = bounds.placeY(CircleMath.clamp(step.y[body], walls.minY(), walls.maxY()));
                step.restX[body] = x == step.x[body] ? step.restX[body] : 0f;
                step.restY[body] = y == step.y[body] ? step.restY[body] : 0f;
                step.x[body] = x;
                step.y[body] = y;
            }
        }
    }

    // ---- contacts

    /** Makes room to note what goes after the next step: circles and pieces of ids below limits. If there is none, nothing has changed. */
    public void makeRoom(int circles, int pieces, boolean sleeps) {
        if (isThere()) {
            if (sleeps) {
                ensureExtras();
            }
            goneCircles = withRoom(goneCircles, circles);
            gonePieces = withRoom(gonePieces, pieces);
            settle();
        }
    }

    /** A circle goes. */
    public void circleGoes(int circle) {
        events.circleGoes(circle);
        if (step.contacts.count > 0) {
            note(goneCircles, circle);
        }
    }

    /** All circles go. */
    public void circlesGo() {
        events.circlesGo();
        if (step.contacts.count > 0) {
            Arrays.fill(goneCircles, -1L);
            someGone = true;
        }
    }

    /** A piece of terrain goes, or is another one now. */
    public void pieceGoes(int piece) {
        if (!pieces.has(piece)) {
            events.pieceGoes(piece);
        }
        if (step.contacts.count > 0) {
            note(gonePieces, piece);
        }
    }

    private static long[] withRoom(long[] set, int ids) {
        return set.length * 64 < ids ? Arrays.copyOf(set, ids / 32 + 1) : set;
    }

    private void note(long[] set, int id) {
        if (id >> 6 < set.length) { // else it came after the last step
            set[id >> 6] |= 1L << id;
            someGone = true;
        }
    }

    /** Drops the contacts of all that has gone. */
    public void settle() {
        if (someGone) {
            dropContactsOf(-1);
            forgetGone();
        }
    }

    private void forgetGone() {
        if (someGone) {
            Arrays.fill(goneCircles, 0L);
            Arrays.fill(gonePieces, 0L);
            someGone = false;
        }
    }

    private static boolean has(long[] set, int id) {
        return id >> 6 < set.length && (set[id >> 6] & 1L << id) != 0;
    }

    /** Drops contacts of a body, and of all that has gone. */
    private void dropContactsOf(int body) {
        KeptContacts contacts = step.contacts;
        int end = contacts.count;
        contacts.count = 0;
        for (int k = 0; k < end; k++) {
            if (!isGone(contacts, k, body)) {
                contacts.add(contacts, k);
            }
        }
        step.changes++;
    }

    private boolean isGone(KeptContacts contacts, int k, int body) {
        int b = contacts.b(k);
        boolean ofBody = contacts.a(k) == body;
        return switch (contacts.type(k)) {
            case RigidStep.BODY_BODY -> ofBody || b == body;
            case RigidStep.BODY_CIRCLE -> ofBody || has(goneCircles, b);
            case RigidStep.BODY_PIECE -> ofBody || has(gonePieces, b);
            default -> ofBody;
        };
    }

    // ---- states

    public void save(SavedRigids to) {
        settle();
        to.setIds(ids.end());
        ids.save(to.generation);
        to.ensureOutlines(outlines.end());
        if (savedNumbers.length < outlines.end()) {
            savedNumbers = new int[2 * outlines.end()];
        }
        Arrays.fill(savedNumbers, -1);
        to.outlineCount = 0;
        for (int body = 0; body < ids.end(); body++) {
            to.outline[body] = SavedRigids.NO_BODY;
            if (ids.lives(body)) {
                save(body, to);
            }
        }
        to.contacts.ensure(step.contacts.count);
        to.contacts.copy(step.contacts);
        events.save(to);
    }

    private void save(int body, SavedRigids to) {
        int number = outline[body];
        if (savedNumbers[number] < 0) {
            savedNumbers[number] = to.outlineCount;
            to.outlines[to.outlineCount++] = outlines.shape(number);
        }
        to.outline[body] = savedNumbers[number];
        to.kind[body] = step.kind[body];
        to.set(body, SavedRigids.X, step.x[body]);
        to.set(body, SavedRigids.Y, step.y[body]);
        to.set(body, SavedRigids.REST_X, step.restX[body]);
        to.set(body, SavedRigids.REST_Y, step.restY[body]);
        to.values[SavedRigids.VALUES * body + SavedRigids.ANGLE] = step.angle[body];
        to.set(body, SavedRigids.VX, step.vx[body]);
        to.set(body, SavedRigids.VY, step.vy[body]);
        to.set(body, SavedRigids.OMEGA, step.omega[body]);
        to.set(body, SavedRigids.MASS, mass[body]);
        to.set(body, SavedRigids.INERTIA, inertia[body]);
        to.set(body, SavedRigids.RESTITUTION, step.restitution[body]);
        to.set(body, SavedRigids.FORCE_X, step.forceX[body]);
        to.set(body, SavedRigids.FORCE_Y, step.forceY[body]);
        to.set(body, SavedRigids.TORQUE, step.torque[body]);
        to.values[SavedRigids.VALUES * body + SavedRigids.TAG_LOW] = (int) tag[body];
        to.values[SavedRigids.VALUES * body + SavedRigids.TAG_HIGH] = (int) (tag[body] >> Integer.SIZE);
        int at = SavedRigids.VALUES * body + SavedRigids.EXTRAS;
        step.extras.save(body, 0, RigidExtras.COUNT, to.values, at);
    }

    /** Makes room for {@link #load}. If there is none, nothing has changed. */
    public void makeRoom(SavedRigids from) {
        if (from.ids > ids.room()) {
            setRoom(from.ids);
        }
        for (int k = 0; k < from.outlineCount; k++) {
            outlines.prepare(from.outlines[k]);
        }
        if (from.hasExtras()) {
            step.extras.ensure(Math.max(ids.room(), from.ids));
        }
        step.contacts.ensure(from.contacts.count);
        goneCircles = withRoom(goneCircles, from.contacts.idsTouched(RigidStep.BODY_CIRCLE));
        gonePieces = withRoom(gonePieces, from.contacts.idsTouched(RigidStep.BODY_PIECE));
        events.makeRoom(from);
    }

    /** Takes over saved bodies, which have been checked. There is room. */
    public void load(SavedRigids from) {
        ids.load(from.generation, from.ids);
        Arrays.fill(step.outline, null);
        outlines.releaseAll();
        pushed = false;
        for (int body = 0; body < from.ids; body++) {
            if (from.lives(body)) {
                ids.revive(body);
                load(body, from);
            }
        }
        outlines.dropUnused();
        count();
        step.contacts.copy(from.contacts);
        forgetGone();
        events.load(from);
    }

    private void load(int body, SavedRigids from) {
        setOutline(body, from.outlines[from.outline[body]]);
        step.kind[body] = from.kind[body];
        step.x[body] = from.real(body, SavedRigids.X);
        step.y[body] = from.real(body, SavedRigids.Y);
        step.restX[body] = from.real(body, SavedRigids.REST_X);
        step.restY[body] = from.real(body, SavedRigids.REST_Y);
        step.angle[body] = from.values[SavedRigids.VALUES * body + SavedRigids.ANGLE];
        step.vx[body] = from.real(body, SavedRigids.VX);
        step.vy[body] = from.real(body, SavedRigids.VY);
        step.omega[body] = from.real(body, SavedRigids.OMEGA);
        mass[body] = from.real(body, SavedRigids.MASS);
        step.inverseMass[body] = CircleMath.inverseMass(mass[body]);
        setInertia(body, from.real(body, SavedRigids.INERTIA));
        step.restitution[body] = from.real(body, SavedRigids.RESTITUTION);
        step.forceX[body] = from.real(body, SavedRigids.FORCE_X);
        step.forceY[body] = from.real(body, SavedRigids.FORCE_Y);
        step.torque[body] = from.real(body, SavedRigids.TORQUE);
        pushed |= acts(body);
        tag[body] = from.values[SavedRigids.VALUES * body + SavedRigids.TAG_LOW] & 0xFFFFFFFFL
                | (long) from.values[SavedRigids.VALUES * body + SavedRigids.TAG_HIGH] << Integer.SIZE;
        int at = SavedRigids.VALUES * body + SavedRigids.EXTRAS;
        step.extras.load(body, 0, RigidExtras.COUNT, from.values, at);
    }

    /** Bytes of the table. */
    public long bytes() {
        return isThere()
                ? 20L * ids.room()
                        + step.bytes()
                        + outlines.bytes()
                        + events.bytes()
                        + 8L * (goneCircles.length + gonePieces.length)
                : 0;
    }
}
