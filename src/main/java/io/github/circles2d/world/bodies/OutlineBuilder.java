package io.github.circles2d.world.bodies;

import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.terrain.ChainPath;
import java.util.Arrays;

/** The lines and corners of a path that is closed, simple and anticlockwise, in order. */
final class OutlineBuilder {
    // of an element: a place, a radius or thickness, the normals at its ends, whether it is a line, the length of that,
    // and how much longer its core
    // is at both ends, where reflex corners are
    static final int X = 0;
    static final int Y = 1;
    static final int R = 2;
    static final int AX = 3;
    static final int AY = 4;
    static final int BX = 5;
    static final int BY = 6;
    static final int IS_LINE = 7;
    static final int SPAN = 8;
    private static final int BEFORE = 9;
    private static final int AFTER = 10;

    /** The radius of the core of an arc. */
    private static final int BEND = 11;

    static final int STRIDE = 12;

    /** A sine: pieces that meet at less are smooth. */
    private static final double SMOOTH = 1e-4;

    /** Radians. */
    private static final double OVERLAP = 1e-4;

    /** Share of a line: if no more is left between rounded corners, these meet. */
    private static final double GONE = 1e-6;

    private static final double QUARTER = Math.PI / 2;

    /** By the least width of a path, which is found by lines within arcs: an arc of a smaller radius is a round end if it meets all smoothly. */
    private static final double ROUND = 0.505;

    /** By the least width: how deep the core of an arc lies that is no round end. */
    private static final double DEPTH = 0.25;

    private final ChainPath path;
    private final double r;
    private final double width;
    private double[] elements = new double[16 * STRIDE];
    private int count;
    private int lineCount;

    // by piece: the unit tangents at both ends
    private final double[] startX;
    private final double[] startY;
    private final double[] endX;
    private final double[] endY;

    /** By joint of two lines: how far the ends of both cores lie before it, in roundings; 0 elsewhere. */
    private final double[] back;

    /** Width: the least one of the path. */
    OutlineBuilder(ChainPath path, double r, double width) {
        this.path = path;
        this.r = r;
        this.width = width;
        int n = path.pieces();
        startX = new double[n];
        startY = new double[n];
        endX = new double[n];
        endY = new double[n];
        back = new double[n];
        findTangents();
        for (int k = 0; k < n; k++) {
            addJoint(k);
            if (path.turn(k) == 0) {
                addLine(k);
            } else {
                addArc(k);
            }
        }
    }

    /** The rounding at which the first of the cores of the lines has no length. */
    static double mostRounding(ChainPath path) {
        OutlineBuilder b = new OutlineBuilder(path, 0, 0);
        double most = Double.POSITIVE_INFINITY;
        for (int k = 0; k < path.pieces(); k++) {
            double lost = b.back[k] + b.back[b.next(k)];
            if (path.turn(k) == 0 && lost > 0) {
                most = Math.min(most, b.length(k) / lost);
            }
        }
        return most;
    }

    private int next(int k) {
        return k + 1 == path.pieces() ? 0 : k + 1;
    }

    private int before(int k) {
        return k == 0 ? path.pieces() - 1 : k - 1;
    }

    private double length(int k) {
        double dx = (double) path.x(next(k)) - path.x(k);
        double dy = (double) path.y(next(k)) - path.y(k);
        return Math.sqrt(dx * dx + dy * dy);
    }

    private void findTangents() {
        int n = path.pieces();
        for (int k = 0; k < n; k++) {
            if (path.turn(k) == 0) {
                double length = length(k);
                startX[k] = ((double) path.x(next(k)) - path.x(k)) / length;
                startY[k] = ((double) path.y(next(k)) - path.y(k)) / length;
                endX[k] = startX[k];
                endY[k] = startY[k];
            } else {
                double dx = (double) path.x(k) - path.centreX(k);
                double dy = (double) path.y(k) - path.centreY(k);
                double radius = Math.sqrt(dx * dx + dy * dy);
                double cos = Rotation.cos((int) path.turn(k));
                double sin = Rotation.sin((int) path.turn(k));
                startX[k] = -dy / radius;
                startY[k] = dx / radius;
                endX[k] = cos * startX[k] - sin * startY[k];
                endY[k] = sin * startX[k] + cos * startY[k];
            }
        }
        for (int k = 0; k < n; k++) {
            int h = before(k);
            if (path.turn(k) == 0 && path.turn(h) == 0) {
                // the tangent of half the angle by which the lines turn
                back[k] = sine(h, k) / (1 + cosine(h, k));
            }
        }
    }

    private double sine(int h, int k) {
        return endX[h] * startY[k] - endY[h] * startX[k];
    }

    private double cosine(int h, int k) {
        return endX[h] * startX[k] + endY[h] * startY[k];
    }

    /** The corner between a piece and the one before it, if there is one. */
    private void addJoint(int k) {
        int h = before(k);
        if (!(sine(h, k) > SMOOTH)) {
            return;
        }
        boolean rounded = path.turn(k) == 0 && path.turn(h) == 0;
        double inset = rounded ? r : 0;
        double x = path.x(k) + inset * (startX[k] * back[k] - startY[k]);
        double y = path.y(k) + inset * (startY[k] * back[k] + startX[k]);
        add(x, y, inset, endY[h], -endX[h], startY[k], -startX[k]);
    }

    private void addLine(int k) {
        double length = length(k) - r * (back[k] + back[next(k)]);
        if (Math.abs(length) <= GONE * length(k)) {
            return;
        }
        if (!(length > 0)) {
            throw new IllegalArgumentException("line " + k + " of the outline is " + (float) length(k)
                    + " long, too short for a rounding of " + (float) r);
        }
        double before = r * Math.max(0, -back[k]);
        double after = r * Math.max(0, -back[next(k)]);
        double along = r * back[k] + before;
        double x = path.x(k) + (along * startX[k] - r * startY[k]);
        double y = path.y(k) + (along * startY[k] + r * startX[k]);
        int e = add(x, y, r, startY[k], -startX[k], startY[k], -startX[k]);
        elements[e + IS_LINE] = 1;
        elements[e + SPAN] = length - before - after;
        elements[e + BEFORE] = before;
        elements[e + AFTER] = after;
        lineCount++;
    }

    private void addArc(int k) {
        double radians = path.turn(k) * Rotation.RADIANS_PER_UNIT;
        if (radians < 0) {
            throw new IllegalArgumentException("piece " + k
                    + " of the outline is an arc that bends inwards, but arcs of outlines must bend outwards");
        }
        double dx = (double) path.x(k) - path.centreX(k);
        double dy = (double) path.y(k) - path.centreY(k);
        double radius = Math.sqrt(dx * dx + dy * dy);
        boolean sharp = Math.abs(sine(before(k), k)) > SMOOTH || Math.abs(sine(k, next(k))) > SMOOTH;
        boolean roundEnd = !sharp && radius <= ROUND * width;
        double bend = roundEnd ? 0 : Math.max(0, radius - DEPTH * width);
        int parts = (int) Math.max(1, Math.ceil(radians / QUARTER - 1e-9));
        double fromX = startY[k];
        double fromY = -startX[k];
        for (int part = 1; part <= parts; part++) {
            long units = path.turn(k) * part / parts;
            double cos = Rotation.cos((int) units);
            double sin = Rotation.sin((int) units);
            double toX = part == parts ? endY[k] : cos * startY[k] + sin * startX[k];
            double toY = part == parts ? -endX[k] : sin * startY[k] - cos * startX[k];
            int e = add(path.centreX(k), path.centreY(k), radius, fromX, fromY, toX, toY);
            elements[e + BEND] = bend;
            fromX = toX;
            fromY = toY;
        }
    }

    private int add(double x, double y, double radius, double ax, double ay, double bx, double by) {
        if ((count + 1) * STRIDE > elements.length) {
            elements = Arrays.copyOf(elements, 2 * elements.length);
        }
        int e = STRIDE * count++;
        elements[e + X] = x;
        elements[e + Y] = y;
        elements[e + R] = radius;
        elements[e + AX] = ax;
        elements[e + AY] = ay;
        elements[e + BX] = bx;
        elements[e + BY] = by;
        return e;
    }

    int count() {
        return count;
    }

    void copy(int e, double[] to) {
        System.arraycopy(elements, STRIDE * e, to, 0, STRIDE);
    }

    /** Of a line or arc, at a length or an angle from its start. */
    static double pointX(double[] e, double at) {
        return e[IS_LINE] != 0 ? e[X] + e[R] * e[AX] - at * e[AY] : e[X] + e[R] * normalX(e, at);
    }

    static double pointY(double[] e, double at) {
        return e[IS_LINE] != 0 ? e[Y] + e[R] * e[AY] + at * e[AX] : e[Y] + e[R] * normalY(e, at);
    }

    private static double normalX(double[] e, double at) {
        int units = (int) Rotation.units(at);
        return at == 0 ? e[AX] : Rotation.cos(units) * e[AX] - Rotation.sin(units) * e[AY];
    }

    private static double normalY(double[] e, double at) {
        int units = (int) Rotation.units(at);
        return at == 0 ? e[AY] : Rotation.sin(units) * e[AX] + Rotation.cos(units) * e[AY];
    }

    OutlineMass mass() {
        return new OutlineMass(elements, count);
    }

    float[] corners(double centreX, double centreY) {
        float[] to = new float[OutlineShape.CORNER_STRIDE * (count - lineCount)];
        int at = 0;
        for (int e = 0; e < count * STRIDE; e += STRIDE) {
            if (elements[e + IS_LINE] == 0) {
                to[at] = (float) (elements[e + X] - centreX);
                to[at + 1] = (float) (elements[e + Y] - centreY);
                for (int k = OutlineShape.FROM_X; k <= OutlineShape.TO_Y; k++) {
                    to[at + k] = (float) elements[e + k];
                }
                to[at + OutlineShape.RADIUS] = (float) (elements[e + R] - elements[e + BEND]);
                to[at + OutlineShape.BEND] = (float) elements[e + BEND];
                if (isPartOfArc(e)) {
                    to[at + OutlineShape.FROM_X] = (float) (elements[e + AX] + OVERLAP * elements[e + AY]);
                    to[at + OutlineShape.FROM_Y] = (float) (elements[e + AY] - OVERLAP * elements[e + AX]);
                }
                at += OutlineShape.CORNER_STRIDE;
            }
        }
        return to;
    }

    /** Whether the element before is a part of the same arc: its cone goes on a little into that one's, so that no way lies between both. */
    private boolean isPartOfArc(int e) {
        int before = e == 0 ? (count - 1) * STRIDE : e - STRIDE;
        return before != e
                && elements[e + BEND] == 0
                && elements[before + IS_LINE] == 0
                && elements[before + X] == elements[e + X]
                && elements[before + Y] == elements[e + Y];
    }

    /** As {@link OutlineShape#edges}. The centre of a line is its start. */
    double[] edges(double centreX, double centreY) {
        double[] to = new double[OutlineShape.EDGE_STRIDE * count];
        double[] element = new double[STRIDE];
        int n = 0;
        for (int e = 0; e < count; e++) {
            copy(e, element);
            boolean line = element[IS_LINE] != 0;
            if (line || element[R] > 0) {
                to[n] = pointX(element, 0) - centreX;
                to[n + 1] = pointY(element, 0) - centreY;
                to[n + OutlineShape.CENTRE_X] = line ? to[n] : element[X] - centreX;
                to[n + OutlineShape.CENTRE_Y] = line ? to[n + 1] : element[Y] - centreY;
                to[n + OutlineShape.EDGE_RADIUS] = line ? 0 : element[R];
                n += OutlineShape.EDGE_STRIDE;
            }
        }
        return withoutPoints(to, n);
    }

    /** Leaves out edges without length. */
    private static double[] withoutPoints(double[] edges, int n) {
        int kept = 0;
        for (int e = 0; e < n; e += OutlineShape.EDGE_STRIDE) {
            int next = e + OutlineShape.EDGE_STRIDE == n ? 0 : e + OutlineShape.EDGE_STRIDE;
            if (edges[e] != edges[next] || edges[e + 1] != edges[next + 1]) {
                System.arraycopy(edges, e, edges, kept, OutlineShape.EDGE_STRIDE);
                kept += OutlineShape.EDGE_STRIDE;
            }
        }
        return Arrays.copyOf(edges, kept);
    }

    float[] lines(double centreX, double centreY) {
        float[] to = new float[OutlineShape.LINE_STRIDE * lineCount];
        int at = 0;
        for (int e = 0; e < count * STRIDE; e += STRIDE) {
            if (elements[e + IS_LINE] != 0) {
                to[at] = (float) (elements[e + X] + elements[e + BEFORE] * elements[e + AY] - centreX);
                to[at + 1] = (float) (elements[e + Y] - elements[e + BEFORE] * elements[e + AX] - centreY);
                to[at + OutlineShape.NX] = (float) elements[e + AX];
                to[at + OutlineShape.NY] = (float) elements[e + AY];
                to[at + OutlineShape.LENGTH] =
                        (float) (elements[e + BEFORE] + elements[e + SPAN] + elements[e + AFTER]);
                to[at + OutlineShape.THICKNESS] = (float) elements[e + R];
                at += OutlineShape.LINE_STRIDE;
            }
        }
        return to;
    }

    /** Both ends of the cores of lines, and ends and middles of arcs that are no rounded corners. */
    float[] core(double centreX, double centreY) {
        float[] to = new float[6 * count];
        int n = 0;
        for (int e = 0; e < count * STRIDE; e += STRIDE) {
            boolean line = elements[e + IS_LINE] != 0;
            double radius = elements[e + R];
            if (!line && radius == r) {
                continue;
            }
            double x = elements[e + X] - centreX;
            double y = elements[e + Y] - centreY;
            if (line) {
                to[n++] = (float) (x + elements[e + BEFORE] * elements[e + AY]);
                to[n++] = (float) (y - elements[e + BEFORE] * elements[e + AX]);
                double end = elements[e + SPAN] + elements[e + AFTER];
                to[n++] = (float) (x - end * elements[e + AY]);
                to[n++] = (float) (y + end * elements[e + AX]);
            } else {
                double inner = Math.max(0, radius - r);
                to[n++] = (float) (x + inner * elements[e + AX]);
                to[n++] = (float) (y + inner * elements[e + AY]);
                double mx = elements[e + AX] + elements[e + BX];
                double my = elements[e + AY] + elements[e + BY];
                double m = Math.sqrt(mx * mx + my * my);
                to[n++] = (float) (x + inner * mx / m);
                to[n++] = (float) (y + inner * my / m);
                to[n++] = (float) (x + inner * elements[e + BX]);
                to[n++] = (float) (y + inner * elements[e + BY]);
            }
        }
        return Arrays.copyOf(to, n);
    }
}
