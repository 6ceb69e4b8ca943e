package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.WorldSettings;

/**
 * The calls on circles that are there: they go and change. A change waits as a record in {@link Commands} until the next step or read. What
 * only calls change is in {@link HandleTable} at once; {@link FieldCalls} has the calls on single fields of that. A call checks its
 * arguments and makes room before it changes the state.
 */
public final class Circles {
    private final Guard guard;
    private final HandleTable handles;
    private final Commands commands;
    private final PendingWork pending;
    private final Copies copies;
    private final WorldSettings settings;
    private final NextStep nextStep;
    private final PreparedChanges changes;

    public Circles(
            Guard guard,
            HandleTable handles,
            Commands commands,
            PendingWork pending,
            Copies copies,
            WorldSettings settings,
            NextStep nextStep,
            PreparedChanges changes) {
        this.guard = guard;
        this.handles = handles;
        this.commands = commands;
        this.pending = pending;
        this.copies = copies;
        this.settings = settings;
        this.nextStep = nextStep;
        this.changes = changes;
    }

    /** Removes a circle. */
    public void remove(long handle) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(1);
            changes.setChecked(Commands.REMOVE, id, 0, 0);
            changes.make(Commands.REMOVE);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Whether a handle is that of a circle. */
    public boolean contains(long handle) {
        guard.check();
        return handles.find(handle) >= 0;
    }

    /** One more than the greatest id that a circle has had. */
    public int idLimit() {
        guard.check();
        return handles.end();
    }

    /** The handle of the circle that has an id; 0 if there is none. */
    public long handle(int id) {
        guard.enter();
        try {
            if (id < 0 || id >= handles.end()) {
                throw new IllegalArgumentException(
                        "the id is " + id + ", but must be at least 0 and less than " + handles.end());
            }
            return handles.lives(id) ? handles.handle(id) : 0;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** The number of circles. */
    public int size() {
        guard.check();
        return handles.size();
    }

    /**
     * Changes a circle.
     *
     * @param operation an operation of {@link Commands} that changes a circle
     * @param handle the circle
     * @param a first value of the operation
     * @param b second value; of no meaning if the operation has one
     */
    public void set(int operation, long handle, float a, float b) {
        guard.enter();
        try {
            int id = find(handle);
            changes.checkValues(operation, a, b);
            pending.expect(2);
            copies.forgetBy(operation);
            guard.changing = true;
            if (operation == Commands.MASS) {
                setMass(id, a);
            }
            boolean places = operation == Commands.POSITION;
            commands.set(
                    operation,
                    id,
                    places ? settings.bounds().placeX(a) : a,
                    places ? settings.bounds().placeY(b) : b);
            if (places) {
                nextStep.travels.forget(id);
            } else if (operation == Commands.RADIUS) {
                handles.setRadius(id, a);
                nextStep.growth.forget(id);
            } else if (operation == Commands.RESTITUTION) {
                handles.setRestitution(id, a);
            }
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    private void setMass(int id, float mass) {
        if (mass != Float.POSITIVE_INFINITY && nextStep.travels.travels(id)) {
            nextStep.travels.end(id);
        }
        handles.setMass(id, mass);
    }

    /**
     * Puts a circle somewhere else. A static one is to travel there in the next step.
     *
     * @param handle the circle
     * @param x x of the place
     * @param y y of the place
     */
    public void move(long handle, float x, float y) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(1);
            changes.move(id, x, y);
            changes.make(Commands.POSITION);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Turns a circle to an angle in radians. */
    public void setAngle(long handle, float angle) {
        Limits.within("angle", angle, -Limits.ANGLE, Limits.ANGLE);
        turnTo(handle, Surface.units(angle));
    }

    /** Turns a circle to an angle in units of a turn's 2^-32. */
    public void turnTo(long handle, int units) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(1);
            changes.setAngle(id, units);
            changes.make(Commands.ANGLE);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    public void setAngularVelocity(long handle, float velocity) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(1);
            changes.setAngularVelocity(id, velocity);
            changes.make(Commands.ANGULAR_VELOCITY);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Applies an angular impulse to a circle of its kind. */
    public void applyAngularImpulse(long handle, float impulse) {
        applyAngularImpulse(handle, impulse, Float.NaN);
    }

    /** Applies an angular impulse. The inverse inertia by inverse mass is that of the circle's kind if it is NaN. */
    public void applyAngularImpulse(long handle, float impulse, float inertia) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(1);
            changes.pushAround(id, impulse, inertia);
            changes.make(Commands.ANGULAR_IMPULSE);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Gives a circle another kind, and the restitution of the kind if it has one. */
    public void setKind(long handle, int kind) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(2);
            changes.setKind(id, kind);
            changes.make(Commands.FIELD);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Sets the force on a circle. */
    public void setForce(long handle, float x, float y) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(2);
            changes.setForce(id, x, y);
            changes.make(Commands.FIELD);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    private int find(long handle) {
        return find(handles, handle);
    }

    /** The id of the circle that has a handle. */
    public static int find(HandleTable handles, long handle) {
        int id = handles.find(handle);
        if (id < 0) {
            throw new IllegalArgumentException(gone(handle));
        }
        return id;
    }

    /** Why a handle is refused. */
    static String gone(long handle) {
        return "no circle has the handle " + handle + Handle.reason(handle, 0);
    }

    /** The restitution of one circle. */
    public float restitution(long handle) {
        guard.check();
        return handles.restitution(find(handle));
    }
}
