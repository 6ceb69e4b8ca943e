package io.github.circles2d.world.bodies;

import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.terrain.ChainPath;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The lines and corners of a path that is closed, simple and anticlockwise, in order. */
final class OutlineBuilder {
    /** A line or an arc of an outline, or a sharp corner, which is an arc without a radius. Lines and arcs lie along the surface, anticlockwise. */
    static final class Element {
        final boolean isLine;

        // where the core of a line begins, or the centre of an arc
        final double x;
        final double y;

        /** How thick a line is; the radius of an arc. */
        final double r;

        // the normals at both ends
        final double ax;
        final double ay;
        final double bx;
        final double by;

        /** The length of a line, without the next two. */
        double span;

        // how much longer the core of a line is at both ends, where reflex corners are
        double before;
        double after;

        /** The radius of the core of an arc. */
        double bend;

        Element(boolean isLine, double x, double y, double r, double ax, double ay, double bx, double by) {
            this.isLine = isLine;
            this.x = x;
            this.y = y;
            this.r = r;
            this.ax = ax;
            this.ay = ay;
            this.bx = bx;
            this.by = by;
        }

        /** The same, so much lower. */
        Element lower(double byX, double byY) {
            Element other = new Element(isLine, x - byX, y - byY, r, ax, ay, bx, by);
            other.span = span;
            other.before = before;
            other.after = after;
            other.bend = bend;
            return other;
        }

        /** The length of a line, or the opening of an arc's cone, radians. */
        double span() {
            return isLine ? span : angle(ax * bx + ay * by, Math.max(0, ax * by - ay * bx));
        }

        /** A point, at a length or an angle from the start. */
        double pointX(double at) {
            return isLine ? x + r * ax - at * ay : x + r * normalX(at);
        }

        double pointY(double at) {
            return isLine ? y + r * ay + at * ax : y + r * normalY(at);
        }

        private double normalX(double at) {
            int units = (int) Rotation.units(at);
            return at == 0 ? ax : Rotation.cos(units) * ax - Rotation.sin(units) * ay;
        }

        private double normalY(double at) {
            int units = (int) Rotation.units(at);
            return at == 0 ? ay : Rotation.sin(units) * ax + Rotation.cos(units) * ay;
        }

        /** Angle in radians of a unit vector's way to another, from 0 to pi, from its cosine and sine. */
        private static double angle(double cos, double sin) {
            int low = 0;
            for (int bit = 1 << 30; bit > 0; bit >>= 1) {
                // the angle is at least that of low + bit if it lies anticlockwise of it
                int next = low + bit;
                if (next > 0 && sin * Rotation.cos(next) - cos * Rotation.sin(next) >= 0) {
                    low = next;
                }
            }
            double c = Rotation.cos(low);
            double s = Rotation.sin(low);
            return low * Rotation.RADIANS_PER_UNIT + (sin * c - cos * s);
        }
    }

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
    final List<Element> elements = new ArrayList<>();

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
        elements.add(new Element(false, x, y, inset, endY[h], -endX[h], startY[k], -startX[k]));
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
        Element e = new Element(true, x, y, r, startY[k], -startX[k], startY[k], -startX[k]);
        e.span = length - before - after;
        e.before = before;
        e.after = after;
        elements.add(e);
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
            Element e = new Element(false, path.centreX(k), path.centreY(k), radius, fromX, fromY, toX, toY);
            e.bend = bend;
            elements.add(e);
            fromX = toX;
            fromY = toY;
        }
    }

    OutlineMass mass() {
        return new OutlineMass(elements);
    }

    float[] corners(double centreX, double centreY) {
        float[] to = new float[OutlineShape.CORNER_STRIDE * elements.size()];
        int at = 0;
        for (int k = 0; k < elements.size(); k++) {
            Element e = elements.get(k);
            if (!e.isLine) {
                boolean isPart = isPartOfArc(k);
                to[at] = (float) (e.x - centreX);
                to[at + 1] = (float) (e.y - centreY);
                to[at + OutlineShape.RADIUS] = (float) (e.r - e.bend);
                to[at + OutlineShape.FROM_X] = (float) (isPart ? e.ax + OVERLAP * e.ay : e.ax);
                to[at + OutlineShape.FROM_Y] = (float) (isPart ? e.ay - OVERLAP * e.ax : e.ay);
                to[at + OutlineShape.TO_X] = (float) e.bx;
                to[at + OutlineShape.TO_Y] = (float) e.by;
                to[at + OutlineShape.BEND] = (float) e.bend;
                at += OutlineShape.CORNER_STRIDE;
            }
        }
        return Arrays.copyOf(to, at);
    }

    /** Whether the element before is a part of the same arc: its cone goes on a little into that one's, so that no way lies between both. */
    private boolean isPartOfArc(int k) {
        Element e = elements.get(k);
        Element before = elements.get(k == 0 ? elements.size() - 1 : k - 1);
        return before != e && e.bend == 0 && !before.isLine && before.x == e.x && before.y == e.y;
    }

    /** As {@link OutlineShape#edges}. The centre of a line is its start. */
    double[] edges(double centreX, double centreY) {
        double[] to = new double[OutlineShape.EDGE_STRIDE * elements.size()];
        int n = 0;
        for (Element e : elements) {
            if (e.isLine || e.r > 0) {
                to[n] = e.pointX(0) - centreX;
                to[n + 1] = e.pointY(0) - centreY;
                to[n + OutlineShape.CENTRE_X] = e.isLine ? to[n] : e.x - centreX;
                to[n + OutlineShape.CENTRE_Y] = e.isLine ? to[n + 1] : e.y - centreY;
                to[n + OutlineShape.EDGE_RADIUS] = e.isLine ? 0 : e.r;
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
        float[] to = new float[OutlineShape.LINE_STRIDE * elements.size()];
        int at = 0;
        for (Element e : elements) {
            if (e.isLine) {
                to[at] = (float) (e.x + e.before * e.ay - centreX);
                to[at + 1] = (float) (e.y - e.before * e.ax - centreY);
                to[at + OutlineShape.NX] = (float) e.ax;
                to[at + OutlineShape.NY] = (float) e.ay;
                to[at + OutlineShape.LENGTH] = (float) (e.before + e.span + e.after);
                to[at + OutlineShape.THICKNESS] = (float) e.r;
                at += OutlineShape.LINE_STRIDE;
            }
        }
        return Arrays.copyOf(to, at);
    }

    /** Both ends of the cores of lines, and ends and middles of arcs that are no rounded corners. */
    float[] core(double centreX, double centreY) {
        float[] to = new float[6 * elements.size()];
        int n = 0;
        for (Element e : elements) {
            double x = e.x - centreX;
            double y = e.y - centreY;
            if (e.isLine) {
                double end = e.span + e.after;
                to[n++] = (float) (x + e.before * e.ay);
                to[n++] = (float) (y - e.before * e.ax);
                to[n++] = (float) (x - end * e.ay);
                to[n++] = (float) (y + end * e.ax);
            } else if (e.r != r) {
                double inner = Math.max(0, e.r - r);
                double mx = e.ax + e.bx;
                double my = e.ay + e.by;
                double m = Math.sqrt(mx * mx + my * my);
                to[n++] = (float) (x + inner * e.ax);
                to[n++] = (float) (y + inner * e.ay);
                to[n++] = (float) (x + inner * mx / m);
                to[n++] = (float) (y + inner * my / m);
                to[n++] = (float) (x + inner * e.bx);
                to[n++] = (float) (y + inner * e.by);
            }
        }
        return Arrays.copyOf(to, n);
    }
}
