package io.github.circles2d.world.events;

import io.github.circles2d.world.model.Bounds;
import java.util.Arrays;

/**
 * Tells {@link ContactEvents#endStep} of a step: records of touching pairs, which pairs have ended, and how many it tells of. Each thread
 * fills a list.
 */
public final class TouchRecords {
    /** Floats of what happened: those of an event. */
    public static final int VALUES = 7;

    static final int APPROACH = 0;
    static final int IMPULSE = 1;
    static final int NORMAL_X = 2;
    static final int NORMAL_Y = 3;
    static final int POINT_X = 4;
    static final int POINT_Y = 5;
    static final int SLIP = 6;

    private static final int VN = 7;
    private static final int THRESHOLD = 8;
    private static final int STRIDE = 9;

    int count;
    private int[] lower = new int[0];
    private int[] higher = new int[0];
    private float[] values = new float[0];

    /** By record: the number of its pair, or {@link ContactEvents#NONE}; of a pair whose hit goes on, see {@link ContactEvents#going}. */
    private int[] pair = new int[0];

    /** Pairs of circles that touched in the step before and that this list tells of: that they still do, or do no more. */
    private int told;

    private int[] ended = new int[0];
    private int endedCount;

    public void clear() {
        count = 0;
        told = 0;
        endedCount = 0;
    }

    /** Tells that pairs of circles that touched in the step before still do; a record may tell more of a pair. */
    public void stay(int pairs) {
        told += pairs;
    }

    /** Tells that a pair of circles that touched in the step before does no more. */
    public void end(int number) {
        if (endedCount == ended.length) {
            ended = Arrays.copyOf(ended, Math.max(64, 2 * endedCount));
        }
        ended[endedCount++] = number;
        told++;
    }

    int told() {
        return told;
    }

    int endedCount() {
        return endedCount;
    }

    int ended(int k) {
        return ended[k];
    }

    /**
     * The number may be {@link ContactEvents#NONE}; vn is that after the step, and the threshold as in {@link TouchTracker#concerns}.
     */
    public void add(
            int number,
            int lowerId,
            int higherId,
            float approach,
            float impulse,
            float normalX,
            float normalY,
            float pointX,
            float pointY,
            float slip,
            float vn,
            float threshold) {
        if (count == higher.length) {
            int longer = Math.max(64, 2 * count);
            lower = Arrays.copyOf(lower, longer);
            values = Arrays.copyOf(values, STRIDE * longer);
            pair = Arrays.copyOf(pair, longer);
            higher = Arrays.copyOf(higher, longer);
        }
        pair[count] = number;
        lower[count] = lowerId;
        higher[count] = higherId;
        int at = STRIDE * count++;
        values[at + APPROACH] = approach;
        values[at + IMPULSE] = Math.max(impulse, 0f); // differences of velocities may sum up to less
        values[at + NORMAL_X] = normalX;
        values[at + NORMAL_Y] = normalY;
        values[at + POINT_X] = pointX;
        values[at + POINT_Y] = pointY;
        values[at + SLIP] = slip;
        values[at + VN] = vn;
        values[at + THRESHOLD] = threshold;
    }

    /** Brings the point of a record inside, if it is beyond the edge of an axis that wraps. */
    void bringInside(int record, Bounds arena) {
        int at = STRIDE * record;
        values[at + POINT_X] = arena.placeX(values[at + POINT_X]);
        values[at + POINT_Y] = arena.placeY(values[at + POINT_Y]);
    }

    /** The number that the pair of a record has; after the step, that which it has got in it. */
    public int pair(int record) {
        return pair[record];
    }

    void setPair(int record, int number) {
        pair[record] = number;
    }

    int lower(int record) {
        return lower[record];
    }

    int higher(int record) {
        return higher[record];
    }

    float approach(int record) {
        return values[STRIDE * record + APPROACH];
    }

    float impulse(int record) {
        return values[STRIDE * record + IMPULSE];
    }

    float vn(int record) {
        return values[STRIDE * record + VN];
    }

    float threshold(int record) {
        return values[STRIDE * record + THRESHOLD];
    }

    /** Adds a copy of another list's record, and returns its number. */
    int add(TouchRecords from, int record) {
        return addValues(from.values, STRIDE * record);
    }

    /** Adds the values of an event, and returns its number. */
    int addValues(float[] from, int at) {
        add(
                ContactEvents.NONE,
                0,
                0,
                from[at + APPROACH],
                from[at + IMPULSE],
                from[at + NORMAL_X],
                from[at + NORMAL_Y],
                from[at + POINT_X],
                from[at + POINT_Y],
                from[at + SLIP],
                0f,
                0f);
        return count - 1;
    }

    /** Adds what a record says to that of an earlier step: its impulse, and the rest if it was faster. */
    void addTo(int record, TouchRecords earlier, int earlierRecord) {
        int from = STRIDE * record;
        int to = STRIDE * earlierRecord;
        float impulse = earlier.values[to + IMPULSE] + values[from + IMPULSE];
        if (values[from + APPROACH] > earlier.values[to + APPROACH]) {
            System.arraycopy(values, from, earlier.values, to, VALUES);
        }
        earlier.values[to + IMPULSE] = impulse;
    }

    /** Copies the values of an event. */
    void copy(int record, float[] to, int at) {
        System.arraycopy(values, STRIDE * record, to, at, VALUES);
    }

    void copy(int record, EventRows to, int row) {
        to.setValues(row, values, STRIDE * record);
    }

    public long bytes() {
        return 4L * (lower.length + higher.length + values.length + pair.length + ended.length);
    }
}
