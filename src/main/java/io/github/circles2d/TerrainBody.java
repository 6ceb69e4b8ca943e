package io.github.circles2d;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Call;

/**
 * A body of {@link Terrain}: pieces that move together, such as a lift, a flipper, a drum or a door. It has a place, which is its pivot, and
 * an angle. It moves as its velocities say, whatever is in its way: circles are pushed and carried, and never stop it.
 *
 * <pre>{@code
 * TerrainBody flipper = world.terrain().addBody(4, 2, 0);
 * flipper.addSegment(0, 0, 2, 0); // in the body's own coordinates, from its pivot
 * flipper.setAngularVelocity(30);
 * }</pre>
 *
 * <p>A body that has been removed refuses all calls but {@link #handle} and {@link #exists}. The ground refuses to move. The rules of {@link
 * World} for threads, failures and closed worlds hold here, too.
 */
public final class TerrainBody {
    private final Simulation simulation;
    private long handle;

    TerrainBody(Simulation simulation) {
        this.simulation = simulation;
    }

    /** This is the body that has the handle. The object is made first, since memory may end. */
    TerrainBody of(long itsHandle) {
        handle = itsHandle;
        return this;
    }

    /** {@return the handle of the body, never 0} */
    public long handle() {
        return handle;
    }

    /** The handle, for a call of the body's own world. */
    long handleIn(Simulation world) {
        if (world != simulation) {
            throw new IllegalArgumentException("the body with the handle " + handle + " is of another world");
        }
        return handle;
    }

    /** {@return whether the body is there: nobody has removed it, nor restored a state without it; true at first} */
    public boolean exists() {
        return simulation.bodyIds.contains(handle);
    }

    // ---- pieces

    /**
     * Adds a segment of kind 0 without thickness. It has two sides.
     *
     * @param x1 x of an end, in the body's coordinates, up to 1e9 in magnitude
     * @param y1 y of it
     * @param x2 x of the other end
     * @param y2 y of it
     * @return the handle of the piece
     * @throws IllegalArgumentException if a value is out of range, the segment is not longer than 2^-20 of its coordinates, or it is longer
     *     than half an axis that wraps
     */
    public long addSegment(float x1, float y1, float x2, float y2) {
        return addSegment(x1, y1, x2, y2, 0, 0);
    }

    /**
     * Adds a segment. It has two sides.
     *
     * @param x1 x of an end, in the body's coordinates, up to 1e9 in magnitude
     * @param y1 y of it
     * @param x2 x of the other end
     * @param y2 y of it
     * @param thickness radius around the segment, which makes it a capsule; at least 0
     * @param kind the number of its kind, 0 to 255
     * @return the handle of the piece
     * @throws IllegalArgumentException as {@link #addSegment(float, float, float, float)}, or if there is no such kind
     */
    public long addSegment(float x1, float y1, float x2, float y2, float thickness, int kind) {
        return simulation.pieces.addSegment(handle, kind, x1, y1, x2, y2, thickness);
    }

    /**
     * Adds an arc of kind 0.
     *
     * @param x x of the centre, in the body's coordinates, up to 1e9 in magnitude
     * @param y y of the centre
     * @param radius more than 2^-20 of the coordinates of the centre
     * @param from where the arc begins, an angle in radians
     * @param to where it ends, anticlockwise from there; more than {@code from}, by 2 pi for a circle
     * @param side the side that circles touch
     * @return the handle of the piece
     * @throws IllegalArgumentException if a value is out of range, or the arc is wider than half an axis that wraps
     */
    public long addArc(float x, float y, float radius, float from, float to, ArcSide side) {
        return addArc(x, y, radius, from, to, side, 0);
    }

    /**
     * Adds an arc.
     *
     * @param x x of the centre, in the body's coordinates, up to 1e9 in magnitude
     * @param y y of the centre
     * @param radius more than 2^-20 of the coordinates of the centre
     * @param from where the arc begins, an angle in radians
     * @param to where it ends, anticlockwise from there; more than {@code from}, by 2 pi for a circle
     * @param side the side that circles touch
     * @param kind the number of its kind, 0 to 255
     * @return the handle of the piece
     * @throws IllegalArgumentException as {@link #addArc(float, float, float, float, float, ArcSide)}, or if there is no such kind
     */
    public long addArc(float x, float y, float radius, float from, float to, ArcSide side, int kind) {
        boolean inside = Limits.notNull("side", side) == ArcSide.INNER;
        return simulation.pieces.addArc(handle, kind, x, y, radius, from, to, inside);
    }

    /**
     * Adds the pieces of a chain, of kind 0.
     *
     * @param chain the chain, in the body's coordinates; it may be changed and used again
     * @return the number of pieces
     * @throws IllegalArgumentException if the chain has none, or a piece is longer than half an axis that wraps
     */
    public int addChain(Chain chain) {
        return addChain(chain, 0, null);
    }

    /**
     * Adds the pieces of a chain.
     *
     * @param chain the chain, in the body's coordinates; it may be changed and used again
     * @param kind the number of their kind, 0 to 255
     * @param handles takes the handles of the pieces in their order; may be null
     * @return the number of pieces
     * @throws IllegalArgumentException as {@link #addChain(Chain)}, or if there is no such kind, or the array is too short
     */
    public int addChain(Chain chain, int kind, long[] handles) {
        return simulation.pieces.addChain(handle, Limits.notNull("chain", chain).path(), kind, handles);
    }

    /**
     * Adds many segments without thickness, all or none.
     *
     * @param ends x1, y1, x2 and y2 of one after the other, as {@link #addSegment(float, float, float, float)} takes them
     * @param kind the number of their kind, 0 to 255
     * @param handles takes the handles of the pieces; may be null
     * @return the number of segments
     * @throws IllegalArgumentException if a segment is refused, with its index; if there is no such kind; or if an array has a wrong length
     */
    public int addSegments(float[] ends, int kind, long[] handles) {
        return simulation.pieces.addSegments(handle, ends, kind, handles);
    }

    // ---- motion

    /**
     * Sets the velocity of the pivot, until the next call.
     *
     * @param vx velocity along x, lengths per second, up to 1e9 in magnitude
     * @param vy velocity along y, likewise
     * @throws IllegalArgumentException if a value is out of range, or this is the ground
     */
    public void setVelocity(float vx, float vy) {
        simulation.calls.changeByFloats(Call.BODY_VELOCITY, handle, vx, vy, 0, 0);
    }

    /**
     * Sets how fast the body turns around its pivot, until the next call. It turns less than half a turn a sub-step, however fast it
     * should.
     *
     * @param velocity radians per second, anticlockwise where y points up, up to 1e9 in magnitude
     * @throws IllegalArgumentException if the value is out of range, or this is the ground
     */
    public void setAngularVelocity(float velocity) {
        simulation.calls.changeByFloats(Call.BODY_ANGULAR_VELOCITY, handle, velocity, 0, 0, 0);
    }

    /**
     * Lets the body travel to a place within the next step, the short way round if an axis wraps; it turns the short way, too. Circles in
     * its way are pushed. From then on it moves by its velocities again. A second call before the step takes the place of the first.
     *
     * @param x x of the pivot at the end of the step, up to 1e9 in magnitude
     * @param y y of the pivot, likewise
     * @param angle the angle then, in radians, up to 1e6 in magnitude
     * @throws IllegalArgumentException if a value is out of range, or this is the ground
     */
    public void moveTo(float x, float y, float angle) {
        simulation.calls.changeByFloats(Call.MOVE_BODY, handle, x, y, angle, 0);
    }

    /**
     * Puts the body somewhere else at once. Circles on it stay where they are; those in its place are pushed out slowly.
     *
     * @param x x of the pivot, up to 1e9 in magnitude
     * @param y y of the pivot, likewise
     * @param angle the angle in radians, up to 1e6 in magnitude
     * @throws IllegalArgumentException if a value is out of range, or this is the ground
     */
    public void teleport(float x, float y, float angle) {
        simulation.calls.changeByFloats(Call.TELEPORT_BODY, handle, x, y, angle, 0);
    }

    /**
     * Removes the body with its pieces.
     *
     * @throws IllegalArgumentException if this is the ground, or the body has been removed
     */
    public void remove() {
        simulation.calls.change(Call.REMOVE_BODY, handle);
    }

    /** {@return where the pivot is along x} */
    public float x() {
        return simulation.bodies.x(handle);
    }

    /** {@return where the pivot is along y} */
    public float y() {
        return simulation.bodies.y(handle);
    }

    /** {@return the angle of the body in radians, at least -pi and less than pi} */
    public float angle() {
        return simulation.bodies.angle(handle);
    }

    /**
     * Where a place of the world is in this body's own coordinates now. Rays and circles give places of the world, and pieces and joints on a body
     * take its own: so a rope hangs on what a ray has hit, and goes with it.
     *
     * <pre>{@code
     * float[] hit = new float[Queries.HIT_STRIDE];
     * long piece = world.queries().terrain().rayCast(world.x(player), world.y(player), 30, 40, hit);
     * if (piece != 0) {
     *     TerrainBody body = world.terrain().bodyOf(piece); // the ground, or a body that moves
     *     float x = body.localX(hit[Queries.X], hit[Queries.Y]);
     *     float y = body.localY(hit[Queries.X], hit[Queries.Y]);
     *     rope = world.joints().add(player, body, x, y, Joint.rope(hit[Queries.DISTANCE]));
     * }
     * }</pre>
     *
     * <p>The coordinates of the ground are the world's. Along an axis that wraps, the place is the image that is nearest to the pivot.
     *
     * @param worldX x of the place in the world, up to 1e9 in magnitude
     * @param worldY y of it
     * @return x of the place in the body's coordinates
     * @throws IllegalArgumentException if a value is out of range, or the body has been removed
     */
    public float localX(float worldX, float worldY) {
        return simulation.bodies.localX(handle, worldX, worldY);
    }

    /**
     * Where a place of the world is in this body's own coordinates now; see {@link #localX}.
     *
     * @param worldX x of the place in the world, up to 1e9 in magnitude
     * @param worldY y of it
     * @return y of the place in the body's coordinates
     * @throws IllegalArgumentException if a value is out of range, or the body has been removed
     */
    public float localY(float worldX, float worldY) {
        return simulation.bodies.localY(handle, worldX, worldY);
    }

    /**
     * Where a place of this body is in the world now. Along an axis that wraps, it is inside.
     *
     * @param localX x of the place in the body's coordinates, up to 1e9 in magnitude
     * @param localY y of it
     * @return x of the place in the world
     * @throws IllegalArgumentException if a value is out of range, or the body has been removed
     */
    public float worldX(float localX, float localY) {
        return simulation.bodies.worldX(handle, localX, localY);
    }

    /**
     * Where a place of this body is in the world now; see {@link #worldX}.
     *
     * @param localX x of the place in the body's coordinates, up to 1e9 in magnitude
     * @param localY y of it
     * @return y of the place in the world
     * @throws IllegalArgumentException if a value is out of range, or the body has been removed
     */
    public float worldY(float localX, float localY) {
        return simulation.bodies.worldY(handle, localX, localY);
    }

    /**
     * How fast the body has carried a place along x in the last step, whether it moved by its velocities or by {@link #moveTo}. At the pivot,
     * {@code vxAt(body.x(), body.y())}, it is the velocity that the body really had.
     *
     * <pre>{@code
     * world.setVelocity(hero, walk + lift.vxAt(world.x(hero), world.y(hero)), world.vy(hero)); // walks as fast on a lift as on the ground
     * }</pre>
     *
     * <p>It is 0 before the first step, after {@link #teleport}, and of the ground. Snapshots keep it; {@link World#hash} leaves it out, since
     * no step depends on it.
     *
     * @param worldX x of the place in the world, up to 1e9 in magnitude; the image that is nearest to the pivot along an axis that wraps
     * @param worldY y of it, likewise
     * @return lengths per second
     * @throws IllegalArgumentException if a value is out of range, or the body has been removed
     */
    public float vxAt(float worldX, float worldY) {
        return simulation.bodies.vxAt(handle, worldX, worldY);
    }

    /**
     * How fast the body has carried a place along y in the last step; see {@link #vxAt}.
     *
     * @param worldX x of the place in the world, up to 1e9 in magnitude
     * @param worldY y of it
     * @return lengths per second
     * @throws IllegalArgumentException if a value is out of range, or the body has been removed
     */
    public float vyAt(float worldX, float worldY) {
        return simulation.bodies.vyAt(handle, worldX, worldY);
    }

    /** {@return the velocity along x that was set, in lengths per second; 0 at first; {@link #vxAt} has the real one} */
    public float vx() {
        return simulation.bodies.vx(handle);
    }

    /** {@return the velocity along y that was set, in lengths per second; 0 at first; {@link #vyAt} has the real one} */
    public float vy() {
        return simulation.bodies.vy(handle);
    }

    /** {@return the angular velocity that was set, in radians per second; 0 at first} */
    public float angularVelocity() {
        return simulation.bodies.angularVelocity(handle);
    }

    @Override
    public String toString() {
        return "terrain body " + handle;
    }
}
