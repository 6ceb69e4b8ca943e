package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.TerrainLimits;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.LoggedCall;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.WorldSettings;
import io.github.circles2d.world.terrain.BodyAnchors;
import io.github.circles2d.world.terrain.BodyPoses;
import io.github.circles2d.world.terrain.BodyTable;
import io.github.circles2d.world.terrain.TerrainTables;

/** The calls on bodies of terrain. */
public final class Bodies {
    private final Guard guard;
    private final TerrainTables terrain;
    private final BodyTable table;
    private final BodyAnchors places;
    private final JointTables joints;
    private final CallLog log;
    private final PendingWork pending;
    private final Copies copies;
    private final WorldSettings settings;

    public Bodies(
            Guard guard,
            TerrainTables terrain,
            JointTables joints,
            CallLog log,
            PendingWork pending,
            Copies copies,
            WorldSettings settings) {
        this.guard = guard;
        this.terrain = terrain;
        this.joints = joints;
        this.log = log;
        this.pending = pending;
        this.copies = copies;
        this.settings = settings;
        table = terrain.bodies;
        places = new BodyAnchors(table);
    }

    /** The id of the body that has a handle. */
    static int find(TerrainTables terrain, long handle) {
        int body = terrain.bodies.ids.find(handle);
        if (body < 0) {
            throw new IllegalArgumentException(
                    "no body of terrain has the handle " + handle + Handle.reason(handle, Handle.BODY));
        }
        return body;
    }

    private int find(long handle) {
        return find(terrain, handle);
    }

    private int findMovable(long handle, String what) {
        int body = find(handle);
        if (body == BodyTable.GROUND) {
            throw new IllegalArgumentException("the ground cannot " + what);
        }
        return body;
    }

    /** The handle of the ground. */
    public long ground() {
        guard.check();
        return table.ids.handle(BodyTable.GROUND);
    }

    /** Adds a body at rest, at an angle in radians, and returns its handle. */
    public long add(float x, float y, float angle) {
        guard.enter();
        try {
            checkPlace(x, y, angle);
            if (table.ids.size() >= TerrainLimits.BODIES) {
                throw new IllegalArgumentException(
                        "a world has at most " + TerrainLimits.BODIES + " bodies of terrain, not one more");
            }
            table.ensure(1);
            copies.forgetSaved();
            log.call(LoggedCall.BODY, x, y, angle, 0);
            guard.changing = true;
            long handle = table.ids.handle(terrain.addBody(x, y, Surface.units(angle)));
            guard.changing = false;
            return handle;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    private void checkPlace(float x, float y, float angle) {
        Limits.within("x", x, -Limits.COORDINATE, Limits.COORDINATE);
        Limits.within("y", y, -Limits.COORDINATE, Limits.COORDINATE);
        Limits.within("angle", angle, -Limits.ANGLE, Limits.ANGLE);
    }

    /** Removes a body with its pieces. */
    public void remove(long handle) {
        guard.enter();
        try {
            int body = findMovable(handle, "be removed");
            pending.settleJoints();
            joints.departures().ensure(joints.table.places.count());
            copies.forgetSaved();
            log.call(LoggedCall.REMOVE_BODY, body, 0);
            guard.changing = true;
            joints.departures().removeOfBody(body);
            terrain.removeBody(body);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    public void setVelocity(long handle, float vx, float vy) {
        guard.enter();
        try {
            int body = findMovable(handle, "move");
            Limits.velocity(vx, vy);
            copies.forgetSaved();
            log.call(LoggedCall.BODY_VELOCITY, body, Float.floatToRawIntBits(vx), Float.floatToRawIntBits(vy), 0);
            guard.changing = true;
            table.setVelocity(body, vx, vy);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    public void setAngularVelocity(long handle, float velocity) {
        guard.enter();
        try {
            int body = findMovable(handle, "turn");
            Limits.within("the angular velocity", velocity, -Limits.ANGULAR_VELOCITY, Limits.ANGULAR_VELOCITY);
            copies.forgetSaved();
            log.call(LoggedCall.BODY_ANGULAR_VELOCITY, body, Float.floatToRawIntBits(velocity));
            guard.changing = true;
            table.setOmega(body, velocity);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Lets a body travel to a place in the next step. */
    public void move(long handle, float x, float y, float angle) {
        guard.enter();
        try {
            place(handle, x, y, angle, true);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Puts a body at a place at once. */
    public void teleport(long handle, float x, float y, float angle) {
        guard.enter();
        try {
            place(handle, x, y, angle, false);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    private void place(long handle, float x, float y, float angle, boolean travels) {
        int body = findMovable(handle, "move");
        checkPlace(x, y, angle);
        copies.forgetSaved();
        log.call(
                travels ? LoggedCall.MOVE_BODY : LoggedCall.TELEPORT_BODY,
                body,
                Float.floatToRawIntBits(x),
                Float.floatToRawIntBits(y),
                Float.floatToRawIntBits(angle));
        guard.changing = true;
        if (travels) {
            terrain.travel(body, x, y, Surface.units(angle));
        } else {
            terrain.teleport(body, x, y, Surface.units(angle));
        }
        guard.changing = false;
    }

    /** Takes down where bodies are. */
    public void keep(BodyPoses poses) {
        guard.enter();
        try {
            poses.keep(table);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Takes down where a body is on the way from before a step to after it. */
    public void keepBetween(int id, BodyPoses before, BodyPoses after, float alpha, BodyPoses to) {
        guard.check();
        to.keepOneBetween(before, after, alpha, table, terrain.bounds(), id);
    }

    public boolean contains(long handle) {
        guard.check();
        return table.ids.find(handle) >= 0;
    }

    /** One more than the greatest id that a body has had; the ground has 0. */
    public int idLimit() {
        guard.check();
        return table.ids.end();
    }

    /** The handle of the body that has an id; 0 if there is none. */
    public long handle(int id) {
        guard.check();
        return table.ids.handleOrNone(id);
    }

    /** The id of a body that is there. */
    public int require(long handle) {
        guard.check();
        return find(handle);
    }

    public float x(long handle) {
        return table.x(require(handle));
    }

    public float y(long handle) {
        return table.y(require(handle));
    }

    /** Where a place in a body's coordinates is in the world now. */
    public float worldX(long handle, float x, float y) {
        int body = require(handle);
        checkPlace(x, y, 0f);
        return places.x(body, x, y, terrain.bounds());
    }

    public float worldY(long handle, float x, float y) {
        int body = require(handle);
        checkPlace(x, y, 0f);
        return places.y(body, x, y, terrain.bounds());
    }

    /** Where a place of the world is in a body's coordinates now; those of the ground are the world's. */
    public float localX(long handle, float x, float y) {
        int body = require(handle);
        checkPlace(x, y, 0f);
        return body == BodyTable.GROUND ? x : places.onBodyX(body, x, y, terrain.bounds());
    }

    public float localY(long handle, float x, float y) {
        int body = require(handle);
        checkPlace(x, y, 0f);
        return body == BodyTable.GROUND ? y : places.onBodyY(body, x, y, terrain.bounds());
    }

    /** In radians, at least -pi and less than pi. */
    public float angle(long handle) {
        return (float) (table.angle(require(handle)) * Rotation.RADIANS_PER_UNIT);
    }

    public float vx(long handle) {
        return table.vx(require(handle));
    }

    public float vy(long handle) {
        return table.vy(require(handle));
    }

    public float angularVelocity(long handle) {
        return table.omega(require(handle));
    }
}
