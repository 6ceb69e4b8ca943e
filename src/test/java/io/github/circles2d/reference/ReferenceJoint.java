package io.github.circles2d.reference;

/** A joint: what it is, and what it keeps from step to step. */
final class ReferenceJoint {
    enum Linear {
        NONE,
        ALONG,
        POINT,
        DRAG
    }

    enum Angular {
        NONE,
        SPEED,
        ANGLE,
        RIGID
    }

    private static final long JOINT = 0x6A6F696E74733264L;

    /**
     * What it holds at one side: a circle, a body that is pushed, or neither.
     *
     * @param circle null if it is none
     * @param rigid null if it is none
     * @param point where it holds a body, in the coordinates of that
     */
    record End(Circle circle, Rigid rigid, float... point) {
        static final End NOTHING = of((Circle) null);

        static End of(Circle circle) {
            return new End(circle, null, 0f, 0f);
        }

        /** A zero is always +0. */
        static End of(Rigid rigid, float x, float y) {
            return new End(null, rigid, x + 0f, y + 0f);
        }
    }

    final int id;
    final long handle;

    /** Null if there is a body. */
    final Circle a;

    /** Null if there is a body, an anchor, or nothing. */
    final Circle b;

    /** The bodies that are pushed at A and B, and where it holds them; null if there are none. */
    final Rigid[] rigids;

    final float[][] points;

    /** Of the anchor; null if it is the world's. */
    final Body body;

    /** In the frame of the body, or of the world. */
    float[] anchor;

    int colour;

    // what it is
    Linear linear = Linear.NONE;
    Angular angular = Angular.NONE;
    boolean rigid;
    boolean elastic;
    boolean hasLeast;
    boolean hasGreatest;
    boolean keepsDirection;
    boolean collides;
    float length;
    float leastLength;
    float greatestLength;
    float frequency;
    float damping;
    float mostForce = Float.POSITIVE_INFINITY;
    float mostTorque = Float.POSITIVE_INFINITY;
    float speed;
    float breakForce = Float.POSITIVE_INFINITY;
    float breakTorque = Float.POSITIVE_INFINITY;

    /** From A to B at the reference angles. */
    float[] direction = new float[2];

    int referenceOfA;
    int referenceOfB;

    // the impulses that it has, on B; the angular one on A
    float along;
    float across;
    float least;
    float greatest;
    float turning;

    /** Of the impulses of a step. */
    final float[] sum = new float[2];

    float sumOfTurning;

    ReferenceJoint(int id, long handle, End a, End b, Body body, float[] anchor) {
        this.id = id;
        this.handle = handle;
        this.a = a.circle;
        this.b = b.circle;
        rigids = new Rigid[] {a.rigid, b.rigid};
        points = new float[][] {a.point, b.point};
        this.body = body;
        this.anchor = anchor;
    }

    /** Makes it what a plan says, of ends as they are now. */
    void become(JointPlan plan, Arena arena) {
        float[] n = plan.numbers();
        switch (plan.kind()) {
            case DISTANCE -> {
                linear = Linear.ALONG;
                rigid = true;
            }
            case SPRING -> {
                linear = Linear.ALONG;
                spring(n[0], n[1]);
            }
            case LIMITS -> linear = Linear.ALONG;
            case PIN -> {
                linear = Linear.POINT;
                rigid = true;
            }
            case SOFT_PIN -> {
                linear = Linear.POINT;
                spring(n[0], n[1]);
            }
            case MOUSE -> {
                linear = Linear.POINT;
                spring(n[0], n[1]);
                mostForce = n[2] + 0f;
            }
            case MOTOR -> {
                angular = Angular.SPEED;
                speed = n[0] + 0f;
                mostTorque = n[1] + 0f;
            }
            case SERVO -> {
                angular = Angular.ANGLE;
                referenceOfA = (int) Angles.units(n[0]);
                spring(n[1], n[2]);
                mostTorque = n[3] + 0f;
            }
            case FRICTION -> {
                linear = Linear.DRAG;
                angular = Angular.SPEED;
                mostForce = n[0] + 0f;
                mostTorque = n[1] + 0f;
            }
            case WELD -> {
                linear = Linear.ALONG;
                rigid = true;
                keepsDirection = true;
                angular = Angular.RIGID;
                float[] way = way(arena);
                float between = holdsRigid() ? 0f : lengthOf(way);
                direction = between > 0f ? new float[] {way[0] / between, way[1] / between} : new float[] {1f, 0f};
                referenceOfA = angle(0);
                referenceOfB = angle(1);
                meet(way, arena);
            }
        }
        if (keepsDirection && holdsRigid()) {
            length = 0f;
        } else if (linear == Linear.ALONG && (rigid || elastic)) {
            length = Float.isNaN(plan.length()) ? lengthOf(way(arena)) : plan.length() + 0f;
        }
        limit(plan.leastLength(), plan.greatestLength());
        breakForce = plan.breakForce() + 0f;
        breakTorque = plan.breakTorque() + 0f;
        collides = plan.collides();
    }

    private void spring(float itsFrequency, float itsDamping) {
        elastic = true;
        frequency = itsFrequency + 0f;
        damping = itsDamping + 0f;
    }

    /** All impulses go if a limit comes or goes. */
    void limit(float least, float most) {
        if (hasLeast != least > 0f || hasGreatest != most < Float.POSITIVE_INFINITY) {
            forgetImpulses();
        }
        leastLength = least + 0f;
        greatestLength = most + 0f;
        hasLeast = least > 0f;
        hasGreatest = most < Float.POSITIVE_INFINITY;
    }

    private void forgetImpulses() {
        along = 0f;
        across = 0f;
        least = 0f;
        greatest = 0f;
        turning = 0f;
        sum[0] = 0f;
        sum[1] = 0f;
        sumOfTurning = 0f;
    }

    /** From A to B, or to the anchor, as they are now. */
    private float[] way(Arena arena) {
        return arena.way(place(0, arena), place(1, arena));
    }

    private Circle circle(int side) {
        return side == 0 ? a : b;
    }

    private float[] place(int side, Arena arena) {
        if (rigids[side] != null) {
            return rigids[side].place(points[side], arena);
        }
        return circle(side) == null ? anchorPlace(arena) : circle(side).base;
    }

    private int angle(int side) {
        return rigids[side] != null ? rigids[side].angle : circle(side).angle;
    }

    /** A weld of a body gets a point that both ends have: the middle between them, or the centre of a circle. */
    private void meet(float[] way, Arena arena) {
        float share = a != null ? 0f : b != null ? 1f : 0.5f;
        float[] from = place(0, arena);
        float[] at = {from[0] + share * way[0], from[1] + share * way[1]};
        for (int side = 0; side < 2; side++) {
            if (rigids[side] != null) {
                points[side] = rigids[side].pointAt(at, arena);
            }
        }
    }

    boolean holdsRigid() {
        return rigids[0] != null || rigids[1] != null;
    }

    boolean isOf(Rigid rigid) {
        return rigids[0] == rigid || rigids[1] == rigid;
    }

    /** The handle of the circle or the body at a side; 0 if there is neither. */
    long handle(int side) {
        Circle circle = circle(side);
        return rigids[side] != null ? rigids[side].handle : circle == null ? 0 : circle.handle;
    }

    /** Whether it keeps a body and a circle, or another body, from colliding. */
    boolean parts(RigidThing body, RigidThing other) {
        boolean isOther = other.body != null ? isOf(other.body) : other.circle != null && isOf(other.circle);
        return !collides && isOther && isOf(body.body);
    }

    private static float lengthOf(float[] way) {
        return (float) Math.sqrt((double) way[0] * way[0] + (double) way[1] * way[1]);
    }

    boolean isOf(Circle c) {
        return a == c || b == c;
    }

    /** The circle that it holds another one to; null if it is a place. */
    Circle otherThan(Circle c) {
        return c == a ? b : a;
    }

    /** Whether it has an angular part, or keeps its direction. */
    boolean turns() {
        return angular != Angular.NONE || keepsDirection;
    }

    // ---- sleep

    /** Whether a circle of it sleeps, and none that a step could move is awake; or whether all it holds are bodies that sleep: steps leave it out. */
    boolean rests() {
        if (holdsRigid()) {
            return a == null
                    && b == null
                    && (rigids[0] == null || rigids[0].isAsleep())
                    && (rigids[1] == null || rigids[1].isAsleep());
        }
        boolean sleeps = a.isAsleep() || b != null && b.isAsleep();
        return sleeps && a.isStatic() && (b == null || b.isStatic());
    }

    /** What a step does to a joint that rests. */
    void keep(float warmScale) {
        along *= warmScale;
        across *= warmScale;
        least *= warmScale;
        greatest *= warmScale;
        turning *= warmScale;
        sum[0] *= warmScale;
        sum[1] *= warmScale;
        sumOfTurning *= warmScale;
    }

    /** Whether it moves one of its circles whatever the others do: by a motor, or since what it holds it to moves by itself. */
    boolean drives(Circle c) {
        if (holdsRigid()) {
            return true;
        }
        if (angular == Angular.SPEED && speed != 0f && mostTorque > 0f || body != null && body.motion != null) {
            return true;
        }
        Circle o = otherThan(c);
        return o != null
                && o.hasInfiniteMass()
                && (o.velocity[0] != 0f || o.velocity[1] != 0f || turns() && o.angularVelocity != 0f);
    }

    /** Whether it moves its bodies whatever they do. Circles know nothing of what bodies do by joints: so one that holds a circle does. */
    boolean drivesRigids() {
        return a != null
                || b != null
                || angular == Angular.SPEED && speed != 0f && mostTorque > 0f
                || body != null && body.motion != null;
    }

    /** From A to B, or to the anchor, with displacements. */
    float[] offset(Arena arena) {
        float[] way = b == null ? arena.way(a.base, anchorPlace(arena)) : a.wayTo(b);
        float[] to = b == null ? new float[2] : b.displacement;
        return Numbers.plus(way, Numbers.minus(to, a.displacement));
    }

    /** Whether it may break. */
    private boolean isBreakable() {
        return breakForce < Float.POSITIVE_INFINITY || breakTorque < Float.POSITIVE_INFINITY;
    }

    /** A bit for each of what it has. */
    private int form() {
        boolean[] has = {rigid, elastic, hasLeast, hasGreatest, keepsDirection};
        int form = linear.ordinal() | angular.ordinal() << 7;
        for (int k = 0; k < has.length; k++) {
            form |= has[k] ? 4 << k : 0;
        }
        return form | (collides ? 1 << 9 : 0) | (isBreakable() ? 1 << 10 : 0);
    }

    long hash() {
        long h = ReferenceWorld.absorb(ReferenceWorld.absorb(ReferenceWorld.absorb(JOINT, id), form()), colour);
        h = ReferenceWorld.absorb(ReferenceWorld.absorb(h, a == null ? -1 : a.id), b == null ? -1 : b.id);
        h = ReferenceWorld.absorb(h, body == null ? 0 : body.id);
        h = ReferenceWorld.absorb(ReferenceWorld.absorb(h, referenceOfA), referenceOfB);
        for (int side = 0; side < 2 && holdsRigid(); side++) {
            h = ReferenceWorld.absorb(h, rigids[side] == null ? -1 : rigids[side].id);
            h = ReferenceWorld.absorb(h, points[side]);
        }
        h = ReferenceWorld.absorb(h, anchor == null ? new float[2] : anchor);
        h = ReferenceWorld.absorb(h, length, leastLength, greatestLength, mostForce, mostTorque, speed);
        h = ReferenceWorld.absorb(h, breakForce, breakTorque, direction[0], direction[1], frequency, damping);
        h = ReferenceWorld.absorb(h, along, across, least, greatest, turning);
        return ReferenceWorld.absorb(h, sum[0], sum[1], sumOfTurning);
    }

    /** Whether its spring pushes. */
    boolean isElastic() {
        return elastic || angular == Angular.ANGLE;
    }

    // ---- what it did in the last step, which had a length; on A

    float forceX(float dt) {
        return -sum[0] / dt + 0f;
    }

    float forceY(float dt) {
        return -sum[1] / dt + 0f;
    }

    float force(float dt) {
        return Numbers.length(forceX(dt), forceY(dt));
    }

    float torque(float dt) {
        return sumOfTurning / dt + 0f;
    }

    /** Where the anchor is now, in the world. */
    float[] anchorPlace(Arena arena) {
        if (body == null) {
            return anchor;
        }
        double[] at = body.place(anchor);
        float[] place = new float[2];
        for (int axis = 0; axis < 2; axis++) {
            place[axis] = arena.inside(axis, (float) (at[axis] - arena.laps(axis, at[axis])));
        }
        return place;
    }

    /** How the anchor moves in a step; null if it is at rest. */
    AnchorMotion anchorMotion(StepParameters k) {
        return body == null || body.motion == null ? null : body.motionOf(anchor, k);
    }
}
