package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.Needs;
import io.github.circles2d.world.shared.PendingWork;

/** The calls on single fields of a circle, {@link CircleField}, which only calls change. The pipeline gets those that steps read. */
public final class FieldCalls {
    private final Guard guard;
    private final HandleTable handles;
    private final CircleFields fields;
    private final Commands commands;
    private final CallLog log;
    private final PendingWork pending;
    private final Copies copies;
    private final Kinds kinds;
    private final Needs needs;

    public FieldCalls(
            Guard guard,
            HandleTable handles,
            Commands commands,
            CallLog log,
            PendingWork pending,
            Copies copies,
            Kinds kinds,
            Needs needs) {
        this.guard = guard;
        this.handles = handles;
        this.commands = commands;
        this.log = log;
        this.pending = pending;
        this.copies = copies;
        this.kinds = kinds;
        this.needs = needs;
        fields = handles.fields();
    }

    /**
     * Changes a field of a circle.
     *
     * @param field what changes
     * @param handle the circle
     * @param value the new value
     */
    public void set(CircleField field, long handle, long value) {
        guard.enter();
        try {
            int id = find(handle);
            field.check(value);
            pending.expect(1);
            fields.ensure(field, id + 1);
            copies.forgetSaved();
            if (!field.isOfSteps()) {
                log.field(field, id, value);
            }
            guard.changing = true;
            if (field.isOfTurning() && value != field.initial()) {
                needs.askToTurn();
            }
            enter(field, id, value);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Gives a circle friction of its own, or takes it away. */
    public void setFriction(long handle, float friction) {
        set(
                CircleField.FRICTION,
                handle,
                Float.isNaN(friction) ? CircleField.NONE : CircleField.bits(Limits.friction(friction)));
    }

    /** Gives a circle rolling resistance of its own, or takes it away. */
    public void setRollingResistance(long handle, float resistance) {
        set(
                CircleField.ROLLING_RESISTANCE,
                handle,
                Float.isNaN(resistance) ? CircleField.NONE : CircleField.bits(Limits.rollingResistance(resistance)));
    }

    /** The friction of a circle: its own, else that of its kind, else the world's. */
    public float friction(long handle) {
        guard.check();
        int id = find(handle);
        float own = fields.getFloat(CircleField.FRICTION, id);
        return Float.isNaN(own) ? kinds.friction(kindOf(id)) : own;
    }

    /** Likewise. */
    public float rollingResistance(long handle) {
        guard.check();
        int id = find(handle);
        float own = fields.getFloat(CircleField.ROLLING_RESISTANCE, id);
        return Float.isNaN(own) ? kinds.rollingResistance(kindOf(id)) : own;
    }

    /** Sets the torque on a circle. */
    public void setTorque(long handle, float torque) {
        set(CircleField.TORQUE, handle, CircleField.bits(torque));
    }

    private int kindOf(int id) {
        return fields.getInt(CircleField.KIND, id);
    }

    private int find(long handle) {
        return Circles.find(handles, handle);
    }

    /** What is set for a circle: {@link CircleField#FORCE_X}, {@code FORCE_Y} or {@code TORQUE}. */
    public float force(CircleField component, long handle) {
        return Float.intBitsToFloat((int) get(component, handle));
    }

    /** Takes down the value of a field, for which there is room. */
    private void enter(CircleField field, int id, long value) {
        fields.set(field, id, value);
        if (field.isOfSteps()) {
            commands.setField(field, id, (int) value);
        }
    }

    /** A field of a circle. */
    public long get(CircleField field, long handle) {
        guard.check();
        return fields.get(field, find(handle));
    }
}
