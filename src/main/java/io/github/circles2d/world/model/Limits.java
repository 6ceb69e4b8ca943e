package io.github.circles2d.world.model;

/** The values that a world takes: within them a state stays finite. */
public final class Limits {
    public static final float COORDINATE = 1e9f;

    /** Of the arena. */
    public static final float LEAST_EXTENT = 1e-6f;

    /** Of {@link Bounds#magnitude}. */
    public static final float LEAST_RADIUS_SHARE = 0x1p-20f;

    /** Four cells, in greatest radii. */
    public static final float LEAST_PERIOD = 11f;

    private static final float LEAST_PERIOD_SHARE = 64 * LEAST_RADIUS_SHARE;

    public static final float LEAST_MASS = 1e-9f;

    public static final float GREATEST_MASS = 1e9f;

    /** Of a component; of gravity, too. */
    public static final float SPEED = Tuning.GREATEST_SPEED;

    public static final float GRAVITY_SCALE = 1000f;

    /** 1/s */
    public static final float VELOCITY_DAMPING = 1e6f;

    public static final float FORCE = 1e18f;

    public static final float FRICTION = 1_000f;

    public static final float ROLLING_RESISTANCE = 1_000f;

    /** Radians. */
    public static final float ANGLE = 1e6f;

    /** Radians a second. */
    public static final float ANGULAR_VELOCITY = SPEED;

    public static final float TORQUE = FORCE;

    public static final float ANGULAR_IMPULSE = 1e18f;

    public static final int GROWTH_STEPS = 100_000;

    public static final float IMPULSE = 1e18f;

    /** More than any two circles are apart. */
    public static final float EXPLOSION = 1e10f;

    /** In a snapshot: more than steps leave, and far from overflow. */
    public static final float CACHED_IMPULSE = 1e24f;

    /** In a snapshot, of a rolling impulse by the lesser radius: likewise. */
    public static final float CACHED_ROLLING = 1e33f;

    /** In a snapshot, a speed; steps leave less than 1e13. */
    public static final float WALL_IMPULSE = 1e15f;

    /** Seconds. */
    public static final float LEAST_STEP = 1e-6f;

    public static final float GREATEST_STEP = 1f;

    /** Hertz. */
    public static final float LEAST_FREQUENCY = 1f;

    public static final float GREATEST_FREQUENCY = 10_000f;

    public static final float DAMPING = 1_000f;

    /** Mean radii a second. */
    public static final float PUSH_OUT_SPEED = 100f;

    public static final int SUB_STEPS = 16;

    public static final int THREADS = 256;

    /** Four floats a circle must fit into a Java array. */
    public static final int CIRCLES = 100_000_000;

    private Limits() {}

    public static <T> T notNull(String what, T value) {
        if (value == null) {
            throw new NullPointerException(what + " must not be null");
        }
        return value;
    }

    public static float within(String what, float value, float least, float greatest) {
        if (!(value >= least && value <= greatest)) {
            throw new IllegalArgumentException(
                    what + " is " + value + ", but must be from " + least + " to " + greatest);
        }
        return value;
    }

    public static int within(String what, int value, int least, int greatest) {
        if (value < least || value > greatest) {
            throw new IllegalArgumentException(
                    what + " is " + value + ", but must be from " + least + " to " + greatest);
        }
        return value;
    }

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

    public static Bounds edges(Bounds bounds) {
        float least = LEAST_PERIOD_SHARE * bounds.magnitude();
        if (bounds.periodX() < least || bounds.periodY() < least) {
            throw new IllegalArgumentException("the bounds are " + (bounds.maxX() - bounds.minX()) + " wide and "
                    + (bounds.maxY() - bounds.minY()) + " high, but an axis that wraps must have at least " + least
                    + " for coordinates of this size");
        }
        return bounds;
    }

    /** An axis that wraps keeps its edges. */
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

    public static float radius(float radius, Bounds bounds) {
        return radius("radius", radius, bounds);
    }

    /** Of whatever is as large as a circle may be. */
    public static float radius(String what, float radius, Bounds bounds) {
        if (!hasRoom(radius, bounds)) {
            throw new IllegalArgumentException(noRoom(what, radius, bounds)
                    + ": larger bounds (bounds of World.Builder, World.setBounds) take larger things");
        }
        return radius;
    }

    private static boolean hasRoom(float radius, Bounds bounds) {
        return radius >= bounds.leastRadius() && radius <= bounds.greatestRadius();
    }

    private static String noRoom(String what, float radius, Bounds bounds) {
        return what + " is " + radius + ", but must be from " + bounds.leastRadius() + " to " + bounds.greatestRadius()
                + " in bounds from " + bounds.minX() + ", " + bounds.minY() + " to " + bounds.maxX() + ", "
                + bounds.maxY();
    }

    /** Refuses bounds in which a circle that is there has no room. */
    public static void room(String what, float radius, Bounds next) {
        if (!hasRoom(radius, next)) {
            throw new IllegalArgumentException(noRoom(what, radius, next));
        }
    }

    public static void growth(float radius, int steps, Bounds bounds) {
        radius(radius, bounds);
        within("the number of steps", steps, 1, GROWTH_STEPS);
    }

    public static float mass(float mass) {
        if (mass != Float.POSITIVE_INFINITY && !(mass >= LEAST_MASS && mass <= GREATEST_MASS)) {
            throw new IllegalArgumentException("mass is " + mass + ", but must be from " + LEAST_MASS + " to "
                    + GREATEST_MASS + ", or positive infinity for a static circle");
        }
        return mass;
    }

    public static void position(float x, float y, Bounds bounds) {
        boolean walledX = bounds.edgeX() == AxisEdge.WALL;
        boolean walledY = bounds.edgeY() == AxisEdge.WALL;
        within("x", x, walledX ? bounds.minX() : -COORDINATE, walledX ? bounds.maxX() : COORDINATE);
        within("y", y, walledY ? bounds.minY() : -COORDINATE, walledY ? bounds.maxY() : COORDINATE);
    }

    /** Of a circle: inside an axis that wraps, as steps see it. So close below a least coordinate of 0 that no lap is left, it is. */
    public static void place(float x, float y, Bounds bounds) {
        position(x, y, bounds);
        if (bounds.placeX(x) != x) {
            within("x", x, bounds.minX(), bounds.lastX());
        }
        if (bounds.placeY(y) != y) {
            within("y", y, bounds.minY(), bounds.lastY());
        }
    }

    public static void velocity(float vx, float vy) {
        within("vx", vx, -SPEED, SPEED);
        within("vy", vy, -SPEED, SPEED);
    }

    public static void impulse(float x, float y) {
        within("impulse x", x, -IMPULSE, IMPULSE);
        within("impulse y", y, -IMPULSE, IMPULSE);
    }

    public static void force(float x, float y) {
        within("force x", x, -FORCE, FORCE);
        within("force y", y, -FORCE, FORCE);
    }

    public static void gravity(float x, float y) {
        within("gravity x", x, -SPEED, SPEED);
        within("gravity y", y, -SPEED, SPEED);
    }

    public static float restitution(float restitution) {
        return within("restitution", restitution, 0f, 1f);
    }

    public static float friction(float friction) {
        return within("friction", friction, 0f, FRICTION);
    }

    public static float beltSpeed(float speed) {
        return within("belt speed", speed, -SPEED, SPEED);
    }

    public static float rollingResistance(float resistance) {
        return within("rolling resistance", resistance, 0f, ROLLING_RESISTANCE);
    }
}
