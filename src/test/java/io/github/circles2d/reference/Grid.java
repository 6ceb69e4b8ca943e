package io.github.circles2d.reference;

import java.util.List;
import java.util.stream.IntStream;

/** The levels of the circles, and the cells of each level's grid, which lie on a ring in both directions. */
final class Grid {
    private static final int LEVELS = 20;
    private static final int JOIN = 2;

    private final Rings[] rings = new Rings[LEVELS];
    private final float[] largestRadius = new float[LEVELS];

    /** The columns and rows of a level. */
    private record Rings(Ring columns, Ring rows) {}

    /** Cells along an axis, the first of them from the lower wall on; after the last one comes the first again. */
    private record Ring(int cells, float low, float inverseEdge) {
        /** The number of a coordinate's cell, as if there were any number of cells. */
        int cell(float coordinate) {
            return (int) Numbers.max((coordinate - low) * inverseEdge, 0f);
        }

        /** The lesser one of two cells that are equal or neighbours. */
        int lesser(float a, float b) {
            int cellOfA = cell(a) % cells;
            int cellOfB = cell(b) % cells;
            return (cellOfB + 1) % cells == cellOfA ? cellOfB : cellOfA;
        }

        /** Whether the cell of a coordinate is one of those from one coordinate to another. */
        boolean covers(float from, float to, float coordinate) {
            return Math.floorMod(cell(coordinate) - cell(from), cells) <= cell(to) - cell(from);
        }
    }

    /** Sorts the circles into levels. */
    Grid(List<Circle> circles, StepParameters.Walls x, StepParameters.Walls y) {
        largestRadius[0] =
                (float) circles.stream().mapToDouble(c -> c.radius).max().orElseThrow();
        for (int k = 1; k < LEVELS; k++) {
            largestRadius[k] = largestRadius[k - 1] * 0.5f;
        }
        int[] count = new int[LEVELS];
        circles.forEach(c -> count[sizeClass(c.radius)]++);
        int[] level = new int[LEVELS];
        int[] population = new int[LEVELS];
        for (int k = 0; k < LEVELS; k++) {
            boolean joins = k > 0 && level[k - 1] == k - 1 && count[k] <= JOIN * count[k - 1];
            level[k] = joins ? k - 1 : k;
            population[level[k]] += count[k];
        }
        circles.forEach(c -> c.level = level[sizeClass(c.radius)]);
        for (int k = 0; k < LEVELS; k++) {
            rings[k] = layOut(largestRadius[k], population[k], x, y);
        }
    }

    /** Class k holds radii from the largest one over 2 to the power of k down to half of that; the last one all smaller ones. */
    private int sizeClass(float radius) {
        int k = 0;
        while (k < LEVELS - 1 && radius <= largestRadius[k] * 0.5f) {
            k++;
        }
        return k;
    }

    private static Rings layOut(float radius, int circles, StepParameters.Walls x, StepParameters.Walls y) {
        float magnitude = Math.max(magnitude(x), magnitude(y));
        float edge = 2f * (radius * (1f + Circle.MARGIN + Circle.CAP)) + magnitude * 0x1p-20f;
        float across = (x.high() - x.low()) / edge;
        float down = (y.high() - y.low()) / edge;
        int columns = cells(across);
        int rows = cells(down);
        int most = Math.max(16, 2 * Integer.highestOneBit(circles));
        while ((long) columns * rows > most) {
            if (columns >= rows) {
                columns /= 2;
            } else {
                rows /= 2;
            }
        }
        if (columns >= 16 && across > 4 * columns) {
            columns = 2 * primeBelow(columns / 2);
        }
        if (rows >= 16 && down > 4 * rows) {
            rows = 2 * primeBelow(primeBelow(rows / 2));
        }
        return new Rings(new Ring(columns, x.low(), 1f / edge), new Ring(rows, y.low(), 1f / edge));
    }

    /** The greatest prime that is less than a number. */
    private static int primeBelow(int number) {
        int prime = number - 1;
        while (hasDivisor(prime)) {
            prime--;
        }
        return prime;
    }

    private static boolean hasDivisor(int number) {
        return IntStream.rangeClosed(2, (int) Math.sqrt(number)).anyMatch(divisor -> number % divisor == 0);
    }

    private static float magnitude(StepParameters.Walls walls) {
        return Math.max(Math.max(Math.abs(walls.low()), Math.abs(walls.high())), walls.high() - walls.low());
    }

    /** The least power of two that is not less than a number; from 4 to 32,768. */
    private static int cells(float number) {
        int cells = 4;
        while (cells < 32_768 && number > cells) {
            cells *= 2;
        }
        return cells;
    }

    float largestRadius(int level) {
        return largestRadius[level];
    }

    /** The colour of the contact of two circles: the parities of their lesser column and row in the level of the larger. */
    int colour(Circle a, Circle b) {
        Rings r = rings[Math.min(a.level, b.level)];
        return r.columns.lesser(a.x.base, b.x.base) % 2 + 2 * (r.rows.lesser(a.y.base, b.y.base) % 2);
    }

    /** Whether the cell of a circle, in its own level, is one of those of a rectangle. */
    boolean covers(float fromX, float fromY, float toX, float toY, Circle c) {
        Rings r = rings[c.level];
        return r.columns.covers(fromX, toX, c.x.base) && r.rows.covers(fromY, toY, c.y.base);
    }
}
