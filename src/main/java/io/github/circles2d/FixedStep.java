package io.github.circles2d;

import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.world.bodies.RigidPoses;
import io.github.circles2d.world.circles.BulkCopies;
import io.github.circles2d.world.joints.JointEnds;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.terrain.BodyPoses;
import java.io.IOException;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.Arrays;

/**
 * A game loop with steps of one length, whatever the rate of frames: it makes the steps that are due, and gives a renderer positions
 * in between.
 *
 * <pre>{@code
 * FixedStep loop = new FixedStep(world, 1 / 60f);
 * Runnable steer = () -> world.setVelocity(player, stick.x(), stick.y()); // your own
 * while (running) {
 *     loop.advance(secondsSinceTheLastFrame, steer);
 *     FloatBuffer positions = loop.positions(null);
 *     draw(positions.get(2 * World.id(player)), positions.get(2 * World.id(player) + 1));
 * }
 * }</pre>
 *
 * <p><b>Steps.</b> Time is saved up until it is enough for a step. A frame makes at most {@link #setMaxSteps} of them, 5 at first;
 * whole steps that are due beyond that are dropped, and the game slows down. Otherwise, if a step takes longer than the time that it
 * simulates, each frame would owe more steps than the one before. Changes of the world that a replay is to repeat belong into the
 * Runnable: it runs before each step, so it sees the same steps at any rate of frames. Take events there, too: {@link World#events}
 * gives those of the step before. A frame may make no step at all, so keep a key press until the Runnable has seen it.
 *
 * <p><b>Positions</b> lie on the straight line from the place of a circle before the last step to its place after it; {@link #alpha} says
 * how far along. So they are up to a step old, and move evenly. No call comes between the two places: a circle that a call moves
 * elsewhere, or that is new, appears at its place and is not drawn across the screen. The effect of a call shows from the next step on,
 * except for {@link World#remove}: a removed circle is gone at once. {@link #radii} gives the radii of circles that grow, and {@link
 * #angles} the angles of circles that turn, likewise; {@link #pieces} and {@link #pose} have the terrain, {@link #bodies} the bodies that are pushed, and {@link #jointEnds} the joints.
 *
 * <p><b>A replay</b> is shown by {@link #advanceReplay} in place of {@link #advance}: it makes the steps of a log, and positions are as
 * smooth as in the game.
 *
 * <p><b>On an OpenCL device</b> {@link #advance} does not wait for the last step, only for the positions before it; {@link
 * #positions} waits for the step. A game that draws first and calls advance at the end of the frame does not wait there either: the
 * next frame finds the positions, which have been copied meanwhile.
 *
 * <p>It uses {@link World#requestPositions}: a game that has a FixedStep leaves the requests of its world to it. All other methods of
 * the world may be called at any time. One thread at a time uses it, as the world. Frames leave no garbage, once its memory has grown.
 */
public final class FixedStep {
    private static final int MAX_STEPS = 5;
    private static final int GREATEST_MAX_STEPS = 1000;
    private static final float GREATEST_SPEED = 1000;

    /** Floats in a buffer of its own that are drawn. */
    private static final class Shown {
        FloatBuffer values = ByteBuffer.allocateDirect(0).asFloatBuffer();
        private FloatBuffer view = values.asReadOnlyBuffer();

        /** Makes room, and keeps nothing. */
        void ensure(int floats) {
            if (values.capacity() < floats) {
                FloatBuffer larger = ByteBuffer.allocateDirect(Float.BYTES * (floats + (floats >> 1)))
                        .order(ByteOrder.nativeOrder())
                        .asFloatBuffer();
                view = larger.asReadOnlyBuffer();
                values = larger;
            }
        }

        FloatBuffer first(int floats) {
            ((Buffer) view).clear().limit(floats);
            return view;
        }
    }

    private final World world;
    private final float timeStep;
    private int maxSteps = MAX_STEPS;
    private float speed = 1;
    private long dropped;

    /** Seconds that no step has made up for yet. */
    private double saved;

    /** The positions by id before the last step; those after it if there was no step. */
    private FloatBuffer before;

    /** The positions by id after the last step; null while they are requested, or not known. */
    private FloatBuffer after;

    /** Whether the positions after the last step have been requested and not taken. */
    private boolean requested;

    /** The world's number of the last request. */
    private int request;

    private float[] from = new float[0];
    private float[] to = new float[0];
    private final Shown shown = new Shown();

    /** Whether the radii before and after each last step are kept, which is so from the first call of {@link #radii} on. */
    private boolean keepsRadii;

    /** Whether those of the last step are kept. */
    private boolean hasRadii;

    // By id: the radii before the last step, and after it.
    private float[] radiiBefore = new float[0];
    private float[] radiiAfter = new float[0];
    private final Shown shownRadii = new Shown();

    /** Whether the angles before and after each last step are kept, which is so from the first call of {@link #angles} on. */
    private boolean keepsAngles;

    /** Whether those of the last step are kept. */
    private boolean hasAngles;

    // By id, in units of a turn's 2^-32: the angles before the last step, and after it.
    private int[] anglesBefore = new int[0];
    private int[] anglesAfter = new int[0];
    private final Shown shownAngles = new Shown();

    /** Whether the poses of bodies of terrain before and after each last step are kept, from the first call that gives them on. */
    private boolean keepsBodies;

    /** Whether those of the last step are kept. */
    private boolean hasBodies;

    private final BodyPoses bodiesBefore = new BodyPoses();
    private final BodyPoses bodiesAfter = new BodyPoses();
    private final BodyPoses bodiesBetween = new BodyPoses();

    /** Whether the poses of bodies that are pushed are kept likewise. */
    private boolean keepsRigids;

    /** Whether those of the last step are kept. */
    private boolean hasRigids;

    private final RigidPoses rigidsBefore = new RigidPoses();
    private final RigidPoses rigidsAfter = new RigidPoses();

    private final JointEnds.Drawn drawn =
            new JointEnds.Drawn(bodiesBefore, bodiesAfter, bodiesBetween, rigidsBefore, rigidsAfter);

    /** Whether {@link #advance} is running. */
    private boolean advancing;

    /** Whether {@link #reset} has been called since it began. */
    private boolean wasReset;

    /**
     * A loop that has saved up no time.
     *
     * @param world the world that makes the steps
     * @param timeStep the length of each in seconds, 1e-6 to 1; games use 1 / 60f
     * @throws IllegalArgumentException if the value is out of range
     */
    public FixedStep(World world, float timeStep) {
        this.world = Limits.notNull("world", world);
        world.simulation().check();
        this.timeStep = Limits.within("the time step", timeStep, Limits.LEAST_STEP, Limits.GREATEST_STEP);
    }

    /**
     * Sets the most steps of a frame. At first 5.
     *
     * @param steps 1 to 1000
     * @throws IllegalArgumentException if the value is out of range
     */
    public void setMaxSteps(int steps) {
        maxSteps = Limits.within("the number of steps", steps, 1, GREATEST_MAX_STEPS);
    }

    /**
     * Sets how fast the time of the game goes by. The length of a step stays, so there are fewer or more of them, and positions in
     * between keep slow motion smooth.
     *
     * @param factor 0 (stands still) to 1000; 1 at first, and less than 1 for slow motion
     * @throws IllegalArgumentException if the value is out of range
     */
    public void setSpeed(float factor) {
        speed = Limits.within("the speed", factor, 0, GREATEST_SPEED);
    }

    /**
     * Makes the steps that are due. If the Runnable throws, or memory is short, the step that it came before and those after it are not
     * made, neither now nor later; those before it have been made. If memory is short, {@link #positions} are those of now until the next
     * step. The Runnable makes no steps of this world, unless it goes back in time, repeats steps and calls {@link #reset}. It may make
     * those of other worlds.
     *
     * @param frameSeconds time since the last frame in seconds, at least 0 and finite
     * @param beforeStep runs before each step; may be null. Keep one in a field: a lambda that is made in each frame may be garbage
     * @return the number of steps made, 0 to the greatest number of a frame
     * @throws IllegalArgumentException if the time is out of range
     * @throws IllegalStateException if the Runnable calls this method; or if it has made steps, which stay, and has not called {@link
     *     #reset}
     */
    public int advance(float frameSeconds, Runnable beforeStep) {
        int steps = due(frameSeconds);
        advancing = true;
        wasReset = false;
        try {
            return beforeStep == null ? make(steps) : make(steps, beforeStep);
        } finally {
            advancing = false;
        }
    }

    /**
     * Makes the steps that are due by a replay, with the changes before each. They take as much time here as the loop's own steps do,
     * whatever their lengths are in the log. When the log has come to its end ({@link Replay#hasEnded}), this is a {@link #reset}: the
     * positions are those of now, and the game may go on with {@link #advance}.
     *
     * @param frameSeconds time since the last frame in seconds, at least 0 and finite
     * @param replay a replay in the world of this loop
     * @return the number of steps made, 0 to the greatest number of a frame; fewer than are due at the end of the log
     * @throws IOException if the log's stream fails
     * @throws IllegalArgumentException if the time is out of range, the replay plays in another world, or the log is damaged or cut
     *     off
     */
    public int advanceReplay(float frameSeconds, Replay replay) throws IOException {
        if (!Limits.notNull("replay", replay).plays(world)) {
            throw new IllegalArgumentException("the replay plays in another world than that of this FixedStep");
        }
        int steps = due(frameSeconds);
        if (steps > 0) {
            forget();
        }
        for (int k = 0; k < steps; k++) {
            if (!replay.makeChanges()) {
                reset();
                return k;
            }
            if (k == steps - 1) {
                makeLast(replay);
            } else {
                replay.makeStep();
            }
        }
        return steps;
    }

    /** Saves up the time of a frame, and takes the steps out that are due. Returns how many these are. */
    private int due(float frameSeconds) {
        world.simulation().check();
        Limits.within("the time of the frame", frameSeconds, 0, Float.MAX_VALUE);
        if (advancing) {
            throw new IllegalStateException(
                    "the frame is being made: what runs before a step cannot make steps of its own");
        }
        double left = saved + (double) frameSeconds * speed;
        int steps = 0;
        while (left >= timeStep && steps < maxSteps) {
            left -= timeStep;
            steps++;
        }
        if (left >= timeStep) {
            long more = (long) (left / timeStep);
            dropped = Math.min(dropped, Long.MAX_VALUE - more) + more;
            left %= timeStep;
        }
        saved = left;
        return steps;
    }

    private int make(int steps) {
        if (steps > 1) {
            world.step(timeStep, steps - 1);
        }
        if (steps > 0) {
            makeLast();
        }
        return steps;
    }

    private int make(int steps, Runnable beforeStep) {
        for (int k = 1; k <= steps; k++) {
            long made = world.stepsMade();
            beforeStep.run();
            if (world.stepsMade() != made && !wasReset) {
                throw new IllegalStateException("the world has made steps between those of the loop:"
                        + " what runs before a step cannot make steps of its own, unless it calls reset");
            }
            if (k == steps || wasReset) {
                makeLast();
                return k;
            }
            world.step(timeStep);
        }
        return 0;
    }

    /** Makes a step, and has the positions before and after it copied. */
    private void makeLast() {
        forget();
        world.requestPositions();
        keepBefore();
        world.step(timeStep);
        showStep();
    }

    /** The same with the next step of a replay, the changes before which have been made. */
    private void makeLast(Replay replay) throws IOException {
        world.requestPositions();
        keepBefore();
        replay.makeStep();
        showStep();
    }

    /** Behind a step, which has been made: if its positions find no room, the next call for them gets those of then. */
    private void showStep() {
        try {
            keepAfter();
            takeBoth();
        } catch (OutOfMemoryError | DeviceMemoryException e) {
            forget();
        }
    }

    private void keepBefore() {
        if (keepsRadii) {
            ensureRadii(world.idLimit());
            world.readRadiiById(radiiBefore, null);
        }
        if (keepsAngles) {
            ensureAngles(world.idLimit());
            world.readAngleUnits(anglesBefore);
        }
        if (keepsBodies) {
            world.simulation().bodies.keep(bodiesBefore);
        }
        if (keepsRigids) {
            world.simulation().rigidReads.keep(rigidsBefore);
        }
    }

    private void keepAfter() {
        if (keepsRadii) {
            world.readRadiiById(radiiAfter, null);
            hasRadii = true;
        }
        if (keepsAngles) {
            world.readAngleUnits(anglesAfter);
            hasAngles = true;
        }
        if (keepsBodies) {
            world.simulation().bodies.keep(bodiesAfter);
            hasBodies = true;
        }
        if (keepsRigids) {
            world.simulation().rigidReads.keep(rigidsAfter);
            hasRigids = true;
        }
    }

    private void takeBoth() {
        FloatBuffer taken = world.takePositionsById(null); // waits for steps before this one alone
        request();
        before = taken;
    }

    private void request() {
        world.requestPositions();
        request = world.positionRequests();
        requested = true;
    }

    private void forget() {
        before = null;
        after = null;
        requested = false;
        hasRadii = false;
        hasAngles = false;
        hasBodies = false;
        hasRigids = false;
    }

    /**
     * Starts again from the world as it is: no time is saved up, and {@link #positions} are those of now until the next step. Call
     * this after {@link World#restore} and {@link Rewind#restore}, and when a level has been built. If the Runnable of {@link #advance}
     * calls it, the step that follows is the last one of the frame.
     */
    public void reset() {
        forget();
        saved = 0;
        wasReset = true;
    }

    /** {@return how far the positions are on the way from before the last step (0) to after it (1)} */
    public float alpha() {
        return (float) (saved / timeStep);
    }

    /** {@return the number of steps that were due and have been dropped, since more would have been made in a frame than are allowed; at least 0} */
    public long droppedSteps() {
        return dropped;
    }

    /**
     * The positions to draw, by id: element 2 k is x of the circle with the id k ({@link World#id}), and element 2 k + 1 is y. They are
     * NaN if no circle has the id. A circle that has been added since the last step, as in a game that is paused, is where it is now: to read
     * that, an OpenCL device is waited for. Before the first step, all positions are the present ones.
     *
     * @param living takes a bit for each id, 1 if there is a position: id k is bit k % 64 of element k / 64. Further bits become 0.
     *     It has an element for each 64 of {@link World#idLimit}, or more; may be null
     * @return two elements an id, from position 0 to the limit, in direct memory of the loop's own. Read-only, and often the same
     *     object: the next call overwrites it
     * @throws IllegalArgumentException if the array is too short
     * @throws IllegalStateException if the game has requested positions of its own since the last step
     */
    public FloatBuffer positions(long[] living) {
        take();
        int length = after.limit();
        int whole = 2 * ids();
        ensure(whole);
        BulkCopies.get(before, from, length);
        BulkCopies.get(after, to, length);
        float alpha = alpha();
        Bounds arena = world.arena();
        if (arena.wraps()) {
            interpolateTheShortWay(length, alpha, arena);
        } else {
            for (int k = 0; k < length; k++) {
                to[k] = from[k] + (to[k] - from[k]) * alpha;
            }
        }
        Arrays.fill(to, length, whole, Float.NaN);
        BulkCopies.put(shown.values, to, whole);
        world.markGone(shown.values, 2, living);
        for (int id = world.nextNew(0); id >= 0; id = world.nextNew(id + 1)) {
            long added = world.handle(id);
            shown.values.put(2 * id, world.x(added));
            shown.values.put(2 * id + 1, world.y(added));
        }
        return shown.first(whole);
    }

    /**
     * The radii to draw, by id: element k is the radius of the circle with the id k. A radius that {@link World#grow} changes lies on the
     * way from before the last step to after it, as far as {@link #alpha} says; one that {@link World#setRadius} has set changes at
     * once, with the next step. The same ids have NaN as in {@link #positions}. The loop keeps radii from the first call of this method
     * on. That call, and those before the first step, give the present radii.
     *
     * @return an element an id, from position 0 to the limit, in direct memory of the loop's own. Read-only, and often the same object:
     *     the next call overwrites it
     * @throws IllegalStateException if the game has requested positions of its own since the last step
     */
    public FloatBuffer radii() {
        take();
        keepsRadii = true;
        int whole = ids();
        ensureRadii(whole);
        if (!hasRadii) {
            world.readRadiiById(radiiBefore, null);
            world.readRadiiById(radiiAfter, null);
        }
        int length = after.limit() / 2;
        float alpha = alpha();
        for (int k = 0; k < length; k++) {
            shownRadii.values.put(k, radiiBefore[k] + (radiiAfter[k] - radiiBefore[k]) * alpha);
        }
        for (int k = length; k < whole; k++) {
            shownRadii.values.put(k, Float.NaN);
        }
        world.markGone(shownRadii.values, 1, null);
        for (int id = world.nextNew(0); id >= 0; id = world.nextNew(id + 1)) {
            shownRadii.values.put(id, world.radius(world.handle(id)));
        }
        return shownRadii.first(whole);
    }

    /**
     * The angles to draw, by id: element k is the angle of the circle with the id k. It lies on the short way from that before the last
     * step to that after it, as far as {@link #alpha} says; a circle that turns by more than half a turn in a step seems to turn the other
     * way. The same ids have NaN as in {@link #positions}. The loop keeps angles from the first call of this method on, and reads them
     * around the last step of each frame, so on an OpenCL device {@link #advance} waits for that step from then on. That call, and those
     * before the first step, give the present angles.
     *
     * @return an element an id, radians anticlockwise from -pi to pi, from position 0 to the limit, in direct memory of the loop's own.
     *     Read-only, and often the same object: the next call overwrites it
     * @throws IllegalStateException if the game has requested positions of its own since the last step
     */
    public FloatBuffer angles() {
        take();
        keepsAngles = true;
        int whole = ids();
        ensureAngles(whole);
        if (!hasAngles) {
            world.readAngleUnits(anglesBefore);
            world.readAngleUnits(anglesAfter);
        }
        int length = after.limit() / 2;
        float alpha = alpha();
        for (int k = 0; k < length; k++) {
            int way = anglesAfter[k] - anglesBefore[k]; // the short one: turns wrap
            shownAngles.values.put(k, Surface.radians(anglesBefore[k] + (int) ((double) way * alpha)));
        }
        for (int k = length; k < whole; k++) {
            shownAngles.values.put(k, Float.NaN);
        }
        world.markGone(shownAngles.values, 1, null);
        for (int id = world.nextNew(0); id >= 0; id = world.nextNew(id + 1)) {
            shownAngles.values.put(id, world.angle(world.handle(id)));
        }
        return shownAngles.first(whole);
    }

    /**
     * What the pieces of terrain to draw look like: as {@link Terrain#readPieces}, but with each body on the straight way from before the last
     * step to after it, as far as {@link #alpha} says. A body that a call puts elsewhere, or that is new, is at its place; what is removed is
     * gone at once. The loop keeps poses from the first call of this method, or of {@link #pose}, on. That call, and those before the first
     * step, give the present ones.
     *
     * @param pieces takes {@link Terrain#PIECE_STRIDE} elements a piece
     * @param handles takes their handles; may be null
     * @return the number of pieces
     * @throws IllegalArgumentException if an array is too short
     */
    public int pieces(float[] pieces, long[] handles) {
        keepBodies();
        return world.simulation()
                .pieces
                .readBetween(bodiesBefore, bodiesAfter, alpha(), bodiesBetween, pieces, handles);
    }

    /**
     * Where a body of terrain is to be drawn, likewise.
     *
     * @param body a body of the loop's world
     * @param pose takes x and y of its pivot, and its angle in radians
     * @throws IllegalArgumentException if the body is of another world or has been removed, or the array is shorter than three elements
     */
    public void pose(TerrainBody body, float[] pose) {
        long handle = Limits.notNull("body", body).handleIn(world.simulation());
        if (Limits.notNull("pose", pose).length < 3) {
            throw new IllegalArgumentException("pose has " + pose.length + " elements, but must have 3");
        }
        int id = world.simulation().bodies.require(handle);
        keepBodies();
        world.simulation().bodies.keepBetween(id, bodiesBefore, bodiesAfter, alpha(), bodiesBetween);
        pose[0] = (float) bodiesBetween.x(id);
        pose[1] = (float) bodiesBetween.y(id);
        pose[2] = Surface.radians(bodiesBetween.angle(id));
    }

    /**
     * Where the ends of joints are to be drawn: as {@link Joints#readEnds}, but each end is at its circle as {@link #positions} has it, or at
     * its place of a body of terrain as {@link #pose} has that. An anchor in the world is where it is now. What is removed or breaks is gone at once. The loop keeps poses as for {@link #pieces}.
     *
     * @param ends takes four elements a joint, in the order of their ids: x and y of the first end, then of the second one
     * @param handles takes the handles of the joints; may be null
     * @return the number of joints
     * @throws IllegalArgumentException if an array is too short
     * @throws IllegalStateException if the game has requested positions of its own since the last step
     */
    public int jointEnds(float[] ends, long[] handles) {
        FloatBuffer positions = positions(null);
        keepBodies();
        keepRigids();
        return world.simulation().jointReads.readEnds(drawn.at(positions, alpha()), ends, handles);
    }

    /**
     * Where the bodies that are pushed are to be drawn, by id: as {@link Bodies#readById}, but each on the straight way from before the last step to
     * after it, as far as {@link #alpha} says; it turns the short way. A body that a call puts elsewhere, or that is new, is at its place;
     * one that is removed is gone at once. The loop keeps poses from the first call of this method on. That call, and those before the first step, give the
     * present ones.
     *
     * @param bodies takes three elements an id: x and y of the centroid, and the angle in radians. All of it is written: elements without a body
     *     become NaN
     * @param living takes a bit for each id, 1 if there is such a body, as with {@link World#readById}; may be null
     * @throws IllegalArgumentException if an array is too short
     */
    public void bodies(float[] bodies, long[] living) {
        keepRigids();
        world.simulation().rigidReads.readBetween(rigidsBefore, rigidsAfter, alpha(), bodies, living);
    }

    private void keepBodies() {
        keepsBodies = true;
        if (!hasBodies) {
            world.simulation().bodies.keep(bodiesBefore);
            world.simulation().bodies.keep(bodiesAfter);
        }
    }

    private void keepRigids() {
        keepsRigids = true;
        if (!hasRigids) {
            world.simulation().rigidReads.keep(rigidsBefore);
            world.simulation().rigidReads.keep(rigidsAfter);
        }
    }

    /** A circle that has crossed the seam is drawn on its way across, on one side or the other. */
    private void interpolateTheShortWay(int length, float alpha, Bounds arena) {
        float periodX = arena.periodX();
        float periodY = arena.periodY();
        for (int k = 0; k < length; k += 2) {
            to[k] = arena.placeX(from[k] + CircleMath.shortWay(to[k] - from[k], periodX) * alpha);
            to[k + 1] = arena.placeY(from[k + 1] + CircleMath.shortWay(to[k + 1] - from[k + 1], periodY) * alpha);
        }
    }

    private void take() {
        if (after == null || before == after) {
            if (!requested) {
                request();
                before = null;
                after = null;
            }
            requireOwnRequest();
            after = world.takePositionsById(null);
            requested = false;
            if (before == null) {
                before = after;
            }
        }
        requireOwnRequest();
    }

    /** How many ids have a place: those of the last request, and those that have come since. */
    private int ids() {
        return Math.max(after.limit() / 2, world.idLimit());
    }

    private void requireOwnRequest() {
        if (world.positionRequests() != request) {
            throw new IllegalStateException("the world's positions have been requested since the last step:"
                    + " leave requestPositions to the FixedStep, or call reset");
        }
    }

    private void ensure(int length) {
        shown.ensure(length);
        if (to.length < length) {
            from = new float[shown.values.capacity()];
            to = new float[shown.values.capacity()];
        }
    }

    /** Makes room for radii, and keeps those that are there. */
    private void ensureRadii(int ids) {
        shownRadii.ensure(ids);
        if (radiiAfter.length < ids) {
            radiiBefore = Arrays.copyOf(radiiBefore, shownRadii.values.capacity());
            radiiAfter = Arrays.copyOf(radiiAfter, shownRadii.values.capacity());
        }
    }

    /** As {@link #ensureRadii}. */
    private void ensureAngles(int ids) {
        shownAngles.ensure(ids);
        if (anglesAfter.length < ids) {
            anglesBefore = Arrays.copyOf(anglesBefore, shownAngles.values.capacity());
            anglesAfter = Arrays.copyOf(anglesAfter, shownAngles.values.capacity());
        }
    }
}
