package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Arrays;

/**
 * The forces and torques on circles. The one that is set for a circle is a field that steps read. What is applied for one step waits on the
 * host: the pipelines get the sum for that step, and then what was set again. If a step fails before it has begun, the next one does the
 * same once more.
 */
public final class Forces implements Calls.Effects {
    private final WorldParts world;
    private final CircleFields fields;

    /** Circles on which a force or a torque may have been applied since the last step; some may be gone. */
    private int[] ids = new int[16];

    private int count;

    /** Whether the step that is being made is theirs. */
    private boolean acting;

    public Forces(WorldParts world) {
        this.world = world;
        fields = world.handles.fields();
        world.calls.define(this, Call.FORCE, Call.TORQUE);
    }

    /** Whether some circle has a force, or has had one. */
    public boolean drive() {
        return fields.isUsed(CircleField.FORCE_X)
                || fields.isUsed(CircleField.FORCE_Y)
                || fields.isUsed(CircleField.APPLIED_X)
                || fields.isUsed(CircleField.APPLIED_Y);
    }

    @Override
    public long make(Call call, int[] w) {
        if (call == Call.FORCE) {
            apply(w[0], Call.real(w[1]), Call.real(w[2]));
        } else {
            applyTorque(w[0], Call.real(w[1]));
        }
        return 0;
    }

    /** Applies a force to a circle in the next step. */
    public void apply(long circle, float x, float y) {
        world.guard.enter();
        try (world.guard) {
            apply(world.circle(circle), x, y);
        }
    }

    private void apply(int id, float x, float y) {
        Limits.force(x, y);
        ensure();
        fields.ensure(CircleField.APPLIED_X, id + 1);
        fields.ensure(CircleField.APPLIED_Y, id + 1);
        world.copies.forgetSaved();
        world.calls.begin(Call.FORCE, id, Float.floatToRawIntBits(x), Float.floatToRawIntBits(y), 0);
        list(id);
        add(CircleField.APPLIED_X, id, x);
        add(CircleField.APPLIED_Y, id, y);
        world.calls.end();
    }

    /** Applies a torque to a circle in the next step. */
    public void applyTorque(long circle, float torque) {
        world.guard.enter();
        try (world.guard) {
            applyTorque(world.circle(circle), torque);
        }
    }

    private void applyTorque(int id, float torque) {
        Limits.within("torque", torque, -Limits.TORQUE, Limits.TORQUE);
        ensure();
        fields.ensure(CircleField.APPLIED_TORQUE, id + 1);
        world.copies.forgetSaved();
        world.calls.begin(Call.TORQUE, id, Float.floatToRawIntBits(torque), 0, 0);
        world.needs.askToTurn();
        list(id);
        add(CircleField.APPLIED_TORQUE, id, torque);
        world.calls.end();
    }

    /** Makes room for one more circle that a force or a torque is applied to. */
    private void ensure() {
        if (count == ids.length) {
            ids = Arrays.copyOf(ids, 2 * count);
        }
    }

    private void add(CircleField applied, int id, float more) {
        fields.set(applied, id, CircleField.bits(sum(fields.getFloat(applied, id), more)));
    }

    private void list(int id) {
        if (!isForced(id) && !isTurned(id)) {
            ids[count++] = id;
        }
    }

    private boolean isForced(int id) {
        return fields.getInt(CircleField.APPLIED_X, id) != 0 || fields.getInt(CircleField.APPLIED_Y, id) != 0;
    }

    private boolean isTurned(int id) {
        return fields.getInt(CircleField.APPLIED_TORQUE, id) != 0;
    }

    /** The sum of two forces or torques, within the greatest one, which is the same for both; never -0. */
    private static float sum(float a, float b) {
        return CircleMath.clamp(a + b, -Limits.FORCE, Limits.FORCE) + 0f;
    }

    /** Whether no force or torque acts in the next step alone. */
    boolean isEmpty() {
        return count == 0;
    }

    /** The number of commands that {@link #begin} records at most. */
    int most() {
        return 3 * count;
    }

    /** Before the step: records what acts in it alone. There is room. */
    void begin() {
        acting = true;
        for (int k = 0; k < count; k++) {
            if (isForced(ids[k])) {
                hand(ids[k], CircleField.FORCE_X, CircleField.APPLIED_X);
                hand(ids[k], CircleField.FORCE_Y, CircleField.APPLIED_Y);
            }
            if (isTurned(ids[k])) {
                hand(ids[k], CircleField.TORQUE, CircleField.APPLIED_TORQUE);
            }
        }
    }

    private void hand(int id, CircleField set, CircleField applied) {
        world.commands.setField(set, id, sum(set, applied, id));
    }

    private int sum(CircleField set, CircleField applied, int id) {
        return CircleField.bits(sum(fields.getFloat(set, id), fields.getFloat(applied, id)));
    }

    /** What acts in the step that is being made alone, for a pipeline that takes it over. */
    void carry(CircleFields into) {
        for (int k = 0; acting && k < count; k++) {
            if (isForced(ids[k])) {
                carry(into, ids[k], CircleField.FORCE_X, CircleField.APPLIED_X);
                carry(into, ids[k], CircleField.FORCE_Y, CircleField.APPLIED_Y);
            }
            if (isTurned(ids[k])) {
                carry(into, ids[k], CircleField.TORQUE, CircleField.APPLIED_TORQUE);
            }
        }
    }

    private void carry(CircleFields into, int id, CircleField set, CircleField applied) {
        into.ensure(set, id + 1);
        into.set(set, id, sum(set, applied, id));
    }

    /** The step has not been made. */
    void undo() {
        acting = false;
    }

    /** After the step: puts back what has been set. There is room, since as many records were there for {@link #begin}. */
    void end() {
        for (int k = 0; k < count; k++) {
            int id = ids[k];
            if (isForced(id)) {
                world.commands.setField(CircleField.FORCE_X, id, fields.getInt(CircleField.FORCE_X, id));
                world.commands.setField(CircleField.FORCE_Y, id, fields.getInt(CircleField.FORCE_Y, id));
                fields.set(CircleField.APPLIED_X, id, 0);
                fields.set(CircleField.APPLIED_Y, id, 0);
            }
            if (isTurned(id)) {
                world.commands.setField(CircleField.TORQUE, id, fields.getInt(CircleField.TORQUE, id));
                fields.set(CircleField.APPLIED_TORQUE, id, 0);
            }
        }
        count = 0;
        acting = false;
    }

    void makeRoom(SavedState from) {
        int forced = from.fields.used(CircleField.APPLIED_X) + from.fields.used(CircleField.APPLIED_Y);
        int turned = from.fields.used(CircleField.APPLIED_TORQUE);
        if (ids.length < forced + turned) {
            ids = new int[forced + turned];
        }
        if (turned > 0) {
            fields.ensure(CircleField.APPLIED_TORQUE, from.ids);
        }
        if (forced > 0) {
            fields.ensure(CircleField.APPLIED_X, from.ids);
            fields.ensure(CircleField.APPLIED_Y, from.ids);
        }
    }

    /** A saved state, for which there is room, has taken the place of the circles. */
    void restored(SavedState from) {
        count = 0;
        for (int id = 0; id < from.ids; id++) {
            if (isForced(id) || isTurned(id)) {
                ids[count++] = id;
            }
        }
    }
}
