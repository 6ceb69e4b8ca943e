package io.github.circles2d.world.bodies;

import io.github.circles2d.world.circles.StateHash;

/** The rigid bodies of a saved state, by id, and what steps keep of their contacts. Arrays are reused, and may be longer than their contents. */
public final class SavedRigids {
    // values of a body: the bits of floats, but for the angle in units and the two halves of the tag
    public static final int X = 0;
    public static final int Y = 1;
    public static final int REST_X = 2;
    public static final int REST_Y = 3;
    public static final int ANGLE = 4;
    public static final int VX = 5;
    public static final int VY = 6;
    public static final int OMEGA = 7;
    public static final int MASS = 8;
    public static final int INERTIA = 9;
    public static final int RESTITUTION = 10;
    public static final int FORCE_X = 11;
    public static final int FORCE_Y = 12;
    public static final int TORQUE = 13;
    public static final int TAG_LOW = 14;
    public static final int TAG_HIGH = 15;

    /** The first of those of {@link RigidExtras}, in its order: what few bodies have, so that it is no part of the hash of others. */
    public static final int EXTRAS = 16;

    /** Ints of a body. */
    public static final int VALUES = EXTRAS + RigidExtras.COUNT;

    public static final int NO_BODY = -1;

    /** Ids in use so far. */
    public int ids;

    public int[] generation = new int[0];

    /** By id: its outline among {@link #outlines}, or {@link #NO_BODY}. */
    public int[] outline = new int[0];

    public int[] kind = new int[0];

    /** By id: {@link #VALUES} ints. */
    public int[] values = new int[0];

    /** In the order of the first bodies that have them, each once. */
    public OutlineShape[] outlines = new OutlineShape[0];

    public int outlineCount;

    /** {@link RigidStep#contacts}. */
    public final KeptContacts contacts = new KeptContacts();

    /** What bodies touched in the last step, if that is reported: by {@link RigidStep#TOUCH_KEYS}. */
    public int touching;

    public int[] touchingKeys = new int[0];

    public SavedRigids() {}

    /** As it is at first. */
    public void clear() {
        ids = 0;
        outlineCount = 0;
        contacts.count = 0;
        touching = 0;
    }

    public boolean isAsAtFirst() {
        return ids == 0;
    }

    public boolean lives(int body) {
        return outline[body] != NO_BODY;
    }

    /** Whether there are bodies. */
    public boolean hasBodies() {
        return outlineCount > 0;
    }

    /** Whether a body has one of {@link RigidExtras}. */
    boolean hasExtras() {
        for (int body = 0; body < ids; body++) {
            for (int k = VALUES * body + EXTRAS; lives(body) && k < VALUES * (body + 1); k++) {
                if (values[k] != 0) {
                    return true;
                }
            }
        }
        return false;
    }

    /** A value that is a float. */
    public float real(int body, int value) {
        return Float.intBitsToFloat(values[VALUES * body + value]);
    }

    /** Sets a value that is a float. */
    void set(int body, int value, float to) {
        values[VALUES * body + value] = Float.floatToRawIntBits(to);
    }

    /** Makes room, without the contents so far, and sets the number. */
    public void setIds(int bodies) {
        if (outline.length < bodies) {
            // All arrays are made before one is assigned: a growth that fails changes nothing.
            int c = Math.max(bodies, outline.length + (outline.length >> 1));
            int[] newGeneration = new int[c];
            int[] newOutline = new int[c];
            int[] newKind = new int[c];
            int[] newValues = new int[VALUES * c];
            generation = newGeneration;
            outline = newOutline;
            kind = newKind;
            values = newValues;
        }
        ids = bodies;
    }

    /** Makes room for outlines, and keeps those that there are: a reader takes equal ones over. */
    public void ensureOutlines(int needed) {
        if (outlines.length < needed) {
            OutlineShape[] grown = new OutlineShape[Math.max(needed, 2 * outlines.length)];
            System.arraycopy(outlines, 0, grown, 0, outlines.length);
            outlines = grown;
        }
    }

    /** Makes room, without the contents so far, and sets the number. */
    public void setTouching(int pairs) {
        if (touchingKeys.length < RigidStep.TOUCH_KEYS * pairs) {
            touchingKeys = new int[Math.max(RigidStep.TOUCH_KEYS * pairs, touchingKeys.length * 3 / 2)];
        }
        touching = pairs;
    }

    /** The part of the bodies in the hash of the state; what they touched without a contact that stays does not count. */
    public long hash() {
        long sum = contacts.hash();
        for (int body = 0; body < ids; body++) {
            sum += lives(body) ? hash(body) : 0;
        }
        return sum;
    }

    private long hash(int body) {
        long h = StateHash.absorb(StateHash.absorb(StateHash.rigid(), body), kind[body]);
        for (int k = VALUES * body; k < VALUES * body + EXTRAS; k++) {
            h = StateHash.absorb(h, values[k]);
        }
        for (int k = EXTRAS; k < VALUES; k++) {
            int value = values[VALUES * body + k];
            h = value == 0 ? h : StateHash.absorb(StateHash.absorb(h, k), value);
        }
        for (int word : outlines[outline[body]].words()) {
            h = StateHash.absorb(h, word);
        }
        return h;
    }
}
