package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.model.Surface;
import java.util.Arrays;

/** The {@link RigidThing things} of a step, with their corners and lines. The first ones are the bodies, in the order of their ids. */
final class RigidThings {
    RigidThing[] all = {};
    int count;
    int bodies;

    /** Corners and lines against the place of their thing, as they lie and as they have turned; {@link OutlineShape} numbers the elements. */
    float[] corner = new float[0];

    float[] turnedCorner = new float[0];
    float[] line = new float[0];
    float[] turnedLine = new float[0];
    private int cornerCount;
    private int lineCount;

    /** Forgets the things from a number on, which have been added last. */
    void truncate(int from) {
        if (from < count) {
            cornerCount = all[from].firstCorner;
            lineCount = all[from].firstLine;
            count = from;
        }
    }

    static int corner(int c) {
        return OutlineShape.CORNER_STRIDE * c;
    }

    static int line(int l) {
        return OutlineShape.LINE_STRIDE * l;
    }

    /** One more thing without corners and lines, at rest and unturned. */
    RigidThing add(int type, int id, float x, float y) {
        if (count == all.length) {
            RigidThing[] grown = Arrays.copyOf(all, Math.max(64, 2 * count));
            for (int t = count; t < grown.length; t++) {
                grown[t] = new RigidThing(t);
            }
            all = grown;
        }
        RigidThing t = all[count++];
        t.begin(type, id, x, y);
        t.firstCorner = cornerCount;
        t.endCorner = cornerCount;
        t.firstLine = lineCount;
        t.endLine = lineCount;
        return t;
    }

    private void ensure(int moreCorners, int moreLines) {
        int c = corner(cornerCount + moreCorners);
        if (c > corner.length) {
            corner = Arrays.copyOf(corner, 2 * c);
            turnedCorner = Arrays.copyOf(turnedCorner, 2 * c);
        }
        int l = line(lineCount + moreLines);
        if (l > line.length) {
            line = Arrays.copyOf(line, 2 * l);
            turnedLine = Arrays.copyOf(turnedLine, 2 * l);
        }
    }

    /** Gives the last thing the outline of a body. */
    void setShape(OutlineShape outline) {
        float[] itsCorners = outline.corners();
        float[] itsLines = outline.lines();
        int moreCorners = itsCorners.length / OutlineShape.CORNER_STRIDE;
        int moreLines = itsLines.length / OutlineShape.LINE_STRIDE;
        ensure(moreCorners, moreLines);
        System.arraycopy(itsCorners, 0, corner, corner(cornerCount), itsCorners.length);
        System.arraycopy(itsLines, 0, line, line(lineCount), itsLines.length);
        cornerCount += moreCorners;
        lineCount += moreLines;
        RigidThing t = all[count - 1];
        t.endCorner = cornerCount;
        t.endLine = lineCount;
        t.shape = outline;
        t.reach = outline.reach();
        t.thin = outline.halfThickness();
    }

    /** Gives the last thing one more corner, with a cone of normals, anticlockwise from the first to the second one. */
    void addCorner(float px, float py, float r, float fromX, float fromY, float toX, float toY) {
        ensure(1, 0);
        int c = corner(cornerCount++);
        corner[c] = px;
        corner[c + 1] = py;
        corner[c + OutlineShape.RADIUS] = r;
        corner[c + OutlineShape.FROM_X] = fromX;
        corner[c + OutlineShape.FROM_Y] = fromY;
        corner[c + OutlineShape.TO_X] = toX;
        corner[c + OutlineShape.TO_Y] = toY;
        corner[c + OutlineShape.BEND] = 0f;
        all[count - 1].endCorner = cornerCount;
    }

    /** Gives the last thing a corner that is a whole disc. */
    void addDisc(float px, float py, float r) {
        addCorner(px, py, r, 0f, 0f, 0f, 0f);
    }

    /** Gives the last thing one more line. Of a hollow the place is its centre, the normal is that at its middle, turned, the length minus its radius, the thickness the cosine of half its opening. */
    void addLine(float px, float py, float nx, float ny, float length, float thickness) {
        ensure(0, 1);
        int l = line(lineCount++);
        line[l] = px;
        line[l + 1] = py;
        line[l + OutlineShape.NX] = nx;
        line[l + OutlineShape.NY] = ny;
        line[l + OutlineShape.LENGTH] = length;
        line[l + OutlineShape.THICKNESS] = thickness;
        all[count - 1].endLine = lineCount;
    }

    boolean isBent(int c) {
        return corner[corner(c) + OutlineShape.BEND] > 0f;
    }

    /** The point of a core that is farthest in a direction, which is a unit: by how much its x differs from that of the corner. */
    float bentX(int c, float nx, float ny) {
        return isBent(c) ? bent(c, endOf(c, nx, ny), nx) : 0f;
    }

    float bentY(int c, float nx, float ny) {
        return isBent(c) ? bent(c, endOf(c, nx, ny) + 1, ny) : 0f;
    }

    private float bent(int c, int end, float along) {
        int at = corner(c);
        return turnedCorner[at + OutlineShape.BEND] * (end < OutlineShape.FROM_X ? along : turnedCorner[at + end]);
    }

    /** The end of a cone that is nearer to a direction beyond it, as the number of an element; 0 if the cone has the direction. */
    private int endOf(int c, float nx, float ny) {
        if (isInCone(c, nx, ny, 0f)) {
            return 0;
        }
        int at = corner(c);
        float from = turnedCorner[at + OutlineShape.FROM_X] * nx + turnedCorner[at + OutlineShape.FROM_Y] * ny;
        float to = turnedCorner[at + OutlineShape.TO_X] * nx + turnedCorner[at + OutlineShape.TO_Y] * ny;
        return from > to ? OutlineShape.FROM_X : OutlineShape.TO_X;
    }

    /** The same of an arc of a thing, which may have several corners. */
    int endOf(RigidThing t, int c, float nx, float ny) {
        return isOfArc(t, c, nx, ny) ? 0 : endOf(c, nx, ny);
    }

    /** Whether an arc that a corner of a thing goes on as has a direction in its cone; the corner is an end of the arc, or a part of it. */
    boolean isOfArc(RigidThing t, int c, float nx, float ny) {
        int last = t.endCorner - 1;
        int before = c == t.firstCorner ? last : c - 1;
        int after = c == last ? t.firstCorner : c + 1;
        return goesOnAs(c, before, OutlineShape.FROM_X, OutlineShape.TO_X) && isInCone(before, nx, ny, 0f)
                || goesOnAs(c, after, OutlineShape.TO_X, OutlineShape.FROM_X) && isInCone(after, nx, ny, 0f);
    }

    private boolean goesOnAs(int c, int arc, int element, int itsElement) {
        int at = corner(c);
        int to = corner(arc);
        return isBent(arc)
                && arc != c
                && corner[at + element] == corner[to + itsElement]
                && corner[at + element + 1] == corner[to + itsElement + 1]
                && (corner[at + OutlineShape.BEND] + corner[at + OutlineShape.RADIUS] == 0f
                        || corner[at] == corner[to] && corner[at + 1] == corner[to + 1]);
    }

    boolean isRound(int c) {
        int at = corner(c);
        return corner[at + OutlineShape.FROM_X] == 0f && corner[at + OutlineShape.FROM_Y] == 0f;
    }

    boolean isHollow(int l) {
        return line[line(l) + OutlineShape.LENGTH] < 0f;
    }

    /** Sets the angle of a body from what it has turned, and turns its outline. */
    void turn(RigidThing t) {
        setAngle(t);
        place(t);
    }

    /** The same within a step, for what measures look at: not the cones of corners that are not bent. */
    void turnOn(RigidThing t) {
        setAngle(t);
        float c = t.cos;
        float s = t.sin;
        for (int k = t.firstCorner; k < t.endCorner; k++) {
            int at = corner(k);
            rotate(corner, at, turnedCorner, c, s);
            if (corner[at + OutlineShape.BEND] > 0f) {
                rotate(corner, at + OutlineShape.FROM_X, turnedCorner, c, s);
                rotate(corner, at + OutlineShape.TO_X, turnedCorner, c, s);
            }
        }
        turnLines(t, c, s);
    }

    private void setAngle(RigidThing t) {
        int units = Surface.turn(t.angle, t.turned, 1f, 1f);
        // the bits of Rotation.cos and sin, which would each look for the quarter
        int quarter = Rotation.quarter(units);
        double beyond = Rotation.fromQuarter(units, quarter);
        float s = (float) Rotation.sinOfEighth(beyond);
        float c = (float) Rotation.cosOfEighth(beyond);
        boolean odd = (quarter & 1) != 0;
        t.cos = (odd ? s : c) * (1 - (quarter + 1 & 2));
        t.sin = (odd ? c : s) * (1 - (quarter & 2));
    }

    /** Turns the outline of a thing as its cosine and sine are. */
    void place(RigidThing t) {
        float c = t.cos;
        float s = t.sin;
        for (int k = t.firstCorner; k < t.endCorner; k++) {
            int at = corner(k);
            rotate(corner, at, turnedCorner, c, s);
            turnedCorner[at + OutlineShape.RADIUS] = corner[at + OutlineShape.RADIUS];
            turnedCorner[at + OutlineShape.BEND] = corner[at + OutlineShape.BEND];
            rotate(corner, at + OutlineShape.FROM_X, turnedCorner, c, s);
            rotate(corner, at + OutlineShape.TO_X, turnedCorner, c, s);
        }
        turnLines(t, c, s);
        for (int k = t.firstLine; k < t.endLine; k++) {
            int at = line(k);
            turnedLine[at + OutlineShape.LENGTH] = line[at + OutlineShape.LENGTH];
            turnedLine[at + OutlineShape.THICKNESS] = line[at + OutlineShape.THICKNESS];
        }
    }

    private void turnLines(RigidThing t, float c, float s) {
        for (int k = t.firstLine; k < t.endLine; k++) {
            int at = line(k);
            rotate(line, at, turnedLine, c, s);
            rotate(line, at + OutlineShape.NX, turnedLine, c, s);
        }
    }

    private static void rotate(float[] from, int at, float[] to, float c, float s) {
        float x = from[at];
        float y = from[at + 1];
        to[at] = c * x - s * y;
        to[at + 1] = s * x + c * y;
    }

    /** Whether a direction is in the cone of a corner, within a tolerance. */
    boolean isInCone(int c, float nx, float ny, float tolerance) {
        int at = corner(c);
        float fx = turnedCorner[at + OutlineShape.FROM_X];
        float fy = turnedCorner[at + OutlineShape.FROM_Y];
        float tx = turnedCorner[at + OutlineShape.TO_X];
        float ty = turnedCorner[at + OutlineShape.TO_Y];
        if (isRound(c)) {
            return true;
        }
        // the cone is half a turn at most: then its middle is 0
        return fx * ny - fy * nx >= -tolerance
                && tx * ny - ty * nx <= tolerance
                && (fx + tx) * nx + (fy + ty) * ny >= -Math.abs(tolerance);
    }

    /** Whether a place, against that of a body, is inside its core. */
    boolean isInside(RigidThing t, float px, float py) {
        float far = t.shape.coreReach();
        if (px * px + py * py > far * far) {
            return false;
        }
        float[] p = t.shape.core();
        float lx = t.cos * px + t.sin * py;
        float ly = t.cos * py - t.sin * px;
        boolean in = false;
        for (int a = 0, b = p.length - 2; a < p.length; b = a, a += 2) {
            if (p[a + 1] > ly != p[b + 1] > ly && lx < (p[b] - p[a]) * (ly - p[a + 1]) / (p[b + 1] - p[a + 1]) + p[a]) {
                in = !in;
            }
        }
        return in;
    }

    long bytes() {
        return 196L * all.length + 8L * (corner.length + line.length);
    }
}
