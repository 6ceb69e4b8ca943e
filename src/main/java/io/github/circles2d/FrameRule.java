package io.github.circles2d;

/**
 * Says when a world moves to the other side, the JVM or a device, by what its own frames take: a step, with the reads since. It knows times and
 * numbers of circles alone, so it can be tried without a world.
 *
 * <p>Frames are looked at in windows of three groups; the least mean of a group is the time of a window, so that a disturbance counts for nothing.
 * A world goes where frames take at least a fifth less, and returns at once if they take a tenth more there. So it does not swing: in between it
 * stays. After a move that did not pay it stays twice as long as before.
 */
class FrameRule {
    /** With fewer circles, a world stays on the JVM: a read from a device alone takes longer than their step. */
    static final int LEAST_CIRCLES = 1250;

    /** Frames that take less are not worth a move. */
    private static final double LEAST_NANOS = 0.5e6;

    /** Less is expected of no frame, however few circles are awake. */
    private static final double LEAST_EXPECTED = 0.1e6;

    /** How much longer frames must take here than there before a world goes; and, once there, before it returns. */
    private static final double GOES = 1.25;

    private static final double RETURNS = 1.1;

    /** Frames behind a move that do not count: memory is made, and code is compiled. */
    private static final int SKIPPED = 4;

    private static final int GROUPS = 3;

    /** A group ends after so many frames, or after so long. */
    private static final int GROUP_FRAMES = 8;

    private static final double GROUP_NANOS = 50e6;

    /** For how many windows a world stays at least, and at most, unless its number of circles doubles or halves. */
    private static final int LEAST_STAY = 4;

    private static final int MOST_STAY = 1024;

    /** A time of the other side holds for crowds of half to twice the size. */
    private static final double ALIKE = 2;

    /** What a frame takes on a device, as a calibration says. */
    private record Expected(double nanos, int circles) {}

    private boolean onDevice;

    /** Of the last window here, and of the last one on the other side; NaN if there was none. */
    private double here = Double.NaN;

    private double there = Double.NaN;

    /** How many circles were awake then. */
    private int awakeHere;

    private int awakeThere;

    /** How many there are, awake or not. */
    private int circles;

    /** Whether the world came here to see whether that pays, and whether it goes because that did not. */
    private boolean tries;

    private boolean returns;

    private int windows;
    private int stay = LEAST_STAY;
    private int skip = SKIPPED;

    // of the window that goes on
    private int groups;
    private int frames;
    private double nanos;
    private double least;

    /** Whether the next frame ends a group: steps that a device has not made yet belong to it. */
    boolean endsGroup() {
        return skip == 0 && frames == GROUP_FRAMES - 1;
    }

    /**
     * Takes a frame; returns whether the world should go to the other side, which is asked again with each window if it cannot.
     *
     * @param awake how many of the circles are awake: a frame takes as long as they make it
     */
    boolean frame(double frameNanos, int count, int awake) {
        if (skip > 0) {
            skip--;
            return false;
        }
        frames++;
        nanos += frameNanos;
        if (frames < GROUP_FRAMES && nanos < GROUP_NANOS) {
            return false;
        }
        least = groups == 0 ? nanos / frames : Math.min(least, nanos / frames);
        frames = 0;
        nanos = 0;
        if (++groups < GROUPS) {
            return false;
        }
        groups = 0;
        windows++;
        here = least;
        awakeHere = awake;
        circles = count;
        return judge();
    }

    private boolean judge() {
        if (onDevice && circles < LEAST_CIRCLES) {
            return true;
        }
        if (windows == 1 && tries) {
            returns = here > RETURNS * expectedThere();
            stay = returns ? Math.min(2 * stay, MOST_STAY) : LEAST_STAY;
            return returns;
        }
        if (windows < stay && isAlike(awakeThere)) {
            return false;
        }
        return onDevice ? here > RETURNS * expectedThere() : pays();
    }

    private boolean pays() {
        boolean known = !Double.isNaN(there) && isAlike(awakeThere);
        return awakeHere >= LEAST_CIRCLES
                && here >= LEAST_NANOS
                && (!known || windows >= MOST_STAY || here > GOES * there);
    }

    private boolean isAlike(int awake) {
        return awakeHere <= ALIKE * awake && awake <= ALIKE * awakeHere;
    }

    /** What a frame would take on the other side. On the JVM that is in proportion to those awake; not known, it never pays to leave. */
    private double expectedThere() {
        if (Double.isNaN(there)) {
            return Double.POSITIVE_INFINITY;
        }
        return onDevice ? Math.max(LEAST_EXPECTED, there * awakeHere / Math.max(1, awakeThere)) : there;
    }

    /** The world has moved. chosen: because this rule said so. */
    void moved(boolean toDevice, boolean chosen) {
        onDevice = toDevice;
        double left = here;
        int awakeLeft = awakeHere;
        here = there;
        awakeHere = awakeThere;
        there = left;
        awakeThere = awakeLeft;
        tries = chosen && !returns;
        returns = false;
        windows = 0;
        skip = SKIPPED;
        groups = 0;
        frames = 0;
        nanos = 0;
    }

    /** What a frame took here and on the other side in the last windows, in milliseconds; NaN if not known. */
    double millisHere() {
        return here * 1e-6;
    }

    double millisThere() {
        return there * 1e-6;
    }
}
