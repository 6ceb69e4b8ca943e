package io.github.circles2d.world.queries;

/**
 * Boxes that a search has still to look at, the nearest of a group first: a stack. An entry names a group of boxes, those that
 * share a box of the next level, or at {@link #CIRCLES} the circles of a box.
 */
final class Frontier {
    /** The level below level 0. */
    static final int CIRCLES = -1;

    /** A group has three siblings at most for each level, and the last group four. */
    private static final int DEPTH = 4 * (CircleTree.LEVELS + 1);

    private final int[] level = new int[DEPTH];
    private final int[] group = new int[DEPTH];
    private final double[] distance = new double[DEPTH];
    private int size;
    private int base;

    /** Begins with the box of the top level. */
    void start(CircleTree tree) {
        size = 0;
        beginGroup();
        push(tree.top, 0, Double.NEGATIVE_INFINITY);
    }

    /** Says that the entries to come are siblings. */
    void beginGroup() {
        base = size;
    }

    /** Adds an entry, which comes out before its siblings that are farther. */
    void push(int itsLevel, int itsGroup, double itsDistance) {
        int k = size++;
        while (k > base && distance[k - 1] < itsDistance) {
            level[k] = level[k - 1];
            group[k] = group[k - 1];
            distance[k] = distance[k - 1];
            k--;
        }
        level[k] = itsLevel;
        group[k] = itsGroup;
        distance[k] = itsDistance;
    }

    /** Takes the next entry, if there is one. */
    boolean pop() {
        return --size >= 0;
    }

    /** The level of the entry that was taken. */
    int level() {
        return level[size];
    }

    /** The group of the entry that was taken, or the box whose circles it names. */
    int group() {
        return group[size];
    }

    /** The distance of the entry that was taken. */
    double distance() {
        return distance[size];
    }
}
