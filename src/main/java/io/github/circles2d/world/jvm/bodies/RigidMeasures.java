package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.model.CircleMath;

/** Measures contacts of rigid bodies as their things have moved. */
final class RigidMeasures {
    /** How far lines go on beyond their ends within a step, in half thicknesses. */
    private static final float GOES_ON = 0.25f;

    /** The cosine of the angle by which a normal turns at most from one measure to the next if impulses are to stay. */
    private static final float SAME_WAY = 0.98f;

    private float h;

    /** Begins a step with so long sub-steps. */
    void begin(float subStep) {
        h = subStep;
    }

    /**
     * Finds normal, gap and arms of a contact. Impulses have acted along the normal before: if a corner goes beyond the end of a line, they would be
     * taken back along another one, and slow down what slides.
     */
    void measure(RigidContact c) {
        RigidCorner corner = c.corner;
        float nx = c.nx;
        float ny = c.ny;
        float px = corner.x;
        float py = corner.y;
        float r = corner.bend + corner.radius;
        float x = c.x();
        float y = c.y();
        int end = corner.isBent() ? beyond(c, x + px, y + py) : 0;
        if (end != 0) {
            px += r * corner.endX(end);
            py += r * corner.endY(end);
            r = 0f;
        }
        if (c.line == null) {
            onCorner(c, x + px, y + py, r);
        } else if (c.line.isHollow()) {
            inHollow(c, x + px, y + py, r);
        } else {
            onLine(c, x, y, px, py, r);
        }
        if (c.gap > 0f && nx * c.nx + ny * c.ny < SAME_WAY) {
            c.impulse = 0f;
            c.grip = 0f;
        }
        c.ax = px - c.nx * r;
        c.ay = py - c.ny * r;
        c.bx = x + c.ax;
        c.by = y + c.ay;
    }

    /** The end of an arc at (x, y) with which it touches if it has turned so far that its cone has no normal of the contact; 0 if there is none. */
    private static int beyond(RigidContact c, float x, float y) {
        RigidLine line = c.line;
        if (line == null) {
            return c.a.endOf(c.corner, c.itsCorner.x - x, c.itsCorner.y - y);
        }
        return line.isHollow() ? c.a.endOf(c.corner, x - line.x, y - line.y) : c.a.endOf(c.corner, -line.nx, -line.ny);
    }

    /** (x, y): of A's corner, against the place of B. */
    private static void onCorner(RigidContact c, float x, float y, float r) {
        RigidCorner other = c.itsCorner;
        float rx = x - other.x;
        float ry = y - other.y;
        float itsRadius = other.bend + other.radius;
        int end = other.isBent() ? c.b.endOf(other, rx, ry) : 0;
        if (end == 0) {
            atPoint(c, rx, ry, r + itsRadius);
        } else {
            atPoint(c, rx - itsRadius * other.endX(end), ry - itsRadius * other.endY(end), r);
        }
    }

    private static void atPoint(RigidContact c, float rx, float ry, float reach) {
        float d = CircleMath.length(rx, ry);
        if (d > 0f) {
            set(c, rx / d, ry / d, d - reach);
        } else {
            c.gap = d - reach; // the normal stays
        }
    }

    private static void inHollow(RigidContact c, float x, float y, float r) {
        float rx = x - c.line.x;
        float ry = y - c.line.y;
        float d = CircleMath.length(rx, ry);
        float gap = (-1f * c.line.length - d) - r;
        if (d > 0f) {
            set(c, -1f * rx / d, -1f * ry / d, gap);
        } else {
            c.gap = gap; // the normal stays
        }
    }

    private void onLine(RigidContact c, float x, float y, float px, float py, float r) {
        RigidThing t = c.a;
        RigidThing other = c.b;
        float rx = x + px - c.line.x;
        float ry = y + py - c.line.y;
        float lx = c.line.nx;
        float ly = c.line.ny;
        float length = c.line.length;
        float reach = r + c.line.thickness;
        float height = rx * lx + ry * ly;
        float along = ry * lx - rx * ly;
        float more = GOES_ON * (t.ownW > 0f || other.ownW == 0f ? t.thin : other.thin);
        boolean beside = !(along >= -more && along <= length + more);
        if (beside && height > reach) {
            // a fast one that will be over the line as it meets it
            float ux = t.vx - t.omega * py - other.vx + other.omega * (y + py);
            float uy = t.vy + t.omega * px - other.vy - other.omega * (x + px);
            float un = ux * lx + uy * ly;
            float then = along + (uy * lx - ux * ly) * ((height - reach) / -un);
            beside = !(un < 0f && -un * h >= height - reach && then >= -more && then <= length + more);
        }
        if (beside) {
            float end = along < 0f ? 0f : length;
            float ex = rx + ly * end;
            float ey = ry - lx * end;
            if (ex * lx + ey * ly > 0f) {
                atPoint(c, ex, ey, reach);
                return;
            }
        }
        set(c, lx, ly, (height - reach) + 0f); // never -0
    }

    private static void set(RigidContact c, float nx, float ny, float gap) {
        c.nx = nx;
        c.ny = ny;
        c.gap = gap;
    }
}
