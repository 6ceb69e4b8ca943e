package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.KeptContacts.BOTH;
import static io.github.circles2d.world.bodies.KeptContacts.CORNER_ON_LINE;
import static io.github.circles2d.world.bodies.KeptContacts.SWAPPED;
import static io.github.circles2d.world.bodies.OutlineShape.BEND;
import static io.github.circles2d.world.bodies.OutlineShape.LENGTH;
import static io.github.circles2d.world.bodies.OutlineShape.NX;
import static io.github.circles2d.world.bodies.OutlineShape.NY;
import static io.github.circles2d.world.bodies.OutlineShape.RADIUS;
import static io.github.circles2d.world.bodies.OutlineShape.THICKNESS;

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

    private final RigidThings things;
    private final RigidCrossing crossing;

    /** Those that have been found in the step, of all pairs. */
    RigidContact[] found = {};

    int count;

    // within a step; it has the contacts that pairs had before
    private KeptContacts known;
    private float dt;

    // of the thing whose corners meet another one: the pair, where it is, within which angle beyond their cones they
    // may
    // have contacts, whether one of both comes fast, and whether the thing is the second one of the pair
    private RigidPair pair;
    private float x;
    private float y;
    private float tolerance;
    private boolean fast;
    private boolean swapped;

    RigidFeatures(RigidThings things) {
        this.things = things;
        crossing = new RigidCrossing(things);
    }

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
        for (int c = t.firstCorner; c < t.endCorner; c++) {
            int at = RigidThings.corner(c);
            float px = x + things.turnedCorner[at];
            float py = y + things.turnedCorner[at + 1];
            if (frontOf(piece, c, px, py) - things.turnedCorner[at + RADIUS] < -slack) {
                return false;
            }
        }
        return true;
    }

    /** How far the core of a corner is in front of a piece, against whose place it is; an arc has its circle. */
    private float frontOf(RigidThing piece, int c, float px, float py) {
        if (piece.firstLine == piece.endLine) {
            int at = RigidThings.corner(piece.firstCorner);
            return fromCentre(c, px - things.turnedCorner[at], py - things.turnedCorner[at + 1], -1f)
                    - things.turnedCorner[at + RADIUS];
        }
        int line = RigidThings.line(piece.firstLine);
        float rx = px - things.turnedLine[line];
        float ry = py - things.turnedLine[line + 1];
        if (things.isHollow(piece.firstLine)) {
            return -1f * things.turnedLine[line + LENGTH] - fromCentre(c, rx, ry, 1f);
        }
        float nx = things.turnedLine[line + NX];
        float ny = things.turnedLine[line + NY];
        rx += things.bentX(c, -nx, -ny);
        ry += things.bentY(c, -nx, -ny);
        return rx * nx + ry * ny - things.turnedLine[line + THICKNESS];
    }

    /** How far the core of a corner, which is at (x, y), is from a centre at most, or at least if side is -1. */
    private float fromCentre(int c, float x, float y, float side) {
        float d = CircleMath.length(x, y);
        if (!things.isBent(c) || d == 0f) {
            return d;
        }
        float nx = side * (x / d);
        float ny = side * (y / d);
        return CircleMath.length(x + things.bentX(c, nx, ny), y + things.bentY(c, nx, ny));
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
        if (other.shape != null && (!touch || areOpposed(from)) && crossing.find(t, other, atX, atY, touch)) {
            count = from;
            swapped = crossing.swapped;
            add(swapped ? other : t, swapped ? t : other, crossing.corner, crossing.line, true);
        }
    }

    /** Whether one of the contacts of a pair on lines pushes the other way than the first one. */
    private boolean areOpposed(int from) {
        float firstX = 0f;
        float firstY = 0f;
        for (int n = from; n < count; n++) {
            RigidContact c = found[n];
            if (!c.isLine() || things.isHollow(c.feature)) {
                continue;
            }
            int line = RigidThings.line(c.feature);
            float side = c.form() == SWAPPED ? -1f : 1f;
            float nx = side * things.turnedLine[line + NX];
            float ny = side * things.turnedLine[line + NY];
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
        float[] corner = things.turnedCorner;
        tolerance = TOLERANCE + Math.abs(t.omega - other.omega) * dt;
        fast = m > (t.ownW > 0f ? t.thin : other.thin);
        for (int c = t.firstCorner; c < t.endCorner; c++) {
            int at = RigidThings.corner(c);
            float px = atX + corner[at];
            float py = atY + corner[at + 1];
            float ux = t.vx - t.omega * corner[at + 1] - other.vx;
            float uy = t.vy + t.omega * corner[at] - other.vy;
            ux += other.omega * py;
            uy -= other.omega * px;
            float wide = corner[at + RADIUS] + corner[at + BEND];
            if (!isFar(other, px, py, wide + (m + dt * (Math.abs(ux) + Math.abs(uy))))) {
                cornerOnLines(t, other, c, px, py, ux, uy);
                if (!swapped && !isFar(other, px, py, wide + m)) {
                    cornerOnCorners(t, other, c, px, py);
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
    private void cornerOnLines(RigidThing t, RigidThing other, int c, float px, float py, float ux, float uy) {
        float m = pair.margin;
        float[] lines = things.turnedLine;
        float r = things.turnedCorner[RigidThings.corner(c) + RADIUS];
        boolean bent = things.isBent(c);
        int from = count;
        int deepest = -1;
        float deepestHeight = Float.NEGATIVE_INFINITY;
        float deepestReach = 0f;
        float deepestX = px;
        float deepestY = py;
        for (int l = other.firstLine; l < other.endLine; l++) {
            int line = RigidThings.line(l);
            float rx = px - lines[line];
            float ry = py - lines[line + 1];
            float length = lines[line + LENGTH];
            if (length < 0f) {
                cornerInHollow(t, other, c, l, rx, ry, r);
                continue;
            }
            float lx = lines[line + NX];
            float ly = lines[line + NY];
            float bentX = 0f;
            float bentY = 0f;
            if (bent) {
                bentX = things.bentX(c, -lx, -ly);
                bentY = things.bentY(c, -lx, -ly);
                rx += bentX;
                ry += bentY;
            }
            float height = rx * lx + ry * ly;
            float reach = r + lines[line + THICKNESS];
            float far = height - reach;
            if (far > m) {
                continue;
            }
            float along = ry * lx - rx * ly;
            if (!(along >= 0f && along <= length)) {
                // where it would be as it meets the line
                float un = ux * lx + uy * ly;
                float then = far > 0f && -un * dt >= far ? along + (uy * lx - ux * ly) * (far / -un) : along;
                if (!(then >= 0f && then <= length)) {
                    continue;
                }
            }
            // one that comes fast may have turned by then
            if (!(fast && far > 0f) && !things.isInCone(c, -lx, -ly, tolerance) || things.isOfArc(t, c, -lx, -ly)) {
                continue;
            }
            if (height >= 0f) {
                add(t, other, c, l, true);
            } else if (height > deepestHeight) {
                deepestHeight = height;
                deepestReach = reach;
                deepest = l;
                deepestX = px + bentX;
                deepestY = py + bentY;
            }
        }
        if (count == from && deepest >= 0) {
            boolean holds = other.shape != null
                    ? deepestHeight > -deepestReach || things.isInside(other, deepestX, deepestY)
                    : isWall(other) || wasThere(c - t.firstCorner, deepest - other.firstLine) || isBefore(deepest);
            if (holds) {
                add(t, other, c, deepest, true);
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
    private boolean isBefore(int l) {
        int line = RigidThings.line(l);
        float height = (x - things.turnedLine[line]) * things.turnedLine[line + NX]
                + (y - things.turnedLine[line + 1]) * things.turnedLine[line + NY];
        return height > 0f;
    }

    private static boolean isWall(RigidThing t) {
        return t.type == RigidStep.BODY_WALL;
    }

    /** A corner inside an arc that is solid outside, from whose centre it is (atX, atY) away. */
    private void cornerInHollow(RigidThing t, RigidThing other, int c, int l, float atX, float atY, float r) {
        int line = RigidThings.line(l);
        float m = pair.margin;
        float rx = atX;
        float ry = atY;
        float d = CircleMath.length(rx, ry);
        if (things.isBent(c) && d > 0f) {
            rx += things.bentX(c, atX / d, atY / d);
            ry += things.bentY(c, atX / d, atY / d);
            d = CircleMath.length(rx, ry);
        }
        float radius = -things.turnedLine[line + LENGTH];
        float far = (radius - d) - r;
        boolean inFront = d > 0f
                && far <= m
                && d < radius + r + m
                && rx * things.turnedLine[line + NX] + ry * things.turnedLine[line + NY]
                        >= things.turnedLine[line + THICKNESS] * d;
        if (inFront && things.isInCone(c, rx / d, ry / d, tolerance)) {
            add(t, other, c, l, true);
        }
    }

    private void cornerOnCorners(RigidThing t, RigidThing other, int c, float px, float py) {
        float[] corner = things.turnedCorner;
        int at = RigidThings.corner(c);
        for (int o = other.firstCorner; o < other.endCorner; o++) {
            int to = RigidThings.corner(o);
            float rx = px - corner[to];
            float ry = py - corner[to + 1];
            float bend = corner[at + BEND] + corner[to + BEND];
            float most = bend + (corner[at + RADIUS] + corner[to + RADIUS]) + pair.margin;
            if (CircleMath.isLonger(rx, ry, SLACK * most)) {
                continue; // surely, without a square root
            }
            float d = CircleMath.length(rx, ry);
            if (d > most || d <= bend) {
                continue; // cores that have crossed are at their backs
            }
            boolean noGap = things.isRound(c) || things.isRound(o) || bend > 0f;
            float tolerance = noGap ? NO_GAP : STRICT;
            if (things.isInCone(o, rx / d, ry / d, tolerance) && things.isInCone(c, -rx / d, -ry / d, tolerance)) {
                add(t, other, c, o, false);
            }
        }
    }

    private void add(RigidThing t, RigidThing other, int corner, int feature, boolean line) {
        if (count == found.length) {
            found = Arrays.copyOf(found, Math.max(64, 2 * count));
        }
        if (found[count] == null) {
            found[count] = new RigidContact();
        }
        RigidContact c = found[count++];
        int ofCorner = corner - t.firstCorner;
        int ofOther = feature - (line ? other.firstLine : other.firstCorner);
        c.corner = corner;
        c.feature = feature;
        c.first = KeptContacts.formAndFeature(
                line ? swapped ? SWAPPED : CORNER_ON_LINE : BOTH, swapped ? ofOther : ofCorner);
        c.second = swapped ? ofCorner : ofOther;
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
