package io.github.circles2d.world.changes;

import static io.github.circles2d.world.shared.Call.real;
import static java.lang.Float.floatToRawIntBits;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Explosion;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.search.BodyView;
import io.github.circles2d.world.search.TerrainView;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.WorldParts;

/** The calls that change many circles at once, all of them or none, and explosions. {@link PreparedChanges} has what each changes. */
public final class BulkChanges {
    /** Words of {@link Call#RIGID_IMPULSE}. */
    private static final int PUSH = 5;

    private final WorldParts world;
    private final PreparedChanges changes;
    private final Explosion explosion = new Explosion();
    private final TerrainView terrain;
    private final BodyView bodies;

    /** Where an explosion meets a body. */
    private final float[] hit = new float[CastSearch.HIT_STRIDE];

    /** The words of pushes of bodies, {@link #PUSH} each. */
    private int[] pushes = new int[0];

    private final int[] words = new int[Call.MOST_WORDS];

    public BulkChanges(WorldParts world, PreparedChanges changes, TerrainView terrain, BodyView bodies) {
        this.world = world;
        this.changes = changes;
        this.terrain = terrain;
        this.bodies = bodies;
    }

    /** Removes circles. Returns the number of handles that were left out, as all calls here do. */
    public int remove(long[] circles, int count, boolean skipStale) {
        return change(Commands.REMOVE, null, 0, circles, count, null, null, skipStale);
    }

    /** Puts circles somewhere else. Static ones travel there in the next step. */
    public int setPositions(long[] circles, int count, float[] values, boolean skipStale) {
        return change(Commands.POSITION, "positions", 2, circles, count, values, null, skipStale);
    }

    public int setVelocities(long[] circles, int count, float[] values, boolean skipStale) {
        return change(Commands.VELOCITY, "velocities", 2, circles, count, values, null, skipStale);
    }

    public int applyImpulses(long[] circles, int count, float[] values, boolean skipStale) {
        return change(Commands.IMPULSE, "impulses", 2, circles, count, values, null, skipStale);
    }

    public int setForces(long[] circles, int count, float[] values, boolean skipStale) {
        return change(Commands.FIELD, "forces", 2, circles, count, values, null, skipStale);
    }

    public int setAngularVelocities(long[] circles, int count, float[] values, boolean skipStale) {
        return change(Commands.ANGULAR_VELOCITY, "angularVelocities", 1, circles, count, values, null, skipStale);
    }

    public int setKinds(long[] circles, int count, int[] kinds, boolean skipStale) {
        return change(Commands.FIELD, "kinds", 1, circles, count, null, kinds, skipStale);
    }

    /**
     * Makes changes by one operation, in the order of the handles. There are so many values for each, of the name: floats, or kinds if they are not
     * null. Refuses stale handles, or leaves them out, and returns how many.
     */
    private int change(
            int operation,
            String name,
            int each,
            long[] circles,
            int count,
            float[] values,
            int[] kinds,
            boolean skipStale) {
        world.guard.enter();
        try (world.guard) {
            checkCount(circles, count);
            if (each > 0) {
                checkLength(name, each, kinds != null ? kinds.length : Limits.notNull(name, values).length, count);
            }
            changes.begin(count);
            int left = 0;
            for (int i = 0; i < count; i++) {
                int id = find(circles, i, skipStale);
                if (id < 0 || !prepare(operation, id, values, kinds, i, skipStale)) {
                    left++;
                }
            }
            changes.make(operation);
            return left;
        }
    }

    static void checkCount(long[] circles, int count) {
        Limits.notNull("handles", circles);
        if (count < 0 || count > circles.length) {
            throw new IllegalArgumentException("count is " + count + ", but must be from 0 to " + circles.length
                    + ", the number of elements of handles");
        }
    }

    static void checkLength(String name, int each, int length, int count) {
        if (length < (long) each * count) {
            throw new IllegalArgumentException(name + " has " + length + " elements, but must have "
                    + (long) each * count + ": " + each + " for each of " + count + " handles");
        }
    }

    /** Refuses kinds that are not one for each of so many; null are none. */
    static void checkKinds(int[] kinds, int n) {
        if (kinds != null && kinds.length != n) {
            throw new IllegalArgumentException(
                    "kinds has " + kinds.length + " elements, but must have one for each of " + n);
        }
    }

    /** Refuses an array, which may be null, without room for the handles of so many. */
    static void checkHandles(long[] to, int n, String what) {
        if (to != null && to.length < n) {
            throw new IllegalArgumentException(
                    "handles has " + to.length + " elements, but there are " + n + " " + what);
        }
    }

    /** The id of handle i; -1 if it is stale and left out. Each element is read once: another thread may write to the array. */
    private int find(long[] circles, int i, boolean skipStale) {
        long handle = circles[i];
        int id = world.handles.find(handle);
        if (id < 0 && !skipStale) {
            throw new IllegalArgumentException("handle " + i + ": " + WorldParts.goneCircle(handle));
        }
        return id;
    }

    /** Prepares change i. Returns false if its circle is gone by an earlier handle of the call, and left out. */
    private boolean prepare(int operation, int id, float[] values, int[] kinds, int i, boolean skipStale) {
        boolean isThere;
        try {
            isThere = prepare(operation, id, values, kinds, i);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("circle " + i + ": " + e.getMessage(), e);
        }
        if (!isThere && !skipStale) {
            throw new IllegalArgumentException(
                    "handle " + i + ": the circle with the handle " + world.handles.handle(id) + " occurs twice");
        }
        return isThere;
    }

    /** Reads each element once: another thread may write to the array. */
    private boolean prepare(int operation, int id, float[] values, int[] kinds, int i) {
        switch (operation) {
            case Commands.REMOVE -> {
                return changes.remove(id);
            }
            case Commands.POSITION -> changes.move(id, values[2 * i], values[2 * i + 1]);
            case Commands.VELOCITY -> changes.setVelocity(id, values[2 * i], values[2 * i + 1]);
            case Commands.IMPULSE -> changes.push(id, values[2 * i], values[2 * i + 1]);
            case Commands.ANGULAR_VELOCITY -> changes.setAngularVelocity(id, values[i]);
            default -> {
                if (kinds == null) {
                    changes.setForce(id, values[2 * i], values[2 * i + 1]);
                } else {
                    changes.setKind(id, kinds[i]);
                }
            }
        }
        return true;
    }

    /** {@link Explosion}; if masked, of circles and bodies whose kinds have a category of the mask. Returns how many got an impulse. */
    public int explode(boolean masked, int mask, float x, float y, float radius, float impulse, float falloff) {
        world.guard.enter();
        try (world.guard) {
            return explode(masked, mask, false, x, y, radius, impulse, falloff);
        }
    }

    /** The same of what no piece of terrain hides. */
    public int explodeInSight(boolean masked, int mask, float x, float y, float radius, float impulse, float falloff) {
        world.guard.enter();
        try (world.guard) {
            return explode(masked, mask, true, x, y, radius, impulse, falloff);
        }
    }

    private int explode(
            boolean masked, int mask, boolean inSight, float x, float y, float radius, float impulse, float falloff) {
        explosion.set(x, y, radius, impulse, falloff, world.settings.bounds());
        float[] circles = world.last.circles();
        boolean hides = inSight && terrain.look();
        int reached = prepareBodies(masked, mask, hides);
        changes.begin(0);
        int pushed = 0;
        int s = 0;
        for (int id = 0; id < world.handles.end(); id++) {
            if (world.handles.lives(id)) {
                int kind = world.handles.fields().getInt(CircleField.KIND, id);
                if ((!masked || isOf(kind, mask)) && explosion.reaches(circles, s) && !(hides && isHidden(kind))) {
                    changes.setChecked(Commands.IMPULSE, id, explosion.impulseX(), explosion.impulseY());
                    pushed++;
                }
                s += CircleRow.STRIDE;
            }
        }
        changes.make(Commands.IMPULSE);
        pushBodies(reached);
        return pushed + reached;
    }

    /** Prepares the pushes of bodies, and returns how many: what may lack memory comes before the first change. */
    private int prepareBodies(boolean masked, int mask, boolean hides) {
        if (!world.rigids.isThere()) {
            return 0;
        }
        int near = bodies.near(explosion.x(), explosion.y(), explosion.reach());
        if (pushes.length < PUSH * near) {
            pushes = new int[PUSH * Math.max(near, 2 * pushes.length / PUSH)];
        }
        int reached = 0;
        for (int k = 0; k < near; k++) {
            int body = bodies.id(k);
            bodies.read(k, hit);
            if ((!masked || isOf(world.rigids.step.kind[body], mask)) && reaches(body, hides)) {
                int at = PUSH * reached++;
                pushes[at] = body;
                pushes[at + 1] = floatToRawIntBits(explosion.impulseX());
                pushes[at + 2] = floatToRawIntBits(explosion.impulseY());
                pushes[at + 3] = place(hit[CastSearch.X]);
                pushes[at + 4] = place(hit[CastSearch.Y]);
            }
        }
        return reached;
    }

    private static int place(float coordinate) {
        return floatToRawIntBits(CircleMath.clamp(coordinate, -Limits.COORDINATE, Limits.COORDINATE));
    }

    /** Whether the body of the last hit gets an impulse: not if the explosion is at its centroid. */
    private boolean reaches(int body, boolean hides) {
        RigidStep step = world.rigids.step;
        return (step.x[body] != explosion.x() || step.y[body] != explosion.y())
                && explosion.reaches(
                        hit[CastSearch.DISTANCE],
                        hit[CastSearch.X],
                        hit[CastSearch.Y],
                        hit[CastSearch.NORMAL_X],
                        hit[CastSearch.NORMAL_Y])
                && !(hides && isHidden(step.kind[body]));
    }

    private void pushBodies(int count) {
        for (int k = 0; k < count; k++) {
            System.arraycopy(pushes, PUSH * k, words, 0, PUSH);
            world.calls.begin(Call.RIGID_IMPULSE, words);
            world.rigids.push(
                    words[0], real(words[1]), real(words[2]), real(words[3]), real(words[4]), world.settings.bounds());
            world.calls.end();
        }
    }

    /** Whether a kind has a category of a mask. */
    private boolean isOf(int kind, int mask) {
        return (world.kinds.get(KindField.CATEGORY, kind) & mask) != 0;
    }

    private boolean isHidden(int kind) {
        return terrain.isHidden(kind, explosion.x(), explosion.y(), explosion.dx(), explosion.dy());
    }
}
