package io.github.circles2d.world.bodies;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Sleep;
import java.util.Arrays;

/**
 * The rigid bodies of a world, and what steps keep of their contacts. Arrays are by the id of a
 * body. Calls change them between steps; steps read and change them.
 */
public final class RigidStep {
    // types of contacts, in the order of keys
    public static final int BODY_BODY = 0;
    public static final int BODY_PIECE = 1;
    public static final int BODY_WALL = 2;
    public static final int BODY_CIRCLE = 3;

    /** Added to the type of a touch of what only senses each other, so that these come last. */
    public static final int SENSED = 4;

    // numbers of the key of a contact or a touch
    public static final int TYPE = 0;
    public static final int A = 1;

    /** The other body, of a higher id; the id of a piece of terrain; the number of a wall; the id of a circle. */
    public static final int B = 2;

    /** Floats of a touch in {@link #touchValues}: the point, the normal from the body to what it touches, the impulse, the speed of the approach. */
    public static final int TOUCH_VALUES = 6;

    public static final int TOUCH_X = 0;
    public static final int TOUCH_Y = 1;
    public static final int TOUCH_NX = 2;
    public static final int TOUCH_NY = 3;
    public static final int TOUCH_IMPULSE = 4;
    public static final int TOUCH_SPEED = 5;

    /** Ints of a touch in {@link #touchKeys}: its type, perhaps with {@link #SENSED}, a body, and what it touches. */
    public static final int TOUCH_KEYS = 3;

    /** Told of each step. */
    public interface Listener {
        /** A step has been made; the touches are those of it. */
        void stepped();

        /** Whether a pair has touched in the step before, by its key. */
        boolean touched(int type, int a, int b);
    }

    /** Greatest id of a body, and 1. */
    public int end;

    /** How many there are. */
    public int count;

    /** What a body looks like; null if no body has the id. */
    public OutlineShape[] outline = new OutlineShape[0];

    /** Where the centroid is: within the bounds along an axis with walls or that wraps. */
    public float[] x = new float[0];

    public float[] y = new float[0];

    /** What rounding has left of {@link #x} and {@link #y}. */
    public float[] restX = new float[0];

    public float[] restY = new float[0];

    /** In units of a turn's 2^-32. */
    public int[] angle = new int[0];

    public float[] vx = new float[0];
    public float[] vy = new float[0];

    /** Radians a second. */
    public float[] omega = new float[0];

    /** 0 if nothing moves the body. */
    public float[] inverseMass = new float[0];

    /** 0 if nothing turns the body. */
    public float[] inverseInertia = new float[0];

    public float[] restitution = new float[0];
    public int[] kind = new int[0];

    /** The forces of the next step alone. */
    public float[] forceX = new float[0];

    public float[] forceY = new float[0];
    public float[] torque = new float[0];

    /** Among others the forces that last. */
    public final RigidExtras extras = new RigidExtras();

    /** Contacts that the next step starts from. */
    public final KeptContacts contacts = new KeptContacts();

    /** Is told of each step; null if nobody wants to know, and there are no touches then. */
    public Listener listener;

    /** What bodies touched in the last step, each pair once, in ascending order of the keys. */
    public int touches;

    /** Whether all that bodies pushed in the step before still counts, since it rests. */
    public boolean touchesStay;

    public int[] touchKeys = new int[0];
    public float[] touchValues = new float[0];

    /** Counts changes by calls and states, behind which the balance of a body that sleeps may be another. */
    public int changes;

    /** Contacts of the last step whose things rested. The passes that made it fill the list again in the next one. */
    public KeptContacts resting = new KeptContacts();

    // ---- sleep

    public boolean isAsleep(int body) {
        return Sleep.isAsleep(extras.get(body, RigidExtras.REST));
    }

    /** How many do not sleep. */
    public int awake() {
        int awake = 0;
        for (int body = 0; body < end; body++) {
            awake += outline[body] != null && !isAsleep(body) ? 1 : 0;
        }
        return awake;
    }

    /** Wakes those that sleep and reach out of bounds, or nearly. */
    public void wakeOutside(Bounds calm) {
        for (int body = 0; body < end; body++) {
            if (outline[body] != null && isAsleep(body)) {
                float far = Sleep.NEIGHBOURS * outline[body].reach();
                if (x[body] - far < calm.minX()
                        || x[body] + far > calm.maxX()
                        || y[body] - far < calm.minY()
                        || y[body] + far > calm.maxY()) {
                    wake(body);
                }
            }
        }
        changes++;
    }

    /** A body that is awake begins anew to come to rest. */
    public void wake(int body) {
        setRest(body, 0, 0, 0f, 0f);
        setSpinOfRest(body, 0f, 0);
    }

    /** Sets how a body rests; there is room unless all is 0. */
    public void setRest(int body, int rest, int turned, float driftX, float driftY) {
        extras.set(body, RigidExtras.REST, rest);
        extras.set(body, RigidExtras.TURNED, turned);
        extras.set(body, RigidExtras.DRIFT_X, Float.floatToRawIntBits(driftX));
        extras.set(body, RigidExtras.DRIFT_Y, Float.floatToRawIntBits(driftY));
    }

    /** The same of what turns a body that sleeps. */
    public void setSpinOfRest(int body, float known, int offset) {
        extras.set(body, RigidExtras.KNOWN_SPIN, Float.floatToRawIntBits(known));
        extras.set(body, RigidExtras.SPIN_OFFSET, offset);
    }

    /** Wakes the bodies that sleep near to a place, by {@link Sleep#NEIGHBOURS}, from which something reaches so far; not itself. */
    public void wakeNear(int itself, float atX, float atY, float itsReach, float periodX, float periodY) {
        for (int body = 0; body < end; body++) {
            if (body != itself && outline[body] != null && isAsleep(body)) {
                float far = Sleep.NEIGHBOURS * (outline[body].reach() + itsReach);
                if (Math.abs(CircleMath.shortWay(atX - x[body], periodX)) <= far
                        && Math.abs(CircleMath.shortWay(atY - y[body], periodY)) <= far) {
                    wake(body);
                }
            }
        }
        changes++;
    }

    /** Wakes those that sleep by their kinds, and at walls, as changes of circles and surroundings ask for. */
    public void wakeBy(Commands commands) {
        for (int body = 0; body < end; body++) {
            if (outline[body] != null && isAsleep(body) && commands.wakes(kind[body], 0f, 0f)) {
                wake(body);
            }
        }
        for (int k = 0; k < contacts.count; k++) {
            boolean presses = contacts.type(k) == BODY_WALL && contacts.impulse(k) > 0f;
            if (presses && isAsleep(contacts.a(k)) && (commands.wallsToWake() & 1 << contacts.b(k)) != 0) {
                wake(contacts.a(k));
            }
        }
        changes++;
    }

    /** Whether one of them sleeps. */
    public boolean anySleeps() {
        boolean any = false;
        for (int body = 0; !any && body < end; body++) {
            any = outline[body] != null && isAsleep(body);
        }
        return any;
    }

    /** Whether there are bodies. */
    public boolean isThere() {
        return count > 0;
    }

    /** Ids that the arrays have room for. */
    public int room() {
        return kind.length;
    }

    /** The force that acts on a body in the next step along x. */
    public float forceX(int body) {
        return extras.areThere() ? RigidLimits.sum(extras.real(body, RigidExtras.FORCE_X), forceX[body]) : forceX[body];
    }

    public float forceY(int body) {
        return extras.areThere() ? RigidLimits.sum(extras.real(body, RigidExtras.FORCE_Y), forceY[body]) : forceY[body];
    }

    /** The torque that acts on a body in the next step. */
    public float torque(int body) {
        return extras.areThere() ? RigidLimits.sum(extras.real(body, RigidExtras.TORQUE), torque[body]) : torque[body];
    }

    /** Whether a body is in a group, and that is another one's. */
    public boolean isOfGroup(int body, int group) {
        return group != 0 && extras.get(body, RigidExtras.GROUP) == group;
    }

    /** Makes room for ids. If there is none, nothing has changed: the array that tells the room comes last, here and below. */
    public void setRoom(int ids) {
        outline = Arrays.copyOf(outline, ids);
        x = Arrays.copyOf(x, ids);
        y = Arrays.copyOf(y, ids);
        restX = Arrays.copyOf(restX, ids);
        restY = Arrays.copyOf(restY, ids);
        angle = Arrays.copyOf(angle, ids);
        vx = Arrays.copyOf(vx, ids);
        vy = Arrays.copyOf(vy, ids);
        omega = Arrays.copyOf(omega, ids);
        inverseMass = Arrays.copyOf(inverseMass, ids);
        inverseInertia = Arrays.copyOf(inverseInertia, ids);
        restitution = Arrays.copyOf(restitution, ids);
        forceX = Arrays.copyOf(forceX, ids);
        forceY = Arrays.copyOf(forceY, ids);
        torque = Arrays.copyOf(torque, ids);
        kind = Arrays.copyOf(kind, ids);
    }

    /** Compares a key, of a contact or a touch, with that of a pair. */
    public static int compare(int[] keys, int at, int type, int a, int b) {
        int order = Integer.compare(keys[at + TYPE], type);
        order = order == 0 ? Integer.compare(keys[at + A], a) : order;
        return order == 0 ? Integer.compare(keys[at + B], b) : order;
    }

    /** Adds a touch, behind those that there are. */
    public void addTouch(int type, int a, int b, float px, float py, float nx, float ny, float impulse, float speed) {
        ensureTouches(touches + 1);
        int key = TOUCH_KEYS * touches;
        touchKeys[key + TYPE] = type;
        touchKeys[key + A] = a;
        touchKeys[key + B] = b;
        int to = TOUCH_VALUES * touches++;
        touchValues[to + TOUCH_X] = px;
        touchValues[to + TOUCH_Y] = py;
        touchValues[to + TOUCH_NX] = nx;
        touchValues[to + TOUCH_NY] = ny;
        touchValues[to + TOUCH_IMPULSE] = impulse;
        touchValues[to + TOUCH_SPEED] = speed;
    }

    /** Makes room for touches, and keeps those that there are. If there is none, nothing has changed. */
    public void ensureTouches(int needed) {
        if (touchKeys.length < TOUCH_KEYS * needed) {
            int c = Math.max(Math.max(needed, 64), touchKeys.length / TOUCH_KEYS * 3 / 2);
            touchValues = Arrays.copyOf(touchValues, TOUCH_VALUES * c);
            touchKeys = Arrays.copyOf(touchKeys, TOUCH_KEYS * c);
        }
    }

    /** Bytes of the arrays. */
    public long bytes() {
        return extras.bytes() + contacts.bytes() + 4L * (16L * room() + touchKeys.length + touchValues.length);
    }
}
