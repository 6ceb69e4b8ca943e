package io.github.circles2d.reference;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** The levels of the circles, and the cells of each level's grid, which lie on a ring in both directions. */
final class Grid {
    private static final int LEVELS = 20;
    private static final int JOIN = 2;

    private final float[] largestRadius = new float[LEVELS];
    private final int finestLevel;

    /** Of each level, its columns and its rows. */
    private final Ring[][] rings = new Ring[LEVELS][];

    /** Cells along an axis, the first of them from the lower wall on; after the last one comes the first again. */
    private record Ring(int cells, float min, float inverseEdge) {
        /** The number of a coordinate's cell, as if there were any number of cells. */
        int cell(float coordinate) {
            return (int) Numbers.max((coordinate - min) * inverseEdge, 0f);
        }

        int cellOnRing(float coordinate) {
            return cell(coordinate) % cells;
        }

        /** The lesser one of two cells that are equal or neighbours. */
        int lesser(float a, float b) {
            int cellOfA = cellOnRing(a);
            int cellOfB = cellOnRing(b);
            return (cellOfB + 1) % cells == cellOfA ? cellOfB : cellOfA;
        }
    }

    /** Sorts the circles into levels. */
    Grid(List<Circle> circles, StepParameters step) {
        largestRadius[0] =
                (float) circles.stream().mapToDouble(c -> c.radius).max().orElseThrow();
        for (int k = 1; k < LEVELS; k++) {
            largestRadius[k] = largestRadius[k - 1] * 0.5f;
        }
        int[] count = new int[LEVELS];
        circles.forEach(c -> count[sizeClass(c)]++);
        int[] level = new int[LEVELS];
        int[] population = new int[LEVELS];
        for (int k = 0; k < LEVELS; k++) {
            boolean joins = k > 0 && level[k - 1] == k - 1 && count[k] <= JOIN * count[k - 1];
            level[k] = joins ? k - 1 : k;
            population[level[k]] += count[k];
        }
        circles.forEach(c -> c.level = level[sizeClass(c)]);
        finestLevel = circles.stream().mapToInt(c -> c.level).max().orElseThrow();
        for (int k = 0; k < LEVELS; k++) {
            rings[k] = layOut(largestRadius[k], population[k], step.min(), step.max());
        }
    }

    private int sizeClass(Circle c) {
        int k = 0;
        while (k < LEVELS - 1 && c.radius <= largestRadius[k] * 0.5f) {
            k++;
        }
        return k;
    }

    private static Ring[] layOut(float radius, int circles, float[] min, float[] max) {
        float m = 0f;
        for (int a = 0; a < 2; a++) {
            m = Math.max(m, Math.max(Math.max(Math.abs(min[a]), Math.abs(max[a])), max[a] - min[a]));
        }
        float edge = 2f * (radius * (1f + Circle.MARGIN + Circle.CAP)) + m * 0x1p-20f;
        float[] extent = {(max[0] - min[0]) / edge, (max[1] - min[1]) / edge};
        int[] cells = {4, 4};
        for (int a = 0; a < 2; a++) {
            while (cells[a] < 32_768 && extent[a] > cells[a]) {
                cells[a] *= 2;
            }
        }
        while ((long) cells[0] * cells[1] > Math.max(16, 2 * Integer.highestOneBit(circles))) {
            cells[cells[0] >= cells[1] ? 0 : 1] /= 2;
        }
        Ring[] rings = new Ring[2];
        for (int a = 0; a < 2; a++) {
            boolean vast = cells[a] >= 16 && extent[a] > 4 * cells[a];
            rings[a] = new Ring(vast ? twicePrime(cells[a], a + 1) : cells[a], min[a], 1f / edge);
        }
        return rings;
    }

    /** Twice the greatest prime below half of a number, or the second greatest one, and so on. */
    private static int twicePrime(int number, int nth) {
        return 2
                * IntStream.iterate(number / 2 - 1, p -> p - 1)
                        .filter(p -> IntStream.range(2, p).allMatch(divisor -> p % divisor != 0))
                        .skip(nth - 1)
                        .findFirst()
                        .orElseThrow();
    }

    /** The largest radius that the level of the smallest circles may have. */
    float finestRadius() {
        return largestRadius[finestLevel];
    }

    /** The colour of a contact: the parities of the lesser column and row of its circles, in the level of the larger one. */
    int colour(Contact contact) {
        Ring[] r = rings[contact.level()];
        float[] a = contact.lower.base;
        float[] b = contact.higher.base;
        return r[0].lesser(a[0], b[0]) % 2 + 2 * (r[1].lesser(a[1], b[1]) % 2);
    }

    /** The order of circles: levels of small circles first, then by rows, columns and ids. */
    boolean isBefore(Circle a, Circle b) {
        return Comparator.comparingInt((Circle c) -> -c.level)
                        .thenComparingInt(c -> rings[c.level][1].cellOnRing(c.base[1]))
                        .thenComparingInt(c -> rings[c.level][0].cellOnRing(c.base[0]))
                        .thenComparingInt(c -> c.id)
                        .compare(a, b)
                < 0;
    }
}
