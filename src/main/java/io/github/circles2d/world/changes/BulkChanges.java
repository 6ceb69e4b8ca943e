package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Explosion;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.search.CategoryFilter;
import io.github.circles2d.world.search.TerrainView;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.WorldParts;
import java.util.function.ToIntFunction;

/** The calls that change many circles at once, all of them or none. {@link PreparedChanges} has what each changes. */
public final class BulkChanges {
    /** Prepares what a call does to a circle. A is the type of the array that has the call's values. */
    private interface Preparation<A> {
        /** False if the circle is gone by an earlier handle of the call. Reads element i once: another thread may write to the array. */
        boolean prepare(int id, A values, int i);
    }

    private interface PreparationOfTwo {
        void prepare(int id, float x, float y);
    }

    /** A call with many handles, and elements for each; the name of its values is null if it has none. */
    private record ManyChanges<A>(
            String values, int each, ToIntFunction<A> length, int operation, Preparation<A> preparation) {}

    private final WorldParts world;
    private final PreparedChanges changes;
    private final Explosion explosion = new Explosion();
    private final CategoryFilter filter;
    private final TerrainView view;

    private final ManyChanges<Void> removal;
    private final ManyChanges<float[]> positions;
    private final ManyChanges<float[]> velocities;
    private final ManyChanges<float[]> impulses;
    private final ManyChanges<float[]> forces;
    private final ManyChanges<float[]> angularVelocities;
    private final ManyChanges<int[]> kinds;

    public BulkChanges(WorldParts world, PreparedChanges changes, TerrainView view) {
        this.world = world;
        this.changes = changes;
        this.view = view;
        removal = new ManyChanges<>(null, 0, values -> 0, Commands.REMOVE, (id, values, i) -> changes.remove(id));
        positions = ofTwo("positions", Commands.POSITION, changes::move);
        velocities = ofTwo("velocities", Commands.VELOCITY, (id, x, y) -> changes.set(Call.VELOCITY, id, x, y));
        impulses = ofTwo("impulses", Commands.IMPULSE, (id, x, y) -> changes.set(Call.IMPULSE, id, x, y));
        forces = ofTwo("forces", Commands.FIELD, changes::setForce);
        angularVelocities = new ManyChanges<>(
                "angularVelocities", 1, values -> values.length, Commands.ANGULAR_VELOCITY, (id, values, i) -> {
                    changes.setAngularVelocity(id, values[i]);
                    return true;
                });
        kinds = new ManyChanges<>("kinds", 1, values -> values.length, Commands.FIELD, (id, values, i) -> {
            changes.setKind(id, values[i]);
            return true;
        });
        filter = new CategoryFilter(world, 0);
    }

    private static ManyChanges<float[]> ofTwo(String values, int operation, PreparationOfTwo preparation) {
        return new ManyChanges<>(values, 2, array -> array.length, operation, (id, array, i) -> {
            preparation.prepare(id, array[2 * i], array[2 * i + 1]);
            return true;
        });
    }

    /** Removes circles. Returns the number of handles that were left out, as all calls here do. */
    public int remove(long[] circles, int count, boolean skipStale) {
        return change(removal, circles, count, null, skipStale);
    }

    /** Puts circles somewhere else. Static ones travel there in the next step. */
    public int setPositions(long[] circles, int count, float[] values, boolean skipStale) {
        return change(positions, circles, count, values, skipStale);
    }

    public int setVelocities(long[] circles, int count, float[] values, boolean skipStale) {
        return change(velocities, circles, count, values, skipStale);
    }

    public int applyImpulses(long[] circles, int count, float[] values, boolean skipStale) {
        return change(impulses, circles, count, values, skipStale);
    }

    public int setForces(long[] circles, int count, float[] values, boolean skipStale) {
        return change(forces, circles, count, values, skipStale);
    }

    public int setAngularVelocities(long[] circles, int count, float[] values, boolean skipStale) {
        return change(angularVelocities, circles, count, values, skipStale);
    }

    public int setKinds(long[] circles, int count, int[] values, boolean skipStale) {
        return change(kinds, circles, count, values, skipStale);
    }

    /** In the order of the handles. Refuses stale handles, or leaves them out, and returns how many. */
    private <A> int change(ManyChanges<A> call, long[] circles, int count, A values, boolean skipStale) {
        world.guard.enter();
        try {
            checkLengths(call, circles, count, values);
            changes.begin(count);
            int left = 0;
            for (int i = 0; i < count; i++) {
                int id = find(circles, i, skipStale);
                if (id < 0 || !prepare(call, id, values, i, skipStale)) {
                    left++;
                }
            }
            changes.makeRoom(call.operation);
            changes.writeToLog();
            changes.make(call.operation);
            return left;
        } catch (RuntimeException | Error e) {
            throw world.guard.failed(e);
        } finally {
            world.guard.user = null;
        }
    }

    private static <A> void checkLengths(ManyChanges<A> call, long[] circles, int count, A values) {
        Limits.notNull("handles", circles);
        if (count < 0 || count > circles.length) {
            throw new IllegalArgumentException("count is " + count + ", but must be from 0 to " + circles.length
                    + ", the number of elements of handles");
        }
        if (call.each > 0) {
            Limits.notNull(call.values, values);
            int length = call.length.applyAsInt(values);
            if (length < (long) call.each * count) {
                throw new IllegalArgumentException(call.values + " has " + length + " elements, but must have "
                        + (long) call.each * count + ": " + call.each + " for each of " + count + " handles");
            }
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

    private <A> boolean prepare(ManyChanges<A> call, int id, A values, int i, boolean skipStale) {
        boolean isThere;
        try {
            isThere = call.preparation.prepare(id, values, i);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("circle " + i + ": " + e.getMessage(), e);
        }
        if (!isThere && !skipStale) {
            throw new IllegalArgumentException(
                    "handle " + i + ": the circle with the handle " + world.handles.handle(id) + " occurs twice");
        }
        return isThere;
    }

    /** {@link Explosion}; if masked, of circles whose kinds have a category of the mask. Returns how many got an impulse. */
    public int explode(boolean masked, int mask, float x, float y, float radius, float impulse, float falloff) {
        world.guard.enter();
        try {
            return explode(masked, mask, false, x, y, radius, impulse, falloff);
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    /** The same of the circles that no piece of terrain hides. */
    public int explodeInSight(boolean masked, int mask, float x, float y, float radius, float impulse, float falloff) {
        world.guard.enter();
        try {
            return explode(masked, mask, true, x, y, radius, impulse, falloff);
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    private int explode(
            boolean masked, int mask, boolean inSight, float x, float y, float radius, float impulse, float falloff) {
        explosion.set(x, y, radius, impulse, falloff, world.settings.bounds());
        filter.setMask(mask);
        float[] circles = world.last.circles();
        boolean hides = inSight && view.look();
        changes.begin(0);
        int pushed = 0;
        int s = 0;
        for (int id = 0; id < world.handles.end(); id++) {
            if (world.handles.lives(id)) {
                if ((!masked || filter.admits(id)) && explosion.reaches(circles, s) && !(hides && isHidden(id))) {
                    changes.setChecked(Commands.IMPULSE, id, explosion.impulseX(), explosion.impulseY());
                    pushed++;
                }
                s += CircleRow.STRIDE;
            }
        }
        changes.writeToLog();
        changes.make(Commands.IMPULSE);
        return pushed;
    }

    private boolean isHidden(int id) {
        return view.isHidden(id, explosion.x(), explosion.y(), explosion.dx(), explosion.dy());
    }
}
