package io.github.circles2d.world.jvm;

import io.github.circles2d.world.model.Tuning;
import java.util.Random;

/** Circles in an arena that has many more cells than there are circles; the arena is the unit square. */
public final class SparseArena {
    /** Takes a circle. */
    public interface Taker {
        void add(float x, float y, float radius, float mass, float restitution, float vx, float vy);
    }

    private SparseArena() {}

    /** Radius of a circle in whose grid the arena has so many columns. */
    private static float radius(int columns) {
        return (1f / columns - 0x1p-20f) / (2 * (1 + Tuning.MARGIN + Tuning.CAP));
    }

    private static float inside(float coordinate) {
        return Math.max(0, Math.min(1, coordinate));
    }

    /** A square lattice of side x side circles. Their centres are some cells apart, in rows and in columns. */
    public static void lattice(int side, int spacing, Taker to) {
        float radius = radius(side * spacing);
        for (int i = 0; i < side * side; i++) {
            to.add((i % side + 0.25f) / side, (i / side + 0.25f) / side, radius, 1, 1, radius, radius);
        }
    }

    /** How many times the radius of {@link #line} and others the arena is wide. */
    public static final int RADII = 200_000;

    /** The radius of circles of a line, of a ring and of a square: the arena is wide enough for thousands of them side by side. */
    public static final float RADIUS = 1f / RADII;

    /**
     * A straight line of circles through the middle of the arena.
     *
     * @param degrees its angle
     * @param gap distance of two centres, in diameters
     */
    public static void line(int circles, double degrees, double gap, float mass, Taker to) {
        double x = Math.cos(Math.toRadians(degrees));
        double y = Math.sin(Math.toRadians(degrees));
        for (int i = 0; i < circles; i++) {
            double along = 2 * RADIUS * gap * (i - circles / 2);
            to.add((float) (0.5 + along * x), (float) (0.5 + along * y), RADIUS, mass, 0, 0, 0);
        }
    }

    /** A ring of circles, each of which touches two. */
    public static void ring(int circles, float mass, Taker to) {
        double radius = RADIUS / Math.sin(Math.PI / circles);
        for (int i = 0; i < circles; i++) {
            double angle = 2 * Math.PI * i / circles;
            to.add(
                    (float) (0.5 + radius * Math.cos(angle)),
                    (float) (0.5 + radius * Math.sin(angle)),
                    RADIUS,
                    mass,
                    0,
                    0,
                    0);
        }
    }

    /** A square of side x side circles, each of which touches four. */
    public static void square(int side, float mass, Taker to) {
        for (int i = 0; i < side * side; i++) {
            float x = 0.5f + 2 * RADIUS * (i % side - side / 2);
            to.add(x, 0.5f + 2 * RADIUS * (i / side - side / 2), RADIUS, mass, 0, 0, 0);
        }
    }

    /** How many circles {@link #corners} adds: the torus of so many has 26 columns and 58 rows. */
    public static final int IN_CORNERS = 2000;

    /**
     * Circles that move slowly, around the corners of 20 x 20 turns of the torus: all are in the same few cells of it.
     *
     * @param isOpen whether the edges are
     * @param large radius of one in forty; another one in forty is static
     */
    public static void corners(boolean isOpen, float large, Random random, Taker to) {
        float cell = 2 * RADIUS * (1 + Tuning.MARGIN + Tuning.CAP) + (isOpen ? 0 : 0x1p-20f);
        for (int i = 0; i < IN_CORNERS; i++) {
            int turn = i / 5;
            float x = (20 + turn % 20) * 26 * cell + 4 * cell * (random.nextFloat() - 0.5f);
            float y = (20 + turn / 20) * 58 * cell + 2 * cell * (random.nextFloat() - 0.5f);
            float vx = 10 * RADIUS * (random.nextFloat() - 0.5f);
            float vy = 10 * RADIUS * (random.nextFloat() - 0.5f);
            float mass = i % 40 == 20 ? Float.POSITIVE_INFINITY : 1;
            to.add(x, y, i % 40 == 0 ? large : 0.99f * RADIUS, mass, 0.5f, vx, vy);
        }
    }

    /**
     * Groups of four circles each, near enough to each other for contacts, at random places; one circle in eight goes a few
     * radii in a step of 1/60.
     */
    public static void groups(int groups, int columns, Random random, Taker to) {
        float radius = radius(columns);
        for (int group = 0; group < groups; group++) {
            float x = random.nextFloat();
            float y = random.nextFloat();
            for (int i = 0; i < 4; i++) {
                float speed = (random.nextInt(8) == 0 ? 500 : 5) * radius;
                to.add(
                        inside(x + 4 * radius * (random.nextFloat() - 0.5f)),
                        inside(y + 4 * radius * (random.nextFloat() - 0.5f)),
                        radius * (0.6f + 0.4f * random.nextFloat()),
                        1,
                        0.5f,
                        speed * (random.nextFloat() - 0.5f),
                        speed * (random.nextFloat() - 0.5f));
            }
        }
    }
}
