package io.github.circles2d;

import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.queries.QueryShape;
import io.github.circles2d.world.search.QueryFilter;
import io.github.circles2d.world.search.Searches;

/**
 * Questions about where the circles of a {@link World} are: which overlap a disc or a box, which is at a point, which are nearest,
 * and which a ray or a moving disc meets. {@link World#queries} gives this object.
 *
 * <pre>{@code
 * Queries queries = world.queries();
 * long[] near = new long[64];
 * int count = queries.overlapCircle(40, 50, 5, near); // all that touch a disc of radius 5 at (40, 50)
 * for (int k = 0; k < Math.min(count, near.length); k++) {
 *     world.applyImpulse(near[k], 0, 10);
 * }
 * long under = queries.pick(mouseX, mouseY); // 0 if there is no circle
 * float[] hit = new float[Queries.HIT_STRIDE];
 * long target = queries.rayCast(40, 50, 100, 0, hit); // from (40, 50) to (140, 50)
 * }</pre>
 *
 * <p><b>Circles</b> have their present places: those after all steps that were asked for, with the changes that wait for the next step
 * (circles that were added, removed, moved or resized, and kinds). Queries find static circles and sensors like all others. A static
 * circle that {@link World#setPosition} lets travel is found at the place where it sets out. Queries do not find walls; {@link #terrain} has
 * those for terrain, and {@link #bodies} those for bodies. They change nothing, and can be made at any time between two steps.
 *
 * <p><b>Masks:</b> {@link #withMask} gives the same queries of some circles alone: those whose kind's category has a bit of the mask.
 * {@link #without} leaves out one circle.
 *
 * <p><b>Edges:</b> along an axis that {@linkplain World.Builder#edges wraps}, a place that a query names counts as the same place
 * inside the bounds, and a box as the one whose centre is inside. Overlaps, picks and the nearest go the short way round, across
 * the seam too, and find each circle once. Rays and moving discs go on beyond the seam, for half of the extent of the bounds;
 * what they meet there has coordinates beyond the bounds, and a circle that they meet on two ways is found twice.
 *
 * <p><b>Results</b> are handles in the caller's arrays; on the JVM nothing is allocated once the world's own arrays have grown. Their order is
 * defined, and so is every bit: overlaps come by id, the lowest first; casts by distance, then by id; the nearest by distance,
 * then by id. A query that finds all circles returns how many there are. If the array is shorter, it holds the first of them; an
 * array of length 0 only counts.
 *
 * <p><b>Batches:</b> every query has a form that takes many at once, one after the other in an array of floats, of which it takes
 * the first n. It answers as n single calls would. A form that finds all circles writes the results of all queries one after the
 * other: those of query q begin at element ends[q - 1] of the handles (0 for the first) and end before element ends[q]. It returns
 * ends[n - 1]. If the handles are too short, ends still count all results.
 *
 * <p><b>Exactness:</b> tests compute in double precision from the floats that {@link World#read} gives, and what touches exactly
 * counts: a disc of radius R overlaps a circle of radius r if dx * dx + dy * dy &lt;= (r + R) * (r + R). So the results are the same
 * on every back end, and the same as if all circles were tested.
 *
 * <p><b>Cost:</b> the first query after a step or a change reads all circles, as {@link World#x} does, and builds an index on the
 * calling thread; later ones use both. On an OpenCL device the first query waits for the steps and copies 16 bytes a circle. So make the
 * queries of a frame together, before the changes that follow from them. The index and what it is built with take about 40 bytes a
 * circle.
 *
 * <p><b>On a GPU</b> that has 1,000 circles or more, the GPU answers batches of 512 queries or more. If it has 20,000 circles or more,
 * it also answers the first few other calls after a change. It builds the index itself, and only results come to the host. The first of
 * these calls compiles the searches, which may take a second. The index takes about 80 bytes a circle of the GPU's memory. The host
 * answers if there is no such memory, if the GPU has no double precision, if a call finds more than four million circles, or if
 * thousands of circles crowd into a place that would hold one if all were spread evenly.
 *
 * <p><b>Misuse:</b> coordinates, radii and lengths may be any finite floats, in the units of the world; radii are at least 0. A
 * query with other values throws an IllegalArgumentException that names the value (in a batch, the query too, and what the arrays
 * then hold is undefined). So does an array that is too short, unless a rule above says otherwise. The rules of {@link World} for
 * threads, for failures and for closed worlds hold here too.
 */
public final class Queries extends ShapeQueries {
    /** Elements of a hit: {@link #DISTANCE}, {@link #X}, {@link #Y}, {@link #NORMAL_X}, {@link #NORMAL_Y}. */
    public static final int HIT_STRIDE = CastSearch.HIT_STRIDE;

    /** In a hit: how far along its path the ray or the disc meets the circle, a length; 0 if it begins in it or at its edge. */
    public static final int DISTANCE = CastSearch.DISTANCE;

    /** In a hit: x of the ray's end, or of the centre of the disc, when it meets the circle. */
    public static final int X = CastSearch.X;

    /** In a hit: y of the ray's end, or of the centre of the disc, when it meets the circle. */
    public static final int Y = CastSearch.Y;

    /**
     * In a hit: x of the unit vector from the centre of the circle to ({@link #X}, {@link #Y}). If both are one point, the vector points
     * against the path, and up if the path has length 0.
     */
    public static final int NORMAL_X = CastSearch.NORMAL_X;

    /** In a hit: y of that vector. */
    public static final int NORMAL_Y = CastSearch.NORMAL_Y;

    private final TerrainQueries terrain;
    private final BodyQueries bodies;

    Queries(Searches searches, Searches ofTerrain, Searches ofBodies) {
        this(searches, new TerrainQueries(ofTerrain, null), new BodyQueries(ofBodies, null), null);
    }

    private Queries(Searches searches, TerrainQueries terrain, BodyQueries bodies, QueryFilter filter) {
        super(searches, filter);
        this.terrain = terrain;
        this.bodies = bodies;
    }

    /** {@return the same questions about the pieces of {@link Terrain}, with the same mask; always the same object} */
    public TerrainQueries terrain() {
        return terrain;
    }

    /** {@return the same questions about the {@link Bodies} that are pushed, with the same mask; always the same object} */
    public BodyQueries bodies() {
        return bodies;
    }

    /**
     * The same queries of some circles alone: those whose kind's category ({@link Kind#setCategory}) has a bit of the mask. Nothing
     * else decides; sensors, groups and the masks of kinds make no difference. The kind of a circle, and its category, count as they
     * are at each query. Keep the object, so that a frame leaves no garbage.
     *
     * @param mask the bits of the categories to find: -1 for all categories but 0, and 0 for no circle
     * @return queries with this mask; a mask of this object no longer counts for them, but a circle that it leaves out stays out
     */
    public Queries withMask(int mask) {
        return new Queries(searches, terrain.withMask(mask), bodies.withMask(mask), searches.filter(filter, mask));
    }

    /**
     * The same queries without one circle, such as the hero whose feet a ray starts from. The mask of this object goes on to count.
     *
     * <pre>{@code
     * Queries others = world.queries().without(hero); // keep it
     * long below = others.circleCast(world.x(hero), world.y(hero), world.radius(hero), 0, -0.2f, hit);
     * }</pre>
     *
     * <p>To leave out all that a path begins in, take {@link #circleCastAll} or {@link #rayCastAll}, and go on to the first hit whose {@link
     * #DISTANCE} is more than 0.
     *
     * @param circle the circle to leave out, in place of one that this object leaves out; 0, and a circle that has been removed, leave out
     *     none
     * @return queries of all other circles
     * @throws IllegalArgumentException if the handle is of a piece of terrain, a body or a joint
     */
    public Queries without(long circle) {
        return new Queries(searches, terrain, bodies, searches.without(filter, circle));
    }

    /**
     * Finds the circle at a point, as under a mouse. Of several that overlap there it takes the one whose centre is nearest, and of
     * several such ones that of the lowest id. A point on the edge of a circle is in it.
     *
     * @param x x of the point
     * @param y y of the point
     * @return the handle, or 0 if there is no circle
     * @throws IllegalArgumentException if a value is not finite
     */
    public long pick(float x, float y) {
        return searches.one(filter, QueryShape.POINT, x, y, 0, 0, 0, null);
    }

    /**
     * Finds the circle at each of many points.
     *
     * @param points x and y of one after the other
     * @param n number of points, at least 0
     * @param handles takes the handle of each, or 0; at least n elements
     * @return at how many of them there is a circle
     * @throws IllegalArgumentException if a value is not finite, or an array is too short
     */
    public int pick(float[] points, int n, long[] handles) {
        return searches.one(filter, QueryShape.POINT, points, n, handles, null);
    }

    /**
     * Finds the circles nearest to a point. The distance is that from the point to their edges, negative inside.
     *
     * @param x x of the point
     * @param y y of the point
     * @param within greatest distance, at least 0; positive infinity for any. The circles that count are those that a disc of
     *     this radius overlaps or touches
     * @param most how many circles to find, at least 1
     * @param handles takes their handles, by distance, then by id; at least {@code most} elements
     * @param distances takes their distances, likewise; may be null
     * @return how many were found
     * @throws IllegalArgumentException if a value is out of range, or an array is too short
     */
    public int nearest(float x, float y, float within, int most, long[] handles, float[] distances) {
        return searches.nearest(filter, x, y, within, most, handles, distances);
    }

    /**
     * Finds the circles nearest to each of many points. Those of point q begin at element q * most of the arrays.
     *
     * @param points x and y of one after the other
     * @param n number of points, at least 0
     * @param within greatest distance, at least 0; positive infinity for any
     * @param most how many circles to find for each, at least 1
     * @param handles takes their handles, by distance, then by id, and then 0 up to the number that may be found; at least
     *     n * most elements
     * @param distances takes their distances, and then positive infinity, likewise; may be null
     * @return how many were found for all points together
     * @throws IllegalArgumentException if a value is out of range, or an array is too short
     */
    public int nearest(float[] points, int n, float within, int most, long[] handles, float[] distances) {
        return searches.nearest(filter, points, n, within, most, handles, distances);
    }
}
