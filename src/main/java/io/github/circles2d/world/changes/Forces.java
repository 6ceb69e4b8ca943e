package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Limits;
import java.util.Arrays;

/**
 * The forces and torques on circles. The one that is set for a circle is a field that steps read. What is applied for one step waits on the
 * host: the pipelines get the sum for that step, and then what was set again. If a step fails before it has begun, the next one does the
 * same once more.
 */
public final class Forces {
    private final CircleFields fields;
    private final Commands commands;

    /** Circles on which a force or a torque may have been applied since the last step; some may be gone. */
    private int[] ids = new int[16];

    private int count;

    public Forces(HandleTable handles, Commands commands) {
        this.commands = commands;
        fields = handles.fields();
    }

    /** Whether some circle has a force, or has had one. */
    public boolean drive() {
        return fields.isUsed(CircleField.FORCE_X)
                || fields.isUsed(CircleField.FORCE_Y)
                || fields.isUsed(CircleField.APPLIED_X)
                || fields.isUsed(CircleField.APPLIED_Y);
    }

    /** Makes room for one more circle that a force or a torque is applied to. */
    void ensure() {
        if (count == ids.length) {
            ids = Arrays.copyOf(ids, 2 * count);
        }
    }

    /** Applies a force in the next step, for which there is room. */
    void apply(int id, float x, float y) {
        list(id);
        fields.set(CircleField.APPLIED_X, id, bits(sum(fields.getFloat(CircleField.APPLIED_X, id), x)));
        fields.set(CircleField.APPLIED_Y, id, bits(sum(fields.getFloat(CircleField.APPLIED_Y, id), y)));
    }

    /** Applies a torque in the next step, for which there is room. */
    void applyTorque(int id, float torque) {
        list(id);
        float before = fields.getFloat(CircleField.APPLIED_TORQUE, id);
        fields.set(CircleField.APPLIED_TORQUE, id, bits(sum(before, torque)));
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

    /** A force or a torque as the bits of a field: there is one zero. */
    static int bits(float force) {
        return Float.floatToRawIntBits(force + 0f);
    }

    /** Whether no force or torque acts in the next step alone. */
    public boolean isEmpty() {
        return count == 0;
    }

    /** Before the step: records what acts in it alone. */
    public void begin() {
        commands.ensure(3 * count);
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
        commands.setField(set, id, bits(sum(fields.getFloat(set, id), fields.getFloat(applied, id))));
    }

    /** After the step: puts back what has been set. There is room, since as many records were there for {@link #begin}. */
    public void end() {
        for (int k = 0; k < count; k++) {
            int id = ids[k];
            if (isForced(id)) {
                commands.setField(CircleField.FORCE_X, id, fields.getInt(CircleField.FORCE_X, id));
                commands.setField(CircleField.FORCE_Y, id, fields.getInt(CircleField.FORCE_Y, id));
                fields.set(CircleField.APPLIED_X, id, 0);
                fields.set(CircleField.APPLIED_Y, id, 0);
            }
            if (isTurned(id)) {
                commands.setField(CircleField.TORQUE, id, fields.getInt(CircleField.TORQUE, id));
                fields.set(CircleField.APPLIED_TORQUE, id, 0);
            }
        }
        count = 0;
    }

    public void makeRoom(SavedState from) {
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
    public void restored(SavedState from) {
        count = 0;
        for (int id = 0; id < from.ids; id++) {
            if (isForced(id) || isTurned(id)) {
                ids[count++] = id;
            }
        }
    }
}
