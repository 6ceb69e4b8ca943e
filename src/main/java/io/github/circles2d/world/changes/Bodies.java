package io.github.circles2d.world.changes;

import static io.github.circles2d.world.shared.Call.real;

import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.TerrainLimits;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.terrain.BodyAnchors;
import io.github.circles2d.world.terrain.BodyPoses;
import io.github.circles2d.world.terrain.BodyTable;

/** The calls on bodies of terrain. */
public final class Bodies implements Calls.Effects {
    private final WorldParts world;
    private final BodyTable table;
    private final BodyAnchors places;

    public Bodies(WorldParts world) {
        this.world = world;
        table = world.terrain.bodies;
        places = new BodyAnchors(table);
        world.calls.defineAll(this, Call.BODY, Call.TELEPORT_BODY);
    }

    /** The handle of the ground. */
    public long ground() {
        world.guard.check();
        return table.ids.handle(BodyTable.GROUND);
    }

    /** Adds a body at rest, at an angle in radians, and returns its handle. */
    public long add(float x, float y, float angle) {
        return world.calls.makeOfFloats(Call.BODY, x, y, angle, 0);
    }

    @Override
    public long make(Call call, int[] w) {
        if (call == Call.BODY) {
            if (table.ids.size() >= TerrainLimits.BODIES) {
                throw new IllegalArgumentException(
                        "a world has at most " + TerrainLimits.BODIES + " bodies of terrain, not one more");
            }
            table.ensure(1);
        } else if (call == Call.REMOVE_BODY) {
            world.pending.settleJoints();
            world.joints.departures.ensure(world.joints.table.places.count());
        }
        world.calls.begin(call, w);
        switch (call) {
            case BODY -> {
                return table.ids.handle(world.terrain.addBody(real(w[0]), real(w[1]), Surface.units(real(w[2]))));
            }
            case REMOVE_BODY -> {
                world.joints.departures.removeOfBody(w[0]);
                world.terrain.removeBody(w[0]);
            }
            case BODY_VELOCITY -> table.setVelocity(w[0], real(w[1]), real(w[2]));
            case BODY_ANGULAR_VELOCITY -> table.setOmega(w[0], real(w[1]));
            case MOVE_BODY -> world.terrain.travel(w[0], real(w[1]), real(w[2]), Surface.units(real(w[3])));
            default -> world.terrain.teleport(w[0], real(w[1]), real(w[2]), Surface.units(real(w[3])));
        }
        return 0;
    }

    /** Takes down where bodies are. */
    public void keep(BodyPoses poses) {
        world.guard.enter();
        try (world.guard) {
            poses.keep(table);
        }
    }

    /** Takes down where a body is on the way from before a step to after it. */
    public void keepBetween(int id, BodyPoses before, BodyPoses after, float alpha, BodyPoses to) {
        world.guard.check();
        to.keepOneBetween(before, after, alpha, table, world.terrain.bounds(), id);
    }

    /** The id of a body that is there. */
    public int require(long handle) {
        world.guard.check();
        return world.body(handle);
    }

    private static void checkPlace(float x, float y) {
        TerrainLimits.coordinate("x", x);
        TerrainLimits.coordinate("y", y);
    }

    public float x(long handle) {
        return (float) table.x[require(handle)];
    }

    public float y(long handle) {
        return (float) table.y[require(handle)];
    }

    /** Where a place in a body's coordinates is in the world now. */
    public float worldX(long handle, float x, float y) {
        int body = require(handle);
        checkPlace(x, y);
        return places.x(body, x, y, world.terrain.bounds());
    }

    public float worldY(long handle, float x, float y) {
        int body = require(handle);
        checkPlace(x, y);
        return places.y(body, x, y, world.terrain.bounds());
    }

    /** Where a place of the world is in a body's coordinates now; those of the ground are the world's. */
    public float localX(long handle, float x, float y) {
        int body = require(handle);
        checkPlace(x, y);
        return body == BodyTable.GROUND ? x : places.onBodyX(body, x, y, world.terrain.bounds());
    }

    public float localY(long handle, float x, float y) {
        int body = require(handle);
        checkPlace(x, y);
        return body == BodyTable.GROUND ? y : places.onBodyY(body, x, y, world.terrain.bounds());
    }

    /** How fast a place of the world has moved with a body in the last step. */
    public float vxAt(long handle, float x, float y) {
        int body = require(handle);
        checkPlace(x, y);
        return table.lastVxAt(body, table.fromPivotY(body, y, world.terrain.bounds()));
    }

    public float vyAt(long handle, float x, float y) {
        int body = require(handle);
        checkPlace(x, y);
        return table.lastVyAt(body, table.fromPivotX(body, x, world.terrain.bounds()));
    }

    /** In radians, at least -pi and less than pi. */
    public float angle(long handle) {
        return Surface.radians(table.angle[require(handle)]);
    }

    public float vx(long handle) {
        return table.vx[require(handle)];
    }

    public float vy(long handle) {
        return table.vy[require(handle)];
    }

    public float angularVelocity(long handle) {
        return table.omega[require(handle)];
    }
}
