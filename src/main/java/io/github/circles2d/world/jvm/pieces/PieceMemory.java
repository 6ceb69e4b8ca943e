package io.github.circles2d.world.jvm.pieces;

import java.util.Arrays;

/**
 * The pieces of the ground whose boxes meet a box around a circle: they are the same as long as the circle sees nothing outside that box, and the
 * ground does not change. So only circles that move far walk the tree. This decides nothing, and is no part of a state.
 */
final class PieceMemory {
    private static final int BOX = 4;

    // the whole numbers of a circle
    private static final int NUMBERS = 8;
    private static final int VERSION = 0;
    private static final int COUNT = 1;
    private static final int FIRST = 2;
    private static final int MOST = NUMBERS - FIRST;

    /** By id of a circle: the box. An empty one holds nothing. */
    private float[] boxes = new float[0];

    private int[] numbers = new int[0];

    long bytes() {
        return 4L * (boxes.length + numbers.length);
    }

    void ensure(int ids) {
        int old = boxes.length / BOX;
        if (ids > old) {
            numbers = Arrays.copyOf(numbers, NUMBERS * ids);
            for (int id = old; id < ids; id++) {
                numbers[NUMBERS * id + VERSION] = -1;
            }
            boxes = Arrays.copyOf(boxes, BOX * ids);
        }
    }

    /** Gives the pieces to a finder, if they are known for all of a box. */
    boolean recall(int id, float minX, float minY, float maxX, float maxY, int version, PieceSearch.Finder finder) {
        int b = BOX * id;
        int k = NUMBERS * id;
        if (numbers[k + VERSION] != version
                || !(boxes[b] <= minX && boxes[b + 1] <= minY && boxes[b + 2] >= maxX && boxes[b + 3] >= maxY)) {
            return false;
        }
        int end = k + FIRST + numbers[k + COUNT];
        for (int i = k + FIRST; i < end; i++) {
            finder.insert(numbers[i]);
        }
        return true;
    }

    /** Keeps pieces, unless they are too many. */
    void keep(int id, float minX, float minY, float maxX, float maxY, int version, int[] pieces, int count) {
        int b = BOX * id;
        int k = NUMBERS * id;
        if (count > MOST) {
            numbers[k + VERSION] = -1;
            return;
        }
        numbers[k + VERSION] = version;
        numbers[k + COUNT] = count;
        System.arraycopy(pieces, 0, numbers, k + FIRST, count);
        boxes[b] = minX;
        boxes[b + 1] = minY;
        boxes[b + 2] = maxX;
        boxes[b + 3] = maxY;
    }
}
