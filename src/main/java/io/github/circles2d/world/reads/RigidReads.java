package io.github.circles2d.world.reads;

import io.github.circles2d.world.bodies.RigidPoses;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.bodies.RigidTable;
import io.github.circles2d.world.bodies.RigidTouches;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.shared.WorldParts;
import java.util.Arrays;

/** Reads of rigid bodies, which the host always has as of now. */
public final class RigidReads {
    /** Floats of a body in the reads of all. */
    private static final int STRIDE = 3;

    private final WorldParts world;
    public final RigidTable table;
    public final RigidStep step;

    public RigidReads(WorldParts world) {
        this.world = world;
        table = world.rigids;
        step = table.step;
    }

    /** The id of a body, which is there; callers read {@link #table} and {@link #step} by it. */
    public int require(long handle) {
        world.guard.check();
        return world.rigid(handle);
    }

    /** Whether a body does not sleep. */
    public boolean isAwake(long handle) {
        world.guard.enter();
        try (world.guard) {
            int body = world.rigid(handle);
            world.pending.settle();
            return !step.isAsleep(body);
        }
    }

    /** How many bodies do not sleep. */
    public int awake() {
        world.guard.enter();
        try (world.guard) {
            world.pending.settle();
            return step.awake();
        }
    }

    /** Three elements an id: x, y, the angle in radians; living, with a bit an id, may be null. */
    public void readById(float[] poses, long[] living) {
        world.guard.enter();
        try (world.guard) {
            beginById("bodies", poses, living);
            for (int id = 0; id < table.ids.end(); id++) {
                if (table.ids.lives(id)) {
                    poses[STRIDE * id] = step.x[id];
                    poses[STRIDE * id + 1] = step.y[id];
                    poses[STRIDE * id + 2] = Surface.radians(step.angle[id]);
                }
            }
        }
    }

    /** Takes down where bodies are. */
    public void keep(RigidPoses poses) {
        world.guard.enter();
        try (world.guard) {
            poses.keep(table);
        }
    }

    /** As {@link #readById}, on the way from before a step to after it. */
    public void readBetween(RigidPoses before, RigidPoses after, float alpha, float[] poses, long[] living) {
        world.guard.enter();
        try (world.guard) {
            beginById("bodies", poses, living);
            for (int id = 0; id < table.ids.end(); id++) {
                if (table.ids.lives(id)) {
                    after.readBetween(before, alpha, table, id, world.settings.bounds(), poses);
                }
            }
        }
    }

    /** Three elements an id: vx, vy, the angular velocity; living as above. */
    public void readVelocitiesById(float[] velocities, long[] living) {
        world.guard.enter();
        try (world.guard) {
            beginById("velocities", velocities, living);
            for (int id = 0; id < table.ids.end(); id++) {
                if (table.ids.lives(id)) {
                    velocities[STRIDE * id] = step.vx[id];
                    velocities[STRIDE * id + 1] = step.vy[id];
                    velocities[STRIDE * id + 2] = step.omega[id];
                }
            }
        }
    }

    private void beginById(String what, float[] to, long[] living) {
        int end = table.ids.end();
        Readings.requireRoom(what, to, (long) STRIDE * end);
        Readings.requireRoom(living, end);
        if (living != null) {
            Arrays.fill(living, 0L);
        }
        Arrays.fill(to, Float.NaN);
        for (int id = 0; living != null && id < end; id++) {
            living[id >> 6] |= table.ids.lives(id) ? 1L << id : 0L;
        }
    }

    /** Gives the handles of all bodies in the order of ids. */
    public void readHandles(long[] handles) {
        world.guard.enter();
        try (world.guard) {
            Readings.requireRoom("handles", handles, table.ids.size());
            int k = 0;
            for (int id = 0; id < table.ids.end(); id++) {
                if (table.ids.lives(id)) {
                    handles[k++] = table.ids.handle(id);
                }
            }
        }
    }

    // ---- events

    /** Sets whether somebody is told of touches. */
    public void report(boolean on) {
        world.guard.enter();
        try (world.guard) {
            table.events.turn(on);
            world.copies.forgetSaved();
        }
    }

    /** Whether somebody is told of touches. */
    public boolean reports() {
        return table.events.isOn();
    }

    /** Writes what touches a body; returns how many there are. */
    public int touching(long handle, long[] to) {
        world.guard.enter();
        try (world.guard) {
            Limits.notNull("handles", to);
            return table.events.list(world.rigid(handle), to);
        }
    }

    /** Gives the touches that have begun and ended since the last call. */
    public void take(RigidTouches to) {
        world.guard.enter();
        try (world.guard) {
            table.events.take(to);
        }
    }
}
