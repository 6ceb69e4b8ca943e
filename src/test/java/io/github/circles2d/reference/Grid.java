package io.github.circles2d.reference;

import io.github.circles2d.Edge;
import java.math.BigDecimal;
import java.math.BigInteger;
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
    private record Ring(Edge edge, int cells, float min, float perLength, int units) {
        /** The number of a coordinate's cell, as if there were any number of cells. */
        BigInteger cell(float coordinate) {
            return switch (edge) {
                case WALL -> BigInteger.valueOf((int) Numbers.max((coordinate - min) * perLength, 0f));
                case OPEN -> openCell(coordinate);
                case WRAP -> BigInteger.valueOf((long) Math.floor((coordinate - min) * perLength));
            };
        }

        /** A whole number of units, the rest of a unit cut off, and then a whole number of cells. */
        private BigInteger openCell(float coordinate) {
            BigDecimal most = new BigDecimal(0x1p62);
            BigDecimal scaled = new BigDecimal(coordinate * perLength).min(most).max(most.negate());
            BigInteger[] cell = scaled.toBigInteger().divideAndRemainder(BigInteger.valueOf(units));
            return cell[1].signum() < 0 ? cell[0].subtract(BigInteger.ONE) : cell[0];
        }

        int cellOnRing(float coordinate) {
            return cell(coordinate).mod(BigInteger.valueOf(cells)).intValue();
        }

        /** The lesser one of two cells that are equal or neighbours. */
        int lesser(float a, float b) {
            int cellOfA = cellOnRing(a);
            int cellOfB = cellOnRing(b);
            return (cellOfB + 1) % cells == cellOfA ? cellOfB : cellOfA;
        }
    }

    /** Sorts the circles into levels; without any there is nothing to lay out. */
    Grid(List<Circle> circles, StepParameters step) {
        if (circles.isEmpty()) {
            finestLevel = 0;
            return;
        }
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
            rings[k] = layOut(largestRadius[k], population[k], step.arena());
        }
        for (Circle c : circles) {
            c.column = rings[c.level][0].cellOnRing(c.base[0]);
            c.row = rings[c.level][1].cellOnRing(c.base[1]);
        }
    }

    private int sizeClass(Circle c) {
        int k = 0;
        while (k < LEVELS - 1 && c.radius <= largestRadius[k] * 0.5f) {
            k++;
        }
        return k;
    }

    private static Ring[] layOut(float radius, int circles, Arena arena) {
        float[] min = arena.min();
        float[] max = arena.max();
        float m = 0f;
        for (int a = 0; a < 2; a++) {
            m = Math.max(m, Math.max(Math.max(Math.abs(min[a]), Math.abs(max[a])), max[a] - min[a]));
        }
        float edge = 2f * (radius * (1f + Circle.MARGIN + Circle.CAP)) + m * 0x1p-20f;
        float[] extent = {cells(arena, 0, edge), cells(arena, 1, edge)};
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
            int number = vast ? twicePrime(cells[a], a + 1) : cells[a];
            rings[a] = switch (arena.edges()[a]) {
                case WALL -> new Ring(Edge.WALL, number, min[a], 1f / edge, 0);
                case OPEN -> open(number, 2f * (radius * (1f + Circle.MARGIN + Circle.CAP)));
                case WRAP -> wrapped(Math.min(number, (int) extent[a]), (int) extent[a], min[a], arena.period(a));
            };
        }
        return rings;
    }

    /** How many cells of an edge there are along an axis: where it wraps, an even number. */
    private static float cells(Arena arena, int axis, float edge) {
        return switch (arena.edges()[axis]) {
            case WALL -> arena.period(axis) / edge;
            case OPEN -> Float.POSITIVE_INFINITY;
            case WRAP -> (int) (arena.period(axis) / edge) / 2 * 2;
        };
    }

    /** Cells of a whole number of units, of which at least 1,024 are as wide as the edge. */
    private static Ring open(int number, float edge) {
        float perLength = 1024f;
        for (float e = edge; e >= 2f; e *= 0.5f) {
            perLength *= 0.5f;
        }
        for (float e = edge; e < 1f; e *= 2f) {
            perLength *= 2f;
        }
        return new Ring(Edge.OPEN, number, 0f, perLength, (int) Math.floor(edge * perLength) + 2);
    }

    /** A ring that a period goes round a whole number of times. */
    private static Ring wrapped(int number, int fitting, float min, float period) {
        int cells = fitting - fitting % number;
        return new Ring(Edge.WRAP, number, min, cells / period, 0);
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
    Comparator<Circle> order() {
        return Comparator.comparingInt((Circle c) -> -c.level)
                .thenComparingInt(c -> c.row)
                .thenComparingInt(c -> c.column)
                .thenComparingInt(c -> c.id);
    }

    boolean isBefore(Circle a, Circle b) {
        return order().compare(a, b) < 0;
    }
}
