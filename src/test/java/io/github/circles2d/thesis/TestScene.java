package io.github.circles2d.thesis;

import java.util.Random;

/** Circles for tests, and the arrangements that need more than a line. */
final class TestScene {
    final float[] x;
    final float[] y;
    final float[] radius;
    final float[] mass;
    final float[] vx;
    final float[] vy;

    private TestScene(int n) {
        x = new float[n];
        y = new float[n];
        radius = new float[n];
        mass = new float[n];
        vx = new float[n];
        vy = new float[n];
    }

    int size() {
        return x.length;
    }

    CircleList circles() {
        CircleList circles = new CircleList();
        for (int i = 0; i < size(); i++) {
            circles.add(x[i], y[i], radius[i], mass[i], vx[i], vy[i]);
        }
        return circles;
    }

    /**
     * Pairs of circles in the cells of a lattice, wide enough apart that no circle ever meets one of another cell in a few
     * dozen steps: about half of the pairs overlap, the others are close. Their numbers are shuffled, so that their slots lie
     * all over the collision buffer.
     */
    static TestScene isolatedPairs(int side, long seed) {
        TestScene scene = new TestScene(2 * side * side);
        Random random = new Random(seed);
        int[] number = shuffled(scene.size(), random);
        float cell = 1f / side;
        for (int k = 0; k < side * side; k++) {
            float cx = (k % side + 0.5f) * cell;
            float cy = (k / side + 0.5f) * cell;
            float r1 = cell * (0.08f + 0.08f * random.nextFloat());
            float r2 = cell * (0.08f + 0.08f * random.nextFloat());
            double gap = (r1 + r2) * (0.3 + 1.2 * random.nextDouble());
            double angle = random.nextDouble() * 2 * Math.PI;
            float dx = (float) (0.5 * gap * Math.cos(angle));
            float dy = (float) (0.5 * gap * Math.sin(angle));
            scene.set(number[2 * k], cx - dx, cy - dy, r1, random, 0.3f * cell);
            scene.set(number[2 * k + 1], cx + dx, cy + dy, r2, random, 0.3f * cell);
        }
        return scene;
    }

    /** Circles that overlap each other many times over, as in the thesis's own scene. */
    static TestScene crowd(int n, float r, long seed) {
        TestScene scene = new TestScene(n);
        Random random = new Random(seed);
        for (int i = 0; i < n; i++) {
            scene.set(i, 0.1f + 0.8f * random.nextFloat(), 0.1f + 0.8f * random.nextFloat(), r, random, 0.1f);
        }
        return scene;
    }

    /** Fast circles near the walls and in the corners: most of them bounce in the first steps. */
    static TestScene atTheWalls(int n, long seed) {
        TestScene scene = new TestScene(n);
        Random random = new Random(seed);
        for (int i = 0; i < n; i++) {
            float r = 0.005f + 0.01f * random.nextFloat();
            float nearX = random.nextBoolean() ? r : 1 - r;
            float nearY = random.nextBoolean() ? r : 1 - r;
            boolean corner = random.nextInt(4) == 0;
            boolean alongX = random.nextBoolean();
            float px = corner || alongX ? nearX : random.nextFloat();
            float py = corner || !alongX ? nearY : random.nextFloat();
            scene.set(i, px, py, r, random, 2);
        }
        return scene;
    }

    private void set(int i, float px, float py, float r, Random random, float speed) {
        x[i] = px;
        y[i] = py;
        radius[i] = r;
        mass[i] = 1 + 9 * random.nextFloat();
        vx[i] = speed * (2 * random.nextFloat() - 1);
        vy[i] = speed * (2 * random.nextFloat() - 1);
    }

    private static int[] shuffled(int n, Random random) {
        int[] numbers = new int[n];
        for (int i = 0; i < n; i++) {
            int at = random.nextInt(i + 1);
            numbers[i] = numbers[at];
            numbers[at] = i;
        }
        return numbers;
    }
}
