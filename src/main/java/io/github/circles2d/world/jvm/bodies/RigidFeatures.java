package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.KeptContacts.BOTH;
import static io.github.circles2d.world.bodies.KeptContacts.CORNER_ON_LINE;
import static io.github.circles2d.world.bodies.KeptContacts.SWAPPED;

import io.github.circles2d.world.bodies.KeptContacts;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.model.CircleMath;
import java.util.Arrays;

/** Finds between which corners and lines of a pair there are contacts. Each worker has one. */
final class RigidFeatures {
    /** How far beyond its cone a corner meets lines, in radians or nearly so. */
    private static final float TOLERANCE = 0.3f;

    /** The same against corners: the cone itself has them. */
    private static final float STRICT = -1e-6f;

    /** The same of what is round: between a line and the corner beside it is no gap by rounding. */
    private static final float NO_GAP = 1e-5f;

    /** More than what rounding takes. */
    private static final float SLACK = 1.01f;

    /** How deep a body in front of a one-way piece may be in it, in half thicknesses. */
    private static final float ROUNDED = 1e-4f;

    /** The sine of the least angle of lines that cross: of nearly parallel ones rounding decides. */
    private static final float LEAST_SINE = 0.05f;

    /** The sine of the greatest angle of long bodies that cross, and hold each other by their ends. */
    private static final float GREATEST_SINE = 0.45f;

    /** Those that have been found in the step, of all pairs. */
    RigidContact[] found = {};

    int count;

    // within a step; it has the contacts that pairs had before
    private KeptContacts known;
    private float dt;

    // of the thing whose corners meet another one: the pair, where it is, how far beyond their cones they may have
    // contacts, whether one of both comes fast, and whether the thing is the second one of the pair
    private RigidPair pair;
    private float x;
    private float y;
    private float tolerance;
    private boolean fast;
    private boolean swapped;

    // of lines that cross: the corner and the line by which they leave each other, and how far they are apart
    private RigidCorner crossing;
    private RigidThing.Line crossed;
    private float least;
    private float greatestSine;

    /** Begins a step, in which nothing has been found. */
    void begin(KeptContacts ofStepBefore, float timeStep) {
        known = ofStepBefore;
        dt = timeStep;
        count = 0;
    }

    /** Finds the contacts of a pair, and adds them in order to those found. */
    void find(RigidPair of) {
        pair = of;
        if (pair.endOld > pair.firstOld || !pair.b.oneWay || isInFront(pair.a, pair.b)) {
            int from = count;
            findOfPair(pair.a, pair.b);
            sort(from);
        }
    }

    /** Whether a body is wholly in front of a piece that lets pass what comes from behind. */
    private boolean isInFront(RigidThing t, RigidThing piece) {
        float slack = ROUNDED * t.thin;
        float x = pair.x();
        float y = pair.y();
        for (int n = 0; n < t.cornerCount; n++) {
            RigidCorner c = t.corners[n];
            if (frontOf(piece, c, x + c.x, y + c.y) - c.radius < -slack) {
                return false;
            }
        }
        return true;
    }

    /** How far the core of a corner is in front of a piece, against whose place it is; an arc has its circle. */
    private static float frontOf(RigidThing piece, RigidCorner c, float px, float py) {
        if (piece.lineCount == 0) {
            RigidCorner arc = piece.corners[0];
            return fromCentre(c, px - arc.x, py - arc.y, -1f) - arc.radius;
        }
        RigidThing.Line line = piece.lines[0];
        float rx = px - line.x;
        float ry = py - line.y;
        if (line.isHollow()) {
            return -1f * line.length - fromCentre(c, rx, ry, 1f);
        }
        rx += c.bentX(-line.nx, -line.ny);
        ry += c.bentY(-line.nx, -line.ny);
        return rx * line.nx + ry * line.ny - line.thickness;
    }

    /** How far the core of a corner, which is at (x, y), is from a centre at most, or at least if side is -1. */
    private static float fromCentre(RigidCorner c, float x, float y, float side) {
        float d = CircleMath.length(x, y);
        if (!c.isBent() || d == 0f) {
            return d;
        }
        float nx = side * (x / d);
        float ny = side * (y / d);
        return CircleMath.length(x + c.bentX(nx, ny), y + c.bentY(nx, ny));
    }

    private void findOfPair(RigidThing t, RigidThing other) {
        int from = count;
        float atX = pair.x();
        float atY = pair.y();
        if (other.reach < Float.POSITIVE_INFINITY
                && CircleMath.isLonger(atX, atY, (t.reach + other.reach) + 1.125f * pair.margin)) {
            return;
        }
        swapped = false;
        cornersOf(t, other, atX, atY);
        swapped = true;
        cornersOf(other, t, -atX, -atY);
        boolean touch = count > from;
        if (other.shape != null && (!touch || areOpposed(from)) && cross(t, other, atX, atY, touch)) {
            count = from;
            add(crossing, crossed, null);
        }
    }

    /** Whether one of the contacts of a pair on lines pushes the other way than the first one. */
    private boolean areOpposed(int from) {
        float firstX = 0f;
        float firstY = 0f;
        for (int n = from; n < count; n++) {
            RigidContact c = found[n];
            if (c.line == null || c.line.isHollow()) {
                continue;
            }
            float side = c.form() == SWAPPED ? -1f : 1f;
            float nx = side * c.line.nx;
            float ny = side * c.line.ny;
            if (nx * firstX + ny * firstY < 0f) {
                return true;
            }
            if (firstX == 0f && firstY == 0f) {
                firstX = nx;
                firstY = ny;
            }
        }
        return false;
    }

    /** Corners of one thing, and lines of another, from which the first one is so far away; and both things' corners, unless swapped. */
    private void cornersOf(RigidThing t, RigidThing other, float atX, float atY) {
        x = atX;
        y = atY;
        float m = pair.margin;
        tolerance = TOLERANCE + Math.abs(t.omega - other.omega) * dt;
        fast = m > (t.ownW > 0f ? t.thin : other.thin);
        for (int n = 0; n < t.cornerCount; n++) {
            RigidCorner c = t.corners[n];
            float px = atX + c.x;
            float py = atY + c.y;
            float ux = t.vx - t.omega * c.y - other.vx;
            float uy = t.vy + t.omega * c.x - other.vy;
            ux += other.omega * py;
            uy -= other.omega * px;
            float wide = c.radius + c.bend;
            if (!isFar(other, px, py, wide + (m + dt * (Math.abs(ux) + Math.abs(uy))))) {
                cornerOnLines(t, other, c, px, py, ux, uy);
                if (!swapped && !isFar(other, px, py, wide + m)) {
                    cornerOnCorners(other, c, px, py);
                }
            }
        }
    }

    /** Whether a point is surely farther than a distance from all of a thing that may touch it; it spares looking closer. */
    private static boolean isFar(RigidThing t, float px, float py, float distance) {
        return CircleMath.isLonger(px, py, SLACK * (t.reach + distance))
                || t.shape != null && t.shape.isFar(t.cos * px + t.sin * py, t.cos * py - t.sin * px, distance);
    }

    /** A corner, which is at (px, py) and goes with (ux, uy). */
    private void cornerOnLines(RigidThing t, RigidThing other, RigidCorner c, float px, float py, float ux, float uy) {
        int from = count;
        RigidThing.Line deepest = null;
        float deepestHeight = Float.NEGATIVE_INFINITY;
        float deepestReach = 0f;
        float deepestX = px;
        float deepestY = py;
        for (int n = 0; n < other.lineCount; n++) {
            RigidThing.Line line = other.lines[n];
            float rx = px - line.x;
            float ry = py - line.y;
            if (line.isHollow()) {
                cornerInHollow(c, line, rx, ry);
                continue;
            }
            float lx = line.nx;
            float ly = line.ny;
            float bentX = 0f;
            float bentY = 0f;
            if (c.isBent()) {
                bentX = c.bentX(-lx, -ly);
                bentY = c.bentY(-lx, -ly);
                rx += bentX;
                ry += bentY;
            }
            float height = rx * lx + ry * ly;
            float reach = c.radius + line.thickness;
            float far = height - reach;
            if (far > pair.margin) {
                continue;
            }
            float along = ry * lx - rx * ly;
            if (!(along >= 0f && along <= line.length)) {
                // where it would be as it meets the line
                float un = ux * lx + uy * ly;
                float then = far > 0f && -un * dt >= far ? along + (uy * lx - ux * ly) * (far / -un) : along;
                if (!(then >= 0f && then <= line.length)) {
                    continue;
                }
            }
            // one that comes fast may have turned by then
            if (!(fast && far > 0f) && !c.isInCone(-lx, -ly, tolerance) || t.isOfArc(c, -lx, -ly)) {
                continue;
            }
            if (height >= 0f) {
                add(c, line, null);
            } else if (height > deepestHeight) {
                deepestHeight = height;
                deepestReach = reach;
                deepest = line;
                deepestX = px + bentX;
                deepestY = py + bentY;
            }
        }
        if (count == from && deepest != null) {
            boolean holds = other.shape != null
                    ? deepestHeight > -deepestReach || other.isInside(deepestX, deepestY)
                    : other.type == RigidStep.BODY_WALL || wasThere(c.number, deepest.number) || isBefore(deepest);
            if (holds) {
                add(c, deepest, null);
            }
        }
    }

    /** Whether a corner of a body had a contact with a line before. */
    private boolean wasThere(int itsCorner, int itsLine) {
        int itsFirst = swapped
                ? KeptContacts.formAndFeature(SWAPPED, itsLine)
                : KeptContacts.formAndFeature(CORNER_ON_LINE, itsCorner);
        int itsSecond = swapped ? itsCorner : itsLine;
        for (int o = pair.firstOld; o < pair.endOld; o++) {
            if (known.formAndFeature(o) == itsFirst && known.featureOfB(o) == itsSecond) {
                return true;
            }
        }
        return false;
    }

    /** Whether the place of the thing is in front of a line. */
    private boolean isBefore(RigidThing.Line line) {
        return (x - line.x) * line.nx + (y - line.y) * line.ny > 0f;
    }

    /** A corner inside an arc that is solid outside, from whose centre it is (atX, atY) away. */
    private void cornerInHollow(RigidCorner c, RigidThing.Line hollow, float atX, float atY) {
        float rx = atX;
        float ry = atY;
        float d = CircleMath.length(rx, ry);
        if (c.isBent() && d > 0f) {
            rx += c.bentX(atX / d, atY / d);
            ry += c.bentY(atX / d, atY / d);
            d = CircleMath.length(rx, ry);
        }
        float radius = -hollow.length;
        float far = (radius - d) - c.radius;
        boolean inFront = d > 0f
                && far <= pair.margin
                && d < radius + c.radius + pair.margin
                && rx * hollow.nx + ry * hollow.ny >= hollow.thickness * d;
        if (inFront && c.isInCone(rx / d, ry / d, tolerance)) {
            add(c, hollow, null);
        }
    }

    private void cornerOnCorners(RigidThing other, RigidCorner c, float px, float py) {
        for (int n = 0; n < other.cornerCount; n++) {
            RigidCorner o = other.corners[n];
            float rx = px - o.x;
            float ry = py - o.y;
            float bend = c.bend + o.bend;
            float most = bend + (c.radius + o.radius) + pair.margin;
            if (CircleMath.isLonger(rx, ry, SLACK * most)) {
                continue; // surely, without a square root
            }
            float d = CircleMath.length(rx, ry);
            if (d > most || d <= bend) {
                continue; // cores that have crossed are at their backs
            }
            float within = c.isRound() || o.isRound() || bend > 0f ? NO_GAP : STRICT;
            if (o.isInCone(rx / d, ry / d, within) && c.isInCone(-rx / d, -ry / d, within)) {
                add(c, null, o);
            }
        }
    }

    // ---- lines that cross

    /**
     * Finds how two bodies leave each other whose lines cross, like an X: by the corner and the line that are the least way from being apart, as if
     * the line had no ends. The bodies have no contact, or long ones touch, and hold each other by their ends. Whether there are such lines, from
     * which the first body is (atX, atY) away from the other.
     */
    private boolean cross(RigidThing t, RigidThing other, float atX, float atY, boolean touch) {
        greatestSine = touch ? GREATEST_SINE : 2f;
        crossing = null;
        least = Float.NEGATIVE_INFINITY;
        cornersOnLines(t, other, atX, atY, false);
        if (crossing != null) { // else none cross
            cornersOnLines(other, t, -atX, -atY, true);
        }
        return crossing != null;
    }

    private void cornersOnLines(RigidThing t, RigidThing other, float atX, float atY, boolean areSwapped) {
        for (int n = 0; n < other.lineCount; n++) {
            if (!other.lines[n].isHollow() && crosses(t, other.lines[n], atX, atY)) {
                take(t, other.lines[n], atX, atY, areSwapped);
            }
        }
    }

    /** Whether a line crosses one of a thing. */
    private boolean crosses(RigidThing t, RigidThing.Line to, float atX, float atY) {
        for (int n = 0; n < t.lineCount; n++) {
            RigidThing.Line line = t.lines[n];
            float sine = Math.abs(to.nx * line.ny - to.ny * line.nx);
            if (line.isHollow() || sine < LEAST_SINE || sine > greatestSine) {
                continue;
            }
            float rx = atX + line.x - to.x;
            float ry = atY + line.y - to.y;
            float endX = rx - line.length * line.ny;
            float endY = ry + line.length * line.nx;
            boolean ofLine = rx * to.nx + ry * to.ny > 0f != endX * to.nx + endY * to.ny > 0f;
            float itsX = -rx - to.length * to.ny;
            float itsY = -ry + to.length * to.nx;
            if (ofLine && -rx * line.nx - ry * line.ny > 0f != itsX * line.nx + itsY * line.ny > 0f) {
                return true;
            }
        }
        return false;
    }

    /** Takes the deepest corner of a thing behind a line, if that is less deep than what has been taken. */
    private void take(RigidThing t, RigidThing.Line to, float atX, float atY, boolean areSwapped) {
        RigidCorner deepest = null;
        float apart = Float.POSITIVE_INFINITY;
        for (int n = 0; n < t.cornerCount; n++) {
            RigidCorner c = t.corners[n];
            float rx = atX + c.x - to.x;
            float ry = atY + c.y - to.y;
            if (c.isBent()) {
                rx += c.bentX(-to.nx, -to.ny);
                ry += c.bentY(-to.nx, -to.ny);
            }
            float far = (rx * to.nx + ry * to.ny) - (c.radius + to.thickness);
            if (far < apart) {
                apart = far;
                deepest = c;
            }
        }
        if (apart > least) {
            least = apart;
            crossing = deepest;
            crossed = to;
            swapped = areSwapped;
        }
    }

    // ---- contacts that have been found

    /** A corner, and a line or a corner of the other thing. */
    private void add(RigidCorner corner, RigidThing.Line line, RigidCorner itsCorner) {
        if (count == found.length) {
            found = Arrays.copyOf(found, Math.max(64, 2 * count));
        }
        if (found[count] == null) {
            found[count] = new RigidContact();
        }
        RigidContact c = found[count++];
        int other = line == null ? itsCorner.number : line.number;
        int form = line == null ? BOTH : swapped ? SWAPPED : CORNER_ON_LINE;
        c.corner = corner;
        c.line = line;
        c.itsCorner = itsCorner;
        c.first = KeptContacts.formAndFeature(form, swapped ? other : corner.number);
        c.second = swapped ? corner.number : other;
    }

    /** Sorts the contacts of a pair by their features. */
    private void sort(int from) {
        for (int n = from + 1; n < count; n++) {
            RigidContact c = found[n];
            int to = n;
            while (to > from && found[to - 1].isBehind(c)) {
                found[to] = found[--to];
            }
            found[to] = c;
        }
    }

    /** At most: there is room for more than there are. */
    long bytes() {
        return 164L * found.length;
    }
}
