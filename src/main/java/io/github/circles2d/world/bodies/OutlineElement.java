package io.github.circles2d.world.bodies;

import io.github.circles2d.world.model.Rotation;

/** A line or an arc of an outline, or a sharp corner, which is an arc without a radius. Lines and arcs lie along the surface, anticlockwise. */
final class OutlineElement {
    final boolean isLine;

    // where the core of a line begins, or the centre of an arc
    final double x;
    final double y;

    /** How thick a line is; the radius of an arc. */
    final double r;

    // the normals at both ends
    final double ax;
    final double ay;
    final double bx;
    final double by;

    /** The length of a line, without the next two. */
    double span;

    // how much longer the core of a line is at both ends, where reflex corners are
    double before;
    double after;

    /** The radius of the core of an arc. */
    double bend;

    OutlineElement(boolean isLine, double x, double y, double r, double ax, double ay, double bx, double by) {
        this.isLine = isLine;
        this.x = x;
        this.y = y;
        this.r = r;
        this.ax = ax;
        this.ay = ay;
        this.bx = bx;
        this.by = by;
    }

    /** The same, so much lower. */
    OutlineElement lower(double byX, double byY) {
        OutlineElement other = new OutlineElement(isLine, x - byX, y - byY, r, ax, ay, bx, by);
        other.span = span;
        other.before = before;
        other.after = after;
        other.bend = bend;
        return other;
    }

    /** The length of a line, or the opening of an arc's cone, radians. */
    double span() {
        return isLine ? span : angle(ax * bx + ay * by, Math.max(0, ax * by - ay * bx));
    }

    /** A point, at a length or an angle from the start. */
    double pointX(double at) {
        return isLine ? x + r * ax - at * ay : x + r * normalX(at);
    }

    double pointY(double at) {
        return isLine ? y + r * ay + at * ax : y + r * normalY(at);
    }

    private double normalX(double at) {
        int units = (int) Rotation.units(at);
        return at == 0 ? ax : Rotation.cos(units) * ax - Rotation.sin(units) * ay;
    }

    private double normalY(double at) {
        int units = (int) Rotation.units(at);
        return at == 0 ? ay : Rotation.sin(units) * ax + Rotation.cos(units) * ay;
    }

    /** Angle in radians of a unit vector's way to another, from 0 to pi, from its cosine and sine. */
    private static double angle(double cos, double sin) {
        int low = 0;
        for (int bit = 1 << 30; bit > 0; bit >>= 1) {
            // the angle is at least that of low + bit if it lies anticlockwise of it
            int next = low + bit;
            if (next > 0 && sin * Rotation.cos(next) - cos * Rotation.sin(next) >= 0) {
                low = next;
            }
        }
        double c = Rotation.cos(low);
        double s = Rotation.sin(low);
        return low * Rotation.RADIANS_PER_UNIT + (sin * c - cos * s);
    }
}
