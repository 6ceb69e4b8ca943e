package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/** The joints of each circle: the list of their ends, the colours that they have, and how many hold it to another circle. */
final class JointsOfCircles {
    static final int NONE = -1;

    // the ends of a joint
    private static final int ENDS = 2;
    private static final int A = 0;
    private static final int B = 1;

    private static final int ALL = (1 << JointStep.COLOURS) - 1;

    /** By joint. */
    private byte[] colour = new byte[0];

    // by end: the neighbours in the list of its circle
    private int[] next = new int[0];
    private int[] previous = new int[0];

    /** By circle: the end that came last, or {@link #NONE}. */
    private int[] first = new int[0];

    /** By circle: a bit for each colour that one of its joints has. */
    private int[] colours = new int[0];

    /** By circle: its joints with other circles. */
    private int[] partners = new int[0];

    void setRoom(int joints) {
        colour = Arrays.copyOf(colour, joints);
        next = Arrays.copyOf(next, ENDS * joints);
        previous = Arrays.copyOf(previous, ENDS * joints);
    }

    /** Makes room for circles. If there is none, nothing has changed. */
    void ensure(int circleIds) {
        int had = first.length;
        if (had < circleIds) {
            int c = Math.max(circleIds, had + (had >> 1));
            colours = Arrays.copyOf(colours, c);
            partners = Arrays.copyOf(partners, c);
            first = Arrays.copyOf(first, c);
            Arrays.fill(first, had, c, NONE);
        }
    }

    /** The end that came last to a circle, or {@link #NONE}. */
    int first(int circle) {
        return circle < first.length ? first[circle] : NONE;
    }

    int next(int end) {
        return next[end];
    }

    static int jointOf(int end) {
        return end / ENDS;
    }

    int colour(int joint) {
        return colour[joint];
    }

    void setColour(int joint, int to) {
        colour[joint] = (byte) to;
    }

    /** The least colour that is free at a circle and at another one, which may be none. */
    int freeColour(int a, int b) {
        int free = ~(colours[a] | (b == JointRow.NONE ? 0 : colours[b])) & ALL;
        return free == 0 ? JointTable.SPLIT : Integer.numberOfTrailingZeros(free);
    }

    /** 0 of a split joint. */
    private int bit(int joint) {
        return 1 << colour[joint] & ALL;
    }

    /** A joint comes, which has its colour; there is room. */
    void enter(int joint, int a, int b) {
        if (a != JointRow.NONE) {
            enter(ENDS * joint + A, a);
        }
        if (b != JointRow.NONE) {
            enter(ENDS * joint + B, b);
        }
        if (a != JointRow.NONE && b != JointRow.NONE) {
            partners[a]++;
            partners[b]++;
        }
    }

    private void enter(int end, int circle) {
        int then = first[circle];
        next[end] = then;
        previous[end] = NONE;
        if (then != NONE) {
            previous[then] = end;
        }
        first[circle] = end;
        colours[circle] |= bit(jointOf(end));
    }

    /** A joint goes. */
    void leave(int joint, int a, int b) {
        if (a != JointRow.NONE) {
            leave(ENDS * joint + A, a);
        }
        if (b != JointRow.NONE) {
            leave(ENDS * joint + B, b);
        }
        if (a != JointRow.NONE && b != JointRow.NONE) {
            partners[a]--;
            partners[b]--;
        }
    }

    private void leave(int end, int circle) {
        int then = next[end];
        int before = previous[end];
        if (then != NONE) {
            previous[then] = before;
        }
        if (before == NONE) {
            first[circle] = then;
        } else {
            next[before] = then;
        }
        colours[circle] &= ~bit(jointOf(end));
    }

    /** Whether a circle has become a hub by its last joint. */
    boolean becomesHub(int circle) {
        return partners[circle] == JointStep.HUB + 1;
    }

    boolean isHub(int circle) {
        return partners[circle] > JointStep.HUB;
    }

    /** A joint of two circles, which is there, has no colour from now on. */
    void split(int joint, int a, int b) {
        colours[a] &= ~bit(joint);
        colours[b] &= ~bit(joint);
        setColour(joint, JointTable.SPLIT);
    }

    /** No joints. */
    void clear() {
        Arrays.fill(first, NONE);
        Arrays.fill(colours, 0);
        Arrays.fill(partners, 0);
    }

    long bytes() {
        return colour.length + 4L * (next.length + previous.length + first.length + colours.length + partners.length);
    }
}
