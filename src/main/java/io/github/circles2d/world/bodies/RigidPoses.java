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

    public RigidPoses() {}

    /** Takes down where bodies are. */
    public void keep(RigidTable bodies) {
        int n = bodies.ids.end();
        if (angle.length < n) {
            // All arrays are made before one is assigned: a growth that fails changes nothing.
            int c = Math.max(n, angle.length + (angle.length >> 1));
            long[] newHandle = Arrays.copyOf(handle, c);
            float[] newX = Arrays.copyOf(x, c);
            float[] newY = Arrays.copyOf(y, c);
            int[] newAngle = Arrays.copyOf(angle, c);
            handle = newHandle;
            x = newX;
            y = newY;
            angle = newAngle;
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

    /**
     * Writes where a body of now is on the way from before a step to after it, which is the short one: x, y, the angle in radians. One that was not there
     * before the step is where it was after it, and one that is new where it is now.
     */
    public static void readBetween(
            RigidPoses before, RigidPoses after, float alpha, RigidTable now, int id, Bounds bounds, float[] to) {
        float atX = now.step.x[id];
        float atY = now.step.y[id];
        int turned = now.step.angle[id];
        long its = now.ids.handle(id);
        if (after.has(id, its)) {
            RigidPoses from = before.has(id, its) ? before : after;
            float wayX = CircleMath.shortWay(after.x[id] - from.x[id], bounds.periodX());
            float wayY = CircleMath.shortWay(after.y[id] - from.y[id], bounds.periodY());
            atX = bounds.placeX(from.x[id] + wayX * alpha);
            atY = bounds.placeY(from.y[id] + wayY * alpha);
            turned = from.angle[id] + (int) ((double) (after.angle[id] - from.angle[id]) * alpha);
        }
        to[STRIDE * id] = atX;
        to[STRIDE * id + 1] = atY;
        to[STRIDE * id + 2] = Surface.radians(turned);
    }
}
