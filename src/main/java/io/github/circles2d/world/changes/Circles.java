package io.github.circles2d.world.changes;

import static io.github.circles2d.world.shared.Call.real;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;

/**
 * The calls on circles that are there: they go and change. A change waits as a record in {@link Commands} until the next step or read. What
 * only calls change is in {@link HandleTable} at once; {@link FieldCalls} has the calls on single fields of that. A call checks its
 * arguments and makes room before it changes the state.
 */
public final class Circles implements Calls.Effects {
    private final WorldParts world;
    private final NextStep nextStep;
    private final PreparedChanges changes;

    public Circles(WorldParts world, NextStep nextStep, PreparedChanges changes) {
        this.world = world;
        this.nextStep = nextStep;
        this.changes = changes;
        world.calls.define(
                this,
                Call.REMOVE,
                Call.POSITION,
                Call.MOVE,
                Call.VELOCITY,
                Call.RADIUS,
                Call.MASS,
                Call.RESTITUTION,
                Call.IMPULSE,
                Call.ANGLE,
                Call.ANGULAR_VELOCITY,
                Call.ANGULAR_IMPULSE,
                Call.CIRCLE_KIND,
                Call.STEADY_FORCE);
    }

    /** Removes a circle. */
    public void remove(long circle) {
        world.calls.change(Call.REMOVE, circle, 0, 0, 0);
    }

    /** Whether a handle is that of a circle. */
    public boolean contains(long handle) {
        world.guard.check();
        return world.handles.find(handle) >= 0;
    }

    /** One more than the greatest id that a circle has had. */
    public int idLimit() {
        world.guard.check();
        return world.handles.end();
    }

    /** The handle of the circle that has an id; 0 if there is none. */
    public long handle(int id) {
        world.guard.enter();
        try {
            if (id < 0 || id >= world.handles.end()) {
                throw new IllegalArgumentException(
                        "the id is " + id + ", but must be at least 0 and less than " + world.handles.end());
            }
            return world.handles.lives(id) ? world.handles.handle(id) : 0;
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    /** The number of circles. */
    public int size() {
        world.guard.check();
        return world.handles.size();
    }

    /** Changes a circle by an operation of {@link Commands} of one or two values. */
    public void set(int operation, long circle, float a, float b) {
        world.calls.changeByFloats(Call.of(operation), circle, a, b, 0);
    }

    /** Puts a circle somewhere else. A static one is to travel there in the next step. */
    public void move(long circle, float x, float y) {
        world.calls.changeByFloats(Call.MOVE, circle, x, y, 0);
    }

    /** Turns a circle to an angle in radians. */
    public void setAngle(long circle, float angle) {
        Limits.within("angle", angle, -Limits.ANGLE, Limits.ANGLE);
        world.calls.change(Call.ANGLE, circle, Surface.units(angle), 0, 0);
    }

    public void setAngularVelocity(long circle, float velocity) {
        world.calls.changeByFloats(Call.ANGULAR_VELOCITY, circle, velocity, 0, 0);
    }

    public void applyAngularImpulse(long circle, float impulse) {
        world.calls.changeByFloats(Call.ANGULAR_IMPULSE, circle, impulse, 0, 0);
    }

    /** Gives a circle another kind, and the restitution of the kind if it has one. */
    public void setKind(long circle, int kind) {
        world.calls.change(Call.CIRCLE_KIND, circle, kind, 0, 0);
    }

    /** Sets the force on a circle. */
    public void setForce(long circle, float x, float y) {
        world.calls.changeByFloats(Call.STEADY_FORCE, circle, x, y, 0);
    }

    @Override
    public void prepare(Call call, int[] w) {
        changes.begin(2);
        switch (call) {
            case REMOVE -> changes.setChecked(Commands.REMOVE, w[0], 0, 0);
            case MOVE -> changes.move(w[0], real(w[1]), real(w[2]));
            case ANGLE -> changes.setAngle(w[0], w[1]);
            case ANGULAR_VELOCITY -> changes.setAngularVelocity(w[0], real(w[1]));
            case ANGULAR_IMPULSE -> changes.pushAround(w[0], real(w[1]));
            case CIRCLE_KIND -> changes.setKind(w[0], w[1]);
            case STEADY_FORCE -> changes.setForce(w[0], real(w[1]), real(w[2]));
            default -> world.copies.forgetBy(call.number);
        }
        changes.makeRoom(operation(call));
    }

    /** By which {@link PreparedChanges} makes a call. */
    private static int operation(Call call) {
        return switch (call) {
            case MOVE -> Commands.POSITION;
            case CIRCLE_KIND, STEADY_FORCE -> Commands.FIELD;
            default -> call.number;
        };
    }

    @Override
    public long apply(Call call, int[] w) {
        switch (call) {
            case POSITION, VELOCITY, RADIUS, MASS, RESTITUTION, IMPULSE -> change(call, w[0], real(w[1]), real(w[2]));
            default -> changes.make(operation(call));
        }
        return 0;
    }

    private void change(Call call, int id, float a, float b) {
        if (call == Call.POSITION) {
            Bounds bounds = world.settings.bounds();
            world.commands.set(Commands.POSITION, id, bounds.placeX(a), bounds.placeY(b));
            nextStep.travels.forget(id);
            return;
        }
        if (call == Call.MASS) {
            if (a != Float.POSITIVE_INFINITY && nextStep.travels.travels(id)) {
                nextStep.travels.end(id);
            }
            world.handles.setMass(id, a);
        } else if (call == Call.RADIUS) {
            world.handles.setRadius(id, a);
            nextStep.growth.forget(id);
        } else if (call == Call.RESTITUTION) {
            world.handles.setRestitution(id, a);
        }
        world.commands.set(call.number, id, a, b);
    }

    /** The restitution of one circle. */
    public float restitution(long handle) {
        world.guard.check();
        return world.handles.restitution(world.circle(handle));
    }
}
