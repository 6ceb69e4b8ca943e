package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.bodies.OutlineShape.BEND;
import static io.github.circles2d.world.bodies.OutlineShape.LENGTH;
import static io.github.circles2d.world.bodies.OutlineShape.NX;
import static io.github.circles2d.world.bodies.OutlineShape.NY;
import static io.github.circles2d.world.bodies.OutlineShape.RADIUS;
import static io.github.circles2d.world.bodies.OutlineShape.THICKNESS;
import static io.github.circles2d.world.bodies.RigidStep.BOTH;
import static io.github.circles2d.world.bodies.RigidStep.CORNER_ON_LINE;
import static io.github.circles2d.world.bodies.RigidStep.FEATURE;
import static io.github.circles2d.world.bodies.RigidStep.FORM_SHIFT;
import static io.github.circles2d.world.bodies.RigidStep.SWAPPED;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * The contacts of rigid bodies: a corner of one thing, A, and a line or corner of another, B. The normal points from B to A. A contact begins if the
 * corner is over the line, and the line's normal, reversed, is in the corner's cone; or if the way between two corners is in both cones.
 */
final class RigidContacts {
    /** How far beyond its cone a corner meets lines, in radians or nearly so. */
    private static final float TOLERANCE = 0.3f;

    /** The same against corners: the cone itself has them. */
    private static final float STRICT = -1e-6f;

    /** The same of what is round: between a line and the corner beside it is no gap by rounding. */
    private static final float NO_GAP = 1e-5f;

    /** More than what rounding takes. */
    private static final float SLACK = 1.01f;

    /** How far lines go on beyond their ends within a step, in half thicknesses. */
    private static final float GOES_ON = 0.25f;

    /** How deep a body in front of a one-way piece may be in it, in half thicknesses. */
    private static final float ROUNDED = 1e-4f;

    private final RigidPairs pairs;
    private final RigidThings things;

    int count;

    /** Things: who has the corner, and the other. */
    int[] a = new int[0];

    int[] b = new int[0];

    /** The corner of A. */
    int[] corner = new int[0];

    /** The line of B, or its corner. */
    int[] feature = new int[0];

    boolean[] isLine = new boolean[0];

    /** The form of the contact with the feature of the pair's first thing, and the feature of its second one. */
    private int[] first = new int[0];

    private int[] second = new int[0];

    /** By how much the base of A lies beyond that of B. */
    float[] ox = new float[0];

    float[] oy = new float[0];

    float[] nx = new float[0];
    float[] ny = new float[0];
    float[] gap = new float[0];

    /** Arms of A and B. */
    float[] ax = new float[0];

    float[] ay = new float[0];
    float[] bx = new float[0];
    float[] by = new float[0];

    /** Accumulated impulses: along the normal and the tangent, and the angular one of rolling resistance. */
    float[] impulse = new float[0];

    float[] grip = new float[0];
    float[] roll = new float[0];

    /** Within a sub-step. */
    float[] bounce = new float[0];

    /** Within a step: the greatest impulse, and the speed of the approach before it. */
    float[] most = new float[0];

    float[] approach = new float[0];

    /** By pair: its first contact; behind the last pair, the number of contacts. */
    int[] firstOf = new int[1];

    /** By pair that has contacts: its number in {@link RigidPairs}. */
    int[] pair = new int[0];

    int pairCount;

    private boolean[] used = new boolean[0];

    /** The contacts that a pair had before. */
    private RigidStep known;

    private int knownFrom;
    private int knownTo;
    private float h;
    private float dt;

    RigidContacts(RigidPairs pairs) {
        this.pairs = pairs;
        things = pairs.things;
    }

    // ---- finding
    // -----------------------------------------------------------------------------------------------------------

    /** Finds the contacts of all pairs, measures them, and gives them what they had. */
    void find(RigidStep step, StepConstants k) {
        h = k.h;
        dt = k.dt;
        count = 0;
        pairCount = 0;
        int old = 0;
        if (used.length < step.contacts) {
            used = new boolean[step.contactKeys.length / RigidStep.KEYS];
        }
        Arrays.fill(used, 0, step.contacts, false);
        for (int p = 0; p < pairs.count; p++) {
            int from = count;
            int t = pairs.a[p];
            int other = pairs.b[p];
            while (old < step.contacts && compare(step, old, t, other) < 0) {
                old++;
            }
            int end = old;
            while (end < step.contacts && compare(step, end, t, other) == 0) {
                end++;
            }
            if (end > old || !things.oneWay[other] || isInFront(p, t, other)) {
                findOfPair(p, step, old, end);
            }
            if (count > from) {
                sort(from);
                ensurePairs();
                pair[pairCount] = p;
                firstOf[pairCount++] = from;
                take(from, step, old, end, k.warmScale);
            }
            old = end;
        }
        ensurePairs();
        firstOf[pairCount] = count;
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
        if (things.isBent(c)) {
            rx += things.bentX(c, -nx, -ny);
            ry += things.bentY(c, -nx, -ny);
        }
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

    private void ensurePairs() {
        if (pairCount == pair.length) {
            int n = Math.max(64, 2 * pairCount);
            pair = Arrays.copyOf(pair, n);
            firstOf = Arrays.copyOf(firstOf, n + 1);
        }
    }

    /** An old contact and a pair, by their keys. */
    private int compare(RigidStep step, int old, int t, int other) {
        int at = RigidStep.KEYS * old;
        int order = Integer.compare(step.contactKeys[at + RigidStep.TYPE], things.type[other]);
        if (order == 0) {
            order = Integer.compare(step.contactKeys[at + RigidStep.A], things.id[t]);
        }
        return order == 0 ? Integer.compare(step.contactKeys[at + RigidStep.B], things.id[other]) : order;
    }

    private void findOfPair(int p, RigidStep step, int old, int end) {
        known = step;
        knownFrom = old;
        knownTo = end;
        int t = pairs.a[p];
        int other = pairs.b[p];
        float m = pairs.margin[p];
        float x = pairs.ox[p] + (things.dx[t] - things.dx[other]);
        float y = pairs.oy[p] + (things.dy[t] - things.dy[other]);
        if (things.reach[other] < Float.POSITIVE_INFINITY
                && CircleMath.isLonger(x, y, (things.reach[t] + things.reach[other]) + 1.125f * m)) {
            return;
        }
        cornersOnLines(p, t, other, x, y, m, false);
        cornersOnLines(p, other, t, -x, -y, m, true);
        cornersOnCorners(p, t, other, x, y, m);
    }

    /** Corners of one thing and lines of another, from which the first one is (x, y) away. */
    private void cornersOnLines(int p, int t, int other, float x, float y, float m, boolean swapped) {
        float spin = Math.abs(things.omega[t] - things.omega[other]) * dt;
        float tolerance = TOLERANCE + spin;
        boolean fast = m > (things.ownW[t] > 0f ? things.thin[t] : things.thin[other]);
        for (int c = things.firstCorner[t]; c < things.firstCorner[t] + things.corners[t]; c++) {
            int at = RigidThings.corner(c);
            float px = x + things.turnedCorner[at];
            float py = y + things.turnedCorner[at + 1];
            float r = things.turnedCorner[at + RADIUS];
            float ux = things.vx[t] - things.omega[t] * things.turnedCorner[at + 1] - things.vx[other];
            float uy = things.vy[t] + things.omega[t] * things.turnedCorner[at] - things.vy[other];
            ux += things.omega[other] * py;
            uy -= things.omega[other] * px;
            if (isFar(c, other, px, py, m + dt * (Math.abs(ux) + Math.abs(uy)))) {
                continue;
            }
            int from = count;
            int deepest = -1;
            float deepestHeight = Float.NEGATIVE_INFINITY;
            float deepestReach = 0f;
            float deepestX = px;
            float deepestY = py;
            for (int l = things.firstLine[other]; l < things.firstLine[other] + things.lines[other]; l++) {
                int line = RigidThings.line(l);
                float rx = px - things.turnedLine[line];
                float ry = py - things.turnedLine[line + 1];
                if (things.isHollow(l)) {
                    cornerInHollow(p, t, other, c, l, rx, ry, r, m, tolerance, swapped);
                    continue;
                }
                float lx = things.turnedLine[line + NX];
                float ly = things.turnedLine[line + NY];
                float bentX = 0f;
                float bentY = 0f;
                if (things.isBent(c)) {
                    bentX = things.bentX(c, -lx, -ly);
                    bentY = things.bentY(c, -lx, -ly);
                    rx += bentX;
                    ry += bentY;
                }
                float length = things.turnedLine[line + LENGTH];
                float height = rx * lx + ry * ly;
                float reach = r + things.turnedLine[line + THICKNESS];
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
                if (!(fast && far > 0f) && !things.isInCone(c, -lx, -ly, tolerance)) {
                    continue;
                }
                if (things.isOfArc(t, c, -lx, -ly)) {
                    continue;
                }
                if (height < 0f) {
                    if (height > deepestHeight) {
                        deepestHeight = height;
                        deepestReach = reach;
                        deepest = l;
                        deepestX = px + bentX;
                        deepestY = py + bentY;
                    }
                    continue;
                }
                add(p, t, other, c, l, true, swapped);
            }
            if (count == from && deepest >= 0) {
                boolean holds = things.shape[other] != null
                        ? deepestHeight > -deepestReach || things.isInside(other, deepestX, deepestY)
                        : isWall(other)
                                || wasThere(c - things.firstCorner[t], deepest - things.firstLine[other], swapped)
                                || isBefore(deepest, x, y);
                if (holds) {
                    add(p, t, other, c, deepest, true, swapped);
                }
            }
        }
    }

    /** Whether a corner, which is (x, y) away from a thing, is surely farther from it than a distance; this spares looking closer. */
    private boolean isFar(int c, int thing, float x, float y, float distance) {
        int at = RigidThings.corner(c);
        float own = things.turnedCorner[at + RADIUS] + things.turnedCorner[at + BEND];
        return CircleMath.isLonger(x, y, SLACK * (things.reach[thing] + own + distance));
    }

    /** Whether a corner of a body had a contact with a line before. */
    private boolean wasThere(int itsCorner, int itsLine, boolean swapped) {
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

    /** Whether two contacts of a pair share a corner or a line. */
    private static boolean shareFeature(int first, int second, int otherFirst, int otherSecond) {
        int form = first >> FORM_SHIFT;
        int otherForm = otherFirst >> FORM_SHIFT;
        boolean same = (first & FEATURE) == (otherFirst & FEATURE);
        return same && (form == SWAPPED) == (otherForm == SWAPPED)
                || second == otherSecond && (form == CORNER_ON_LINE) == (otherForm == CORNER_ON_LINE);
    }

    /** Whether a place is in front of a line. */
    private boolean isBefore(int l, float x, float y) {
        int line = RigidThings.line(l);
        float height = (x - things.turnedLine[line]) * things.turnedLine[line + NX]
                + (y - things.turnedLine[line + 1]) * things.turnedLine[line + NY];
        return height > 0f;
    }

    private boolean isWall(int t) {
        return things.type[t] == RigidStep.BODY_WALL;
    }

    /** A corner inside an arc that is solid outside, from whose centre it is (atX, atY) away. */
    private void cornerInHollow(
            int p,
            int t,
            int other,
            int c,
            int l,
            float atX,
            float atY,
            float r,
            float m,
            float tolerance,
            boolean swapped) {
        int line = RigidThings.line(l);
        float x = atX;
        float y = atY;
        float d = CircleMath.length(x, y);
        if (things.isBent(c) && d > 0f) {
            x += things.bentX(c, atX / d, atY / d);
            y += things.bentY(c, atX / d, atY / d);
            d = CircleMath.length(x, y);
        }
        float radius = -things.turnedLine[line + LENGTH];
        float far = (radius - d) - r;
        boolean inFront = d > 0f
                && far <= m
                && d < radius + r + m
                && x * things.turnedLine[line + NX] + y * things.turnedLine[line + NY]
                        >= things.turnedLine[line + THICKNESS] * d;
        if (inFront && things.isInCone(c, x / d, y / d, tolerance)) {
            add(p, t, other, c, l, true, swapped);
        }
    }

    private void cornersOnCorners(int p, int t, int other, float x, float y, float m) {
        for (int c = things.firstCorner[t]; c < things.firstCorner[t] + things.corners[t]; c++) {
            int at = RigidThings.corner(c);
            if (isFar(c, other, x + things.turnedCorner[at], y + things.turnedCorner[at + 1], m)) {
                continue;
            }
            for (int o = things.firstCorner[other]; o < things.firstCorner[other] + things.corners[other]; o++) {
                int to = RigidThings.corner(o);
                float rx = x + things.turnedCorner[at] - things.turnedCorner[to];
                float ry = y + things.turnedCorner[at + 1] - things.turnedCorner[to + 1];
                float bend = things.turnedCorner[at + BEND] + things.turnedCorner[to + BEND];
                float reach = things.turnedCorner[at + RADIUS] + things.turnedCorner[to + RADIUS];
                float d = CircleMath.length(rx, ry);
                if (d > bend + reach + m || d <= bend) {
                    continue; // cores that have crossed are at their backs
                }
                boolean noGap = things.isRound(c) || things.isRound(o) || bend > 0f;
                float tolerance = noGap ? NO_GAP : STRICT;
                if (things.isInCone(o, rx / d, ry / d, tolerance) && things.isInCone(c, -rx / d, -ry / d, tolerance)) {
                    add(p, t, other, c, o, false, false);
                }
            }
        }
    }

    /** swapped: the corner is of the second thing of the pair. */
    private void add(int p, int t, int other, int c, int f, boolean line, boolean swapped) {
        if (count == a.length) {
            grow(Math.max(64, 2 * count));
        }
        int to = count++;
        a[to] = t;
        b[to] = other;
        corner[to] = c;
        feature[to] = f;
        isLine[to] = line;
        int ofCorner = c - things.firstCorner[t];
        int ofOther = line ? f - things.firstLine[other] : f - things.firstCorner[other];
        first[to] = key(line ? swapped ? SWAPPED : CORNER_ON_LINE : BOTH, swapped ? ofOther : ofCorner);
        second[to] = swapped ? ofCorner : ofOther;
        ox[to] = swapped ? -pairs.ox[p] : pairs.ox[p];
        oy[to] = swapped ? -pairs.oy[p] : pairs.oy[p];
        impulse[to] = 0f;
        grip[to] = 0f;
        roll[to] = 0f;
        bounce[to] = 0f;
        most[to] = 0f;
        approach[to] = 0f;
        nx[to] = 0f;
        ny[to] = 0f;
    }

    private void grow(int n) {
        a = Arrays.copyOf(a, n);
        b = Arrays.copyOf(b, n);
        corner = Arrays.copyOf(corner, n);
        feature = Arrays.copyOf(feature, n);
        isLine = Arrays.copyOf(isLine, n);
        first = Arrays.copyOf(first, n);
        second = Arrays.copyOf(second, n);
        ox = Arrays.copyOf(ox, n);
        oy = Arrays.copyOf(oy, n);
        nx = Arrays.copyOf(nx, n);
        ny = Arrays.copyOf(ny, n);
        gap = Arrays.copyOf(gap, n);
        ax = Arrays.copyOf(ax, n);
        ay = Arrays.copyOf(ay, n);
        bx = Arrays.copyOf(bx, n);
        by = Arrays.copyOf(by, n);
        impulse = Arrays.copyOf(impulse, n);
        grip = Arrays.copyOf(grip, n);
        roll = Arrays.copyOf(roll, n);
        bounce = Arrays.copyOf(bounce, n);
        most = Arrays.copyOf(most, n);
        approach = Arrays.copyOf(approach, n);
    }

    /** Sorts the contacts of a pair by their features. */
    private void sort(int from) {
        for (int c = from + 1; c < count; c++) {
            for (int k = c; k > from && isAfter(k - 1, k); k--) {
                exchange(a, k);
                exchange(b, k);
                exchange(corner, k);
                exchange(feature, k);
                exchange(first, k);
                exchange(second, k);
                exchange(ox, k);
                exchange(oy, k);
                boolean line = isLine[k];
                isLine[k] = isLine[k - 1];
                isLine[k - 1] = line;
            }
        }
    }

    private boolean isAfter(int c, int other) {
        return first[c] > first[other] || first[c] == first[other] && second[c] > second[other];
    }

    private static void exchange(int[] in, int k) {
        int kept = in[k];
        in[k] = in[k - 1];
        in[k - 1] = kept;
    }

    private static void exchange(float[] in, int k) {
        float kept = in[k];
        in[k] = in[k - 1];
        in[k - 1] = kept;
    }

    // ---- impulses
    // ----------------------------------------------------------------------------------------------------------

    /** Gives the contacts of a pair the impulses of the step before. */
    private void take(int from, RigidStep step, int old, int end, float scale) {
        for (int c = from; c < count; c++) {
            measure(c);
            for (int o = old; o < end; o++) {
                int at = RigidStep.KEYS * o + RigidStep.B;
                if (step.contactKeys[at + 1] == first[c] && step.contactKeys[at + 2] == second[c]) {
                    take(c, step, o, scale);
                }
            }
        }
        // a corner that has gone on to another feature takes along what it had
        for (int c = from; c < count; c++) {
            for (int o = old; o < end && impulse[c] == 0f; o++) {
                int at = RigidStep.KEYS * o + RigidStep.B;
                if (!used[o]
                        && step.contactImpulses[RigidStep.IMPULSES * o + RigidStep.NORMAL] > 0f
                        && shareFeature(step.contactKeys[at + 1], step.contactKeys[at + 2], first[c], second[c])) {
                    take(c, step, o, scale);
                }
            }
        }
    }

    private void take(int c, RigidStep step, int old, float scale) {
        impulse[c] = scale * step.contactImpulses[RigidStep.IMPULSES * old + RigidStep.NORMAL];
        grip[c] = scale * step.contactImpulses[RigidStep.IMPULSES * old + RigidStep.NORMAL + 1];
        used[old] = true;
    }

    /** Keeps the contacts for the next step, and those of what rests. */
    void keep(RigidStep step, RigidResting rests) {
        step.ensureContacts(count + rests.count);
        step.contacts = 0;
        int rest = 0;
        for (int p = 0; p < pairCount; p++) {
            int t = pairs.a[pair[p]];
            int other = pairs.b[pair[p]];
            rest = rests.keepBefore(step, rest, things.type[other], things.id[t], things.id[other]);
            for (int c = firstOf[p]; c < firstOf[p + 1]; c++) {
                int to = step.contacts++;
                int at = RigidStep.KEYS * to;
                step.contactKeys[at + RigidStep.TYPE] = things.type[other];
                step.contactKeys[at + RigidStep.A] = things.id[t];
                step.contactKeys[at + RigidStep.B] = things.id[other];
                step.contactKeys[at + RigidStep.FORM_AND_FEATURE] = first[c];
                step.contactKeys[at + RigidStep.FEATURE_OF_B] = second[c];
                step.contactImpulses[RigidStep.IMPULSES * to + RigidStep.NORMAL] = impulse[c];
                step.contactImpulses[RigidStep.IMPULSES * to + RigidStep.NORMAL + 1] = grip[c];
            }
        }
        rests.keepBefore(step, rest, Integer.MAX_VALUE, 0, 0);
    }

    /** Measures a contact of the step before that no pair has now, behind all others, without counting it; false if a thing has no such feature. */
    boolean probe(RigidStep step, int o) {
        int at = RigidStep.KEYS * o;
        int body = step.contactKeys[at + RigidStep.A];
        int id = step.contactKeys[at + RigidStep.B];
        int type = step.contactKeys[at + RigidStep.TYPE];
        int form = step.contactKeys[at + RigidStep.FORM_AND_FEATURE] >> FORM_SHIFT;
        int ofBody = step.contactKeys[at + RigidStep.FORM_AND_FEATURE] & FEATURE;
        int ofOther = step.contactKeys[at + RigidStep.FEATURE_OF_B];
        pairs.probe(body, type, id);
        int p = pairs.count;
        int t = pairs.a[p];
        int other = pairs.b[p];
        int there = form == CORNER_ON_LINE ? things.lines[other] : things.corners[other];
        if (ofOther < 0 || ofOther >= there) {
            return false;
        }
        if (form == SWAPPED) {
            add(p, other, t, things.firstCorner[other] + ofOther, things.firstLine[t] + ofBody, true, true);
        } else {
            boolean line = form == CORNER_ON_LINE;
            int feature = (line ? things.firstLine[other] : things.firstCorner[other]) + ofOther;
            add(p, t, other, things.firstCorner[t] + ofBody, feature, line, false);
        }
        count--;
        measure(count);
        impulse[count] = step.contactImpulses[RigidStep.IMPULSES * o + RigidStep.NORMAL];
        grip[count] = step.contactImpulses[RigidStep.IMPULSES * o + RigidStep.NORMAL + 1];
        return true;
    }

    /** Leaves out contacts. */
    void removeMarked(boolean[] gone) {
        int to = 0;
        int toPair = 0;
        for (int p = 0; p < pairCount; p++) {
            int from = to;
            for (int c = firstOf[p]; c < firstOf[p + 1]; c++) {
                if (!gone[c]) {
                    copy(c, to++);
                }
            }
            if (to > from) {
                pair[toPair] = pair[p];
                firstOf[toPair++] = from;
            }
        }
        pairCount = toPair;
        count = to;
        firstOf[pairCount] = count;
    }

    private void copy(int from, int to) {
        a[to] = a[from];
        b[to] = b[from];
        corner[to] = corner[from];
        feature[to] = feature[from];
        isLine[to] = isLine[from];
        first[to] = first[from];
        second[to] = second[from];
        ox[to] = ox[from];
        oy[to] = oy[from];
        nx[to] = nx[from];
        ny[to] = ny[from];
        gap[to] = gap[from];
        ax[to] = ax[from];
        ay[to] = ay[from];
        bx[to] = bx[from];
        by[to] = by[from];
        impulse[to] = impulse[from];
        grip[to] = grip[from];
        roll[to] = roll[from];
        bounce[to] = bounce[from];
        most[to] = most[from];
        approach[to] = approach[from];
    }

    // ---- measures
    // ----------------------------------------------------------------------------------------------------------

    void measureAll() {
        for (int c = 0; c < count; c++) {
            measure(c);
        }
    }

    /** Finds normal, gap and arms of a contact. */
    void measure(int c) {
        int t = a[c];
        int other = b[c];
        int at = RigidThings.corner(corner[c]);
        float px = things.turnedCorner[at];
        float py = things.turnedCorner[at + 1];
        float r = things.turnedCorner[at + BEND] + things.turnedCorner[at + RADIUS];
        float x = ox[c] + (things.dx[t] - things.dx[other]);
        float y = oy[c] + (things.dy[t] - things.dy[other]);
        int end = beyond(c, x, y);
        if (end != 0) {
            px += r * things.turnedCorner[at + end];
            py += r * things.turnedCorner[at + end + 1];
            r = 0f;
        }
        if (!isLine[c]) {
            onCorner(c, x + px, y + py, r);
        } else if (things.isHollow(feature[c])) {
            inHollow(c, x + px, y + py, r);
        } else {
            onLine(c, x, y, px, py, r);
        }
        ax[c] = px - nx[c] * r;
        ay[c] = py - ny[c] * r;
        bx[c] = x + ax[c];
        by[c] = y + ay[c];
    }

    /** The end of an arc with which it touches if it has turned so far that its cone has no normal of the contact; 0 if there is none. */
    private int beyond(int c, float x, float y) {
        if (!things.isBent(corner[c])) {
            return 0;
        }
        int at = RigidThings.corner(corner[c]);
        float rx = x + things.turnedCorner[at];
        float ry = y + things.turnedCorner[at + 1];
        if (isLine[c]) {
            int line = RigidThings.line(feature[c]);
            return things.isHollow(feature[c])
                    ? things.endOf(a[c], corner[c], rx - things.turnedLine[line], ry - things.turnedLine[line + 1])
                    : things.endOf(a[c], corner[c], -things.turnedLine[line + NX], -things.turnedLine[line + NY]);
        }
        int to = RigidThings.corner(feature[c]);
        return things.endOf(a[c], corner[c], things.turnedCorner[to] - rx, things.turnedCorner[to + 1] - ry);
    }

    /** (x, y): of A's corner, against the place of B. */
    private void onCorner(int c, float x, float y, float r) {
        int to = RigidThings.corner(feature[c]);
        float rx = x - things.turnedCorner[to];
        float ry = y - things.turnedCorner[to + 1];
        float itsRadius = things.turnedCorner[to + BEND] + things.turnedCorner[to + RADIUS];
        int end = things.isBent(feature[c]) ? things.endOf(b[c], feature[c], rx, ry) : 0;
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
            nx[c] = rx / d;
            ny[c] = ry / d;
        }
        gap[c] = d - reach;
    }

    private void inHollow(int c, float x, float y, float r) {
        int line = RigidThings.line(feature[c]);
        float rx = x - things.turnedLine[line];
        float ry = y - things.turnedLine[line + 1];
        float d = CircleMath.length(rx, ry);
        if (d > 0f) {
            nx[c] = -1f * rx / d;
            ny[c] = -1f * ry / d;
        }
        gap[c] = (-1f * things.turnedLine[line + LENGTH] - d) - r;
    }

    private void onLine(int c, float x, float y, float px, float py, float r) {
        int t = a[c];
        int other = b[c];
        int line = RigidThings.line(feature[c]);
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
        nx[c] = lx;
        ny[c] = ly;
        gap[c] = height - reach;
    }

    long bytes() {
        return 85L * a.length + 8L * pair.length + used.length;
    }
}
