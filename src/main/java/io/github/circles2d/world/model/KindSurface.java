package io.github.circles2d.world.model;

/**
 * Surfaces: a row of floats for each kind, and behind these for each wall, which has a belt, friction and rolling resistance alone. The
 * surface of a circle is such a row too: that of its kind, with the circle's own values in it.
 */
public final class KindSurface {
    /** Speed of the surface besides that of its rotation, positive anticlockwise. */
    public static final int BELT = 0;

    /** Inverse inertia by inverse mass: 2 of a disc, 1 of a ring, 0 of a circle that does not rotate. */
    public static final int INERTIA = 1;

    /** Share of angular velocity that a sub-step leaves. */
    public static final int DAMPING_FACTOR = 2;

    /** The first of those that circles have of their own, or else of the kind, or else of the world; in the order of the fields of circles. */
    public static final int OF_CIRCLES = 3;

    public static final int FRICTION = OF_CIRCLES;

    public static final int ROLLING_RESISTANCE = OF_CIRCLES + 1;

    /** In the first row: 1 if circles have surfaces or torques of their own. */
    public static final int OWN = 5;

    /** In the first row: 1 if something else than contacts changes angular velocities: a torque, or damping. */
    public static final int DRIVES = 6;

    public static final int STRIDE = 8;

    public static final int FLOATS = STRIDE * (PairTable.KINDS + WallMotion.COUNT);

    /** Meaningless unless circles can rotate, as {@link StepConstants#turning} says. */
    public final float[] rows = new float[FLOATS];

    public int version;

    // what the rows follow from
    private float h;
    private SurfaceSettings settings;
    private int kindsVersion = -1;
    private boolean torques;
    private boolean own;

    private boolean alike;

    public static int of(int kind) {
        return STRIDE * kind;
    }

    /** Gives a circle the surface of its kind. */
    public static void copy(float[] from, int kind, float[] to, int circle) {
        System.arraycopy(from, of(kind), to, of(circle), STRIDE);
    }

    /** {@link #INERTIA} */
    public static float inertia(KindField.Values kinds, int kind) {
        return 2f - kinds.get(KindField.INERTIA, kind);
    }

    /** The row of a wall, by {@link WallMotion#of}. */
    public static int ofWall(int wall) {
        return of(PairTable.KINDS + wall);
    }

    /** Does nothing if nothing has changed. The last two: whether circles have surfaces, and torques, of their own. */
    public void update(StepConstants k, KindField.Values kinds, int ofVersion, boolean ofCircles, boolean someTorques) {
        if (kindsVersion == ofVersion
                && h == k.h
                && settings == k.surfaces
                && own == (ofCircles || someTorques)
                && torques == someTorques) {
            return;
        }
        own = ofCircles || someTorques;
        torques = someTorques;
        boolean drives = torques;
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            int row = of(kind);
            rows[row + BELT] = kinds.getFloat(KindField.BELT_SPEED, kind);
            rows[row + INERTIA] = inertia(kinds, kind);
            rows[row + DAMPING_FACTOR] = 1f / (1f + kinds.getFloat(KindField.ANGULAR_DAMPING, kind) * k.h);
            drives |= rows[row + DAMPING_FACTOR] != 1f;
            rows[row + FRICTION] = CircleMath.orOfKind(kinds.getFloat(KindField.FRICTION, kind), k.surfaces.friction);
            rows[row + ROLLING_RESISTANCE] = CircleMath.orOfKind(
                    kinds.getFloat(KindField.ROLLING_RESISTANCE, kind), k.surfaces.rollingResistance);
        }
        for (int wall = 0; wall < WallMotion.COUNT; wall++) {
            int row = ofWall(wall);
            rows[row + BELT] = k.surfaces.wallBelt(wall);
            rows[row + FRICTION] = k.surfaces.wallFriction(wall);
            rows[row + ROLLING_RESISTANCE] = k.surfaces.wallRollingResistance(wall);
        }
        rows[OWN] = own ? 1f : 0f;
        alike = !own && kindsAreAlike();
        rows[DRIVES] = drives ? 1f : 0f;
        h = k.h;
        settings = k.surfaces;
        kindsVersion = ofVersion;
        version++;
    }

    private boolean kindsAreAlike() {
        boolean same = true;
        for (int kind = 1; kind < PairTable.KINDS; kind++) {
            int row = of(kind);
            same &= rows[row + BELT] == rows[BELT]
                    && rows[row + FRICTION] == rows[FRICTION]
                    && rows[row + ROLLING_RESISTANCE] == rows[ROLLING_RESISTANCE];
        }
        return same;
    }

    /** Whether all circles have one friction, one rolling resistance and one belt speed, those of the first row. */
    public boolean areAlike() {
        return alike;
    }
}
