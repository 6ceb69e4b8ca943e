package io.github.circles2d.world.bodies;

import java.util.Arrays;

/** What few rigid bodies have, by id; it is 0 at first. There is no memory for it until a body has it. */
public final class RigidExtras {
    /** The force that is set, along x; the bits of a float. */
    public static final int FORCE_X = 0;

    public static final int FORCE_Y = 1;

    /** The torque that is set; the bits of a float. */
    public static final int TORQUE = 2;

    /** The exclusion group; 0 for none. */
    public static final int GROUP = 3;

    // how a body comes to rest, and sleeps, by Sleep: its rest; the units by which it has turned, or its offset; how
    // far it has drifted, or the
    // acceleration that it knows, as bits of floats; of one that sleeps also the angular acceleration that it knows,
    // and the offset of its turning
    public static final int REST = 4;
    public static final int TURNED = 5;
    public static final int DRIFT_X = 6;
    public static final int DRIFT_Y = 7;
    public static final int KNOWN_SPIN = 8;
    public static final int SPIN_OFFSET = 9;

    /** Values from {@link #REST} on. */
    public static final int RESTS = 6;

    /** Ints of a body. */
    static final int COUNT = 10;

    private int[] values = new int[0];

    /** Makes room for ids. If there is none, nothing has changed. */
    void ensure(int ids) {
        if (values.length < COUNT * ids) {
            values = Arrays.copyOf(values, COUNT * Math.max(ids, values.length / COUNT * 3 / 2));
        }
    }

    /** Whether some body has something, or has had. */
    public boolean areThere() {
        return values.length > 0;
    }

    public int get(int body, int which) {
        int at = COUNT * body + which;
        return at < values.length ? values[at] : 0;
    }

    public float real(int body, int which) {
        return Float.intBitsToFloat(get(body, which));
    }

    /** Sets a value, for which there is room unless it is 0. */
    void set(int body, int which, int to) {
        if (to != 0 || COUNT * body < values.length) {
            values[COUNT * body + which] = to;
        }
    }

    /** A body has nothing. */
    void clear(int body) {
        for (int k = 0; k < COUNT; k++) {
            set(body, k, 0);
        }
    }

    /** Saves so many values of a body, from one on. */
    public void save(int body, int first, int many, int[] to, int at) {
        for (int k = 0; k < many; k++) {
            to[at + k] = get(body, first + k);
        }
    }

    /** Takes them over. There is room. */
    public void load(int body, int first, int many, int[] from, int at) {
        for (int k = 0; k < many; k++) {
            set(body, first + k, from[at + k]);
        }
    }

    long bytes() {
        return 4L * values.length;
    }
}
