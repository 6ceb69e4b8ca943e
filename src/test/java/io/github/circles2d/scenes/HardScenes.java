package io.github.circles2d.scenes;

import java.util.Random;

/** Scenes that ask more of the solver than published ones do. They fit in the unit arena; steps are of 1/60 s. */
public final class HardScenes {
    private static final float STEP = 1f / 60f;

    private HardScenes() {}

    /** A jam: circles with radii and masses as in {@link Scenes#packed}, no gravity, restitution 0.5, and a fill of 1.1. */
    public static Scene jam(int n, long seed) {
        Scene packed = Scenes.packed(n, seed);
        Scene.Builder b = new Scene.Builder("jam", n).restitution(0.5f);
        float larger = (float) Math.sqrt(1.1 / packed.fill());
        for (int i = 0; i < n; i++) {
            // x and y of packed run from 0.1 to 0.9
            float x = (packed.x(i) - 0.1f) / 0.8f;
            float y = (packed.y(i) - 0.1f) / 0.8f;
            b.circle(i, x, y, packed.radius(i) * larger, packed.mass(i));
        }
        return b.build();
    }

    /** A pile: rows of circles that lie on the floor and on each other, almost at rest; gravity (0, -1), restitution 0.5. */
    public static Scene pile(int columns, int rows, long seed) {
        Scene.Builder b =
                new Scene.Builder("pile", columns * rows).gravity(0, -1).restitution(0.5f);
        Random random = new Random(seed);
        float pitch = 1 / (columns + 0.5f);
        for (int i = 0; i < columns * rows; i++) {
            int row = i / columns;
            float x = (i % columns + (row % 2 == 0 ? 0.5f : 1)) * pitch;
            float y = (0.5f + 0.8660254f * row) * pitch;
            float r = 0.5f * pitch * (0.95f + 0.05f * random.nextFloat());
            b.circle(i, x, y, r, 1 + 9 * random.nextFloat());
        }
        return b.build();
    }

    /** A pile as above of circles, each fourth of which has a tenth of the radius up to all of it; masses by area, restitution 0.2. */
    public static Scene mixedPile(int columns, int rows, long seed) {
        Scene.Builder b =
                new Scene.Builder("mixed-pile", columns * rows).gravity(0, -1).restitution(0.2f);
        Random random = new Random(seed);
        float pitch = 1 / (columns + 0.5f);
        for (int i = 0; i < columns * rows; i++) {
            int row = i / columns;
            float x = (i % columns + (row % 2 == 0 ? 0.5f : 1)) * pitch;
            float y = (0.5f + 0.8660254f * row) * pitch;
            float r = 0.5f * pitch * (i % 4 == 0 ? 0.1f + 0.9f * random.nextFloat() : 0.95f);
            b.circle(i, x, y, r, 1e3f * r * r);
        }
        return b.build();
    }

    /**
     * A slope: rows of circles, the largest three times as large as the least, above a floor that leans to the right by 20 degrees;
     * gravity 1, restitution 0.
     */
    public static Scene slope(int columns, int rows, long seed) {
        Scene.Builder b = new Scene.Builder("slope", columns * rows).gravity(0.34202014f, -0.9396926f);
        Random random = new Random(seed);
        float pitch = 1f / columns;
        for (int i = 0; i < columns * rows; i++) {
            float r = pitch * (0.15f + 0.3f * random.nextFloat());
            b.circle(i, (i % columns + 0.5f) * pitch, (i / columns + 0.5f) * pitch, r, 1e3f * r * r);
        }
        return b.build();
    }

    /** A heap: circles in a narrow column fall on one place, all at once; masses by area, gravity (0, -1), restitution 0. */
    public static Scene heap(int n, long seed) {
        Scene.Builder b = new Scene.Builder("heap", n).gravity(0, -1);
        Random random = new Random(seed);
        for (int i = 0; i < n; i++) {
            float r = 0.005f + 0.0025f * random.nextFloat();
            float x = 0.38f + 0.0155f * (i % 16) + 0.0005f * random.nextFloat();
            b.circle(i, x, 0.008f + 0.0155f * (i / 16), r, 1e4f * r * r);
        }
        return b.build();
    }

    /**
     * A fence: side by side balls, r = 0.24 / side, that move 0.5 to 64 radii a step between two rows of static circles of a
     * twentieth of the radius, a radius apart, which cross in the middle. No gravity, restitution 1.
     *
     * @param side the balls in a row, an even number
     */
    public static Scene fence(int side, long seed) {
        float r = 0.24f / side;
        int posts = (int) (1 / r);
        Scene.Builder b = new Scene.Builder("fence", side * side + 2 * posts).restitution(1);
        Random random = new Random(seed);
        lattice(b, side, side * side, r, random);
        for (int i = 0; i < side * side; i++) {
            double speed = r / STEP * 0.5 * StrictMath.pow(128, random.nextDouble());
            double angle = random.nextDouble() * 2 * Math.PI;
            b.velocity(i, (float) (speed * StrictMath.cos(angle)), (float) (speed * StrictMath.sin(angle)));
        }
        for (int k = 0; k < posts; k++) {
            int c = side * side + 2 * k;
            b.circle(c, 0.5f, (k + 0.5f) * r, r / 20, 1);
            b.circle(c + 1, (k + 0.5f) * r, 0.5f, r / 20, 1);
            b.fixed[c] = true;
            b.fixed[c + 1] = true;
        }
        return b.build();
    }

    /**
     * Paddles: static circles, 2 to 5 times as wide as the side by side free balls around them, which fall; gravity (0, -1),
     * restitution 0.5. The paddles move up at 0 to 6 of the balls' radii a step.
     */
    public static Scene paddles(int paddles, int side, long seed) {
        float r = 0.3f / side;
        int balls = side * side;
        Scene.Builder b =
                new Scene.Builder("paddles", balls + paddles).gravity(0, -1).restitution(0.5f);
        Random random = new Random(seed);
        lattice(b, side, side * side, r, random);
        for (int k = 0; k < paddles; k++) {
            float radius = r * (2 + 3 * random.nextFloat());
            b.circle(balls + k, (k + 0.5f) / paddles, 0, radius, 1);
            b.velocity(balls + k, 0, 6 * r / STEP * random.nextFloat());
            b.fixed[balls + k] = true;
        }
        return b.build();
    }

    /**
     * A crowd: side by side balls that almost touch, and below them a row of static circles as large as they, from wall to wall, that
     * rises by 2 of their radii a step. No gravity, restitution 0.5.
     */
    public static Scene crowd(int side, long seed) {
        float r = 0.45f / side;
        int balls = side * side / 2;
        Scene.Builder b = new Scene.Builder("crowd", balls + side + 1).restitution(0.5f);
        lattice(b, side, balls, r, new Random(seed));
        for (int i = 0; i < balls; i++) {
            b.y[i] += 0.2f;
        }
        for (int k = 0; k <= side; k++) {
            b.circle(balls + k, (float) k / side, 0.1f, r, 1);
            b.velocity(balls + k, 0, 2 * r / STEP);
            b.fixed[balls + k] = true;
        }
        return b.build();
    }

    /** Side by side circles, so close that each has some seventy others within its speculative distance. No gravity, restitution 0.5. */
    public static Scene squeezed(int side, long seed) {
        float distance = 0.5f / side;
        Scene.Builder b = new Scene.Builder("squeezed", side * side).restitution(0.5f);
        Random random = new Random(seed);
        for (int i = 0; i < side * side; i++) {
            float x = 0.25f + (i % side + 0.4f + 0.2f * random.nextFloat()) * distance;
            float y = 0.25f + (i / side + 0.4f + 0.2f * random.nextFloat()) * distance;
            b.circle(i, x, y, 2.3f * distance, 1);
        }
        return b.build();
    }

    /**
     * Circles of many sizes in the unit arena, at a fill of 0.6: radii log-uniform over a ratio, masses by area, but of every fifth
     * circle one that is anything; every eleventh static, which moves now and then; every seventh so fast that it meets several circles
     * in a step; and thirty of the least radius at one point.
     */
    public static Scene blend(int n, float ratio, long seed) {
        Scene.Builder b = new Scene.Builder("blend of 1:" + (int) ratio, n).gravity(0, -1);
        Random random = new Random(seed);
        double area = 0;
        for (int i = 0; i < n; i++) {
            b.radius[i] = (float) StrictMath.pow(ratio, random.nextDouble() * (i < 30 ? 0 : 1));
            area += Math.PI * b.radius[i] * b.radius[i];
        }
        float scale = (float) Math.sqrt(0.6 / area);
        for (int i = 0; i < n; i++) {
            float r = scale * b.radius[i];
            float x = r + random.nextFloat() * (1 - 2 * r);
            float y = r + random.nextFloat() * (1 - 2 * r);
            float mass = i % 5 == 0 ? (float) StrictMath.pow(10, 8 * random.nextDouble() - 4) : r * r;
            b.circle(i, i < 30 ? 0.3f + 1e-3f * r * i : x, i < 30 ? 0.7f : y, r, mass);
            b.fixed[i] = i % 11 == 10;
            float speed = i % 7 == 0 ? 20 : b.fixed[i] && i % 2 == 0 ? 0 : 0.5f;
            b.velocity(i, speed * (random.nextFloat() - 0.5f), speed * (random.nextFloat() - 0.5f));
        }
        return b.restitution(0.5f).build();
    }

    /** A core: circles at random places within a radius about the middle, masses by area; gravity (0, -1), restitution 0.3. */
    public static Scene core(int n, float within, long seed) {
        Scene.Builder b = new Scene.Builder("core", n).gravity(0, -1).restitution(0.3f);
        Random random = new Random(seed);
        float pitch = within * (float) Math.sqrt(Math.PI / n);
        for (int i = 0; i < n; i++) {
            double far = within * Math.sqrt((i + 0.5) / n);
            double angle = i * 2.399963;
            float r = 0.4f * pitch * (0.7f + 0.3f * random.nextFloat());
            float x = 0.5f + (float) (far * StrictMath.cos(angle));
            float y = 0.5f + (float) (far * StrictMath.sin(angle));
            b.circle(i, x, y, r, 1e4f * r * r);
        }
        return b.build();
    }

    /** Puts balls into the unit arena, one into each of side by side squares, not quite in its middle. */
    private static void lattice(Scene.Builder b, int side, int balls, float r, Random random) {
        float room = 1f / side - 2 * r;
        for (int i = 0; i < balls; i++) {
            float x = (i % side + 0.5f) / side + 0.9f * room * (random.nextFloat() - 0.5f);
            float y = (i / side + 0.5f) / side + 0.9f * room * (random.nextFloat() - 0.5f);
            b.circle(i, x, y, r, 1 + 9 * random.nextFloat());
        }
    }
}
