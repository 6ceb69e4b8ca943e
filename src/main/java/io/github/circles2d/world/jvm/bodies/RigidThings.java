package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.model.Surface;
import java.util.Arrays;

/**
 * What takes part in contacts of rigid bodies in a step: the bodies, and the pieces of terrain, walls and circles near to them. All are alike: a
 * place, an angle, velocities, and an outline of corners and lines, which turns with them.
 *
 * <p>A place is a base, which stays for a step, and the displacement since, as those of circles.
 */
final class RigidThings {
    int count;

    /** The first things are the bodies, in the order of their ids. */
    int bodies;

    /** {@link RigidStep#BODY_BODY} of a body, and so on. */
    int[] type = new int[0];

    int[] id = new int[0];
    float[] x = new float[0];
    float[] y = new float[0];
    float[] dx = new float[0];
    float[] dy = new float[0];
    int[] angle = new int[0];

    /** Of bodies: by how much they have turned in the step, in radians. */
    float[] turned = new float[0];

    float[] cos = new float[0];
    float[] sin = new float[0];
    float[] vx = new float[0];
    float[] vy = new float[0];
    float[] omega = new float[0];

    /** Within a sub-step: velocities before impulses. */
    float[] beforeX = new float[0];

    float[] beforeY = new float[0];
    float[] beforeOmega = new float[0];

    /** Inverse mass and inertia; 0 of what contacts do not move. */
    float[] w = new float[0];

    float[] i = new float[0];

    /** The same, also of what sleeps, which moves others as if it would give way. */
    float[] ownW = new float[0];

    float[] ownI = new float[0];

    /** Lengths of contacts are measured by it. */
    float[] thin = new float[0];

    float[] reach = new float[0];
    float[] restitution = new float[0];
    float[] friction = new float[0];
    float[] rolling = new float[0];
    float[] belt = new float[0];

    /** Speed by gravity and forces in a sub-step, also of a body that sleeps, which does not take it. */
    float[] gainX = new float[0];

    float[] gainY = new float[0];
    float[] gainOmega = new float[0];
    int[] kind = new int[0];

    /** Of a body: whether it sleeps. */
    boolean[] asleep = new boolean[0];

    /** Of a piece that lets pass what comes from behind. */
    boolean[] oneWay = new boolean[0];

    /** Those that {@link #add} sets to 0. */
    private float[][] zeroAtFirst = {};

    int[] firstCorner = new int[0];
    int[] corners = new int[0];
    int[] firstLine = new int[0];
    int[] lines = new int[0];

    /** Null of what is no body. */
    OutlineShape[] shape = new OutlineShape[0];

    /** Corners and lines against the place of their thing, as they lie and as they have turned; {@link OutlineShape} numbers the elements. */
    float[] corner = new float[0];

    float[] turnedCorner = new float[0];
    float[] line = new float[0];
    float[] turnedLine = new float[0];
    private int cornerCount;
    private int lineCount;

    /** Forgets the things from one on, which have been added last. */
    void truncate(int from) {
        if (from < count) {
            cornerCount = firstCorner[from];
            lineCount = firstLine[from];
            count = from;
        }
    }

    /** Whether a thing is a body with an outline; nobody else has made it. */
    boolean isBody(int t, int itsId, OutlineShape outline) {
        return t < bodies && id[t] == itsId && shape[t] == outline;
    }

    static int corner(int c) {
        return OutlineShape.CORNER_STRIDE * c;
    }

    static int line(int l) {
        return OutlineShape.LINE_STRIDE * l;
    }

    /** One more thing without corners and lines, at rest and unturned. */
    int add(int itsType, int itsId, float atX, float atY) {
        if (count == type.length) {
            grow(Math.max(64, 2 * count));
        }
        int t = count++;
        type[t] = itsType;
        id[t] = itsId;
        x[t] = atX;
        y[t] = atY;
        angle[t] = 0;
        for (float[] each : zeroAtFirst) {
            each[t] = 0f;
        }
        cos[t] = 1f;
        reach[t] = Float.POSITIVE_INFINITY;
        kind[t] = 0;
        asleep[t] = false;
        oneWay[t] = false;
        shape[t] = null;
        firstCorner[t] = cornerCount;
        corners[t] = 0;
        firstLine[t] = lineCount;
        lines[t] = 0;
        return t;
    }

    private void grow(int n) {
        type = Arrays.copyOf(type, n);
        id = Arrays.copyOf(id, n);
        x = Arrays.copyOf(x, n);
        y = Arrays.copyOf(y, n);
        dx = Arrays.copyOf(dx, n);
        dy = Arrays.copyOf(dy, n);
        angle = Arrays.copyOf(angle, n);
        turned = Arrays.copyOf(turned, n);
        cos = Arrays.copyOf(cos, n);
        sin = Arrays.copyOf(sin, n);
        vx = Arrays.copyOf(vx, n);
        vy = Arrays.copyOf(vy, n);
        omega = Arrays.copyOf(omega, n);
        beforeX = Arrays.copyOf(beforeX, n);
        beforeY = Arrays.copyOf(beforeY, n);
        beforeOmega = Arrays.copyOf(beforeOmega, n);
        w = Arrays.copyOf(w, n);
        i = Arrays.copyOf(i, n);
        ownW = Arrays.copyOf(ownW, n);
        ownI = Arrays.copyOf(ownI, n);
        thin = Arrays.copyOf(thin, n);
        reach = Arrays.copyOf(reach, n);
        restitution = Arrays.copyOf(restitution, n);
        friction = Arrays.copyOf(friction, n);
        rolling = Arrays.copyOf(rolling, n);
        belt = Arrays.copyOf(belt, n);
        gainX = Arrays.copyOf(gainX, n);
        gainY = Arrays.copyOf(gainY, n);
        gainOmega = Arrays.copyOf(gainOmega, n);
        asleep = Arrays.copyOf(asleep, n);
        kind = Arrays.copyOf(kind, n);
        oneWay = Arrays.copyOf(oneWay, n);
        shape = Arrays.copyOf(shape, n);
        firstCorner = Arrays.copyOf(firstCorner, n);
        corners = Arrays.copyOf(corners, n);
        firstLine = Arrays.copyOf(firstLine, n);
        lines = Arrays.copyOf(lines, n);
        zeroAtFirst = new float[][] {
            dx,
            dy,
            turned,
            sin,
            vx,
            vy,
            omega,
            beforeX,
            beforeY,
            beforeOmega,
            w,
            i,
            ownW,
            ownI,
            thin,
            restitution,
            friction,
            rolling,
            belt,
            gainX,
            gainY,
            gainOmega
        };
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

    /** Whether contacts move or turn a thing. */
    boolean gives(int t) {
        return w[t] > 0f || i[t] > 0f;
    }

    /** What a thing takes of {@link #gainX}. */
    float gainX(int t) {
        return asleep[t] ? 0f : gainX[t];
    }

    float gainY(int t) {
        return asleep[t] ? 0f : gainY[t];
    }

    float gainOmega(int t) {
        return asleep[t] ? 0f : gainOmega[t];
    }

    /** Gives the last thing the outline of a body. */
    void setShape(OutlineShape outline) {
        int t = count - 1;
        float[] itsCorners = outline.corners();
        float[] itsLines = outline.lines();
        corners[t] = itsCorners.length / OutlineShape.CORNER_STRIDE;
        lines[t] = itsLines.length / OutlineShape.LINE_STRIDE;
        ensure(corners[t], lines[t]);
        System.arraycopy(itsCorners, 0, corner, corner(cornerCount), itsCorners.length);
        System.arraycopy(itsLines, 0, line, line(lineCount), itsLines.length);
        cornerCount += corners[t];
        lineCount += lines[t];
        shape[t] = outline;
        reach[t] = outline.reach();
        thin[t] = outline.halfThickness();
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
        corners[count - 1]++;
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
        lines[count - 1]++;
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
    int endOf(int t, int c, float nx, float ny) {
        return isOfArc(t, c, nx, ny) ? 0 : endOf(c, nx, ny);
    }

    /** Whether an arc that a corner of a thing goes on as has a direction in its cone; the corner is an end of the arc, or a part of it. */
    boolean isOfArc(int t, int c, float nx, float ny) {
        int last = firstCorner[t] + corners[t] - 1;
        int before = c == firstCorner[t] ? last : c - 1;
        int after = c == last ? firstCorner[t] : c + 1;
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
    void turn(int t) {
        setAngle(t);
        place(t);
    }

    /** The same within a step, for what measures look at: not the cones of corners that are not bent. */
    void turnOn(int t) {
        setAngle(t);
        float c = cos[t];
        float s = sin[t];
        int end = firstCorner[t] + corners[t];
        for (int k = firstCorner[t]; k < end; k++) {
            int at = corner(k);
            rotate(corner, at, turnedCorner, c, s);
            if (corner[at + OutlineShape.BEND] > 0f) {
                rotate(corner, at + OutlineShape.FROM_X, turnedCorner, c, s);
                rotate(corner, at + OutlineShape.TO_X, turnedCorner, c, s);
            }
        }
        turnLines(t, c, s);
    }

    private void setAngle(int t) {
        int units = Surface.turn(angle[t], turned[t], 1f, 1f);
        // the bits of Rotation.cos and sin, which would each look for the quarter
        int quarter = Rotation.quarter(units);
        double beyond = Rotation.fromQuarter(units, quarter);
        float s = (float) Rotation.sinOfEighth(beyond);
        float c = (float) Rotation.cosOfEighth(beyond);
        boolean odd = (quarter & 1) != 0;
        cos[t] = (odd ? s : c) * (1 - (quarter + 1 & 2));
        sin[t] = (odd ? c : s) * (1 - (quarter & 2));
    }

    /** Turns the outline of a thing as its cosine and sine are. */
    void place(int t) {
        float c = cos[t];
        float s = sin[t];
        for (int k = firstCorner[t]; k < firstCorner[t] + corners[t]; k++) {
            int at = corner(k);
            rotate(corner, at, turnedCorner, c, s);
            turnedCorner[at + OutlineShape.RADIUS] = corner[at + OutlineShape.RADIUS];
            turnedCorner[at + OutlineShape.BEND] = corner[at + OutlineShape.BEND];
            rotate(corner, at + OutlineShape.FROM_X, turnedCorner, c, s);
            rotate(corner, at + OutlineShape.TO_X, turnedCorner, c, s);
        }
        turnLines(t, c, s);
        for (int k = firstLine[t]; k < firstLine[t] + lines[t]; k++) {
            int at = line(k);
            turnedLine[at + OutlineShape.LENGTH] = line[at + OutlineShape.LENGTH];
            turnedLine[at + OutlineShape.THICKNESS] = line[at + OutlineShape.THICKNESS];
        }
    }

    private void turnLines(int t, float c, float s) {
        int end = firstLine[t] + lines[t];
        for (int k = firstLine[t]; k < end; k++) {
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
    boolean isInside(int t, float px, float py) {
        float far = shape[t].coreReach();
        if (px * px + py * py > far * far) {
            return false;
        }
        float[] p = shape[t].core();
        float lx = cos[t] * px + sin[t] * py;
        float ly = cos[t] * py - sin[t] * px;
        boolean in = false;
        for (int a = 0, b = p.length - 2; a < p.length; b = a, a += 2) {
            if (p[a + 1] > ly != p[b + 1] > ly && lx < (p[b] - p[a]) * (ly - p[a + 1]) / (p[b + 1] - p[a + 1]) + p[a]) {
                in = !in;
            }
        }
        return in;
    }

    long bytes() {
        return 129L * type.length + 8L * (corner.length + line.length);
    }
}
