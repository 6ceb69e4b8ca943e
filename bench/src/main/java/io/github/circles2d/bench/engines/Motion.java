package io.github.circles2d.bench.engines;

import io.github.circles2d.scenes.Quality;
import io.github.circles2d.scenes.Scene;
import java.util.Arrays;

/** Positions and velocities of all circles, read out of an engine. */
public final class Motion {
    public final float[] x;
    public final float[] y;
    public final float[] vx;
    public final float[] vy;

    public Motion(int n) {
        x = new float[n];
        y = new float[n];
        vx = new float[n];
        vy = new float[n];
    }

    public Quality quality(Scene scene) {
        return Quality.of(x, y, scene.radius(), scene.mass(), vx, vy, scene.size());
    }

    /** Changes with any bit of the state. */
    public long hash() {
        long hash = 0;
        for (float[] values : new float[][] {x, y, vx, vy}) {
            hash = 0x9E3779B97F4A7C15L * hash + Arrays.hashCode(values);
        }
        return hash;
    }

    /**
     * Checks what must hold at the end of any run, however rough the engine: every number is finite, the crowd has moved,
     * and no centre is further outside the arena than {@code slack}.
     *
     * @throws IllegalStateException where it does not
     */
    public void requirePlausible(Scene scene, float slack) {
        boolean moved = false;
        for (int i = 0; i < x.length; i++) {
            boolean inside = x[i] >= scene.minX() - slack
                    && x[i] <= scene.maxX() + slack
                    && y[i] >= scene.minY() - slack
                    && y[i] <= scene.maxY() + slack;
            if (!inside || !Float.isFinite(vx[i]) || !Float.isFinite(vy[i])) {
                throw new IllegalStateException("circle " + i + " of " + scene + " ended at (" + x[i] + ", " + y[i]
                        + ") with velocity (" + vx[i] + ", " + vy[i] + ")");
            }
            moved |= x[i] != scene.x(i) || y[i] != scene.y(i);
        }
        if (!moved) {
            throw new IllegalStateException("no circle of " + scene + " has moved");
        }
    }
}
