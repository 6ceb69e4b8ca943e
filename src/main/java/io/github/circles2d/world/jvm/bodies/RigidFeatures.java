package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.bodies.OutlineShape.BEND;
import static io.github.circles2d.world.bodies.OutlineShape.LENGTH;
import static io.github.circles2d.world.bodies.OutlineShape.NX;
import static io.github.circles2d.world.bodies.OutlineShape.NY;
import static io.github.circles2d.world.bodies.OutlineShape.RADIUS;
import static io.github.circles2d.world.bodies.OutlineShape.THICKNESS;
import static io.github.circles2d.world.bodies.RigidStep.BOTH;
import static io.github.circles2d.world.bodies.RigidStep.CORNER_ON_LINE;
import static io.github.circles2d.world.bodies.RigidStep.FORM_SHIFT;
import static io.github.circles2d.world.bodies.RigidStep.SWAPPED;

import io.github.circles2d.world.bodies.OutlineShape;
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

    /** Ints of a contact that was found: its corner, the line or corner of the other, the form with the feature of the pair's first thing, the feature of its second one. */
    static final int STRIDE = 4;

    static final int CORNER = 0;
    static final int OTHER = 1;
    static final int FIRST = 2;
    static final int SECOND = 3;

    private final RigidPairs pairs;
    private final RigidThings things;
    private final RigidCrossing crossing;

    int[] found = new int[0];
    int count;

    /** The contacts that a pair had before. */
    private RigidStep known;

    private int knownFrom;
    private int knownTo;
    private float dt;

    // of the thing whose corners meet another one: where it is, how near they may have contacts, within which angle
    // beyond
    // their cones, whether one of both comes fast, and whether the thing is the second one of the pair
    private float x;
    private float y;
    private float margin;
    private float tolerance;
    private boolean fast;
    private boolean swapped;

    RigidFeatures(RigidPairs pairs) {
        this.pairs = pairs;
        things = pairs.things;
        crossing = new RigidCrossing(things);
    }

    /** Begins a step, in which nothing has been found. */
    void begin(RigidStep step, float timeStep) {
        known = step;
        dt = timeStep;
        count = 0;
    }

    static int form(int first) {
        return first >> FORM_SHIFT;
    }

    /** Finds the contacts of a pair, which had some of those of the step before, and adds them in order to those found. */
    void find(int p, int old, int end) {
        int from = count;
        int t = pairs.a[p];
        int other = pairs.b[p];
        knownFrom = old;
        knownTo = end;
        if (end > old || !things.oneWay[other] || isInFront(p, t, other)) {
            findOfPair(p, t, other);
            sort(from);
        }
    }

    /** Whether a body is wholly in front of a piece that lets pass what comes from behind. */
    private boolean isInFront(int p, int t, int piece) {
        float slack = ROUNDED * things.thin[t];
        float x = pairs.ox[p] + (things.dx[t] - things.dx[piece]);
        float y = pairs.oy[p] + (things.dy[t] - things.dy[piece]);
        for (int c = things.firstCorner[t]; c < things.firstCorner[t] + things.corners[t]; c++) {
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
    private float frontOf(int piece, int c, float px, float py) {
        if (things.lines[piece] == 0) {
            int at = RigidThings.corner(things.firstCorner[piece]);
            return fromCentre(c, px - things.turnedCorner[at], py - things.turnedCorner[at + 1], -1f)
                    - things.turnedCorner[at + RADIUS];
        }
        int line = RigidThings.line(things.firstLine[piece]);
        float rx = px - things.turnedLine[line];
        float ry = py - things.turnedLine[line + 1];
        if (things.isHollow(things.firstLine[piece])) {
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

    private void findOfPair(int p, int t, int other) {
        int from = count;
        margin = pairs.margin[p];
        float atX = pairs.ox[p] + (things.dx[t] - things.dx[other]);
        float atY = pairs.oy[p] + (things.dy[t] - things.dy[other]);
        if (things.reach[other] < Float.POSITIVE_INFINITY
                && CircleMath.isLonger(atX, atY, (things.reach[t] + things.reach[other]) + 1.125f * margin)) {
            return;
        }
        swapped = false;
        cornersOf(t, other, atX, atY);
        swapped = true;
        cornersOf(other, t, -atX, -atY);
        boolean touch = count > from;
        if (things.shape[other] != null && (!touch || areOpposed(from)) && crossing.find(t, other, atX, atY, touch)) {
            count = from;
            swapped = crossing.swapped;
            add(swapped ? other : t, swapped ? t : other, crossing.corner, crossing.line, true);
        }
    }

    /** Whether one of the contacts of a pair on lines pushes the other way than the first one. */
    private boolean areOpposed(int from) {
        float firstX = 0f;
        float firstY = 0f;
        for (int at = STRIDE * from; at < STRIDE * count; at += STRIDE) {
            int form = form(found[at + FIRST]);
            if (form == BOTH || things.isHollow(found[at + OTHER])) {
                continue;
            }
            int line = RigidThings.line(found[at + OTHER]);
            float side = form == SWAPPED ? -1f : 1f;
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
    private void cornersOf(int t, int other, float atX, float atY) {
        x = atX;
        y = atY;
        float m = margin;
        float[] corner = things.turnedCorner;
        float vx = things.vx[t];
        float vy = things.vy[t];
        float omega = things.omega[t];
        float itsVx = things.vx[other];
        float itsVy = things.vy[other];
        float itsOmega = things.omega[other];
        float itsReach = things.reach[other];
        float cos = things.cos[other];
        float sin = things.sin[other];
        OutlineShape shape = things.shape[other];
        tolerance = TOLERANCE + Math.abs(omega - itsOmega) * dt;
        fast = m > (things.ownW[t] > 0f ? things.thin[t] : things.thin[other]);
        int end = things.firstCorner[t] + things.corners[t];
        for (int c = things.firstCorner[t]; c < end; c++) {
            int at = RigidThings.corner(c);
            float px = atX + corner[at];
            float py = atY + corner[at + 1];
            float r = corner[at + RADIUS];
            float ux = vx - omega * corner[at + 1] - itsVx;
            float uy = vy + omega * corner[at] - itsVy;
            ux += itsOmega * py;
            uy -= itsOmega * px;
            float wide = r + corner[at + BEND];
            float near = wide + (m + dt * (Math.abs(ux) + Math.abs(uy)));
            // surely farther from all that may touch it than this; it spares looking closer
            if (CircleMath.isLonger(px, py, SLACK * (itsReach + near))
                    || shape != null && shape.isFar(cos * px + sin * py, cos * py - sin * px, near)) {
                continue;
            }
            cornerOnLines(t, other, c, px, py, ux, uy);
            if (!swapped
                    && !(CircleMath.isLonger(px, py, SLACK * (itsReach + (wide + m)))
                            || shape != null && shape.isFar(cos * px + sin * py, cos * py - sin * px, wide + m))) {
                cornerOnCorners(t, other, c, px, py);
            }
        }
    }

    /** A corner, which is at (px, py) and goes with (ux, uy). */
    private void cornerOnLines(int t, int other, int c, float px, float py, float ux, float uy) {
        float m = margin;
        float[] lines = things.turnedLine;
        float r = things.turnedCorner[RigidThings.corner(c) + RADIUS];
        boolean bent = things.isBent(c);
        int from = count;
        int deepest = -1;
        float deepestHeight = Float.NEGATIVE_INFINITY;
        float deepestReach = 0f;
        float deepestX = px;
        float deepestY = py;
        int end = things.firstLine[other] + things.lines[other];
        for (int l = things.firstLine[other]; l < end; l++) {
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
            boolean holds = things.shape[other] != null
                    ? deepestHeight > -deepestReach || things.isInside(other, deepestX, deepestY)
                    : isWall(other)
                            || wasThere(c - things.firstCorner[t], deepest - things.firstLine[other])
                            || isBefore(deepest);
            if (holds) {
                add(t, other, c, deepest, true);
            }
        }
    }

    /** Whether a corner of a body had a contact with a line before. */
    private boolean wasThere(int itsCorner, int itsLine) {
        int itsFirst = swapped ? key(SWAPPED, itsLine) : key(CORNER_ON_LINE, itsCorner);
        int itsSecond = swapped ? itsCorner : itsLine;
        for (int o = knownFrom; o < knownTo; o++) {
            int at = RigidStep.KEYS * o + RigidStep.B;
            if (known.contactKeys[at + 1] == itsFirst && known.contactKeys[at + 2] == itsSecond) {
                return true;
            }
        }
        return false;
    }

    private static int key(int form, int feature) {
        return form << FORM_SHIFT | feature;
    }

    /** Whether the place of the thing is in front of a line. */
    private boolean isBefore(int l) {
        int line = RigidThings.line(l);
        float height = (x - things.turnedLine[line]) * things.turnedLine[line + NX]
                + (y - things.turnedLine[line + 1]) * things.turnedLine[line + NY];
        return height > 0f;
    }

    private boolean isWall(int t) {
        return things.type[t] == RigidStep.BODY_WALL;
    }

    /** A corner inside an arc that is solid outside, from whose centre it is (atX, atY) away. */
    private void cornerInHollow(int t, int other, int c, int l, float atX, float atY, float r) {
        int line = RigidThings.line(l);
        float m = margin;
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

    private void cornerOnCorners(int t, int other, int c, float px, float py) {
        float[] corner = things.turnedCorner;
        int at = RigidThings.corner(c);
        int end = things.firstCorner[other] + things.corners[other];
        for (int o = things.firstCorner[other]; o < end; o++) {
            int to = RigidThings.corner(o);
            float rx = px - corner[to];
            float ry = py - corner[to + 1];
            float bend = corner[at + BEND] + corner[to + BEND];
            float most = bend + (corner[at + RADIUS] + corner[to + RADIUS]) + margin;
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

    private void add(int t, int other, int c, int f, boolean line) {
        int at = STRIDE * count;
        if (at == found.length) {
            found = Arrays.copyOf(found, Math.max(64 * STRIDE, 2 * at));
        }
        int ofCorner = c - things.firstCorner[t];
        int ofOther = line ? f - things.firstLine[other] : f - things.firstCorner[other];
        found[at + CORNER] = c;
        found[at + OTHER] = f;
        found[at + FIRST] = key(line ? swapped ? SWAPPED : CORNER_ON_LINE : BOTH, swapped ? ofOther : ofCorner);
        found[at + SECOND] = swapped ? ofCorner : ofOther;
        count++;
    }

    /** Sorts the contacts of a pair by their features. */
    private void sort(int from) {
        for (int c = from + 1; c < count; c++) {
            for (int k = STRIDE * c; k > STRIDE * from && isAfter(k - STRIDE, k); k -= STRIDE) {
                for (int element = 0; element < STRIDE; element++) {
                    int kept = found[k + element];
                    found[k + element] = found[k + element - STRIDE];
                    found[k + element - STRIDE] = kept;
                }
            }
        }
    }

    private boolean isAfter(int c, int other) {
        int order = Integer.compare(found[c + FIRST], found[other + FIRST]);
        return order > 0 || order == 0 && found[c + SECOND] > found[other + SECOND];
    }

    long bytes() {
        return 4L * found.length;
    }
}
