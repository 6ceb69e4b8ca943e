package io.github.circles2d.world.bodies;

import io.github.circles2d.world.terrain.ChainPath;
import java.util.Arrays;

/**
 * What a body's outline is to a step: lines, and corners that are outer arcs. It lies around its centroid, goes anticlockwise, and never
 * changes. A line is thick: its core lies inside by the rounding. A corner has a radius and a cone of normals, half a turn at most; a reflex one is
 * no corner.
 */
public final class OutlineShape {
    public static final int PIECES = 256;

    /** The most that {@link #words} gives. */
    public static final int MOST_WORDS = 4 + 4 * PIECES;

    /** Floats a corner: place, radius, the normals where its cone begins and ends, and the radius of its core. */
    public static final int CORNER_STRIDE = 8;

    public static final int RADIUS = 2;
    public static final int FROM_X = 3;
    public static final int FROM_Y = 4;
    public static final int TO_X = 5;
    public static final int TO_Y = 6;

    /** 0 if the core of a corner is a point; else the core is an arc so far from the place, from one normal of the cone to the other. */
    public static final int BEND = 7;

    /** Floats a line: where its core begins, its normal, its length and how thick it is. */
    public static final int LINE_STRIDE = 6;

    public static final int NX = 2;
    public static final int NY = 3;
    public static final int LENGTH = 4;
    public static final int THICKNESS = 5;

    /** Doubles of an edge: where it begins, and the centre and the radius of an arc, which is 0 of a line. */
    public static final int EDGE_STRIDE = 5;

    public static final int CENTRE_X = 2;
    public static final int CENTRE_Y = 3;
    public static final int EDGE_RADIUS = 4;

    /** More than what rounding takes. */
    private static final float SLACK = 1.0001f;

    /** The same of coordinates that have turned: an outline is at most a thousand times as long as wide. */
    private static final float FAR = 1.01f;

    /** Of the least width. */
    private static final double ROUNDING = 0.05;

    private static final double LEAST_ROUNDING = 0.01;

    /** Of the greatest distance of two points: the least width. A thousandth of a length is a little less of a diagonal, and rounding counts. */
    private static final double LEAST_WIDTH = 0.0009999;

    /** Share of the rounding at which an edge would be gone. */
    private static final double OF_EDGE = 0.25;

    private static final double LEAST_OF_EDGE = 0.05;

    private final ChainPath path;
    private final float rounding;
    private final double width;
    private final int[] words;
    private final OutlineMass mass;
    private final float[] corners;
    private final float[] lines;

    /** x and y of a polygon near the core: what lies in it is inside. */
    private final float[] core;

    private final float coreReach;

    private final double[] edges;

    // a box around it: the middle, and half its sides
    private final float middleX;
    private final float middleY;
    private final float halfX;
    private final float halfY;

    // likewise of all corners and lines with what is around them
    private final float featuresX;
    private final float featuresY;
    private final float halfFeaturesX;
    private final float halfFeaturesY;

    private final float reach;
    private final float halfThickness;

    private OutlineShape(ChainPath path, float rounding, double width, OutlineBuilder built) {
        this.path = path;
        this.rounding = rounding;
        this.width = width;
        words = words(path, rounding);
        mass = built.mass();
        corners = built.corners(mass.centroidX, mass.centroidY);
        lines = built.lines(mass.centroidX, mass.centroidY);
        core = built.core(mass.centroidX, mass.centroidY);
        coreReach = SLACK * farthest(core);
        edges = built.edges(mass.centroidX, mass.centroidY);
        float far = 0f;
        for (int c = 0; c < corners.length; c += CORNER_STRIDE) {
            far = Math.max(far, farthest(corners, c) + corners[c + RADIUS]);
        }
        reach = far;
        double minX = box(0, -1);
        double minY = box(1, -1);
        double maxX = box(0, 1);
        double maxY = box(1, 1);
        middleX = (float) (0.5 * (minX + maxX));
        middleY = (float) (0.5 * (minY + maxY));
        halfX = (float) Math.max(maxX - middleX, middleX - minX);
        halfY = (float) Math.max(maxY - middleY, middleY - minY);
        float lowX = features(0, -1f);
        float lowY = features(1, -1f);
        float highX = features(0, 1f);
        float highY = features(1, 1f);
        featuresX = 0.5f * (lowX + highX);
        featuresY = 0.5f * (lowY + highY);
        halfFeaturesX = 0.5f * (highX - lowX);
        halfFeaturesY = 0.5f * (highY - lowY);
        halfThickness = (float) Math.min(Math.sqrt(mass.area) / 2, mass.area / (2 * (double) reach));
    }

    /** The least or the greatest coordinate along an axis, at most: whole circles count of arcs, but not beyond the farthest point. */
    private double box(int axis, int sign) {
        double most = Double.NEGATIVE_INFINITY;
        double farthest = reach;
        for (int e = 0; e < edges.length; e += EDGE_STRIDE) {
            farthest = Math.max(farthest, Math.sqrt(edges[e] * edges[e] + edges[e + 1] * edges[e + 1]));
            double centre = sign * edges[e + CENTRE_X + axis];
            most = Math.max(most, Math.max(sign * edges[e + axis], edges[e + EDGE_RADIUS] + centre));
        }
        return sign * Math.min(most, farthest);
    }

    /** How far corners and lines go along an axis, up or down. */
    private float features(int axis, float sign) {
        float most = Float.NEGATIVE_INFINITY;
        for (int c = 0; c < corners.length; c += CORNER_STRIDE) {
            most = Math.max(most, sign * corners[c + axis] + (corners[c + RADIUS] + corners[c + BEND]));
        }
        for (int l = 0; l < lines.length; l += LINE_STRIDE) {
            float along = axis == 0 ? -lines[l + NY] : lines[l + NX];
            float end = lines[l + axis] + along * lines[l + LENGTH];
            most = Math.max(most, Math.max(sign * lines[l + axis], sign * end) + lines[l + THICKNESS]);
        }
        return sign * most;
    }

    /** Whether a point is surely farther than a distance from all corners and lines with what is around them. */
    public boolean isFar(float x, float y, float distance) {
        return Math.abs(x - featuresX) > FAR * (halfFeaturesX + distance)
                || Math.abs(y - featuresY) > FAR * (halfFeaturesY + distance);
    }

    /** Of a path that is closed; rounding: NaN for the usual one. */
    public static OutlineShape of(ChainPath drawn, float rounding) {
        OutlineChecks.closed(drawn);
        ChainPath path = OutlineChecks.area(drawn) < 0 ? drawn.reversed() : drawn;
        double length = OutlineChecks.length(path);
        double width = OutlineChecks.leastWidth(path);
        if (!(width >= LEAST_WIDTH * length)) {
            throw new IllegalArgumentException("the outline is " + (float) width + " wide and " + (float) length
                    + " long, but must be at least a thousandth as wide as long");
        }
        OutlineChecks.simple(path, path != drawn);
        double most = OutlineBuilder.mostRounding(path);
        if (!Float.isNaN(rounding)) {
            rounding(rounding, width, most);
        }
        float r = Float.isNaN(rounding) ? (float) Math.min(ROUNDING * width, OF_EDGE * most) : rounding;
        return new OutlineShape(path, r, width, new OutlineBuilder(path, r, width));
    }

    /** Refuses a rounding that an outline cannot have; most: at which an edge would be gone. */
    private static void rounding(float rounding, double width, double most) {
        double least = Math.min(LEAST_ROUNDING * width, LEAST_OF_EDGE * most);
        if (!(rounding >= (float) least && rounding <= width / 2)) {
            throw new IllegalArgumentException("the rounding is " + rounding + ", but must be from " + (float) least
                    + " to " + (float) (width / 2)
                    + ": a hundredth to a half of the least width, or less for short lines");
        }
    }

    /** The same with another rounding. */
    public OutlineShape rounded(float radius) {
        rounding(radius, width, OutlineBuilder.mostRounding(path));
        return of(path, radius);
    }

    /** From what {@link #words} has given, or anybody has forged. */
    public static OutlineShape of(int[] words) {
        if (words.length < 4 || words.length != 4 + 4L * words[1] || Float.isNaN(Float.intBitsToFloat(words[0]))) {
            throw new IllegalArgumentException("the words of an outline are no outline");
        }
        ChainPath path = new ChainPath(Float.intBitsToFloat(words[2]), Float.intBitsToFloat(words[3]));
        for (int at = 4; at < words.length; at += 4) {
            float x = Float.intBitsToFloat(words[at]);
            float y = Float.intBitsToFloat(words[at + 1]);
            long turn = words[at + 2] & 0xffffffffL | (long) words[at + 3] << 32;
            if (turn == 0) {
                path.lineTo(x, y);
            } else {
                path.arcBy(x, y, turn);
            }
        }
        path.close();
        return of(path, Float.intBitsToFloat(words[0]));
    }

    private static float farthest(float[] points) {
        float far = 0f;
        for (int k = 0; k < points.length; k += 2) {
            far = Math.max(far, length(points[k], points[k + 1]));
        }
        return far;
    }

    /** How far from the centroid the core of a corner is at most. */
    private static float farthest(float[] of, int c) {
        float x = of[c];
        float y = of[c + 1];
        float bend = of[c + BEND];
        boolean between = of[c + FROM_X] * y - of[c + FROM_Y] * x >= 0f && of[c + TO_X] * y - of[c + TO_Y] * x <= 0f;
        if (bend == 0f || between) {
            return length(x, y) + bend;
        }
        return Math.max(
                length(x + bend * of[c + FROM_X], y + bend * of[c + FROM_Y]),
                length(x + bend * of[c + TO_X], y + bend * of[c + TO_Y]));
    }

    private static float length(float x, float y) {
        return (float) Math.sqrt(x * x + y * y);
    }

    private static int[] words(ChainPath path, float rounding) {
        int[] words = new int[4 + 4 * path.pieces()];
        words[0] = Float.floatToRawIntBits(rounding);
        words[1] = path.pieces();
        words[2] = Float.floatToRawIntBits(path.x(0));
        words[3] = Float.floatToRawIntBits(path.y(0));
        for (int k = 0; k < path.pieces(); k++) {
            boolean line = path.turn(k) == 0;
            words[4 + 4 * k] = Float.floatToRawIntBits(line ? path.x(k + 1) : path.centreX(k));
            words[5 + 4 * k] = Float.floatToRawIntBits(line ? path.y(k + 1) : path.centreY(k));
            words[6 + 4 * k] = (int) path.turn(k);
            words[7 + 4 * k] = (int) (path.turn(k) >> 32);
        }
        return words;
    }

    /**
     * The rounding, the number of pieces, the first point, and of each piece the end of a line or the centre of an arc, and how far that turns. Nobody may
     * change them.
     */
    public int[] words() {
        return words;
    }

    @Override
    public boolean equals(Object other) {
        return other == this || other instanceof OutlineShape && Arrays.equals(words, ((OutlineShape) other).words);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(words);
    }

    /** As it was drawn, but anticlockwise. */
    public ChainPath path() {
        return path;
    }

    public float rounding() {
        return rounding;
    }

    public double area() {
        return mass.area;
    }

    /** Of the path. */
    public double centroidX() {
        return mass.centroidX;
    }

    public double centroidY() {
        return mass.centroidY;
    }

    /** About the centroid, of a mass of 1. */
    public float inertia() {
        return (float) (mass.secondMoment / mass.area);
    }

    /** Of the farthest point from the centroid, at most. */
    public float reach() {
        return reach;
    }

    /** What lengths of contacts are measured by, as those of circles by their radii. */
    public float halfThickness() {
        return halfThickness;
    }

    /** By {@link #CORNER_STRIDE}. Nobody may change it. */
    public float[] corners() {
        return corners;
    }

    /** By {@link #LINE_STRIDE}. Nobody may change it. */
    public float[] lines() {
        return lines;
    }

    /** By {@link #EDGE_STRIDE}: lines and arcs along the surface, anticlockwise. Each ends where the next begins. Nobody may change it. */
    public double[] edges() {
        return edges;
    }

    /** The middle of a box around it. */
    public float middleX() {
        return middleX;
    }

    public float middleY() {
        return middleY;
    }

    /** Half a side of that box. */
    public float halfX() {
        return halfX;
    }

    public float halfY() {
        return halfY;
    }

    public float[] core() {
        return core;
    }

    /** A little more than the distance of the centroid from the farthest point of {@link #core}. */
    public float coreReach() {
        return coreReach;
    }

    /** x and y of points on the outline around its centroid, between which lines are at most so far from it; the last is not the first again. */
    public float[] points(float tolerance) {
        float[] to = new float[64];
        int n = 0;
        for (OutlineBuilder.Element e : new OutlineBuilder(path, rounding, width).elements) {
            double span = e.span();
            int parts = e.isLine || e.r == 0
                    ? 1
                    : (int) Math.max(1, Math.min(1024, Math.ceil(span * Math.sqrt(e.r / (8.0 * tolerance)))));
            for (int k = 0; k <= parts; k++) {
                double x = e.pointX(span * k / parts);
                double y = e.pointY(span * k / parts);
                float px = (float) (x - mass.centroidX);
                float py = (float) (y - mass.centroidY);
                boolean again = n > 0 && near(to[n - 2], to[n - 1], px, py) || n > 2 && near(to[0], to[1], px, py);
                if (!again) {
                    to = n + 2 > to.length ? Arrays.copyOf(to, 2 * n) : to;
                    to[n] = px;
                    to[n + 1] = py;
                    n += 2;
                }
            }
        }
        return Arrays.copyOf(to, n);
    }

    private boolean near(float x, float y, float px, float py) {
        float close = 1e-6f * reach;
        return Math.abs(x - px) <= close && Math.abs(y - py) <= close;
    }
}
