package io.github.circles2d.bench.broadphase;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** Random positions without overlaps for circles of unlike radii: the largest first, each drawn until it touches no other. */
final class Darts {
    /** The circles of one factor of two between the radii, in square cells. */
    private static final class Level {
        private final float top;
        private final int side;
        private final int[] first;

        private Level(float top) {
            this.top = top;
            // A cell is at least as wide as the greatest diameter here.
            side = (int) Math.max(1, 1 / (2 * top));
            first = new int[side * side];
            Arrays.fill(first, -1);
        }

        private int cell(float at) {
            return Math.max(0, Math.min(side - 1, (int) (at * side)));
        }
    }

    private final float[] circles;
    private final int[] next;
    private final List<Level> levels = new ArrayList<>();

    private Darts(int n) {
        circles = new float[4 * n];
        next = new int[n];
    }

    /**
     * Places circles in the unit square.
     *
     * @param radius in increasing order
     * @return x, y, radius and mass of each; the mass is that of a disc whose largest circle has a mass of 10
     */
    static float[] throwInto(float[] radius, Random random) {
        Darts darts = new Darts(radius.length);
        float greatest = radius[radius.length - 1];
        for (int i = radius.length - 1; i >= 0; i--) {
            float r = radius[i];
            float top = darts.levels.isEmpty() ? greatest : darts.last().top;
            while (darts.levels.isEmpty() || r <= 0.5f * top) {
                top = darts.levels.isEmpty() ? greatest : 0.5f * top;
                darts.levels.add(new Level(top));
            }
            float share = r / greatest;
            darts.place(i, r, 10 * share * share, random);
        }
        return darts.circles;
    }

    private Level last() {
        return levels.get(levels.size() - 1);
    }

    private void place(int i, float r, float mass, Random random) {
        float x;
        float y;
        do {
            x = r + random.nextFloat() * (1 - 2 * r);
            y = r + random.nextFloat() * (1 - 2 * r);
        } while (touches(x, y, r));
        circles[4 * i] = x;
        circles[4 * i + 1] = y;
        circles[4 * i + 2] = r;
        circles[4 * i + 3] = mass;
        Level level = last();
        int cell = level.cell(y) * level.side + level.cell(x);
        next[i] = level.first[cell];
        level.first[cell] = i;
    }

    private boolean touches(float x, float y, float r) {
        for (Level level : levels) {
            float range = r + level.top;
            for (int row = level.cell(y - range); row <= level.cell(y + range); row++) {
                for (int column = level.cell(x - range); column <= level.cell(x + range); column++) {
                    for (int j = level.first[row * level.side + column]; j >= 0; j = next[j]) {
                        if (Circles.near(x, y, r, circles[4 * j], circles[4 * j + 1], circles[4 * j + 2])) {
                            return true;
                        }
                    }
                }
            }
        }
        return false;
    }
}
