package io.github.circles2d.scenes;

import java.util.Random;

/**
 * Scenes with published parameters, one factory each. Steps of 1/60 s throughout. Random numbers come from
 * {@link Random} with the seed given, so a scene is the same on every machine.
 */
public final class Scenes {
    /** The seed of every published figure: the year of the thesis. */
    public static final long SEED = 2014;

    /** The number of circles of the thesis's test program, and the one at which {@link #packed} is {@link #thesis}. */
    public static final int THESIS_SIZE = 1250;

    private Scenes() {}

    /**
     * The thesis's test program (S. Young, 2014): arena [0, 1] x [0, 1], x and y ~ U(0.1, 0.9), r ~ U(0.010, 0.015), m ~
     * U(1, 10), at rest, gravity (0, -0.01), restitution 0.5. The fill is 0.62 at n = 1,250 and grows with n: above about
     * 1,800 circles they cannot fit, which the thesis did not mind. For each circle x, y, r and m are drawn in this order.
     *
     * @param n the number of circles, at least 1; the thesis has 1,250, 2,500, 5,000, 10,000 and 15,000
     * @param seed the seed of the random numbers
     * @return the scene
     */
    public static Scene thesis(int n, long seed) {
        return crowd("thesis", n, seed, 1);
    }

    /**
     * {@link #thesis} with every radius multiplied by sqrt(1250 / n): the fill is 0.62 at every n. The series for
     * comparisons between engines; at n = 1,250 it is the thesis's scene to the bit.
     *
     * @param n the number of circles, at least 1; used up to 10,000,000
     * @param seed the seed of the random numbers
     * @return the scene
     */
    public static Scene packed(int n, long seed) {
        return crowd("packed", n, seed, Math.sqrt((double) THESIS_SIZE / n));
    }

    /**
     * {@link #packed} with gravity multiplied by sqrt(1250 / n), too: seen in radii, circles fall as fast at every n, and n alone
     * changes. In {@link #packed} gravity grows in radii as n does, until the lowest of a thousand layers give way. The circles
     * are those of packed to the bit.
     *
     * @param n the number of circles, at least 1; used up to 10,000,000
     * @param seed the seed of the random numbers
     * @return the scene
     */
    public static Scene packedSimilar(int n, long seed) {
        double scale = Math.sqrt((double) THESIS_SIZE / n);
        return crowd("packed-similar", n, seed, scale, (float) (-0.01f * scale));
    }

    private static Scene crowd(String name, int n, long seed, double scale) {
        return crowd(name, n, seed, scale, -0.01f);
    }

    private static Scene crowd(String name, int n, long seed, double scale, float gravity) {
        Scene.Builder b = new Scene.Builder(name, n).gravity(0, gravity).restitution(0.5f);
        Random random = new Random(seed);
        for (int i = 0; i < n; i++) {
            float x = 0.1f + random.nextFloat() * 0.8f;
            float y = 0.1f + random.nextFloat() * 0.8f;
            float r = (float) ((0.01f + random.nextFloat() * 0.005f) * scale);
            b.circle(i, x, y, r, 1 + random.nextFloat() * 9);
        }
        return b.build();
    }

    /**
     * A gas: radii and masses distributed as in {@link #packed} at a fill of 0.3, no gravity, restitution 1, speeds ~
     * U(0.05, 0.2) in random directions, uniform positions without overlaps in the unit arena. Kinetic energy must stay,
     * and so must momentum between the walls.
     *
     * @param n the number of circles, at least 1
     * @param seed the seed of the random numbers
     * @return the scene
     */
    public static Scene gas(int n, long seed) {
        double meanSquare = (0.01 * 0.01 + 0.01 * 0.015 + 0.015 * 0.015) / 3;
        double scale = Math.sqrt(0.3 / (n * Math.PI * meanSquare));
        Scene.Builder b = new Scene.Builder("gas", n).restitution(1);
        Random random = new Random(seed);
        for (int i = 0; i < n; i++) {
            b.radius[i] = (float) ((0.01f + random.nextFloat() * 0.005f) * scale);
            b.mass[i] = 1 + random.nextFloat() * 9;
            double speed = 0.05 + random.nextFloat() * 0.15;
            double angle = random.nextDouble() * 2 * Math.PI;
            // StrictMath: sin and cos of Math may differ by a bit between machines.
            b.velocity(i, (float) (speed * StrictMath.cos(angle)), (float) (speed * StrictMath.sin(angle)));
        }
        Scatter.withoutOverlaps(b.x, b.y, b.radius, random);
        return b.build();
    }

    /**
     * A pyramid of 15 circles, rows of 5 (lowest) to 1: r = 0.05, m = 4, row i from the top has circles j = 0..i at (0.35 +
     * 0.1 j - 0.05 i, 0.6 - 0.1 i); unit arena, gravity (0, -0.02), restitution 0.5. It starts above the floor, the
     * neighbours in a row touching, and falls.
     *
     * @return the scene
     */
    public static Scene pyramid() {
        Scene.Builder b = new Scene.Builder("pyramid", 15).gravity(0, -0.02f).restitution(0.5f);
        int c = 0;
        for (int i = 0; i < 5; i++) {
            for (int j = 0; j <= i; j++) {
                b.circle(c++, 0.35f + 0.1f * j - 0.05f * i, 0.6f - 0.1f * i, 0.05f, 4);
            }
        }
        return b.build();
    }

    /**
     * Box2D's barrel benchmark with circles: 26 columns of 150, r ~ U(0.25, 0.75), density 1, x = 1.15 i - 14.95 with -0.1
     * and +0.1 added in turn, y = 1.65 j + 100.575, gravity (0, -10), restitution 0. The container is 80 wide; Box2D's is
     * 100 high and open, here the walls go on up to y = 400 so that all start inside. Some neighbours overlap at the start.
     *
     * @param seed the seed of the radii
     * @return the scene
     */
    public static Scene barrel(long seed) {
        int columns = 26;
        int rows = 150;
        Scene.Builder b = new Scene.Builder("barrel", columns * rows)
                .arena(-40, 0, 40, 400)
                .gravity(0, -10);
        Random random = new Random(seed);
        float side = -0.1f;
        for (int i = 0; i < columns; i++) {
            for (int j = 0; j < rows; j++) {
                float r = 0.25f + random.nextFloat() * 0.5f;
                b.circle(i * rows + j, 1.15f * i - 14.95f + side, 1.65f * j + 100.575f, r, disc(r, 1));
                side = -side;
            }
        }
        return b.build();
    }

    /**
     * Rapier's balls2 benchmark: 50 columns of 250 balls, r = 1, density 1, x = 2.5 i - 62.5, y = 2 j + 1, gravity (0,
     * -9.81), restitution 0; the lowest row, j = 0, is fixed. Rapier's plane has no end; here balls that roll off the fixed
     * row land on a floor at y = 0, between walls at -250 and 250, under a ceiling at 600.
     *
     * @return the scene
     */
    public static Scene balls2() {
        int columns = 50;
        int rows = 250;
        Scene.Builder b = new Scene.Builder("balls2", columns * rows)
                .arena(-250, 0, 250, 600)
                .gravity(0, -9.81f);
        for (int i = 0; i < columns; i++) {
            for (int j = 0; j < rows; j++) {
                b.circle(i * rows + j, 2.5f * i - 62.5f, 2f * j + 1, 1, disc(1, 1));
                b.fixed[i * rows + j] = j == 0;
            }
        }
        return b.build();
    }

    /**
     * Rapier's confined benchmark: 25 x 25 balls, r = 0.5, density 1, at a pitch of 0.72 and so overlapping, in the middle
     * of a box of 21 x 20.5, no gravity, restitution 0. They push apart; with a fill of 1.14 they never all find room, so
     * what counts is that the overlap spreads evenly and comes to rest.
     *
     * @return the scene
     */
    public static Scene confined() {
        int side = 25;
        Scene.Builder b = new Scene.Builder("confined", side * side).arena(-10.5f, -10.25f, 10.5f, 10.25f);
        for (int i = 0; i < side; i++) {
            for (int j = 0; j < side; j++) {
                b.circle(i * side + j, 0.72f * (i - 12), 0.72f * (j - 12), 0.5f, disc(0.5f, 1));
            }
        }
        return b.build();
    }

    /**
     * Rapier's restitution scene: 22 balls, r = 0.5, density 1, with restitutions 0, 0.1, .. 1, dropped at rest on the floor
     * y = 0 (restitution 1) with centres at 10 (the first 11) and 20 (the last 11), gravity (0, -9.81). Each ball has a
     * column of its own, 2 wide, so that none meets another. A ball of restitution e that falls by h bounces by e^2 h where
     * its own restitution rules the contact with the wall.
     *
     * @return the scene
     */
    public static Scene restitution() {
        int kinds = 11;
        Scene.Builder b = new Scene.Builder("restitution", 2 * kinds)
                .arena(-22, 0, 22, 40)
                .gravity(0, -9.81f)
                .restitution(1);
        float[] restitutions = new float[2 * kinds];
        for (int i = 0; i < 2 * kinds; i++) {
            restitutions[i] = (i % kinds) / 10f;
            b.circle(i, 2f * i - 21, i < kinds ? 10 : 20, 0.5f, disc(0.5f, 1));
        }
        return b.restitutions(restitutions).build();
    }

    /**
     * Nexus's balls2 benchmark: 124 columns of 496 balls, r = 0.5, density 1, x = 1.2 i - 74.4 + 0.2 (j mod 2), y = 1.2 j +
     * 20.6, gravity (0, -9.81), restitution 0, floor at y = 0, walls at -150 and 150; a ceiling at y = 700 that none
     * reaches.
     *
     * @return the scene
     */
    public static Scene nexusBalls2() {
        int columns = 124;
        int rows = 496;
        Scene.Builder b = new Scene.Builder("nexus-balls2", columns * rows)
                .arena(-150, 0, 150, 700)
                .gravity(0, -9.81f);
        for (int i = 0; i < columns; i++) {
            for (int j = 0; j < rows; j++) {
                b.circle(i * rows + j, 1.2f * i - 74.4f + 0.2f * (j % 2), 1.2f * j + 20.6f, 0.5f, disc(0.5f, 1));
            }
        }
        return b.build();
    }

    /**
     * After Chipmunk's bouncy-circles benchmark: 500 circles, r = 5, m = 25, positions uniform in a disc of 130 and
     * velocities uniform in a disc of 50, no gravity, restitution 1, arena 640 x 480 about the origin. Many overlap at the
     * start.
     *
     * @param seed the seed of the random numbers
     * @return the scene
     */
    public static Scene bouncy(long seed) {
        Scene.Builder b =
                new Scene.Builder("bouncy", 500).arena(-320, -240, 320, 240).restitution(1);
        Random random = new Random(seed);
        float[] p = new float[2];
        for (int i = 0; i < 500; i++) {
            inUnitDisc(random, p);
            b.circle(i, 130 * p[0], 130 * p[1], 5, 25);
            inUnitDisc(random, p);
            b.velocity(i, 50 * p[0], 50 * p[1]);
        }
        return b.build();
    }

    /**
     * Chipmunk's no-collide benchmark: 33 x 25 static circles, r = 4.5, at a pitch of 20, and 28 movers (the last 28
     * circles; r = 4.5, m = 7) that thread between them at speed 100, 12 along x and 16 along y. No gravity, restitution 1.
     * Nothing may ever touch but movers the walls, which stand at +/-334.5 and +/-254.5: with exact reflection two movers
     * never come nearer than 14.1, before the walls and after.
     *
     * @return the scene
     */
    public static Scene noCollide() {
        Scene.Builder b = new Scene.Builder("no-collide", 33 * 25 + 28)
                .arena(-334.5f, -254.5f, 334.5f, 254.5f)
                .restitution(1);
        int c = 0;
        for (int i = 0; i < 33; i++) {
            for (int j = 0; j < 25; j++) {
                b.fixed[c] = true;
                b.circle(c++, 20f * i - 320, 20f * j - 240, 4.5f, 7);
            }
        }
        for (int k = 0; k < 12; k++) {
            b.velocity(c, 100, 0);
            b.circle(c++, -320, 40f * k - 230, 4.5f, 7);
        }
        for (int k = 0; k < 16; k++) {
            b.velocity(c, 0, 100);
            b.circle(c++, 40f * k - 290, -240, 4.5f, 7);
        }
        return b.build();
    }

    /**
     * After dyn4j's billiards sample: a table of 1.83 x 1.12 about the origin, 15 balls racked with their apex at x = 0.4
     * and gaps of 0.001, and a cue ball (the last) at (-0.6, 0) that moves towards them; r = 0.028575, m = 0.5592,
     * restitution 0.9, no gravity. At 10 the cue ball crosses three diameters a step: it must not pass through the rack.
     *
     * @param cueSpeed the speed of the cue ball, lengths a second, at least 0
     * @return the scene
     */
    public static Scene billiards(float cueSpeed) {
        if (!(cueSpeed >= 0 && cueSpeed < Float.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("cue speed must be finite and not negative: " + cueSpeed);
        }
        float r = 0.028575f;
        float mass = disc(r, 217.97925f);
        Scene.Builder b = new Scene.Builder("billiards", 16)
                .arena(-0.915f, -0.56f, 0.915f, 0.56f)
                .restitution(0.9f);
        float pitch = 2 * r + 0.001f;
        int c = 0;
        for (int i = 0; i < 5; i++) {
            for (int j = 0; j <= i; j++) {
                b.circle(c++, 0.4f + 0.8660254f * pitch * i, pitch * (j - 0.5f * i), r, mass);
            }
        }
        b.circle(c, -0.6f, 0, r, mass);
        b.velocity(c, cueSpeed, 0);
        return b.build();
    }

    /**
     * Radii over two decades in one arena: log-uniform from 0.0005 to 0.05, density 1, so masses over four; uniform
     * positions, gravity (0, -0.01), restitution 0.5. The arena is a square with its lower left corner at the origin and the
     * side that makes the fill 0.5. A broad phase must not fall off a cliff here.
     *
     * @param n the number of circles, at least 1
     * @param seed the seed of the random numbers
     * @return the scene
     */
    public static Scene mixed(int n, long seed) {
        Scene.Builder b = new Scene.Builder("mixed", n).gravity(0, -0.01f).restitution(0.5f);
        Random random = new Random(seed);
        double area = 0;
        for (int i = 0; i < n; i++) {
            float r = (float) (0.0005 * StrictMath.pow(100, random.nextDouble()));
            b.radius[i] = r;
            b.mass[i] = disc(r, 1);
            area += Math.PI * r * r;
        }
        float side = (float) Math.sqrt(area / 0.5);
        for (int i = 0; i < n; i++) {
            float r = b.radius[i];
            b.x[i] = r + random.nextFloat() * (side - 2 * r);
            b.y[i] = r + random.nextFloat() * (side - 2 * r);
        }
        return b.arena(0, 0, side, side).build();
    }

    /**
     * Unlike radii at the fill of {@link #packed}: log-uniform from R / ratio to R, where R makes the fill 0.62; masses 10^5 r^2,
     * which are those of packed for its radii; x and y ~ U(0.1, 0.9), or U(R, 1 - R) where R is greater than 0.1; at rest, gravity
     * (0, -0.01), restitution 0.5, unit arena. All radii are drawn first, then x and y circle by circle. Many small circles start
     * inside large ones.
     *
     * @param n the number of circles, at least 1
     * @param ratio the greatest radius over the least, at least 1; the published series have 10 and 100
     * @param seed the seed of the random numbers
     * @return the scene, named {@code mixed-} and the ratio
     */
    public static Scene mixed(int n, int ratio, long seed) {
        if (ratio < 1) {
            throw new IllegalArgumentException("the ratio of the radii must be at least 1: " + ratio);
        }
        Scene.Builder b =
                new Scene.Builder("mixed-" + ratio, n).gravity(0, -0.01f).restitution(0.5f);
        Random random = new Random(seed);
        double[] radii = new double[n];
        double squares = 0;
        double greatest = 0;
        for (int i = 0; i < n; i++) {
            radii[i] = StrictMath.pow(ratio, random.nextDouble());
            squares += radii[i] * radii[i];
            greatest = Math.max(greatest, radii[i]);
        }
        double scale = Math.sqrt(0.62 / (Math.PI * squares));
        float margin = (float) Math.max(0.1, 1.0001 * scale * greatest);
        for (int i = 0; i < n; i++) {
            double r = scale * radii[i];
            float x = margin + random.nextFloat() * (1 - 2 * margin);
            float y = margin + random.nextFloat() * (1 - 2 * margin);
            b.circle(i, x, y, (float) r, (float) (1e5 * r * r));
        }
        return b.build();
    }

    /**
     * A boulder on grains: circle 0 has a radius of 1,000 mean radii of the others, which lie below it in a bed of rows, r ~
     * U(0.8, 1.2) of their mean, masses 10^5 r^2. Bed and boulder are 0.95 high together. At rest, gravity (0, -0.01), restitution
     * 0.5, unit arena. A broad phase that looks around every circle as far as around the greatest looks at every pair.
     *
     * @param n the number of circles, the boulder among them, at least 2; the published series has 100,000
     * @param seed the seed of the random numbers
     * @return the scene
     */
    public static Scene boulder(int n, long seed) {
        if (n < 2) {
            throw new IllegalArgumentException("a boulder on grains needs at least 2 circles, not " + n);
        }
        double ratio = 1000;
        double greatest = 1.2;
        // The bed is bed * R^2 high, where R is the boulder's radius; 1.01 leaves the grains a little room.
        double pitch = 2.02 * greatest / ratio;
        double bed = (n - 1) * pitch * pitch;
        double boulder = (Math.sqrt(1 + 0.95 * bed) - 1) / bed;
        double wide = pitch * boulder;
        int columns = (int) (1 / wide);
        Scene.Builder b = new Scene.Builder("boulder", n).gravity(0, -0.01f).restitution(0.5f);
        Random random = new Random(seed);
        for (int i = 1; i < n; i++) {
            int row = (i - 1) / columns;
            double r = (0.8 + 0.4 * random.nextDouble()) * boulder / ratio;
            double x = ((i - 1) % columns + 0.5) * wide;
            b.circle(i, (float) x, (float) ((row + 0.5) * wide), (float) r, (float) (1e5 * r * r));
        }
        int rows = (n - 2) / columns + 1;
        b.circle(0, 0.5f, (float) (rows * wide + boulder), (float) boulder, (float) (1e5 * boulder * boulder));
        return b.build();
    }

    /**
     * {@link #packed} with every centre at (0.5, 0.5). Slow is allowed, wrong is not.
     *
     * @param n the number of circles, at least 1
     * @param seed the seed of radii and masses
     * @return the scene
     */
    public static Scene onePoint(int n, long seed) {
        return squeezed("one-point", n, seed, 0);
    }

    /**
     * {@link #packed} with all centres inside a square as wide as the smallest radius, so that any grid has them in one
     * cell or in neighbours. Slow is allowed, wrong is not.
     *
     * @param n the number of circles, at least 1
     * @param seed the seed of the random numbers
     * @return the scene
     */
    public static Scene oneCell(int n, long seed) {
        return squeezed("one-cell", n, seed, 0.01f * (float) Math.sqrt((double) THESIS_SIZE / n));
    }

    private static Scene squeezed(String name, int n, long seed, float width) {
        Scene packed = packed(n, seed);
        Scene.Builder b = new Scene.Builder(name, n)
                .gravity(packed.gravityX(), packed.gravityY())
                .restitution(packed.restitution());
        for (int i = 0; i < n; i++) {
            // x and y of packed run from 0.1 to 0.9
            float u = (packed.x(i) - 0.5f) / 0.8f;
            float v = (packed.y(i) - 0.5f) / 0.8f;
            b.circle(i, 0.5f + width * u, 0.5f + width * v, packed.radius(i), packed.mass(i));
        }
        return b.build();
    }

    private static float disc(float radius, float density) {
        return (float) (density * Math.PI * radius * radius);
    }

    private static void inUnitDisc(Random random, float[] p) {
        do {
            p[0] = 2 * random.nextFloat() - 1;
            p[1] = 2 * random.nextFloat() - 1;
        } while (p[0] * p[0] + p[1] * p[1] >= 1);
    }
}
