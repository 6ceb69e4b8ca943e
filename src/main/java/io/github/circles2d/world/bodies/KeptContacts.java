package io.github.circles2d.world.bodies;

import io.github.circles2d.world.circles.StateHash;
import java.util.Arrays;

/** Contacts of rigid bodies as steps keep them for the next one, in ascending order of their keys. */
public final class KeptContacts {
    /** Ints of a key: as that of a touch, the type, a body, and what it touches; then where on both. */
    public static final int KEYS = 5;

    /** The form of a contact, and behind it the number of a corner or a line of A. */
    public static final int FORM_AND_FEATURE = RigidStep.TOUCH_KEYS;

    /** The number of a corner or a line of B. */
    public static final int FEATURE_OF_B = 4;

    // forms: a corner of A is on a line of B, the other way round, or both are corners
    public static final int CORNER_ON_LINE = 0;
    public static final int SWAPPED = 1;
    public static final int BOTH = 2;

    private static final int FORM_SHIFT = 16;
    private static final int FEATURE = (1 << FORM_SHIFT) - 1;

    /** Floats of a contact: the impulses along the normal, and along the tangent. */
    public static final int IMPULSES = 2;

    public int count;
    public int[] keys = new int[0];
    public float[] impulses = new float[0];

    public KeptContacts() {}

    /** Makes room, and keeps those that there are. If there is none, nothing has changed. */
    public void ensure(int needed) {
        if (keys.length < KEYS * needed) {
            int c = Math.max(Math.max(needed, 64), keys.length / KEYS * 3 / 2);
            impulses = Arrays.copyOf(impulses, IMPULSES * c);
            keys = Arrays.copyOf(keys, KEYS * c);
        }
    }

    public int type(int k) {
        return keys[KEYS * k + RigidStep.TYPE];
    }

    public int a(int k) {
        return keys[KEYS * k + RigidStep.A];
    }

    public int b(int k) {
        return keys[KEYS * k + RigidStep.B];
    }

    public int formAndFeature(int k) {
        return keys[KEYS * k + FORM_AND_FEATURE];
    }

    public int featureOfB(int k) {
        return keys[KEYS * k + FEATURE_OF_B];
    }

    public float impulse(int k) {
        return impulses[IMPULSES * k];
    }

    public float grip(int k) {
        return impulses[IMPULSES * k + 1];
    }

    public static int formAndFeature(int form, int feature) {
        return form << FORM_SHIFT | feature;
    }

    public static int form(int formAndFeature) {
        return formAndFeature >> FORM_SHIFT;
    }

    public static int feature(int formAndFeature) {
        return formAndFeature & FEATURE;
    }

    /** Sets a contact, for which there is room. */
    public void set(int k, int type, int a, int b, int formAndFeature, int featureOfB, float impulse, float grip) {
        int at = KEYS * k;
        keys[at + RigidStep.TYPE] = type;
        keys[at + RigidStep.A] = a;
        keys[at + RigidStep.B] = b;
        keys[at + FORM_AND_FEATURE] = formAndFeature;
        keys[at + FEATURE_OF_B] = featureOfB;
        impulses[IMPULSES * k] = impulse;
        impulses[IMPULSES * k + 1] = grip;
    }

    /** Takes a contact over behind those that there are; there is room. */
    public void add(KeptContacts from, int k) {
        System.arraycopy(from.keys, KEYS * k, keys, KEYS * count, KEYS);
        System.arraycopy(from.impulses, IMPULSES * k, impulses, IMPULSES * count, IMPULSES);
        count++;
    }

    /** Takes all over; there is room. */
    void copy(KeptContacts from) {
        count = from.count;
        System.arraycopy(from.keys, 0, keys, 0, KEYS * count);
        System.arraycopy(from.impulses, 0, impulses, 0, IMPULSES * count);
    }

    /** Compares the pair of a contact with another one, by their keys. */
    public int compare(int k, int type, int a, int b) {
        return RigidStep.compare(keys, KEYS * k, type, a, b);
    }

    /** How many pairs have contacts: those of one are next to each other. */
    public int pairs() {
        int pairs = 0;
        for (int k = 0; k < count; k++) {
            pairs += k > 0 && compare(k, type(k - 1), a(k - 1), b(k - 1)) == 0 ? 0 : 1;
        }
        return pairs;
    }

    /** One more than the greatest id of what bodies have contacts with, of a type. */
    int idsTouched(int type) {
        int end = 0;
        for (int k = 0; k < count; k++) {
            end = type(k) == type ? Math.max(end, b(k) + 1) : end;
        }
        return end;
    }

    long hash() {
        long sum = 0;
        for (int k = 0; k < count; k++) {
            long h = StateHash.rigidContact();
            for (int key = KEYS * k; key < KEYS * (k + 1); key++) {
                h = StateHash.absorb(h, keys[key]);
            }
            sum += StateHash.absorb(StateHash.absorb(h, impulse(k)), grip(k));
        }
        return sum;
    }

    public long bytes() {
        return 4L * (keys.length + impulses.length);
    }
}
