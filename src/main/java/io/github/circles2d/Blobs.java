package io.github.circles2d;

import io.github.circles2d.world.changes.Net;
import io.github.circles2d.world.model.Limits;

/**
 * Makes soft bodies: circles that springs hold together.
 *
 * <pre>{@code
 * JointedCircles ball = Blobs.ring(world, 50, 40, 2, 24, 0.24f, 1, 10, 0.7f);
 * JointedCircles jelly = Blobs.lattice(world, 20, 40, 8, 6, 0.5f, 0.25f, 0.2f, 15, 0.5f);
 * JointedCircles flag = Blobs.cloth(world, 70, 40, 20, 12, 0.4f, 0.15f, 0.05f, 20, 0.5f);
 * world.joints().add(flag.circles()[20 * 11], 66.2f, 42.2f, Joint.pin()); // its upper left corner
 * }</pre>
 *
 * <p><b>Springs:</b> a frequency in hertz says how stiff they are, whatever the masses: 2 is jelly, 10 a ball, 30 almost rigid. A damping ratio of 0 rings on, of
 * 1 does not overshoot. Circles that a spring joins do not collide with each other. Own joints between any of the circles may be added, and joints of a
 * blob may be changed or removed, by their handles.
 *
 * <p>The calls add all or nothing.
 */
public final class Blobs {
    /** Greatest number of circles of a blob. */
    private static final int MOST = 100_000;

    /** Springs across a ring are softer than those around it: by this a ring keeps its area, and yields. */
    private static final float ACROSS = 0.4f;

    private static final double ROW = 0.8660254037844386; // half the root of 3

    /** How far the threads of a cloth give. */
    private static final float GIVE = 1.05f;

    private Blobs() {}

    /**
     * Adds a ring, a soft ball: each circle is joined to its neighbours, to their neighbours, and to the one on the other side of the ring. The springs
     * across have two fifths of the frequency.
     *
     * @param world the world
     * @param x x of the centre
     * @param y y of the centre
     * @param radius the radius of the ring, to the centres of its circles, greater than 0
     * @param count the number of circles, 3 to 100,000
     * @param circleRadius the radius of each
     * @param mass the mass of each
     * @param hertz the frequency of the springs, 0 to 10,000
     * @param dampingRatio their damping ratio, 0 to 1,000
     * @return the circles anticlockwise, from the one at the right on; the springs to neighbours, to their neighbours, and across
     * @throws IllegalArgumentException if a value is out of range
     */
    public static JointedCircles ring(
            World world,
            float x,
            float y,
            float radius,
            int count,
            float circleRadius,
            float mass,
            float hertz,
            float dampingRatio) {
        return ring(world, x, y, radius, count, circleRadius, mass, hertz, dampingRatio, 0);
    }

    /**
     * Adds a ring, a soft ball, of circles of a {@link Kind}.
     *
     * @param world the world
     * @param x x of the centre
     * @param y y of the centre
     * @param radius the radius of the ring, to the centres of its circles, greater than 0
     * @param count the number of circles, 3 to 100,000
     * @param circleRadius the radius of each
     * @param mass the mass of each
     * @param hertz the frequency of the springs, 0 to 10,000
     * @param dampingRatio their damping ratio, 0 to 1,000
     * @param kind the number of the kind of each circle, 0 to 255
     * @return as {@link #ring(World, float, float, float, int, float, float, float, float)}
     * @throws IllegalArgumentException if a value is out of range, or there is no such kind
     */
    public static JointedCircles ring(
            World world,
            float x,
            float y,
            float radius,
            int count,
            float circleRadius,
            float mass,
            float hertz,
            float dampingRatio,
            int kind) {
        Limits.notNull("world", world);
        positive("radius", radius);
        Limits.within("the number of circles", count, 3, MOST);
        Joint around = Joint.spring(hertz, dampingRatio);
        Joint across = Joint.spring(ACROSS * hertz, dampingRatio);
        Builder builder = new Builder(count, circleRadius, mass, kind);
        for (int k = 0; k < count; k++) {
            double angle = 2 * Math.PI * k / count;
            builder.circle(x + radius * StrictMath.cos(angle), y + radius * StrictMath.sin(angle));
        }
        // in rings of few circles the second neighbour, or the other side, is one that is joined already
        int second = count > 4 ? count : 0;
        int opposite = count < 4 || count == 5 ? 0 : count % 2 == 0 ? count / 2 : count;
        int[] joints = new int[2 * (count + second + opposite)];
        int at = 0;
        for (int k = 0; k < count; k++) {
            at = pair(joints, at, k, (k + 1) % count);
        }
        for (int k = 0; k < second; k++) {
            at = pair(joints, at, k, (k + 2) % count);
        }
        for (int k = 0; k < opposite; k++) {
            at = pair(joints, at, k, (k + count / 2) % count);
        }
        return builder.add(world, joints, count + second, around, across);
    }

    private static int pair(int[] joints, int at, int a, int b) {
        joints[at] = a;
        joints[at + 1] = b;
        return at + 2;
    }

    /**
     * Adds a hexagonal lattice, a block of jelly: rows that are offset by half a spacing by turns, and each circle is joined to up to six around it.
     *
     * @param world the world
     * @param x x of the middle
     * @param y y of the middle
     * @param columns the circles of a row, at least 2
     * @param rows the rows, at least 2; at most 100,000 circles together
     * @param spacing how far circles are apart, greater than 0
     * @param circleRadius the radius of each
     * @param mass the mass of each
     * @param hertz the frequency of the springs, 0 to 10,000
     * @param dampingRatio their damping ratio, 0 to 1,000
     * @return the circles, row by row from the lowest on, each from left to right; the springs along the rows, and then those between them
     * @throws IllegalArgumentException if a value is out of range
     */
    public static JointedCircles lattice(
            World world,
            float x,
            float y,
            int columns,
            int rows,
            float spacing,
            float circleRadius,
            float mass,
            float hertz,
            float dampingRatio) {
        return lattice(world, x, y, columns, rows, spacing, circleRadius, mass, hertz, dampingRatio, 0);
    }

    /**
     * Adds a hexagonal lattice, a block of jelly, of circles of a {@link Kind}.
     *
     * @param world the world
     * @param x x of the middle
     * @param y y of the middle
     * @param columns the circles of a row, at least 2
     * @param rows the rows, at least 2; at most 100,000 circles together
     * @param spacing how far circles are apart, greater than 0
     * @param circleRadius the radius of each
     * @param mass the mass of each
     * @param hertz the frequency of the springs, 0 to 10,000
     * @param dampingRatio their damping ratio, 0 to 1,000
     * @param kind the number of the kind of each circle, 0 to 255
     * @return as {@link #lattice(World, float, float, int, int, float, float, float, float, float)}
     * @throws IllegalArgumentException if a value is out of range, or there is no such kind
     */
    public static JointedCircles lattice(
            World world,
            float x,
            float y,
            int columns,
            int rows,
            float spacing,
            float circleRadius,
            float mass,
            float hertz,
            float dampingRatio,
            int kind) {
        Limits.notNull("world", world);
        Joint spring = Joint.spring(hertz, dampingRatio);
        Builder builder = grid(columns, rows, spacing, circleRadius, mass, kind);
        double left = x - 0.5 * spacing * (columns - 0.5);
        double low = y - 0.5 * spacing * ROW * (rows - 1);
        for (int k = 0; k < columns * rows; k++) {
            int row = k / columns;
            builder.circle(left + spacing * (k % columns + 0.5 * (row % 2)), low + spacing * ROW * row);
        }
        int along = (columns - 1) * rows;
        int between = (2 * columns - 1) * (rows - 1);
        int[] joints = new int[2 * (along + between)];
        int at = 0;
        for (int k = 0; k < columns * rows; k++) {
            at = k % columns + 1 < columns ? pair(joints, at, k, k + 1) : at;
        }
        for (int k = 0; k < columns * (rows - 1); k++) {
            int up = k + columns;
            int aside = k / columns % 2 == 0 ? -1 : 1;
            boolean has = aside < 0 ? k % columns > 0 : k % columns + 1 < columns;
            at = pair(joints, at, k, up);
            at = has ? pair(joints, at, k, up + aside) : at;
        }
        return builder.add(world, joints, along + between, spring, spring);
    }

    /**
     * Adds a cloth: a grid of threads along and across, that give by a twentieth at most, and springs in both diagonals of each mesh that keep it in shape.
     *
     * @param world the world
     * @param x x of the middle
     * @param y y of the middle
     * @param columns the circles of a row, at least 2
     * @param rows the rows, at least 2; at most 100,000 circles together
     * @param spacing how far circles are apart, greater than 0
     * @param circleRadius the radius of each
     * @param mass the mass of each
     * @param hertz the frequency of the threads; those of the diagonals have half of it; 0 to 10,000
     * @param dampingRatio their damping ratio, 0 to 1,000
     * @return the circles, row by row from the lowest on, each from left to right; the threads along the rows, those between them, and the diagonals
     * @throws IllegalArgumentException if a value is out of range
     */
    public static JointedCircles cloth(
            World world,
            float x,
            float y,
            int columns,
            int rows,
            float spacing,
            float circleRadius,
            float mass,
            float hertz,
            float dampingRatio) {
        return cloth(world, x, y, columns, rows, spacing, circleRadius, mass, hertz, dampingRatio, 0);
    }

    /**
     * Adds a cloth of circles of a {@link Kind}.
     *
     * @param world the world
     * @param x x of the middle
     * @param y y of the middle
     * @param columns the circles of a row, at least 2
     * @param rows the rows, at least 2; at most 100,000 circles together
     * @param spacing how far circles are apart, greater than 0
     * @param circleRadius the radius of each
     * @param mass the mass of each
     * @param hertz the frequency of the threads; those of the diagonals have half of it; 0 to 10,000
     * @param dampingRatio their damping ratio, 0 to 1,000
     * @param kind the number of the kind of each circle, 0 to 255
     * @return as {@link #cloth(World, float, float, int, int, float, float, float, float, float)}
     * @throws IllegalArgumentException if a value is out of range, or there is no such kind
     */
    public static JointedCircles cloth(
            World world,
            float x,
            float y,
            int columns,
            int rows,
            float spacing,
            float circleRadius,
            float mass,
            float hertz,
            float dampingRatio,
            int kind) {
        Limits.notNull("world", world);
        Builder builder = grid(columns, rows, spacing, circleRadius, mass, kind);
        Joint thread = Joint.spring(hertz, dampingRatio).withLength(spacing).withLimits(0, GIVE * spacing);
        Joint diagonal = Joint.spring(0.5f * hertz, dampingRatio);
        double left = x - 0.5 * spacing * (columns - 1);
        double low = y - 0.5 * spacing * (rows - 1);
        for (int k = 0; k < columns * rows; k++) {
            builder.circle(left + spacing * (double) (k % columns), low + spacing * (double) (k / columns));
        }
        int threads = (columns - 1) * rows + columns * (rows - 1);
        int[] joints = new int[2 * (threads + 2 * (columns - 1) * (rows - 1))];
        int at = 0;
        for (int k = 0; k < columns * rows; k++) {
            at = k % columns + 1 < columns ? pair(joints, at, k, k + 1) : at;
        }
        for (int k = 0; k < columns * (rows - 1); k++) {
            at = pair(joints, at, k, k + columns);
        }
        for (int k = 0; k < columns * (rows - 1); k++) {
            if (k % columns + 1 < columns) {
                at = pair(joints, at, k, k + columns + 1);
                at = pair(joints, at, k + 1, k + columns);
            }
        }
        return builder.add(world, joints, threads, thread, diagonal);
    }

    private static Builder grid(int columns, int rows, float spacing, float circleRadius, float mass, int kind) {
        Limits.within("columns", columns, 2, MOST / 2);
        Limits.within("rows", rows, 2, MOST / 2);
        if ((long) columns * rows > MOST) {
            throw new IllegalArgumentException("there are " + (long) columns * rows + " circles in " + columns
                    + " columns and " + rows + " rows, but must be at most " + MOST);
        }
        positive("spacing", spacing);
        return new Builder(columns * rows, circleRadius, mass, kind);
    }

    private static void positive(String what, float value) {
        if (!(value > 0 && value <= Limits.COORDINATE)) {
            throw new IllegalArgumentException(
                    what + " is " + value + ", but must be greater than 0, up to " + Limits.COORDINATE);
        }
    }

    /** Collects circles, and adds them and their joints. */
    private static final class Builder {
        private final float[] circles;
        private final float radius;
        private final float mass;
        private final int kind;
        private int count;

        Builder(int most, float radius, float mass, int kind) {
            circles = new float[4 * most];
            this.radius = radius;
            this.mass = mass;
            this.kind = kind;
        }

        void circle(double x, double y) {
            circles[4 * count] = (float) x;
            circles[4 * count + 1] = (float) y;
            circles[4 * count + 2] = radius;
            circles[4 * count + 3] = mass;
            count++;
        }

        /** Pairs of numbers of circles; the first ones get a joint, and the others another. */
        JointedCircles add(World world, int[] pairs, int first, Joint joint, Joint others) {
            Net net = JointedCircles.net(circles, kind, pairs.length / 2);
            for (int k = 0; k < pairs.length / 2; k++) {
                net.join((k < first ? joint : others).form(), pairs[2 * k], pairs[2 * k + 1]);
            }
            return JointedCircles.add(world, net);
        }
    }
}
