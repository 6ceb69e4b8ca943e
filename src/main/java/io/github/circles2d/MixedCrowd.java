package io.github.circles2d;

import io.github.circles2d.calibration.Crowd;
import java.util.Arrays;
import java.util.Random;

/**
 * Circles of mixed radii that fill 0.62 of the unit square: the logarithms of the radii are spread evenly, masses go by area, and ids
 * have no order. The largest are placed first, each where it overlaps no other if a place is soon found.
 */
final class MixedCrowd {
    private static final double FILL = 0.62;
    private static final double GREATEST_MASS = 10;

    /** In narrow gaps a circle of the calibration overlaps another: that is pushed out soon, and a long search takes longer. */
    private static final int MOST_DRAWS = 100;

    /** Bounds the memory of a grid. */
    private static final double CELLS_PER_CIRCLE = 4;

    private final float[] circles;
    private final int[] next;

    /** Columns, and rows, of a grid for each factor of two below the greatest diameter. */
    private final int[] columns;

    private final int[][] first;

    private MixedCrowd(int count, float greatest, float least) {
        circles = new float[4 * count];
        next = new int[count];
        columns = new int[Math.getExponent(greatest) - Math.getExponent(least) + 2];
        first = new int[columns.length][];
        double most = Math.sqrt(CELLS_PER_CIRCLE * count);
        for (int level = 0; level < columns.length; level++) {
            columns[level] = (int) Math.max(1, Math.min(most, Math.scalb(1 / (2 * greatest), level)));
            first[level] = new int[columns[level] * columns[level]];
            Arrays.fill(first[level], -1);
        }
    }

    /** x, y, radius and mass of each: the same circles every time that the random numbers are the same. */
    static float[] of(Crowd crowd, Random random) {
        int count = crowd.circles();
        float[] radii = radii(crowd, random);
        float greatest = radii[count - 1];
        MixedCrowd mixed = new MixedCrowd(count, greatest, radii[0]);
        int[] ids = shuffled(count, random);
        int level = 0;
        for (int k = count - 1; k >= 0; k--) {
            while (radii[k] <= Math.scalb(greatest, -level - 1)) {
                level++;
            }
            double share = radii[k] / greatest;
            mixed.place(ids[k], radii[k], (float) (GREATEST_MASS * share * share), level, random);
        }
        return mixed.circles;
    }

    /** In ascending order. */
    private static float[] radii(Crowd crowd, Random random) {
        double[] shares = new double[crowd.circles()];
        double area = 0;
        for (int i = 0; i < shares.length; i++) {
            shares[i] = StrictMath.pow(crowd.ratio(), random.nextDouble());
            area += Math.PI * shares[i] * shares[i];
        }
        double scale = Math.sqrt(FILL / area);
        float[] radii = new float[shares.length];
        for (int i = 0; i < shares.length; i++) {
            radii[i] = (float) (scale * shares[i]);
        }
        Arrays.sort(radii);
        return radii;
    }

    private static int[] shuffled(int count, Random random) {
        int[] ids = new int[count];
        for (int i = 0; i < count; i++) {
            int other = random.nextInt(i + 1);
            ids[i] = ids[other];
            ids[other] = i;
        }
        return ids;
    }

    private void place(int id, float radius, float mass, int level, Random random) {
        float x;
        float y;
        int draws = 0;
        do {
            x = radius + random.nextFloat() * (1 - 2 * radius);
            y = radius + random.nextFloat() * (1 - 2 * radius);
        } while (++draws < MOST_DRAWS && overlaps(x, y, radius, level));
        circles[4 * id] = x;
        circles[4 * id + 1] = y;
        circles[4 * id + 2] = radius;
        circles[4 * id + 3] = mass;
        int cell = cell(x, level) + columns[level] * cell(y, level);
        next[id] = first[level][cell];
        first[level][cell] = id;
    }

    /** Whether a circle would overlap one of its level, or of one with larger circles. A cell is as wide as the greatest diameter there. */
    private boolean overlaps(float x, float y, float radius, int finest) {
        for (int level = 0; level <= finest; level++) {
            int last = columns[level] - 1;
            for (int row = Math.max(cell(y, level) - 1, 0); row <= Math.min(cell(y, level) + 1, last); row++) {
                for (int column = Math.max(cell(x, level) - 1, 0);
                        column <= Math.min(cell(x, level) + 1, last);
                        column++) {
                    if (overlapsOneOf(first[level][column + columns[level] * row], x, y, radius)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private boolean overlapsOneOf(int id, float x, float y, float radius) {
        for (int other = id; other >= 0; other = next[other]) {
            float dx = x - circles[4 * other];
            float dy = y - circles[4 * other + 1];
            float sum = radius + circles[4 * other + 2];
            if (dx * dx + dy * dy < sum * sum) {
                return true;
            }
        }
        return false;
    }

    private int cell(float at, int level) {
        return Math.min((int) (at * columns[level]), columns[level] - 1);
    }
}
