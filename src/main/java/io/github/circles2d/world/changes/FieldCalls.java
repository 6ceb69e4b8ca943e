package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;

/** The calls on single fields of a circle, {@link CircleField}, which only calls change. The pipeline gets those that steps read. */
public final class FieldCalls implements Calls.Effects {
    private final WorldParts world;
    private final CircleFields fields;
    private final Kinds kinds;

    public FieldCalls(WorldParts world, Kinds kinds) {
        this.world = world;
        this.kinds = kinds;
        fields = world.handles.fields();
        world.calls.define(this, Call.FIELD);
    }

    @Override
    public long make(Call call, int[] w) {
        CircleField field = CircleField.ofNumber(w[1]);
        if (field == null || !field.isOfSteps() && field != CircleField.TAG) {
            throw new IllegalArgumentException("calls set no field with the number " + w[1]);
        }
        set(field, w[0], Call.value(w[2], w[3]));
        return 0;
    }

    /** Changes a field of a circle. */
    public void set(CircleField field, long circle, long value) {
        world.guard.enter();
        try (world.guard) {
            set(field, world.circle(circle), value);
        }
    }

    private void set(CircleField field, int id, long value) {
        field.check(value);
        world.pending.expect(1);
        fields.ensure(field, id + 1);
        world.copies.forgetSaved();
        world.calls.begin(Call.FIELD, id, field.number(), (int) value, (int) (value >> Integer.SIZE));
        if (field.isOfTurning() && value != field.initial()) {
            world.needs.askToTurn();
        }
        world.handles.setField(field, id, value);
        if (field.isOfSteps()) {
            world.commands.setField(field, id, (int) value);
        }
        world.calls.end();
    }

    /** Gives a circle a value of its own in place of that of its kind, or takes it away, by NaN. */
    public void setOwn(CircleField field, long handle, float value) {
        if (!Float.isNaN(value)) {
            field.ofKind().check(Float.floatToRawIntBits(value));
        }
        set(field, handle, Float.isNaN(value) ? CircleField.NONE : CircleField.bits(value));
    }

    /** What a circle has: its own, else that of its kind, else the world's. */
    public float own(CircleField field, long handle) {
        world.guard.check();
        int id = world.circle(handle);
        float own = fields.getFloat(field, id);
        return Float.isNaN(own) ? kinds.ofCircles(field.ofKind(), fields.getInt(CircleField.KIND, id)) : own;
    }

    /** Sets the torque on a circle. */
    public void setTorque(long handle, float torque) {
        set(CircleField.TORQUE, handle, CircleField.bits(torque));
    }

    /** What is set for a circle: {@link CircleField#FORCE_X}, {@code FORCE_Y} or {@code TORQUE}. */
    public float force(CircleField component, long handle) {
        return Float.intBitsToFloat((int) get(component, handle));
    }

    /** A field of a circle. */
    public long get(CircleField field, long handle) {
        world.guard.check();
        return fields.get(field, world.circle(handle));
    }
}
