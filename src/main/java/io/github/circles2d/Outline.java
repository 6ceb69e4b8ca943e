package io.github.circles2d;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.terrain.ChainPath;

/**
 * The outline of a body that is pushed: lines and arcs, with rounded corners. It may be concave. It never changes, so many bodies and worlds may
 * share it, and threads too.
 *
 * <pre>{@code
 * Outline crate = Outline.box(1, 1);
 * Outline plank = Outline.box(6, 0.2f).round(0.02f);
 * Outline wedge = Outline.polygon(0, 0, 2, 0, 2, 1);
 * }</pre>
 *
 * <p>Its place is its centroid: a body at (x, y) has it there, wherever the outline was drawn. {@link #centroidX} and {@link #centroidY} say where
 * it lies in the drawing.
 *
 * <p><b>Rounding.</b> A corner between two lines becomes an arc inside it; the outline grows nowhere. The usual radius is a twentieth of the least
 * width, or less where lines are short. Where an arc and another piece meet at an angle, that corner stays sharp.
 */
public final class Outline {
    private static final int POINT_STRIDE = 2;

    /** Greatest ratio of length and width. */
    private static final float SLIMMEST = 1000;

    private final OutlineShape shape;

    private Outline(OutlineShape shape) {
        this.shape = shape;
    }

    static Outline of(OutlineShape shape) {
        return new Outline(shape);
    }

    private static Outline of(ChainPath path) {
        path.close();
        return new Outline(OutlineShape.of(path, Float.NaN));
    }

    /**
     * A box around its centroid.
     *
     * @param width along x, more than 0 and up to 1e9
     * @param height along y, likewise; the ratio of both is at most 1,000
     * @return the outline
     * @throws IllegalArgumentException if a value is out of range
     */
    public static Outline box(float width, float height) {
        float x = extent("width", width) / 2;
        float y = extent("height", height) / 2;
        return polygon(-x, -y, x, -y, x, y, -x, y);
    }

    /**
     * Two half discs and what is between them: it lies along x. A body with an angle of pi / 2 has it upright.
     *
     * @param length between the centres of its ends, more than 0 and up to 1e9
     * @param radius of its ends, likewise
     * @return the outline
     * @throws IllegalArgumentException if a value is out of range, or it is more than a thousand times as long as wide
     */
    public static Outline capsule(float length, float radius) {
        float x = extent("length", length) / 2;
        float r = extent("radius", radius);
        if (x + r > SLIMMEST * r) {
            // the checks of all outlines see its ends as lines
            throw new IllegalArgumentException("the capsule is " + 2 * r + " wide and " + (length + 2 * r)
                    + " long, but must be at least a thousandth as wide as long");
        }
        ChainPath path = new ChainPath(-x, -r);
        path.lineTo(x, -r);
        path.arcTo(x, 0f, (float) Math.PI);
        path.lineTo(-x, r);
        path.arcTo(-x, 0f, (float) Math.PI);
        return of(path);
    }

    /**
     * A polygon, which may be concave.
     *
     * @param points x and y of one corner after the other, in either direction, three corners at least and 256 at most; the last may be
     *     the first again
     * @return the outline
     * @throws IllegalArgumentException if there are too few or too many points, an odd number of elements, or a point is out of range or the
     *     same as the one before it; if the polygon crosses itself or is more than a thousand times as long as wide
     */
    public static Outline polygon(float... points) {
        int n = Limits.notNull("points", points).length;
        if (n % POINT_STRIDE != 0 || n < 3 * POINT_STRIDE) {
            throw new IllegalArgumentException(
                    "points has " + n + " elements, but must have two a corner, of three corners at least");
        }
        if (n > POINT_STRIDE * OutlineShape.PIECES) {
            throw new IllegalArgumentException(
                    "the polygon has " + n / POINT_STRIDE + " corners, but may have at most " + OutlineShape.PIECES);
        }
        ChainPath path = null;
        for (int k = 0; k < n; k += POINT_STRIDE) {
            float x = points[k];
            float y = points[k + 1];
            corner(k / POINT_STRIDE, x, y, path == null || path.isFar(x, y));
            if (path == null) {
                path = new ChainPath(x, y);
            } else {
                path.lineTo(x, y);
            }
        }
        return of(path);
    }

    private static void corner(int corner, float x, float y, boolean isFar) {
        String place = "corner " + corner + " of the polygon is " + x + ", " + y;
        if (!(Math.abs(x) <= Limits.COORDINATE && Math.abs(y) <= Limits.COORDINATE)) {
            throw new IllegalArgumentException(
                    place + ", but coordinates must be from " + -Limits.COORDINATE + " to " + Limits.COORDINATE);
        }
        if (!isFar) {
            throw new IllegalArgumentException(place + ", which is the corner before it, or too near to it");
        }
    }

    /**
     * The outline along a closed chain, in either direction. Its arcs must bend outwards.
     *
     * @param chain a closed chain of at most 256 pieces; the outline does not change if the chain does
     * @return the outline
     * @throws IllegalArgumentException if the chain is not closed, has too many pieces, crosses itself, is more than a thousand times as long as
     *     wide, or has an arc that bends inwards
     */
    public static Outline of(Chain chain) {
        return new Outline(OutlineShape.of(Limits.notNull("chain", chain).path(), Float.NaN));
    }

    private static float extent(String what, float value) {
        return Limits.within(what, value, Float.MIN_NORMAL, Limits.COORDINATE);
    }

    /**
     * The same outline with other corners. Rounder ones roll and slide more gently over each other.
     *
     * @param radius of the corners between lines, from a hundredth of the least width, or less where lines are short, to a half of it; lines must not be too short for it
     * @return the outline
     * @throws IllegalArgumentException if the radius is out of range, or a line is too short
     */
    public Outline round(float radius) {
        return new Outline(shape.rounded(radius));
    }

    /** {@return the radius of the corners between lines} */
    public float rounding() {
        return shape.rounding();
    }

    /** {@return the area, exact but for rounding: a density times it is a mass} */
    public float area() {
        return (float) shape.area();
    }

    /** {@return where in the drawing the centroid is along x, which is the place of a body} */
    public float centroidX() {
        return (float) shape.centroidX();
    }

    /** {@return the same along y} */
    public float centroidY() {
        return (float) shape.centroidY();
    }

    /**
     * How hard the outline is to turn about its centroid, if its mass is spread evenly.
     *
     * @param mass a mass
     * @return the moment of inertia
     */
    public float inertia(float mass) {
        return mass * shape.inertia();
    }

    /** {@return a length: no point of the outline is farther from the centroid} */
    public float reach() {
        return shape.reach();
    }

    /** {@return the number of lines and arcs that it was drawn with, 1 to 256; corners that are rounded do not count} */
    public int pieces() {
        return shape.path().pieces();
    }

    /**
     * Points along the outline, anticlockwise around its centroid, joined by straight lines, the last with the first: to draw or to fill it. A body at (x,
     * y) with an angle shows the point (px, py) at (x + cos px - sin py, y + sin px + cos py).
     *
     * @param tolerance how far lines may be from an arc, a length more than 0
     * @return x and y of one point after the other
     * @throws IllegalArgumentException if the tolerance is not more than 0
     */
    public float[] points(float tolerance) {
        return shape.points(Limits.within("the tolerance", tolerance, Float.MIN_VALUE, Float.POSITIVE_INFINITY));
    }

    OutlineShape shape() {
        return shape;
    }

    /** Whether the other is the same outline, drawn at the same place. */
    @Override
    public boolean equals(Object other) {
        return other instanceof Outline outline && shape.equals(outline.shape);
    }

    @Override
    public int hashCode() {
        return shape.hashCode();
    }

    @Override
    public String toString() {
        return "outline of " + pieces() + " pieces, area " + area();
    }
}
