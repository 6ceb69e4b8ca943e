package io.github.circles2d;

import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.terrain.ChainPath;

/**
 * The outline of smooth ground: points in a row, joined by lines and arcs. {@link Terrain#addChain} makes pieces of it. Circles touch a chain
 * from its right, as in Box2D, and pass it from its left: draw ground from right to left, a solid island anticlockwise, and the wall of
 * a cave clockwise. At a joint a circle touches once, not twice, and a row of lines that lie in line is as smooth as one.
 *
 * <p><img src="doc-files/terrain-sides.svg" alt="Circles touch a chain from its right, a segment from both sides, an arc from the side that it says, a one-way piece from the front">
 *
 * <pre>{@code
 * Chain hill = Chain.of(100, 0, 60, 0, 50, 10, 40, 0, 0, 0); // from right to left: circles are above
 * Chain bowl = Chain.from(10, 5).arcTo(5, 5, -(float) Math.PI); // half a pipe, circles are inside
 * Chain box = Chain.from(0, 0).lineTo(2, 0).lineTo(2, 1).lineTo(0, 1).close(); // anticlockwise: solid
 * world.terrain().addChain(hill);
 * }</pre>
 *
 * <p>A chain may be added many times, to several bodies and worlds. It is used by one thread at a time.
 */
public final class Chain {
    private static final int POINT_STRIDE = 2;

    private final ChainPath path;

    private Chain(ChainPath path) {
        this.path = path;
    }

    /**
     * A chain of lines.
     *
     * @param points x and y of one point after the other, two at least
     * @return the chain, which may go on
     * @throws IllegalArgumentException if there are fewer than two points or an odd number of elements, or a point is out of range, or the
     *     same as the one before it
     */
    public static Chain of(float... points) {
        int n = Limits.notNull("points", points).length;
        if (n % POINT_STRIDE != 0 || n < 2 * POINT_STRIDE) {
            throw new IllegalArgumentException(
                    "points has " + n + " elements, but must have two a point, of two points at least");
        }
        Chain chain = new Chain(new ChainPath(points[0], points[1]));
        for (int k = POINT_STRIDE; k < n; k += POINT_STRIDE) {
            chain.lineTo(points[k], points[k + 1]);
        }
        return chain;
    }

    /**
     * Begins a chain.
     *
     * @param x x of its first point, up to 1e9 in magnitude
     * @param y y of its first point, likewise
     * @return the chain, which has no pieces yet
     * @throws IllegalArgumentException if a value is out of range
     */
    public static Chain from(float x, float y) {
        return new Chain(new ChainPath(x, y));
    }

    /**
     * Goes on with a line.
     *
     * @param x x of its end, up to 1e9 in magnitude
     * @param y y of its end, likewise
     * @return this
     * @throws IllegalArgumentException if a value is out of range, or the line is not longer than 2^-20 of its coordinates
     * @throws IllegalStateException if the chain has been closed
     */
    public Chain lineTo(float x, float y) {
        path.lineTo(x, y);
        return this;
    }

    /**
     * Goes on with an arc around a centre. One that turns anticlockwise, where y points up, is a hill: circles are outside. One
     * that turns clockwise is a bowl: circles are inside.
     *
     * @param centreX x of the centre, up to 1e9 in magnitude
     * @param centreY y of the centre, likewise; the distance from the last point is the radius
     * @param angle how far the arc turns around the centre, in radians, from -2 pi to 2 pi, positive anticlockwise; not 0
     * @return this
     * @throws IllegalArgumentException if a value is out of range, or the radius is not more than 2^-20 of the coordinates
     * @throws IllegalStateException if the chain has been closed
     */
    public Chain arcTo(float centreX, float centreY, float angle) {
        path.arcTo(centreX, centreY, angle);
        return this;
    }

    /**
     * Joins the last point to the first: by a line, or by nothing if the last piece has come back there, but for rounding.
     *
     * @return this
     * @throws IllegalArgumentException if a line is needed, and the chain has as many pieces as it may have, 2^20
     * @throws IllegalStateException if the chain has been closed, or has no pieces
     */
    public Chain close() {
        path.close();
        return this;
    }

    /** {@return the number of pieces, at least 0} */
    public int pieces() {
        return path.pieces();
    }

    /** {@return whether the last point is joined to the first: true after {@link #close}} */
    public boolean isClosed() {
        return path.isClosed();
    }

    /**
     * {@return a new chain along the same outline in the other direction, so that circles touch its other side; it may go on unless this one is
     * closed} Ends of arcs may differ by rounding.
     */
    public Chain reversed() {
        return new Chain(path.reversed());
    }

    /**
     * Points along the chain, to draw or to fill what it encloses: its own points, and points on arcs, joined by straight lines.
     *
     * @param tolerance how far lines may be from an arc, a length more than 0; an arc becomes at most 4,096 lines, however small it is
     * @return x and y of one point after the other; if the chain is closed, the last is the first, but for rounding
     * @throws IllegalArgumentException if the tolerance is not more than 0
     */
    public float[] points(float tolerance) {
        return path.points(Limits.within("the tolerance", tolerance, Float.MIN_VALUE, Float.POSITIVE_INFINITY));
    }

    ChainPath path() {
        return path;
    }

    @Override
    public String toString() {
        return "chain of " + pieces() + " pieces" + (isClosed() ? ", closed" : "");
    }
}
