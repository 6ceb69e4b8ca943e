package io.github.circles2d.world.model;

/**
 * The values that a world takes. Within these limits no sequence of calls can make a state that is not finite. Every check of
 * a number throws an {@link IllegalArgumentException} that names the value and what is allowed.
 */
public final class Limits {
    /** Greatest magnitude of a coordinate. */
    public static final float COORDINATE = 1e9f;

    /** Least width and height of the arena. */
    public static final float LEAST_EXTENT = 1e-6f;

    /** A quarter of the least width and height of the arena, and the least radius, in units of the arena's greatest coordinate or extent. */
    public static final float LEAST_RADIUS_SHARE = 0x1p-20f;

    /** The least period of an axis that wraps, in radii of the largest circle: it has at least four cells of that circle. */
    public static final float LEAST_PERIOD = 11f;

    /** The least period of an axis that wraps, in units of the arena's greatest coordinate or extent. */
    private static final float LEAST_PERIOD_SHARE = 64 * LEAST_RADIUS_SHARE;

    /** Least mass. */
    public static final float LEAST_MASS = 1e-9f;

    /** Greatest mass of a circle that is not static. */
    public static final float GREATEST_MASS = 1e9f;

    /** Greatest magnitude of a component of a velocity or of gravity. */
    public static final float SPEED = Tuning.GREATEST_SPEED;

    /** Greatest magnitude of what gravity is multiplied by for a kind. */
    public static final float GRAVITY_SCALE = 1000f;

    /** Greatest damping of velocities, 1/s. */
    public static final float VELOCITY_DAMPING = 1e6f;

    /** Greatest magnitude of a component of a force. */
    public static final float FORCE = 1e18f;

    /** Most steps in which a circle grows to a radius. */
    public static final int GROWTH_STEPS = 100_000;

    /** Greatest magnitude of a component of an impulse. */
    public static final float IMPULSE = 1e18f;

    /** Greatest radius, and greatest falloff, of an explosion: more than any two circles are apart. */
    public static final float EXPLOSION = 1e10f;

    /** Greatest impulse that a snapshot may hold: more than any step leaves, and far from overflow in the next one. */
    public static final float CACHED_IMPULSE = 1e24f;

    /** Greatest impulse speed of a wall that a snapshot may hold; steps leave less than 1e13. */
    public static final float WALL_IMPULSE = 1e15f;

    /** Shortest step, seconds. */
    public static final float LEAST_STEP = 1e-6f;

    /** Longest step, seconds. */
    public static final float GREATEST_STEP = 1f;

    /** Least frequency of contacts, hertz. */
    public static final float LEAST_FREQUENCY = 1f;

    /** Greatest frequency of contacts, hertz. */
    public static final float GREATEST_FREQUENCY = 10_000f;

    /** Greatest damping ratio of contacts. */
    public static final float DAMPING = 1_000f;

    /** Greatest push-out speed of overlaps that are not deep, mean radii a second. */
    public static final float PUSH_OUT_SPEED = 100f;

    /** Greatest number of sub-steps. */
    public static final int SUB_STEPS = 16;

    /** Greatest number of threads. */
    public static final int THREADS = 256;

    /** Greatest number of circles: arrays of four floats a circle must fit into a Java array. */
    public static final int CIRCLES = 100_000_000;

    private Limits() {}

    /**
     * Checks that an argument is there.
     *
     * @param what the public parameter
     * @param value the argument
     * @return the argument
     * @throws NullPointerException if it is null
     */
    public static <T> T notNull(String what, T value) {
        if (value == null) {
            throw new NullPointerException(what + " must not be null");
        }
        return value;
    }

    /**
     * Checks that a number lies in a range.
     *
     * @param what its name
     * @param value the number
     * @param least least allowed
     * @param greatest greatest allowed
     * @return the number
     */
    public static float within(String what, float value, float least, float greatest) {
        if (!(value >= least && value <= greatest)) {
            throw new IllegalArgumentException(
                    what + " is " + value + ", but must be from " + least + " to " + greatest);
        }
        return value;
    }

    /**
     * Checks that a number lies in a range.
     *
     * @param what its name
     * @param value the number
     * @param least least allowed
     * @param greatest greatest allowed
     * @return the number
     */
    public static int within(String what, int value, int least, int greatest) {
        if (value < least || value > greatest) {
            throw new IllegalArgumentException(
                    what + " is " + value + ", but must be from " + least + " to " + greatest);
        }
        return value;
    }

    /**
     * Checks bounds.
     *
     * @param minX left wall
     * @param minY lower wall
     * @param maxX right wall
     * @param maxY upper wall
     * @return the bounds
     */
    public static Bounds bounds(float minX, float minY, float maxX, float maxY) {
        within("minX", minX, -COORDINATE, COORDINATE);
        within("minY", minY, -COORDINATE, COORDINATE);
        within("maxX", maxX, -COORDINATE, COORDINATE);
        within("maxY", maxY, -COORDINATE, COORDINATE);
        Bounds bounds = new Bounds(minX, minY, maxX, maxY);
        float least = Math.max(LEAST_EXTENT, 4 * LEAST_RADIUS_SHARE * bounds.magnitude());
        if (!(maxX - minX >= least) || !(maxY - minY >= least)) {
            throw new IllegalArgumentException("the bounds are " + (maxX - minX) + " wide and " + (maxY - minY)
                    + " high, but must be at least " + least + " for coordinates of this size");
        }
        return bounds;
    }

    /**
     * Checks edges.
     *
     * @param bounds the arena, whose rectangle has been checked
     * @return the bounds
     */
    public static Bounds edges(Bounds bounds) {
        float least = LEAST_PERIOD_SHARE * bounds.magnitude();
        if (bounds.periodX() < least || bounds.periodY() < least) {
            throw new IllegalArgumentException("the bounds are " + (bounds.maxX() - bounds.minX()) + " wide and "
                    + (bounds.maxY() - bounds.minY()) + " high, but an axis that wraps must have at least " + least
                    + " for coordinates of this size");
        }
        return bounds;
    }

    /**
     * Checks bounds that take the place of others: where an axis wraps, its edges stay where they are.
     *
     * @param now the bounds so far
     * @param next the others, with the same edges
     * @return the others
     */
    public static Bounds moved(Bounds now, Bounds next) {
        boolean moves = now.edgeX() == AxisEdge.WRAP && (now.minX() != next.minX() || now.maxX() != next.maxX())
                || now.edgeY() == AxisEdge.WRAP && (now.minY() != next.minY() || now.maxY() != next.maxY());
        if (moves) {
            throw new IllegalArgumentException("the bounds would be from " + next.minX() + ", " + next.minY() + " to "
                    + next.maxX() + ", " + next.maxY() + ", but an axis that wraps keeps its own: from " + now.minX()
                    + ", " + now.minY() + " to " + now.maxX() + ", " + now.maxY());
        }
        return edges(next);
    }

    /**
     * Checks a radius.
     *
     * @param radius the radius
     * @param bounds the arena
     * @return the radius
     */
    public static float radius(float radius, Bounds bounds) {
        return within("radius", radius, bounds.leastRadius(), bounds.greatestRadius());
    }

    /** Checks to which radius a circle is to grow or shrink, and in how many steps. */
    public static void growth(float radius, int steps, Bounds bounds) {
        radius(radius, bounds);
        within("the number of steps", steps, 1, GROWTH_STEPS);
    }

    /**
     * Checks a mass.
     *
     * @param mass the mass; positive infinity for a static circle
     * @return the mass
     */
    public static float mass(float mass) {
        if (mass != Float.POSITIVE_INFINITY && !(mass >= LEAST_MASS && mass <= GREATEST_MASS)) {
            throw new IllegalArgumentException("mass is " + mass + ", but must be from " + LEAST_MASS + " to "
                    + GREATEST_MASS + ", or positive infinity for a static circle");
        }
        return mass;
    }

    /**
     * Checks the centre of a circle.
     *
     * @param x x
     * @param y y
     * @param bounds the arena
     */
    public static void position(float x, float y, Bounds bounds) {
        boolean walledX = bounds.edgeX() == AxisEdge.WALL;
        boolean walledY = bounds.edgeY() == AxisEdge.WALL;
        within("x", x, walledX ? bounds.minX() : -COORDINATE, walledX ? bounds.maxX() : COORDINATE);
        within("y", y, walledY ? bounds.minY() : -COORDINATE, walledY ? bounds.maxY() : COORDINATE);
    }

    /**
     * Checks a position that a circle has: inside of an axis that wraps.
     *
     * @param x x
     * @param y y
     * @param bounds the arena
     */
    public static void place(float x, float y, Bounds bounds) {
        position(x, y, bounds);
        if (bounds.edgeX() == AxisEdge.WRAP) {
            within("x", x, bounds.minX(), bounds.lastX());
        }
        if (bounds.edgeY() == AxisEdge.WRAP) {
            within("y", y, bounds.minY(), bounds.lastY());
        }
    }

    /**
     * Checks a velocity.
     *
     * @param vx x
     * @param vy y
     */
    public static void velocity(float vx, float vy) {
        within("vx", vx, -SPEED, SPEED);
        within("vy", vy, -SPEED, SPEED);
    }

    /**
     * Checks an impulse.
     *
     * @param x x
     * @param y y
     */
    public static void impulse(float x, float y) {
        within("impulse x", x, -IMPULSE, IMPULSE);
        within("impulse y", y, -IMPULSE, IMPULSE);
    }

    /**
     * Checks a force.
     *
     * @param x x
     * @param y y
     */
    public static void force(float x, float y) {
        within("force x", x, -FORCE, FORCE);
        within("force y", y, -FORCE, FORCE);
    }

    /**
     * Checks gravity.
     *
     * @param x x
     * @param y y
     */
    public static void gravity(float x, float y) {
        within("gravity x", x, -SPEED, SPEED);
        within("gravity y", y, -SPEED, SPEED);
    }

    /**
     * Checks a restitution.
     *
     * @param restitution the restitution
     * @return the restitution
     */
    public static float restitution(float restitution) {
        return within("restitution", restitution, 0f, 1f);
    }
}
