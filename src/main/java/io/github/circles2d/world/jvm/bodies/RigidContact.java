package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.KeptContacts;
import io.github.circles2d.world.model.CircleMath;

/** A contact of two things: a corner of A, and a line or a corner of B. */
final class RigidContact {
    /** How far lines go on beyond their ends within a step, in half thicknesses. */
    private static final float GOES_ON = 0.25f;

    /** The cosine of the angle by which a normal turns at most from one measure to the next if impulses are to stay. */
    private static final float SAME_WAY = 0.98f;

    RigidThing a;
    RigidThing b;

    /** The corner of A. */
    RigidCorner corner;

    /** The line of B, or null. */
    RigidThing.Line line;

    /** The corner of B, or null. */
    RigidCorner itsCorner;

    // as KeptContacts has them: the form with the feature of the pair's body, and the feature of the other
    int first;
    int second;

    // by how much the base of A lies beyond that of B
    float ox;
    float oy;

    // the normal, from B to A
    float nx;
    float ny;
    float gap;

    // arms
    float ax;
    float ay;
    float bx;
    float by;

    // accumulated impulses: along the normal and the tangent, and the angular one of rolling resistance
    float impulse;
    float grip;
    float roll;

    /** Within a sub-step: the speed after a bounce. */
    float bounce;

    // within a step: the greatest impulse, and the greatest speed before an impulse, towards each other
    float most;
    float approach;

    // effective masses along the normal and the tangent, since contacts were measured; not with circles
    float normalMass;
    float tangentMass;

    // what both things have together
    float friction;
    float rolling;
    float belts;
    float restitution;

    /** Lengths are measured by it. */
    float length;

    /** The square of a speed: slower ones do not bounce. */
    float threshold;

    /** Whether it does not begin. */
    boolean covered;

    // terms of a biased visit that does not bounce, since contacts were measured: factors of speed and impulse, a speed
    float speedScale;
    float decay;
    float bias;

    /** What a visit without bias aims at: to come as near as the gap lets. */
    float near;

    /** Begins without a measure and impulses. */
    void begin(RigidPair pair) {
        boolean swapped = form() == KeptContacts.SWAPPED;
        a = swapped ? pair.b : pair.a;
        b = swapped ? pair.a : pair.b;
        ox = swapped ? -pair.ox : pair.ox;
        oy = swapped ? -pair.oy : pair.oy;
        nx = 0f;
        ny = 0f;
        gap = 0f;
        forgetImpulses();
        most = 0f;
        approach = 0f;
    }

    void forgetImpulses() {
        bounce = 0f;
        impulse = 0f;
        grip = 0f;
        roll = 0f;
    }

    int form() {
        return KeptContacts.form(first);
    }

    /** Whether it comes behind another one of its pair. */
    boolean isBehind(RigidContact other) {
        return first > other.first || first == other.first && second > other.second;
    }

    boolean isLine() {
        return line != null;
    }

    /** How far the place of A is from that of B. */
    float x() {
        return ox + (a.dx - b.dx);
    }

    float y() {
        return oy + (a.dy - b.dy);
    }

    // ---- measures

    /**
     * Finds normal, gap and arms; h: the length of a sub-step. Impulses have acted along the normal before: if a corner goes beyond the end of a line, they would be
     * taken back along another one, and slow down what slides.
     */
    void measure(float h) {
        float oldX = nx;
        float oldY = ny;
        float px = corner.x;
        float py = corner.y;
        float r = corner.bend + corner.radius;
        float x = x();
        float y = y();
        int end = corner.isBent() ? beyond(x + px, y + py) : 0;
        if (end != 0) {
            px += r * corner.endX(end);
            py += r * corner.endY(end);
            r = 0f;
        }
        if (line == null) {
            onCorner(x + px, y + py, r);
        } else if (line.isHollow()) {
            inHollow(x + px, y + py, r);
        } else {
            onLine(x, y, px, py, r, h);
        }
        if (gap > 0f && oldX * nx + oldY * ny < SAME_WAY) {
            impulse = 0f;
            grip = 0f;
        }
        ax = px - nx * r;
        ay = py - ny * r;
        bx = x + ax;
        by = y + ay;
    }

    /** The end of an arc at (x, y) with which it touches if it has turned so far that its cone has no normal of the contact; 0 if there is none. */
    private int beyond(float x, float y) {
        if (line == null) {
            return a.endOf(corner, itsCorner.x - x, itsCorner.y - y);
        }
        return line.isHollow() ? a.endOf(corner, x - line.x, y - line.y) : a.endOf(corner, -line.nx, -line.ny);
    }

    /** (x, y): of A's corner, against the place of B. */
    private void onCorner(float x, float y, float r) {
        RigidCorner other = itsCorner;
        float rx = x - other.x;
        float ry = y - other.y;
        float itsRadius = other.bend + other.radius;
        int end = other.isBent() ? b.endOf(other, rx, ry) : 0;
        if (end == 0) {
            atPoint(rx, ry, r + itsRadius);
        } else {
            atPoint(rx - itsRadius * other.endX(end), ry - itsRadius * other.endY(end), r);
        }
    }

    private void atPoint(float rx, float ry, float reach) {
        float d = CircleMath.length(rx, ry);
        if (d > 0f) {
            setMeasure(rx / d, ry / d, d - reach);
        } else {
            gap = d - reach; // the normal stays
        }
    }

    private void inHollow(float x, float y, float r) {
        float rx = x - line.x;
        float ry = y - line.y;
        float d = CircleMath.length(rx, ry);
        float apart = (-1f * line.length - d) - r;
        if (d > 0f) {
            setMeasure(-1f * rx / d, -1f * ry / d, apart);
        } else {
            gap = apart; // the normal stays
        }
    }

    private void onLine(float x, float y, float px, float py, float r, float h) {
        float rx = x + px - line.x;
        float ry = y + py - line.y;
        float lx = line.nx;
        float ly = line.ny;
        float extent = line.length;
        float reach = r + line.thickness;
        float height = rx * lx + ry * ly;
        float along = ry * lx - rx * ly;
        float more = GOES_ON * (a.ownW > 0f || b.ownW == 0f ? a.thin : b.thin);
        boolean beside = !(along >= -more && along <= extent + more);
        if (beside && height > reach) {
            // a fast one that will be over the line as it meets it
            float ux = a.vx - a.omega * py - b.vx + b.omega * (y + py);
            float uy = a.vy + a.omega * px - b.vy - b.omega * (x + px);
            float un = ux * lx + uy * ly;
            float then = along + (uy * lx - ux * ly) * ((height - reach) / -un);
            beside = !(un < 0f && -un * h >= height - reach && then >= -more && then <= extent + more);
        }
        if (beside) {
            float end = along < 0f ? 0f : extent;
            float ex = rx + ly * end;
            float ey = ry - lx * end;
            if (ex * lx + ey * ly > 0f) {
                atPoint(ex, ey, reach);
                return;
            }
        }
        setMeasure(lx, ly, (height - reach) + 0f); // never -0
    }

    private void setMeasure(float normalX, float normalY, float apart) {
        nx = normalX;
        ny = normalY;
        gap = apart;
    }

    // ---- masses

    /** One over the effective mass of A alone along the normal. */
    float massOfA() {
        float arm = ax * ny - ay * nx;
        return a.ownW + a.ownI * arm * arm;
    }

    float massOfB() {
        float arm = bx * ny - by * nx;
        return b.ownW + b.ownI * arm * arm;
    }

    /** The effective mass along the tangent. Shares: 1, or of what counts as lighter. */
    float gripMass(float shareA, float shareB) {
        float armA = ax * nx + ay * ny;
        float armB = bx * nx + by * ny;
        return massOf(shareA * (a.ownW + a.ownI * armA * armA) + shareB * (b.ownW + b.ownI * armB * armB));
    }

    /** An effective mass, from one over it. No impulse moves what has none. */
    static float massOf(float inverse) {
        return inverse >= Float.MIN_NORMAL ? 1f / inverse : 0f;
    }

    // ---- speeds of A against B

    float speedX() {
        return (a.vx - a.omega * ay) - (b.vx - b.omega * by);
    }

    float speedY() {
        return (a.vy + a.omega * ax) - (b.vy + b.omega * bx);
    }

    float normalSpeed() {
        return speedX() * nx + speedY() * ny;
    }

    /** Before impulses. */
    float speedBefore() {
        float x = (a.beforeX - a.beforeOmega * ay) - (b.beforeX - b.beforeOmega * by);
        float y = (a.beforeY + a.beforeOmega * ax) - (b.beforeY + b.beforeOmega * bx);
        return x * nx + y * ny;
    }

    // ---- what there is to do

    boolean isIdle() {
        return gap > 0f && impulse == 0f && grip == 0f;
    }

    /** Whether nothing presses or grips, so that the next friction changes nothing. */
    boolean isFree() {
        return impulse == 0f && grip == 0f && roll == 0f;
    }

    /** Whether there is friction, or has been. */
    boolean hasGrip() {
        return friction > 0f || grip != 0f;
    }

    /** Whether a contact with a restitution is fast enough to bounce. */
    boolean isImpact(float before) {
        return before < 0f && before * before > threshold;
    }
}
