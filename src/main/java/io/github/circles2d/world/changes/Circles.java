package io.github.circles2d.world.changes;

import static io.github.circles2d.world.shared.Call.real;
import static java.lang.Float.floatToRawIntBits;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;

/**
 * The calls on single circles that are there: they go and change. A change waits as a record in {@link Commands} until the next step or read.
 * What only calls change is in {@link HandleTable} at once; {@link FieldCalls} has the calls on single fields of that.
 */
public final class Circles implements Calls.Effects {
    private final WorldParts world;
    private final NextStep nextStep;
    private final PreparedChanges changes;

    public Circles(WorldParts world, NextStep nextStep, PreparedChanges changes) {
        this.world = world;
        this.nextStep = nextStep;
        this.changes = changes;
        world.calls.defineAll(this, Call.REMOVE, Call.ANGULAR_IMPULSE);
        world.calls.define(this, Call.MOVE, Call.CLEAR, Call.WAKE, Call.WAKE_ALL);
    }

    @Override
    public long make(Call call, int[] w) {
        if (call == Call.CLEAR) {
            removeAll();
            return 0;
        }
        if (call == Call.WAKE_ALL) {
            world.calls.begin(call, w);
            return 0;
        }
        if (call == Call.WAKE) {
            set(Commands.WAKE, w[0], 0, 0);
        } else {
            make(call, w[0], w[1], w[2]);
        }
        return 0;
    }

    private void make(Call call, int id, int a, int b) {
        changes.begin(1);
        switch (call) {
            case REMOVE -> changes.setChecked(Commands.REMOVE, id, 0, 0);
            case MOVE -> changes.move(id, real(a), real(b));
            case ANGLE -> changes.setAngle(id, a);
            case ANGULAR_VELOCITY -> changes.setAngularVelocity(id, real(a));
            case ANGULAR_IMPULSE -> changes.pushAround(id, real(a));
            default -> {
                set(call.number, id, real(a), real(b));
                return;
            }
        }
        changes.make(call == Call.MOVE ? Commands.POSITION : call.number);
    }

    private void make(Call call, long circle, int a, int b) {
        world.guard.enter();
        try (world.guard) {
            make(call, world.circle(circle), a, b);
        }
    }

    /** Removes a circle. */
    public void remove(long circle) {
        make(Call.REMOVE, circle, 0, 0);
    }

    /**
     * The pipeline loads a state without circles, which takes no command for each. If events are reported, a command for each removes them as any
     * other call does, so that their ends are reported.
     */
    private void removeAll() {
        world.pending.settleJoints();
        world.joints.departures.ensure(world.joints.table.ids.size());
        if (world.events.isOn()) {
            world.pending.expect(world.handles.size());
        } else {
            world.pending.finish();
            world.state.makeRoomToRemoveCircles();
        }
        world.copies.forget();
        world.calls.begin(Call.CLEAR, 0, 0, 0, 0);
        world.joints.departures.removeOfCircles();
        world.rigids.circlesGo();
        if (world.events.isOn()) {
            world.pending.recordRemovals();
            world.handles.removeAll();
        } else {
            world.pending.drop(); // changes that wait are of circles that go, or that the pipeline never learns of
            world.state.removeCircles();
        }
        world.state.forgetFigures();
    }

    /** Changes a circle by an operation of {@link Commands} of floats. b has no meaning if the operation has one value. */
    public void set(int operation, long circle, float a, float b) {
        world.guard.enter();
        try (world.guard) {
            set(operation, world.circle(circle), a, b);
        }
    }

    private void set(int operation, int id, float a, float b) {
        Bounds bounds = world.settings.bounds();
        switch (operation) {
            case Commands.POSITION -> Limits.position(a, b, bounds);
            case Commands.VELOCITY -> Limits.velocity(a, b);
            case Commands.RADIUS -> Limits.radius(a, bounds);
            case Commands.MASS -> Limits.mass(a);
            case Commands.RESTITUTION -> Limits.restitution(a);
            case Commands.WAKE -> {
                // it has no value
            }
            default -> Limits.impulse(a, b);
        }
        boolean places = operation == Commands.POSITION;
        world.pending.expect(2);
        if (places) {
            changes.beginHeld(id);
        }
        world.copies.forgetBy(operation);
        world.calls.begin(Call.of(operation), id, floatToRawIntBits(a), floatToRawIntBits(b), 0);
        if (operation == Commands.MASS) {
            setMass(id, a);
        }
        world.commands.set(operation, id, places ? bounds.placeX(a) : a, places ? bounds.placeY(b) : b);
        if (places) {
            nextStep.travels.forget(id);
            changes.wakePartners();
        } else if (operation == Commands.RADIUS) {
            world.handles.setRadius(id, a);
            nextStep.growth.forget(id);
        } else if (operation == Commands.RESTITUTION) {
            world.handles.setRestitution(id, a);
        }
        world.calls.end();
    }

    private void setMass(int id, float mass) {
        if (mass != Float.POSITIVE_INFINITY && nextStep.travels.travels(id)) {
            nextStep.travels.end(id);
        }
        world.handles.setMass(id, mass);
    }

    /** Puts a circle somewhere else. A static one is to travel there in the next step. */
    public void move(long circle, float x, float y) {
        make(Call.MOVE, circle, floatToRawIntBits(x), floatToRawIntBits(y));
    }

    /** Turns a circle to an angle in radians. */
    public void setAngle(long circle, float angle) {
        Limits.within("angle", angle, -Limits.ANGLE, Limits.ANGLE);
        make(Call.ANGLE, circle, Surface.units(angle), 0);
    }

    public void setAngularVelocity(long circle, float velocity) {
        make(Call.ANGULAR_VELOCITY, circle, floatToRawIntBits(velocity), 0);
    }

    public void applyAngularImpulse(long circle, float impulse) {
        make(Call.ANGULAR_IMPULSE, circle, floatToRawIntBits(impulse), 0);
    }

    /** Gives a circle another kind, and the restitution of the kind if it has one. */
    public void setKind(long circle, int kind) {
        world.guard.enter();
        try (world.guard) {
            changes.begin(2);
            changes.setKind(world.circle(circle), kind);
            changes.make(Commands.FIELD);
        }
    }

    /** Sets the force on a circle. */
    public void setForce(long circle, float x, float y) {
        world.guard.enter();
        try (world.guard) {
            changes.begin(2);
            changes.setForce(world.circle(circle), x, y);
            changes.make(Commands.FIELD);
        }
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
        world.guard.check();
        if (id < 0 || id >= world.handles.end()) {
            throw new IllegalArgumentException(
                    "the id is " + id + ", but must be at least 0 and less than " + world.handles.end());
        }
        return world.handles.lives(id) ? world.handles.handle(id) : 0;
    }

    /** The number of circles. */
    public int size() {
        world.guard.check();
        return world.handles.size();
    }

    /** The restitution of one circle. */
    public float restitution(long handle) {
        world.guard.check();
        return world.handles.restitution(world.circle(handle));
    }
}
