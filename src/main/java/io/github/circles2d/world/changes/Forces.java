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
 * The forces on circles. The one that is set for a circle is a field that steps read. What is applied for one step waits on the host: the
 * pipelines get the sum for that step, and then what was set again. If a step fails before it has begun, the next one does the same once
 * more.
 */
public final class Forces {
    private final CircleFields fields;
    private final Commands commands;

    /** Circles on which a force may have been applied since the last step; some may be gone. */
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

    /** Makes room for one more circle that a force is applied to. */
    void ensure() {
        if (count == ids.length) {
            ids = Arrays.copyOf(ids, 2 * count);
        }
    }

    /** Applies a force in the next step, for which there is room. */
    void apply(int id, float x, float y) {
        if (!isApplied(id)) {
            ids[count++] = id;
        }
        fields.set(CircleField.APPLIED_X, id, bits(sum(fields.getFloat(CircleField.APPLIED_X, id), x)));
        fields.set(CircleField.APPLIED_Y, id, bits(sum(fields.getFloat(CircleField.APPLIED_Y, id), y)));
    }

    private boolean isApplied(int id) {
        return fields.getInt(CircleField.APPLIED_X, id) != 0 || fields.getInt(CircleField.APPLIED_Y, id) != 0;
    }

    /** The sum of two forces, within the greatest one; never -0. */
    private static float sum(float a, float b) {
        return CircleMath.clamp(a + b, -Limits.FORCE, Limits.FORCE) + 0f;
    }

    /** A force as the bits of a field: there is one zero. */
    static int bits(float force) {
        return Float.floatToRawIntBits(force + 0f);
    }

    /** Whether no force acts in the next step alone. */
    public boolean isEmpty() {
        return count == 0;
    }

    /** Before the step: records what acts in it alone. */
    public void begin() {
        commands.ensure(2 * count);
        for (int k = 0; k < count; k++) {
            if (isApplied(ids[k])) {
                hand(ids[k], CircleField.FORCE_X, CircleField.APPLIED_X);
                hand(ids[k], CircleField.FORCE_Y, CircleField.APPLIED_Y);
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
            if (isApplied(id)) {
                commands.setField(CircleField.FORCE_X, id, fields.getInt(CircleField.FORCE_X, id));
                commands.setField(CircleField.FORCE_Y, id, fields.getInt(CircleField.FORCE_Y, id));
                fields.set(CircleField.APPLIED_X, id, 0);
                fields.set(CircleField.APPLIED_Y, id, 0);
            }
        }
        count = 0;
    }

    public void makeRoom(SavedState from) {
        int applied = from.fields.used(CircleField.APPLIED_X) + from.fields.used(CircleField.APPLIED_Y);
        if (ids.length < applied) {
            ids = new int[applied];
        }
        if (applied > 0) {
            fields.ensure(CircleField.APPLIED_X, from.ids);
            fields.ensure(CircleField.APPLIED_Y, from.ids);
        }
    }

    /** A saved state, for which there is room, has taken the place of the circles. */
    public void restored(SavedState from) {
        count = 0;
        for (int id = 0; id < from.ids; id++) {
            if (isApplied(id)) {
                ids[count++] = id;
            }
        }
    }
}
