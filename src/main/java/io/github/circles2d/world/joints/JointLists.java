package io.github.circles2d.world.joints;

import java.util.Arrays;

/** The ends of joints by circle: lists of elements by owner. An element is in one list at most. */
final class JointLists {
    static final int NONE = -1;

    private int[] first = new int[0];
    private int[] next = new int[0];
    private int[] previous = new int[0];

    /** Makes room. If there is none, nothing has changed. */
    void ensure(int owners, int elements) {
        if (first.length < owners) {
            int had = first.length;
            int[] more = Arrays.copyOf(first, Math.max(owners, had + (had >> 1)));
            Arrays.fill(more, had, more.length, NONE);
            first = more;
        }
        if (previous.length < elements) {
            int c = Math.max(elements, previous.length + (previous.length >> 1));
            int[] newNext = Arrays.copyOf(next, c);
            int[] newPrevious = Arrays.copyOf(previous, c);
            next = newNext;
            previous = newPrevious;
        }
    }

    /** The one that came last, or {@link #NONE}. */
    int first(int owner) {
        return owner < first.length ? first[owner] : NONE;
    }

    int next(int element) {
        return next[element];
    }

    /** There is room. */
    void add(int owner, int element) {
        int then = first[owner];
        next[element] = then;
        previous[element] = NONE;
        if (then != NONE) {
            previous[then] = element;
        }
        first[owner] = element;
    }

    void remove(int owner, int element) {
        int then = next[element];
        int before = previous[element];
        if (then != NONE) {
            previous[then] = before;
        }
        if (before == NONE) {
            first[owner] = then;
        } else {
            next[before] = then;
        }
    }

    void clear() {
        Arrays.fill(first, NONE);
    }

    long bytes() {
        return (long) Integer.BYTES * (first.length + next.length + previous.length);
    }
}
