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

    private final RigidContacts contacts;
    private final RigidThings things;
    private float h;

    RigidMeasures(RigidContacts contacts, RigidThings things) {
        this.contacts = contacts;
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
    void measure(int c) {
        int t = contacts.a[c];
        int other = contacts.b[c];
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        float nx = rows[row + RigidRow.NX];
        float ny = rows[row + RigidRow.NY];
        int at = RigidThings.corner(contacts.corner(c));
        float px = things.turnedCorner[at];
        float py = things.turnedCorner[at + 1];
        float r = things.turnedCorner[at + BEND] + things.turnedCorner[at + RADIUS];
        float x = contacts.rows[row + RigidRow.OX] + (things.dx[t] - things.dx[other]);
        float y = contacts.rows[row + RigidRow.OY] + (things.dy[t] - things.dy[other]);
        int end = beyond(c, x, y);
        if (end != 0) {
            px += r * things.turnedCorner[at + end];
            py += r * things.turnedCorner[at + end + 1];
            r = 0f;
        }
        if (!contacts.isLine(c)) {
            onCorner(c, x + px, y + py, r);
        } else if (things.isHollow(contacts.feature(c))) {
            inHollow(c, x + px, y + py, r);
        } else {
            onLine(c, x, y, px, py, r);
        }
        if (rows[row + RigidRow.GAP] > 0f && nx * rows[row + RigidRow.NX] + ny * rows[row + RigidRow.NY] < SAME_WAY) {
            rows[row + RigidRow.IMPULSE] = 0f;
            rows[row + RigidRow.GRIP] = 0f;
        }
        float armX = px - rows[row + RigidRow.NX] * r;
        float armY = py - rows[row + RigidRow.NY] * r;
        rows[row + RigidRow.AX] = armX;
        rows[row + RigidRow.AY] = armY;
        rows[row + RigidRow.BX] = x + armX;
        rows[row + RigidRow.BY] = y + armY;
    }

    /** The end of an arc with which it touches if it has turned so far that its cone has no normal of the contact; 0 if there is none. */
    private int beyond(int c, float x, float y) {
        if (!things.isBent(contacts.corner(c))) {
            return 0;
        }
        int at = RigidThings.corner(contacts.corner(c));
        float rx = x + things.turnedCorner[at];
        float ry = y + things.turnedCorner[at + 1];
        if (contacts.isLine(c)) {
            int line = RigidThings.line(contacts.feature(c));
            return things.isHollow(contacts.feature(c))
                    ? things.endOf(
                            contacts.a[c],
                            contacts.corner(c),
                            rx - things.turnedLine[line],
                            ry - things.turnedLine[line + 1])
                    : things.endOf(
                            contacts.a[c],
                            contacts.corner(c),
                            -things.turnedLine[line + NX],
                            -things.turnedLine[line + NY]);
        }
        int to = RigidThings.corner(contacts.feature(c));
        return things.endOf(
                contacts.a[c], contacts.corner(c), things.turnedCorner[to] - rx, things.turnedCorner[to + 1] - ry);
    }

    /** (x, y): of A's corner, against the place of B. */
    private void onCorner(int c, float x, float y, float r) {
        int to = RigidThings.corner(contacts.feature(c));
        float rx = x - things.turnedCorner[to];
        float ry = y - things.turnedCorner[to + 1];
        float itsRadius = things.turnedCorner[to + BEND] + things.turnedCorner[to + RADIUS];
        int end = things.isBent(contacts.feature(c)) ? things.endOf(contacts.b[c], contacts.feature(c), rx, ry) : 0;
        if (end == 0) {
            atPoint(c, rx, ry, r + itsRadius);
        } else {
            atPoint(
                    c,
                    rx - itsRadius * things.turnedCorner[to + end],
                    ry - itsRadius * things.turnedCorner[to + end + 1],
                    r);
        }
    }

    private void atPoint(int c, float rx, float ry, float reach) {
        float d = CircleMath.length(rx, ry);
        if (d > 0f) {
            set(c, rx / d, ry / d, d - reach);
        } else {
            contacts.rows[RigidRow.of(c) + RigidRow.GAP] = d - reach; // the normal stays
        }
    }

    private void inHollow(int c, float x, float y, float r) {
        int line = RigidThings.line(contacts.feature(c));
        float rx = x - things.turnedLine[line];
        float ry = y - things.turnedLine[line + 1];
        float d = CircleMath.length(rx, ry);
        float gap = (-1f * things.turnedLine[line + LENGTH] - d) - r;
        if (d > 0f) {
            set(c, -1f * rx / d, -1f * ry / d, gap);
        } else {
            contacts.rows[RigidRow.of(c) + RigidRow.GAP] = gap; // the normal stays
        }
    }

    private void onLine(int c, float x, float y, float px, float py, float r) {
        int t = contacts.a[c];
        int other = contacts.b[c];
        int line = RigidThings.line(contacts.feature(c));
        float rx = x + px - things.turnedLine[line];
        float ry = y + py - things.turnedLine[line + 1];
        float lx = things.turnedLine[line + NX];
        float ly = things.turnedLine[line + NY];
        float length = things.turnedLine[line + LENGTH];
        float reach = r + things.turnedLine[line + THICKNESS];
        float height = rx * lx + ry * ly;
        float along = ry * lx - rx * ly;
        float more = GOES_ON * (things.ownW[t] > 0f || things.ownW[other] == 0f ? things.thin[t] : things.thin[other]);
        boolean beside = !(along >= -more && along <= length + more);
        if (beside && height > reach) {
            // a fast one that will be over the line as it meets it
            float ux = things.vx[t] - things.omega[t] * py - things.vx[other] + things.omega[other] * (y + py);
            float uy = things.vy[t] + things.omega[t] * px - things.vy[other] - things.omega[other] * (x + px);
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

    private void set(int c, float nx, float ny, float gap) {
        int row = RigidRow.of(c);
        contacts.rows[row + RigidRow.NX] = nx;
        contacts.rows[row + RigidRow.NY] = ny;
        contacts.rows[row + RigidRow.GAP] = gap;
    }
}
