package io.github.circles2d;

import io.github.circles2d.world.search.QueryFilter;
import io.github.circles2d.world.search.Searches;

/**
 * Questions about where the {@link Bodies} are: which is at a point, which overlap a disc or a box, which are nearest, and which a ray or a moving
 * disc meets. {@link Queries#bodies} gives this object.
 *
 * <pre>{@code
 * BodyQueries crates = world.queries().bodies();
 * long held = crates.pick(mouseX, mouseY); // 0 if there is no body
 * float[] hit = new float[Queries.HIT_STRIDE];
 * long shot = crates.rayCast(x, y, 100, 0, hit); // the body, or 0
 * if (shot != 0) {
 *     world.bodies().applyImpulse(shot, 5, 0, hit[Queries.X], hit[Queries.Y]);
 * }
 * }</pre>
 *
 * <p>What {@link Queries} says of circles holds for bodies: masks, the order of results, batches, arrays, misuse. A body is found where it is now:
 * after all steps that were asked for and all calls. Its handle is that of {@link Bodies}.
 *
 * <p><b>Shape:</b> a body is its outline with rounded corners as arcs, and all that is inside. A disc in a hollow of a concave outline does not
 * overlap it. Tests compute in double precision.
 *
 * <p><b>Hits</b> have the elements of {@link Queries#HIT_STRIDE}. ({@link Queries#X}, {@link Queries#Y}) is the end of the ray or the centre of the disc
 * when it meets the body, and the normal leads out of the body there: a disc touches it at the centre minus its radius times the normal. A ray or
 * disc that begins in a body meets it at its start, after a distance of 0, with the normal of the point of the outline that is nearest to the start.
 *
 * <p><b>Edges:</b> along an axis that {@linkplain World.Builder#edges wraps}, overlaps, picks and the nearest find each body once, whichever way
 * round. Rays and discs go on beyond the seam, for half of the extent of the bounds, and find a body once for each way on which they meet it.
 *
 * <p><b>Cost:</b> the first query after a step or a change builds a tree over all bodies; later ones use it.
 */
public final class BodyQueries extends ShapeQueries {
    BodyQueries(Searches searches, QueryFilter filter) {
        super(searches, filter);
    }

    /**
     * The same queries of some bodies alone, as {@link Queries#withMask} of some circles.
     *
     * @param mask the bits of the categories to find: -1 for all categories but 0, and 0 for no body
     * @return queries with this mask; a mask of this object no longer counts for them, but a body that it leaves out stays out
     */
    public BodyQueries withMask(int mask) {
        return new BodyQueries(searches, searches.filter(filter, mask));
    }

    /**
     * The same queries without one body, such as the crate that a ray starts from. The mask of this object goes on to count. Keep the object, so that
     * a frame leaves no garbage.
     *
     * @param body the body to leave out, in place of one that this object leaves out; 0, and a body that has been removed, leave out none
     * @return queries of all other bodies
     * @throws IllegalArgumentException if the handle is of something else
     */
    public BodyQueries without(long body) {
        return new BodyQueries(searches, searches.withoutBody(filter, body));
    }

    /**
     * Finds the body at a point, as under a mouse. Of several that overlap there it takes the one in which the point lies deepest, and of several
     * such ones that of the lowest id. A point on an outline is in the body.
     *
     * @param x x of the point
     * @param y y of the point
     * @return the handle, or 0 if there is no body
     * @throws IllegalArgumentException if a value is not finite
     */
    public long pick(float x, float y) {
        return searches.nearestOne(filter, x, y, 0, null);
    }

    /**
     * Finds the body at each of many points.
     *
     * @param points x and y of one after the other
     * @param n number of points, at least 0
     * @param handles takes the handle of each, or 0; at least n elements
     * @return at how many of them there is a body
     * @throws IllegalArgumentException if a value is not finite, or an array is too short
     */
    public int pick(float[] points, int n, long[] handles) {
        return searches.nearest(filter, points, n, 0, 1, handles, null);
    }

    /**
     * Finds the bodies nearest to a point. The distance is that from the point to their outlines, negative inside.
     *
     * @param x x of the point
     * @param y y of the point
     * @param within greatest distance, at least 0; positive infinity for any
     * @param most how many bodies to find, at least 1
     * @param handles takes their handles, by distance, then by id; at least {@code most} elements
     * @param hits takes {@link Queries#HIT_STRIDE} elements for each: the distance, the nearest point of the outline, and the unit vector that leads
     *     out of the body there; may be null
     * @return how many were found
     * @throws IllegalArgumentException if a value is out of range, or an array is too short
     */
    public int nearest(float x, float y, float within, int most, long[] handles, float[] hits) {
        return searches.nearest(filter, x, y, within, most, handles, hits);
    }

    /**
     * Finds the bodies nearest to each of many points. Those of point q begin at number q * most of the arrays.
     *
     * @param points x and y of one after the other
     * @param n number of points, at least 0
     * @param within greatest distance, at least 0; positive infinity for any
     * @param most how many bodies to find for each, at least 1
     * @param handles takes their handles, by distance, then by id, and then 0 up to the number that may be found; at least
     *     n * most elements
     * @param hits takes their hits as {@link #nearest(float, float, float, int, long[], float[])} does, and then infinite distances, likewise;
     *     may be null
     * @return how many were found for all points together
     * @throws IllegalArgumentException if a value is out of range, or an array is too short
     */
    public int nearest(float[] points, int n, float within, int most, long[] handles, float[] hits) {
        return searches.nearest(filter, points, n, within, most, handles, hits);
    }
}
