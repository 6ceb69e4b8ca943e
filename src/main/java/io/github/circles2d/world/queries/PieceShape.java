package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.PieceRow;

/**
 * A piece of terrain, or an edge of a body, and the exact tests that decide what a search finds. They compute in double precision, from the
 * floats of a piece's row, in the order in which they are written.
 */
final class PieceShape extends ThingShape {
    /** More than what two pieces differ by where they are joined, by its share of coordinates: ends are rounded. */
    private static final double JOINT = 0x1p-23;

    private boolean isArc;
    private boolean isOneSided;

    /** Of an arc: circles are inside. */
    private boolean isInner;

    private boolean isAllAround;

    /** Of an arc: no more than half a circle. */
    private boolean isShallow;

    // the start of a line, the centre of an arc
    private double x;
    private double y;

    // the unit vector of a line
    private double tx;
    private double ty;

    /** Of a line; the radius of an arc. */
    private double length;

    private double thickness;

    // both ends, anticlockwise of an arc, relative to (x, y), and how far beyond them a ray still meets the piece
    private double firstX;
    private double firstY;
    private double lastX;
    private double lastY;
    private double slackFirst;
    private double slackLast;

    // what was nearest to the last point
    private double offX;
    private double offY;
    private double nearX;
    private double nearY;
    private boolean isFace;

    /** Takes a piece, moved by so much. */
    void take(float[] rows, int[] traits, int piece, boolean oneSided, double shiftX, double shiftY) {
        int row = PieceRow.of(piece);
        int shape = traits[PieceRow.traits(piece) + PieceRow.SHAPE];
        isArc = PieceRow.form(shape) == PieceRow.ARC;
        isOneSided = oneSided;
        isInner = isArc && (shape & PieceRow.SOLID_OUTSIDE) != 0;
        x = rows[row + PieceRow.X] + shiftX;
        y = rows[row + PieceRow.Y] + shiftY;
        thickness = isArc ? 0 : rows[row + PieceRow.THICKNESS];
        boolean turned = isInner; // its end comes first
        firstX = rows[row + (turned ? PieceRow.END_X : PieceRow.START_X)];
        firstY = rows[row + (turned ? PieceRow.END_Y : PieceRow.START_Y)];
        lastX = rows[row + (turned ? PieceRow.START_X : PieceRow.END_X)];
        lastY = rows[row + (turned ? PieceRow.START_Y : PieceRow.END_Y)];
        float spread = rows[row + PieceRow.SPREAD];
        isAllAround = isArc && spread == PieceRow.ALL_AROUND;
        isShallow = spread >= 0f;
        length = rows[row + PieceRow.LENGTH];
        if (!isArc) {
            findTangent();
        }
        double slack = (Math.abs(x) + Math.abs(y) + length) * JOINT;
        int first = turned ? PieceRow.endJoint(shape) : PieceRow.startJoint(shape);
        int last = turned ? PieceRow.startJoint(shape) : PieceRow.endJoint(shape);
        slackFirst = first == PieceRow.FREE ? 0 : slack;
        slackLast = last == PieceRow.FREE ? 0 : slack;
    }

    /**
     * Takes an edge that is met from both sides: a line or, if the radius is more than 0, an arc around a centre, anticlockwise, by half a turn at
     * most. A path still meets it so far beyond its ends.
     */
    void take(
            double centreX,
            double centreY,
            double radius,
            double fromX,
            double fromY,
            double toX,
            double toY,
            double slack) {
        isArc = radius > 0;
        isOneSided = false;
        isInner = false;
        isAllAround = false;
        isShallow = true;
        thickness = 0;
        x = isArc ? centreX : fromX;
        y = isArc ? centreY : fromY;
        firstX = fromX - x;
        firstY = fromY - y;
        lastX = toX - x;
        lastY = toY - y;
        length = radius;
        if (!isArc) {
            findTangent();
        }
        slackFirst = slack;
        slackLast = slack;
    }

    private void findTangent() {
        tx = lastX - firstX;
        ty = lastY - firstY;
        length = Math.sqrt(tx * tx + ty * ty);
        tx /= length;
        ty /= length;
    }

    @Override
    boolean overlapsDisc(double px, double py, double reach) {
        near(px, py);
        double s = thickness + reach;
        return squared() <= s * s;
    }

    /** Negative inside one that is thick. */
    @Override
    double distance(double px, double py) {
        near(px, py);
        return Math.sqrt(squared()) - thickness;
    }

    @Override
    boolean overlapsBox(double minX, double minY, double maxX, double maxY) {
        return isArc ? arcMeetsBox(minX, minY, maxX, maxY) : lineMeetsBox(minX, minY, maxX, maxY);
    }

    private boolean lineMeetsBox(double minX, double minY, double maxX, double maxY) {
        if (crossesBox(minX - x, minY - y, maxX - x, maxY - y)) {
            return true;
        }
        double square = thickness * thickness;
        return thickness > 0
                && (squaredToBox(x + firstX, y + firstY, minX, minY, maxX, maxY) <= square
                        || squaredToBox(x + lastX, y + lastY, minX, minY, maxX, maxY) <= square
                        || overlapsDisc(minX, minY, 0)
                        || overlapsDisc(maxX, minY, 0)
                        || overlapsDisc(minX, maxY, 0)
                        || overlapsDisc(maxX, maxY, 0));
    }

    /** Whether no axis divides the line from a box that is relative to its start: neither that of a coordinate, nor its normal. */
    private boolean crossesBox(double minX, double minY, double maxX, double maxY) {
        if (Math.min(firstX, lastX) > maxX
                || Math.max(firstX, lastX) < minX
                || Math.min(firstY, lastY) > maxY
                || Math.max(firstY, lastY) < minY) {
            return false;
        }
        double ex = lastX - firstX;
        double ey = lastY - firstY;
        double lowX = minX - firstX;
        double lowY = minY - firstY;
        double highX = maxX - firstX;
        double highY = maxY - firstY;
        double a = ex * lowY - ey * lowX;
        double b = ex * lowY - ey * highX;
        double c = ex * highY - ey * lowX;
        double d = ex * highY - ey * highX;
        return Math.min(Math.min(a, b), Math.min(c, d)) <= 0 && Math.max(Math.max(a, b), Math.max(c, d)) >= 0;
    }

    private static double squaredToBox(double px, double py, double minX, double minY, double maxX, double maxY) {
        double dx = Math.max(Math.max(minX - px, px - maxX), 0);
        double dy = Math.max(Math.max(minY - py, py - maxY), 0);
        return dx * dx + dy * dy;
    }

    private boolean arcMeetsBox(double minX, double minY, double maxX, double maxY) {
        double anyX = isAllAround ? x + length : x + firstX;
        double anyY = isAllAround ? y : y + firstY;
        return squaredToBox(anyX, anyY, minX, minY, maxX, maxY) == 0
                || !isAllAround && squaredToBox(x + lastX, y + lastY, minX, minY, maxX, maxY) == 0
                || arcMeetsSide(minX - x, minY - y, maxY - y, false)
                || arcMeetsSide(maxX - x, minY - y, maxY - y, false)
                || arcMeetsSide(minY - y, minX - x, maxX - x, true)
                || arcMeetsSide(maxY - y, minX - x, maxX - x, true);
    }

    /** Whether the arc crosses a side of a box, along which one coordinate is the same and the other goes from low to high. */
    private boolean arcMeetsSide(double same, double low, double high, boolean isLevel) {
        double square = length * length - same * same;
        if (square < 0) {
            return false;
        }
        double other = Math.sqrt(square);
        return arcMeetsSideAt(same, other, low, high, isLevel) || arcMeetsSideAt(same, -other, low, high, isLevel);
    }

    private boolean arcMeetsSideAt(double same, double other, double low, double high, boolean isLevel) {
        return other >= low && other <= high && (isLevel ? opens(other, same, 0) : opens(same, other, 0));
    }

    /** Whether the direction of a point is in the opening of the arc, or this far from it with a slack of 1. */
    private boolean opens(double ox, double oy, double slack) {
        if (isAllAround) {
            return true;
        }
        // the sine of the angle, times both lengths
        boolean behindFirst = firstX * oy - firstY * ox >= -slack * slackFirst * length;
        boolean beforeLast = ox * lastY - oy * lastX >= -slack * slackLast * length;
        return isShallow ? behindFirst && beforeLast : behindFirst || beforeLast;
    }

    /** Finds the nearest point of the line or arc itself, without its thickness. */
    private void near(double px, double py) {
        offX = px - x;
        offY = py - y;
        if (isArc) {
            nearArc();
        } else {
            double along = (offX - firstX) * tx + (offY - firstY) * ty;
            isFace = along > 0 && along < length;
            double t = Math.min(Math.max(along, 0), length);
            nearX = along >= length ? lastX : firstX + tx * t;
            nearY = along >= length ? lastY : firstY + ty * t;
        }
    }

    private void nearArc() {
        double d = Math.sqrt(offX * offX + offY * offY);
        isFace = d > 0 && opens(offX, offY, 0);
        if (isFace) {
            nearX = offX * (length / d);
            nearY = offY * (length / d);
        } else if (isAllAround) { // from the centre all points are as near
            nearX = length;
            nearY = 0;
        } else {
            double toFirst = square(offX - firstX) + square(offY - firstY);
            double toLast = square(offX - lastX) + square(offY - lastY);
            nearX = toFirst <= toLast ? firstX : lastX;
            nearY = toFirst <= toLast ? firstY : lastY;
        }
    }

    private static double square(double a) {
        return a * a;
    }

    /** The square of the distance from the last point to the line or arc. */
    private double squared() {
        if (isArc && isFace) {
            return square(Math.sqrt(offX * offX + offY * offY) - length);
        }
        return square(offX - nearX) + square(offY - nearY);
    }

    /** How far a point is in front of the line or of the circle of the arc. */
    private double height(double ox, double oy) {
        if (isArc) {
            double out = Math.sqrt(ox * ox + oy * oy) - length;
            return isInner ? -out : out;
        }
        return (ox - firstX) * ty - (oy - firstY) * tx;
    }

    // ---- casts

    /** Of one that is solid on one side from there. */
    @Override
    double castDistance(double px, double py, double reach, double ux, double uy, double most) {
        double s = reach + thickness;
        if (overlapsDisc(px, py, reach)) {
            if (!isOneSided || height(px - x, py - y) >= 0) {
                return 0;
            }
            if (!isArc) {
                return CircleTests.NONE; // from behind, and it touches a line no second time
            }
        }
        double first = isArc ? castAtArc(px - x, py - y, s, ux, uy) : castAtLine(px - x, py - y, s, ux, uy);
        return first <= most ? first : CircleTests.NONE;
    }

    /** Infinite if it does not touch it. */
    private double castAtLine(double ox, double oy, double s, double ux, double uy) {
        double height = height(ox, oy);
        double side = height >= 0 ? 1 : -1;
        double descent = -side * (ux * ty - uy * tx);
        double gap = side * height - s;
        double first = Double.POSITIVE_INFINITY;
        boolean inFront = side > 0;
        if (gap > 0 && descent > 0) {
            double t = gap / descent;
            double along = (ox - firstX + t * ux) * tx + (oy - firstY + t * uy) * ty;
            if (along >= -slackFirst && along <= length + slackLast) {
                first = t;
            }
        }
        double atFirst = castAtEnd(ox - firstX, oy - firstY, s, ux, uy);
        double atLast = castAtEnd(ox - lastX, oy - lastY, s, ux, uy);
        double atEnd = Math.min(atFirst, atLast);
        if (atEnd < first) {
            first = atEnd;
            inFront = s == 0 ? side > 0 : height(ox + atEnd * ux, oy + atEnd * uy) >= 0;
        }
        return isOneSided && !inFront ? Double.POSITIVE_INFINITY : first;
    }

    /** The same at a disc of this radius around an end, from (-ox, -oy) of it. */
    private static double castAtEnd(double ox, double oy, double s, double ux, double uy) {
        double along = -(ox * ux + oy * uy);
        double across = ox * uy - oy * ux;
        double square = s * s - across * across;
        if (along <= 0 || square < 0 || ox * ox + oy * oy <= s * s) {
            return Double.POSITIVE_INFINITY;
        }
        return Math.max(along - Math.sqrt(square), 0);
    }

    /** Arcs are solid on one side: it comes to the outer side from outside, to the inner one from within, or to an end in front. */
    private double castAtArc(double ox, double oy, double s, double ux, double uy) {
        double first = isInner ? castFromWithin(ox, oy, s, ux, uy) : castFromOutside(ox, oy, s, ux, uy);
        if (isAllAround || s == 0) { // the face of an arc has its ends
            return first;
        }
        double atFirst = castAtEnd(ox - firstX, oy - firstY, s, ux, uy);
        if (atFirst < first && height(ox + atFirst * ux, oy + atFirst * uy) >= 0) {
            first = atFirst;
        }
        double atLast = castAtEnd(ox - lastX, oy - lastY, s, ux, uy);
        if (atLast < first && height(ox + atLast * ux, oy + atLast * uy) >= 0) {
            first = atLast;
        }
        return first;
    }

    private double castFromOutside(double ox, double oy, double s, double ux, double uy) {
        double t = castAtEnd(ox, oy, length + s, ux, uy);
        return t < Double.POSITIVE_INFINITY && opens(ox + t * ux, oy + t * uy, 1) ? t : Double.POSITIVE_INFINITY;
    }

    private double castFromWithin(double ox, double oy, double s, double ux, double uy) {
        double along = -(ox * ux + oy * uy);
        double across = ox * uy - oy * ux;
        double room = length - s;
        double square = room * room - across * across;
        if (room <= 0 || square < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double t = along + Math.sqrt(square);
        return t > 0 && opens(ox + t * ux, oy + t * uy, 1) ? t : Double.POSITIVE_INFINITY;
    }

    // ---- hits

    /**
     * Finds the unit vector from the piece to a point that a disc of radius reach has come to along (ux, uy). Of a ray it is the normal of
     * the side that it meets. Without any direction it points against the path, and up without a path.
     */
    @Override
    void normalAt(double px, double py, double reach, double ux, double uy) {
        near(px, py);
        if (reach + thickness > 0 && normal()) {
            return;
        }
        double side = isOneSided ? 1 : -Math.signum(faceX() * ux + faceY() * uy);
        boolean hasPath = ux != 0 || uy != 0;
        double nx = side != 0 ? side * faceX() : 0 - ux;
        double ny = side != 0 ? side * faceY() : hasPath ? 0 - uy : 1;
        normalX = nx + 0.0; // no negative zeros
        normalY = ny + 0.0;
    }

    /** Finds the unit vector from the piece to a point; from a point on it, that of its front. */
    @Override
    void normalFrom(double px, double py) {
        near(px, py);
        if (!normal()) {
            normalX = faceX();
            normalY = faceY();
        }
        surfaceX = x + nearX + normalX * thickness;
        surfaceY = y + nearY + normalY * thickness;
    }

    /** Returns false if the nearest point is the last point itself. */
    private boolean normal() {
        double nx = offX - nearX;
        double ny = offY - nearY;
        double norm = Math.sqrt(nx * nx + ny * ny);
        if (norm == 0) {
            return false;
        }
        normalX = nx / norm;
        normalY = ny / norm;
        return true;
    }

    /** The normal of the front, at the last point. */
    double faceX() {
        return isArc ? (isInner ? -nearX : nearX) / length : ty;
    }

    double faceY() {
        return isArc ? (isInner ? -nearY : nearY) / length : -tx;
    }

    /** The point of the line or arc itself that was nearest to the last point. */
    double nearestX() {
        return x + nearX;
    }

    double nearestY() {
        return y + nearY;
    }
}
