package io.github.circles2d.world.terrain;

import io.github.circles2d.world.model.Bounds;
import java.util.Arrays;

/** Where bodies are at a time, by their ids. */
public final class BodyPoses {
    private int count;

    /** The handle, or 0. */
    private long[] handle = new long[0];

    private double[] x = new double[0];
    private double[] y = new double[0];
    private int[] angle = new int[0];

    /** Takes down where bodies are. */
    public void keep(BodyTable bodies) {
        int n = bodies.ids.end();
        ensure(n);
        for (int id = 0; id < n; id++) {
            keep(bodies, id);
        }
        count = n;
    }

    private void keep(BodyTable bodies, int id) {
        handle[id] = bodies.ids.lives(id) ? bodies.ids.handle(id) : 0;
        x[id] = bodies.x[id];
        y[id] = bodies.y[id];
        angle[id] = bodies.angle[id];
    }

    /** The array that is compared grows last: a growth that fails is tried again. */
    private void ensure(int bodies) {
        if (angle.length < bodies) {
            int c = Math.max(bodies, angle.length + (angle.length >> 1));
            handle = Arrays.copyOf(handle, c);
            x = Arrays.copyOf(x, c);
            y = Arrays.copyOf(y, c);
            angle = Arrays.copyOf(angle, c);
        }
    }

    private boolean has(int id, long itsHandle) {
        return id < count && handle[id] == itsHandle;
    }

    /** Takes down where the bodies of now are on the way from before a step to after it, as {@link #keepOneBetween}. */
    public void keepBetween(BodyPoses before, BodyPoses after, float alpha, BodyTable now, Bounds bounds) {
        for (int id = 0; id < now.ids.end(); id++) {
            keepOneBetween(before, after, alpha, now, bounds, id);
        }
    }

    /**
     * Takes down where a body of now is on that way, which is the short one. One that was not there before the step is where it was after it, and
     * one that is new where it is now.
     */
    public void keepOneBetween(BodyPoses before, BodyPoses after, float alpha, BodyTable now, Bounds bounds, int id) {
        ensure(now.ids.end());
        count = now.ids.end();
        keep(now, id);
        if (handle[id] != 0 && after.has(id, handle[id])) {
            BodyPoses from = before.has(id, handle[id]) ? before : after;
            int way = after.angle[id] - from.angle[id];
            x[id] = between(from.x[id], after.x[id], alpha, bounds.minX(), bounds.periodX());
            y[id] = between(from.y[id], after.y[id], alpha, bounds.minY(), bounds.periodY());
            angle[id] = from.angle[id] + (int) ((double) way * alpha);
        }
    }

    private static double between(double from, double to, float alpha, double min, double period) {
        return BodyTable.place(from + BodyTable.shortWay(to - from, period) * alpha, min, period);
    }

    public double x(int id) {
        return x[id];
    }

    public double y(int id) {
        return y[id];
    }

    /** In units. */
    public int angle(int id) {
        return angle[id];
    }
}
