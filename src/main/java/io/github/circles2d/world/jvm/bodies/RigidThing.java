package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Velocity;
import java.util.Arrays;

/**
 * What takes part in contacts of rigid bodies in a step: a body, or a piece of terrain, a wall or a circle near to one. All are alike: a place, an angle,
 * velocities, and an outline of corners and lines, which turns with it.
 *
 * <p>A place is a base, which stays for a step, and the displacement since, as those of circles.
 */
final class RigidThing {
    /**
     * A line of a {@link RigidThing}, against the place of that. Of a hollow the place is its centre, the normal is that at its middle, turned, the length minus
     * its radius, the thickness the cosine of half its opening.
     */
    static final class Line {
        /** Its number among those of the thing. */
        final int number;

        // as the thing lies unturned: where its core begins, and its normal
        private float ownX;
        private float ownY;
        private float ownNx;
        private float ownNy;

        float length;
        float thickness;

        // as the thing has turned
        float x;
        float y;
        float nx;
        float ny;

        Line(int number) {
            this.number = number;
        }

        void set(float px, float py, float normalX, float normalY, float itsLength, float thick) {
            ownX = px;
            ownY = py;
            ownNx = normalX;
            ownNy = normalY;
            length = itsLength;
            thickness = thick;
        }

        void turn(float cos, float sin) {
            x = cos * ownX - sin * ownY;
            y = sin * ownX + cos * ownY;
            nx = cos * ownNx - sin * ownNy;
            ny = sin * ownNx + cos * ownNy;
        }

        boolean isHollow() {
            return length < 0f;
        }
    }

    /** Its number among all. */
    final int number;

    /** {@link RigidStep#BODY_BODY} of a body, and so on. */
    int type;

    int id;
    float x;
    float y;
    float dx;
    float dy;
    int angle;

    /** Of a body: by how much it has turned in the step, in radians. */
    float turned;

    float cos;
    float sin;
    float vx;
    float vy;
    float omega;

    // within a sub-step: velocities before impulses
    float beforeX;
    float beforeY;
    float beforeOmega;

    // inverse mass and inertia; 0 of what contacts do not move
    float w;
    float i;

    // the same, also of what sleeps, which moves others as if it would give way
    float ownW;
    float ownI;

    /** Lengths of contacts are measured by it. */
    float thin;

    float reach;
    float restitution;
    float friction;
    float rolling;
    float belt;

    // speed by gravity and forces in a sub-step, also of a body that sleeps, which does not take it
    float gainX;
    float gainY;
    float gainOmega;
    int kind;

    /** Half of its part of a margin. */
    float near;

    /** Of a body: whether it sleeps. */
    boolean asleep;

    /** Of a piece that lets pass what comes from behind. */
    boolean oneWay;

    /** Null of what is no body. */
    OutlineShape shape;

    RigidCorner[] corners = {};
    int cornerCount;
    Line[] lines = {};
    int lineCount;

    /** The number of its pairs in {@link RigidOrder}. */
    int degree;

    /** Of a body: as how many it counts where circles push it at once. */
    float share;

    // of a body: what circles give in a pass, in units; before a step, what presses one that sleeps, with its direction
    // (sums) and without (load)
    long sumX;
    long sumY;
    long sumOmega;
    long sumLoad;

    // of a body that sleeps, by WakingByBodies: the last steps that have looked at it and woken it, the speed that
    // wakes it, and that of the next ring, 0 between rings
    long looked;
    long wokenIn;
    float speed;
    float nextSpeed;

    RigidThing(int number) {
        this.number = number;
    }

    /** Begins as something at rest and unturned, without corners and lines. */
    void begin(int itsType, int itsId, float atX, float atY) {
        type = itsType;
        id = itsId;
        x = atX;
        y = atY;
        dx = 0f;
        dy = 0f;
        angle = 0;
        turned = 0f;
        cos = 1f;
        sin = 0f;
        setVelocity(0f, 0f, 0f);
        noteVelocity();
        setMasses(0f, 0f);
        thin = 0f;
        reach = Float.POSITIVE_INFINITY;
        restitution = 0f;
        setSurface(0f, 0f, 0f);
        gainX = 0f;
        gainY = 0f;
        gainOmega = 0f;
        kind = 0;
        asleep = false;
        oneWay = false;
        shape = null;
        cornerCount = 0;
        lineCount = 0;
    }

    void setVelocity(float itsVx, float itsVy, float itsOmega) {
        vx = itsVx;
        vy = itsVy;
        omega = itsOmega;
    }

    /** A sub-step has given it all but impulses. */
    void noteVelocity() {
        beforeX = vx;
        beforeY = vy;
        beforeOmega = omega;
    }

    /** Inverse mass and inertia of what is awake. */
    void setMasses(float inverseMass, float inverseInertia) {
        w = inverseMass;
        i = inverseInertia;
        ownW = inverseMass;
        ownI = inverseInertia;
    }

    void setSurface(float itsFriction, float itsRolling, float itsBelt) {
        friction = itsFriction;
        rolling = itsRolling;
        belt = itsBelt;
    }

    // ---- outline

    /** Takes the outline of a body. */
    void setShape(OutlineShape outline) {
        float[] c = outline.corners();
        for (int k = 0; k < c.length; k += OutlineShape.CORNER_STRIDE) {
            addCorner()
                    .set(
                            c[k],
                            c[k + 1],
                            c[k + OutlineShape.RADIUS],
                            c[k + OutlineShape.FROM_X],
                            c[k + OutlineShape.FROM_Y],
                            c[k + OutlineShape.TO_X],
                            c[k + OutlineShape.TO_Y],
                            c[k + OutlineShape.BEND]);
        }
        float[] l = outline.lines();
        for (int k = 0; k < l.length; k += OutlineShape.LINE_STRIDE) {
            addLine(
                    l[k],
                    l[k + 1],
                    l[k + OutlineShape.NX],
                    l[k + OutlineShape.NY],
                    l[k + OutlineShape.LENGTH],
                    l[k + OutlineShape.THICKNESS]);
        }
        shape = outline;
        reach = outline.reach();
        thin = outline.halfThickness();
    }

    private RigidCorner addCorner() {
        if (cornerCount == corners.length) {
            corners = Arrays.copyOf(corners, 2 * cornerCount + 1);
        }
        if (corners[cornerCount] == null) {
            corners[cornerCount] = new RigidCorner(cornerCount);
        }
        return corners[cornerCount++];
    }

    void addCorner(float px, float py, float r, float fromX, float fromY, float toX, float toY) {
        addCorner().set(px, py, r, fromX, fromY, toX, toY, 0f);
    }

    /** A corner that is a whole disc. */
    void addDisc(float px, float py, float r) {
        addCorner(px, py, r, 0f, 0f, 0f, 0f);
    }

    void addLine(float px, float py, float nx, float ny, float length, float thickness) {
        if (lineCount == lines.length) {
            lines = Arrays.copyOf(lines, 2 * lineCount + 1);
        }
        if (lines[lineCount] == null) {
            lines[lineCount] = new Line(lineCount);
        }
        lines[lineCount++].set(px, py, nx, ny, length, thickness);
    }

    /** Sets the angle of a body from what it has turned, and turns its outline; within a step only what measures look at. */
    void turn(boolean all) {
        int units = Surface.turn(angle, turned, 1f, 1f);
        // the bits of Rotation.cos and sin, which would each look for the quarter
        int quarter = Rotation.quarter(units);
        double beyond = Rotation.fromQuarter(units, quarter);
        float s = (float) Rotation.sinOfEighth(beyond);
        float c = (float) Rotation.cosOfEighth(beyond);
        boolean odd = (quarter & 1) != 0;
        cos = (odd ? s : c) * (1 - (quarter + 1 & 2));
        sin = (odd ? c : s) * (1 - (quarter & 2));
        place(all);
    }

    /** Turns the outline as cosine and sine are. */
    void place(boolean all) {
        for (int k = 0; k < cornerCount; k++) {
            corners[k].turn(cos, sin, all);
        }
        for (int k = 0; k < lineCount; k++) {
            lines[k].turn(cos, sin);
        }
    }

    /** The end of the cone of a corner, or of an arc of several corners, that is nearer to a direction beyond it; 0 if it has the direction. */
    int endOf(RigidCorner c, float nx, float ny) {
        return isOfArc(c, nx, ny) ? 0 : c.endOf(nx, ny);
    }

    /** Whether an arc that a corner goes on as has a direction in its cone; the corner is an end of the arc, or a part of it. */
    boolean isOfArc(RigidCorner c, float nx, float ny) {
        RigidCorner before = corners[c.number == 0 ? cornerCount - 1 : c.number - 1];
        RigidCorner after = corners[c.number == cornerCount - 1 ? 0 : c.number + 1];
        return c.comesFrom(before) && before.isInCone(nx, ny, 0f) || c.goesTo(after) && after.isInCone(nx, ny, 0f);
    }

    /** Whether a place, against that of a body, is inside its core. */
    boolean isInside(float px, float py) {
        float far = shape.coreReach();
        if (px * px + py * py > far * far) {
            return false;
        }
        float[] p = shape.core();
        float lx = cos * px + sin * py;
        float ly = cos * py - sin * px;
        boolean in = false;
        for (int a = 0, b = p.length - 2; a < p.length; b = a, a += 2) {
            if (p[a + 1] > ly != p[b + 1] > ly && lx < (p[b] - p[a]) * (ly - p[a + 1]) / (p[b + 1] - p[a + 1]) + p[a]) {
                in = !in;
            }
        }
        return in;
    }

    // ---- sums

    void clearSums() {
        sumX = 0L;
        sumY = 0L;
        sumOmega = 0L;
        sumLoad = 0L;
    }

    float range(float inverseH) {
        return CrossRule.velocityRange(reach, inverseH);
    }

    /** Adds velocities. */
    void addToSums(float byX, float byY, float byOmega, float inverseH) {
        float scale = CrossRule.scaleOf(range(inverseH));
        sumX += CrossRule.toFixed(byX, scale);
        sumY += CrossRule.toFixed(byY, scale);
        sumOmega += CrossRule.toFixed(byOmega, CrossRule.scaleOf(inverseH));
    }

    float summedX(float inverseH) {
        return CrossRule.fromFixed(sumX, CrossRule.unitOf(range(inverseH)));
    }

    float summedY(float inverseH) {
        return CrossRule.fromFixed(sumY, CrossRule.unitOf(range(inverseH)));
    }

    float summedOmega(float inverseH) {
        return CrossRule.fromFixed(sumOmega, CrossRule.unitOf(inverseH));
    }

    // ---- what moves it

    /** Adds velocities, within the greatest speed; one look at all is enough nearly always. */
    void add(float byX, float byY, float byOmega) {
        vx += byX;
        vy += byY;
        omega += byOmega;
        if (!(Math.abs(vx) + Math.abs(vy) + Math.abs(omega) <= Tuning.GREATEST_SPEED)) {
            vx = Velocity.limitSpeed(vx);
            vy = Velocity.limitSpeed(vy);
            omega = Velocity.limitSpeed(omega);
        }
    }

    /** Whether contacts move or turn it. */
    boolean gives() {
        return w > 0f || i > 0f;
    }

    float gain() {
        return CircleMath.length(gainX, gainY);
    }

    /** What it takes of {@link #gainX}. */
    float takenX() {
        return asleep ? 0f : gainX;
    }

    float takenY() {
        return asleep ? 0f : gainY;
    }

    float takenOmega() {
        return asleep ? 0f : gainOmega;
    }

    /** At most: there is room for more corners and lines than there are. */
    long bytes() {
        return 268L + 76L * corners.length + 60L * lines.length;
    }
}
