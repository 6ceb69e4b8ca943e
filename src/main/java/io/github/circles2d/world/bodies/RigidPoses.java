package io.github.circles2d.world.bodies;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Surface;
import java.util.Arrays;

/** Where rigid bodies are at a time, by their ids. */
public final class RigidPoses {
    private static final int STRIDE = 3;

    private int count;

    /** The handle, or 0. */
    private long[] handle = new long[0];

    private float[] x = new float[0];
    private float[] y = new float[0];
    private int[] angle = new int[0];
    private final Pose drawn = new Pose();

    public RigidPoses() {}

    /** Takes down where bodies are. */
    public void keep(RigidTable bodies) {
        int n = bodies.ids.end();
        if (angle.length < n) {
            int c = Math.max(n, angle.length + (angle.length >> 1));
            handle = Arrays.copyOf(handle, c);
            x = Arrays.copyOf(x, c);
            y = Arrays.copyOf(y, c);
            angle = Arrays.copyOf(angle, c);
        }
        for (int id = 0; id < n; id++) {
            handle[id] = bodies.ids.lives(id) ? bodies.ids.handle(id) : 0;
            x[id] = bodies.step.x[id];
            y[id] = bodies.step.y[id];
            angle[id] = bodies.step.angle[id];
        }
        count = n;
    }

    private boolean has(int id, long itsHandle) {
        return id < count && handle[id] == itsHandle;
    }

    /** A pose, which callers read. */
    static final class Pose {
        float x;
        float y;
        int angle;
    }

    /**
     * Gives where a body of now is on the way from before a step to after it, which is the short one. One that was not there
     * before the step is where it was after it, and one that is new where it is now.
     */
    static void between(
            RigidPoses before, RigidPoses after, float alpha, RigidTable now, int id, Bounds bounds, Pose to) {
        to.x = now.step.x[id];
        to.y = now.step.y[id];
        to.angle = now.step.angle[id];
        long its = now.ids.handle(id);
        if (after.has(id, its)) {
            RigidPoses from = before.has(id, its) ? before : after;
            float wayX = CircleMath.shortWay(after.x[id] - from.x[id], bounds.periodX());
            float wayY = CircleMath.shortWay(after.y[id] - from.y[id], bounds.periodY());
            to.x = bounds.placeX(from.x[id] + wayX * alpha);
            to.y = bounds.placeY(from.y[id] + wayY * alpha);
            to.angle = from.angle[id] + (int) ((double) (after.angle[id] - from.angle[id]) * alpha);
        }
    }

    /** Writes the same of a body: x, y, the angle in radians. */
    public void readBetween(RigidPoses before, float alpha, RigidTable now, int id, Bounds bounds, float[] to) {
        between(before, this, alpha, now, id, bounds, drawn);
        to[STRIDE * id] = drawn.x;
        to[STRIDE * id + 1] = drawn.y;
        to[STRIDE * id + 2] = Surface.radians(drawn.angle);
    }
}
