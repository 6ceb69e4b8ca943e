package io.github.circles2d.world.bodies;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/** The outlines that bodies have: equal ones are one object, however many bodies have them. No result depends on their numbers. */
final class Outlines {
    private final Map<OutlineShape, Integer> numbers = new HashMap<>();
    private OutlineShape[] shapes = new OutlineShape[0];

    /** By number: how many bodies have it. */
    private int[] uses = new int[0];

    private int end;

    /** Makes a number for an outline, which {@link #take} then finds. If memory is short, nothing has changed. */
    void prepare(OutlineShape shape) {
        if (numbers.get(shape) == null) {
            int number = free();
            if (number == shapes.length) {
                int c = Math.max(8, 2 * number);
                uses = Arrays.copyOf(uses, c);
                shapes = Arrays.copyOf(shapes, c);
            }
            numbers.put(shape, number);
            shapes[number] = shape;
            end = Math.max(end, number + 1);
        }
    }

    private int free() {
        int number = 0;
        while (number < end && shapes[number] != null) {
            number++;
        }
        return number;
    }

    /** One more than the greatest number. */
    int end() {
        return end;
    }

    OutlineShape shape(int number) {
        return shapes[number];
    }

    /** Whether a body has the outline of a number. */
    boolean isUsed(int number) {
        return uses[number] > 0;
    }

    /** The number of an outline that has been prepared; one more body has it. */
    int take(OutlineShape shape) {
        int number = numbers.get(shape);
        uses[number]++;
        return number;
    }

    /** One body less has an outline. */
    void release(int number) {
        uses[number]--;
        if (uses[number] == 0) {
            drop(number);
        }
    }

    /** No body has any outline, until {@link #take}; numbers stay until {@link #dropUnused}. */
    void releaseAll() {
        Arrays.fill(uses, 0, end, 0);
    }

    void dropUnused() {
        for (int number = 0; number < end; number++) {
            if (shapes[number] != null && uses[number] == 0) {
                drop(number);
            }
        }
    }

    private void drop(int number) {
        numbers.remove(shapes[number]);
        shapes[number] = null;
        while (end > 0 && shapes[end - 1] == null) {
            end--;
        }
    }

    long bytes() {
        return 12L * shapes.length;
    }
}
