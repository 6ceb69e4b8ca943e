package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.WorldParts;

/**
 * The calls on circles that are there: they go and change. A change waits as a record in {@link Commands} until the next step or read. What
 * only calls change is in {@link HandleTable} at once; {@link FieldCalls} has the calls on single fields of that. A call checks its
 * arguments and makes room before it changes the state.
 */
public final class Circles {
    private final WorldParts world;
    private final NextStep nextStep;
    private final PreparedChanges changes;

    public Circles(WorldParts world, NextStep nextStep, PreparedChanges changes) {
        this.world = world;
        this.nextStep = nextStep;
        this.changes = changes;
    }

    /** Removes a circle. */
    public void remove(long handle) {
        world.guard.enter();
        try {
            int id = world.circle(handle);
            changes.begin(1);
            changes.setChecked(Commands.REMOVE, id, 0, 0);
            changes.make(Commands.REMOVE);
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
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

    /**
     * Changes a circle.
     *
     * @param operation an operation of {@link Commands} that changes a circle
     * @param handle the circle
     * @param a first value of the operation
     * @param b second value; of no meaning if the operation has one
     */
    public void set(int operation, long handle, float a, float b) {
        world.guard.enter();
        try {
            int id = world.circle(handle);
            changes.checkValues(operation, a, b);
            world.pending.expect(2);
            world.copies.forgetBy(operation);
            world.guard.changing = true;
            if (operation == Commands.MASS) {
                setMass(id, a);
            }
            boolean places = operation == Commands.POSITION;
            world.commands.set(
                    operation,
                    id,
                    places ? world.settings.bounds().placeX(a) : a,
                    places ? world.settings.bounds().placeY(b) : b);
            world.log.writeRecord(Call.of(operation), world.commands.count() - 1);
            if (places) {
                nextStep.travels.forget(id);
            } else if (operation == Commands.RADIUS) {
                world.handles.setRadius(id, a);
                nextStep.growth.forget(id);
            } else if (operation == Commands.RESTITUTION) {
                world.handles.setRestitution(id, a);
            }
            world.guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    private void setMass(int id, float mass) {
        if (mass != Float.POSITIVE_INFINITY && nextStep.travels.travels(id)) {
            nextStep.travels.end(id);
        }
        world.handles.setMass(id, mass);
    }

    /**
     * Puts a circle somewhere else. A static one is to travel there in the next step.
     *
     * @param handle the circle
     * @param x x of the place
     * @param y y of the place
     */
    public void move(long handle, float x, float y) {
        world.guard.enter();
        try {
            int id = world.circle(handle);
            changes.begin(1);
            changes.move(id, x, y);
            changes.make(Commands.POSITION);
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    /** Turns a circle to an angle in radians. */
    public void setAngle(long handle, float angle) {
        Limits.within("angle", angle, -Limits.ANGLE, Limits.ANGLE);
        turnTo(handle, Surface.units(angle));
    }

    /** Turns a circle to an angle in units of a turn's 2^-32. */
    public void turnTo(long handle, int units) {
        world.guard.enter();
        try {
            int id = world.circle(handle);
            changes.begin(1);
            changes.setAngle(id, units);
            changes.make(Commands.ANGLE);
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    public void setAngularVelocity(long handle, float velocity) {
        world.guard.enter();
        try {
            int id = world.circle(handle);
            changes.begin(1);
            changes.setAngularVelocity(id, velocity);
            changes.make(Commands.ANGULAR_VELOCITY);
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    /** Applies an angular impulse to a circle of its kind. */
    public void applyAngularImpulse(long handle, float impulse) {
        applyAngularImpulse(handle, impulse, Float.NaN);
    }

    /** Applies an angular impulse. The inverse inertia by inverse mass is that of the circle's kind if it is NaN. */
    public void applyAngularImpulse(long handle, float impulse, float inertia) {
        world.guard.enter();
        try {
            int id = world.circle(handle);
            changes.begin(1);
            changes.pushAround(id, impulse, inertia);
            changes.make(Commands.ANGULAR_IMPULSE);
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    /** Gives a circle another kind, and the restitution of the kind if it has one. */
    public void setKind(long handle, int kind) {
        world.guard.enter();
        try {
            int id = world.circle(handle);
            changes.begin(2);
            changes.setKind(id, kind);
            changes.make(Commands.FIELD);
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    /** Sets the force on a circle. */
    public void setForce(long handle, float x, float y) {
        world.guard.enter();
        try {
            int id = world.circle(handle);
            changes.begin(2);
            changes.setForce(id, x, y);
            changes.make(Commands.FIELD);
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    /** The restitution of one circle. */
    public float restitution(long handle) {
        world.guard.check();
        return world.handles.restitution(world.circle(handle));
    }
}
