package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.OutlineShape.BEND;
import static io.github.circles2d.world.bodies.OutlineShape.LENGTH;
import static io.github.circles2d.world.bodies.OutlineShape.NX;
import static io.github.circles2d.world.bodies.OutlineShape.NY;
import static io.github.circles2d.world.bodies.OutlineShape.RADIUS;
import static io.github.circles2d.world.bodies.OutlineShape.THICKNESS;

import io.github.circles2d.world.model.CircleMath;

/** Measures contacts of rigid bodies as their things have moved. */
final class RigidMeasures {
    /** How far lines go on beyond their ends within a step, in half thicknesses. */
    private static final float GOES_ON = 0.25f;

    /** The cosine of the angle by which a normal turns at most from one measure to the next if impulses are to stay. */
    private static final float SAME_WAY = 0.98f;

    private final RigidThings things;
    private float h;

    RigidMeasures(RigidThings things) {
        this.things = things;
    }

    /** Begins a step with so long sub-steps. */
    void begin(float subStep) {
        h = subStep;
    }

    /**
     * Finds normal, gap and arms of a contact. Impulses have acted along the normal before: if a corner goes beyond the end of a line, they would be
     * taken back along another one, and slow down what slides.
     */
    void measure(RigidContact c) {
        float[] corners = things.turnedCorner;
        float nx = c.nx;
        float ny = c.ny;
        int at = RigidThings.corner(c.corner);
        float px = corners[at];
        float py = corners[at + 1];
        float r = corners[at + BEND] + corners[at + RADIUS];
        float x = c.x();
        float y = c.y();
        int end = beyond(c, x + px, y + py);
        if (end != 0) {
            px += r * corners[at + end];
            py += r * corners[at + end + 1];
            r = 0f;
        }
        if (!c.isLine()) {
            onCorner(c, x + px, y + py, r);
        } else if (things.isHollow(c.feature)) {
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
    private int beyond(RigidContact c, float x, float y) {
        if (!things.isBent(c.corner)) {
            return 0;
        }
        if (!c.isLine()) {
            int to = RigidThings.corner(c.feature);
            return things.endOf(c.a, c.corner, things.turnedCorner[to] - x, things.turnedCorner[to + 1] - y);
        }
        float[] lines = things.turnedLine;
        int line = RigidThings.line(c.feature);
        return things.isHollow(c.feature)
                ? things.endOf(c.a, c.corner, x - lines[line], y - lines[line + 1])
                : things.endOf(c.a, c.corner, -lines[line + NX], -lines[line + NY]);
    }

    /** (x, y): of A's corner, against the place of B. */
    private void onCorner(RigidContact c, float x, float y, float r) {
        float[] corners = things.turnedCorner;
        int to = RigidThings.corner(c.feature);
        float rx = x - corners[to];
        float ry = y - corners[to + 1];
        float itsRadius = corners[to + BEND] + corners[to + RADIUS];
        int end = things.isBent(c.feature) ? things.endOf(c.b, c.feature, rx, ry) : 0;
        if (end == 0) {
            atPoint(c, rx, ry, r + itsRadius);
        } else {
            atPoint(c, rx - itsRadius * corners[to + end], ry - itsRadius * corners[to + end + 1], r);
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

    private void inHollow(RigidContact c, float x, float y, float r) {
        int line = RigidThings.line(c.feature);
        float rx = x - things.turnedLine[line];
        float ry = y - things.turnedLine[line + 1];
        float d = CircleMath.length(rx, ry);
        float gap = (-1f * things.turnedLine[line + LENGTH] - d) - r;
        if (d > 0f) {
            set(c, -1f * rx / d, -1f * ry / d, gap);
        } else {
            c.gap = gap; // the normal stays
        }
    }

    private void onLine(RigidContact c, float x, float y, float px, float py, float r) {
        RigidThing t = c.a;
        RigidThing other = c.b;
        int line = RigidThings.line(c.feature);
        float rx = x + px - things.turnedLine[line];
        float ry = y + py - things.turnedLine[line + 1];
        float lx = things.turnedLine[line + NX];
        float ly = things.turnedLine[line + NY];
        float length = things.turnedLine[line + LENGTH];
        float reach = r + things.turnedLine[line + THICKNESS];
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
