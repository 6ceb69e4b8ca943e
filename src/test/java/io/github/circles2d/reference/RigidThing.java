package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.clamp;

import java.util.ArrayList;
import java.util.List;

/**
 * What takes part in a step of bodies that are pushed: a body, a piece of terrain, a wall or a circle. It has lines and corners, against its place,
 * as {@link RigidOutline} has them. A line of a negative length is a hollow: an arc that is solid outside, at its centre, with the direction of its
 * middle as the normal, the radius as the length and the cosine of half its opening as the thickness. A corner with a cone of zeros is a disc.
 */
final class RigidThing {
    // in the order in which pairs are visited
    static final int BODY = 0;
    static final int PIECE = 1;
    static final int WALL = 2;
    static final int CIRCLE = 3;

    private static final float UNITS_PER_RADIAN = 683565275.576f;
    private static final float GREATEST_UNITS = 0x1p62f;

    final int type;
    final int id;

    /** Where it is as the step begins. */
    final float[] place;

    /** How far it has come since, and by how many radians it has turned. */
    float[] way = new float[2];

    float turned;
    final float[] velocity = new float[2];
    float omega;

    // of the sub-step before any impulse
    float[] velocityBefore = new float[2];
    float omegaBefore;

    /** Inverse mass and inertia; 0 if nothing moves it. */
    float w;

    float i;

    /** The same, also of what sleeps. */
    float ownW;

    float ownI;

    /** Half the thickness, and how far from the place a point of it is at most. */
    float thin;

    float reach = Float.POSITIVE_INFINITY;
    float restitution;
    float friction;
    float rolling;
    float belt;
    final float[] gain = new float[2];
    float angularGain;

    /** The same, also of a body that sleeps. */
    float[] ownGain = new float[2];

    float ownAngularGain;
    int kind;
    boolean oneWay;

    /** How far others may be from it, as its part. */
    float near;

    /** Of a body. */
    Rigid body;

    /** Of a piece of terrain. */
    Piece piece;

    /** Of a circle. */
    Circle circle;

    /** Of a body that wakes, the speed that woke it. */
    float wakingSpeed;

    /** As how many a body counts where circles push it at once. */
    float share;

    /** What circles give a body in a pass: along x and y, and as a spin. */
    FixedSum given;

    FixedSum givenSpin;

    private final List<float[]> ownCorners = new ArrayList<>();
    private final List<float[]> ownLines = new ArrayList<>();
    List<float[]> corners;
    List<float[]> lines;
    private float cos = 1f;
    private float sin;

    RigidThing(int type, int id, float... place) {
        this.type = type;
        this.id = id;
        this.place = place;
    }

    /** Whether contacts move or turn it. */
    boolean gives() {
        return w > 0f || i > 0f;
    }

    boolean isAsleep() {
        return body != null && body.isAsleep();
    }

    void addCorner(float x, float y, float r, float fromX, float fromY, float toX, float toY) {
        ownCorners.add(new float[] {x, y, r, fromX, fromY, toX, toY, 0f});
    }

    void addDisc(float x, float y, float r) {
        addCorner(x, y, r, 0f, 0f, 0f, 0f);
    }

    void addLine(float... line) {
        ownLines.add(line);
    }

    void setOutline(RigidOutline outline) {
        ownCorners.addAll(outline.corners);
        ownLines.addAll(outline.lines);
        reach = outline.reach;
        thin = outline.halfThickness;
    }

    static boolean isHollow(float[] line) {
        return line[4] < 0f;
    }

    static boolean isDisc(float[] corner) {
        return corner[3] == 0f && corner[4] == 0f;
    }

    /** The angle of a body, by what it has turned. */
    int angle() {
        return body.angle + (int) (long) clamp(turned * UNITS_PER_RADIAN, -GREATEST_UNITS, GREATEST_UNITS);
    }

    /** Turns lines and corners of a body as it has turned. */
    void turnBody() {
        turn((float) Angles.cos(angle()), (float) Angles.sin(angle()));
    }

    void turn(float toCos, float toSin) {
        cos = toCos;
        sin = toSin;
        corners = ownCorners.stream().map(c -> turned(c, 0, 3, 5)).toList();
        lines = ownLines.stream().map(l -> turned(l, 0, 2)).toList();
    }

    /** A copy of which the vectors at some places are turned; a cone of zeros stays one. */
    private float[] turned(float[] values, int... vectors) {
        float[] to = values.clone();
        for (int v : vectors) {
            to[v] = cos * values[v] - sin * values[v + 1];
            to[v + 1] = sin * values[v] + cos * values[v + 1];
        }
        return to;
    }

    /** From its place to a point of it. */
    float[] turned(float[] point) {
        return turned(point, 0);
    }

    /** Whether a direction is in the cone of a corner, within a tolerance. */
    static boolean isInCone(float[] corner, float x, float y, float tolerance) {
        return isDisc(corner)
                || corner[3] * y - corner[4] * x >= -tolerance
                        && corner[5] * y - corner[6] * x <= tolerance
                        && (corner[3] + corner[5]) * x + (corner[4] + corner[6]) * y >= -Math.abs(tolerance);
    }

    /** From the place of a corner to the point of its core that is farthest in a direction, which is a unit. */
    static float[] farthest(float[] corner, float x, float y) {
        int end = isInCone(corner, x, y, 0f) ? 0 : nearerEnd(corner, x, y);
        return end == 0
                ? new float[] {corner[7] * x, corner[7] * y}
                : new float[] {corner[7] * corner[end], corner[7] * corner[end + 1]};
    }

    /** Where the numbers of the end of a cone begin that is nearer to a direction. */
    private static int nearerEnd(float[] corner, float x, float y) {
        return corner[3] * x + corner[4] * y > corner[5] * x + corner[6] * y ? 3 : 5;
    }

    /** The normal of the end with which a bent corner touches in a direction that its arc has not; null if it touches between its ends. */
    float[] end(int c, float x, float y) {
        float[] corner = corners.get(c);
        if (corner[7] == 0f || isInCone(corner, x, y, 0f) || isOfArc(c, x, y)) {
            return null;
        }
        int end = nearerEnd(corner, x, y);
        return new float[] {corner[end], corner[end + 1]};
    }

    /** Whether a bent corner before or after a corner, of the same arc or one that ends there, has a direction in its cone. */
    boolean isOfArc(int c, float x, float y) {
        int before = Math.floorMod(c - 1, corners.size());
        int after = (c + 1) % corners.size();
        return goesOn(c, 3, before, 5) && isInCone(corners.get(before), x, y, 0f)
                || goesOn(c, 5, after, 3) && isInCone(corners.get(after), x, y, 0f);
    }

    /** Whether an end of the cone of a corner is an end of another, bent one. */
    private boolean goesOn(int c, int end, int arc, int itsEnd) {
        float[] p = ownCorners.get(c);
        float[] q = ownCorners.get(arc);
        return q[7] > 0f
                && arc != c
                && p[end] == q[itsEnd]
                && p[end + 1] == q[itsEnd + 1]
                && (p[7] + p[2] == 0f || p[0] == q[0] && p[1] == q[1]);
    }

    /** Whether a place against that of a body is inside: a line from it to the right crosses the core an odd number of times. */
    boolean isInside(float px, float py) {
        float x = cos * px + sin * py;
        float y = cos * py - sin * px;
        List<float[]> core = body.outline.core;
        boolean in = false;
        for (int k = 0; k < core.size(); k++) {
            float[] p = core.get(k);
            float[] q = core.get(Math.floorMod(k - 1, core.size()));
            if (p[1] > y != q[1] > y && x < (q[0] - p[0]) * (y - p[1]) / (q[1] - p[1]) + p[0]) {
                in = !in;
            }
        }
        return in;
    }

    void push(float x, float y, float armX, float armY, boolean summing) {
        give(w * x, w * y, i * (armX * y - armY * x), summing);
    }

    /** Changes the velocities; those of a body only with the end of a pass over circles. */
    void give(float x, float y, float spin, boolean summing) {
        if (summing && type == BODY) {
            given.add(0, x);
            given.add(1, y);
            givenSpin.add(0, spin);
        } else {
            velocity[0] = Numbers.limitSpeed(velocity[0] + x);
            velocity[1] = Numbers.limitSpeed(velocity[1] + y);
            omega = Numbers.limitSpeed(omega + spin);
        }
    }

    void takeGiven() {
        float[] sums = given.take();
        velocity[0] += sums[0];
        velocity[1] += sums[1];
        omega += givenSpin.take()[0];
    }
}
