package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.engines.Motion;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.scenes.Quality;
import io.github.circles2d.scenes.Scene;
import java.util.Map;

/** How good the state is in which a run ends. */
public final class EndState {
    private EndState() {}

    /**
     * Puts how good the state is in which a run ends: a step that leaves circles inside each other is soon made.
     *
     * @throws IllegalStateException if a number is not finite
     */
    public static void put(Map<String, String> row, Scene scene, Motion end) {
        int outside = 0;
        for (int i = 0; i < scene.size(); i++) {
            if (!Float.isFinite(end.x[i] + end.y[i] + end.vx[i] + end.vy[i])) {
                throw new IllegalStateException("circle " + i + " of " + scene + " ended at (" + end.x[i] + ", "
                        + end.y[i] + ") with velocity (" + end.vx[i] + ", " + end.vy[i] + ")");
            }
            boolean inside = end.x[i] >= scene.minX()
                    && end.x[i] <= scene.maxX()
                    && end.y[i] >= scene.minY()
                    && end.y[i] <= scene.maxY();
            outside += inside ? 0 : 1;
        }
        Quality quality = end.quality(scene);
        row.put("mean_depth", Numbers.exact(quality.meanDepth()));
        row.put("max_depth", Numbers.exact(quality.maxDepth()));
        row.put("deep_pairs", Long.toString(quality.deep()));
        row.put("kinetic_energy", Numbers.exact(quality.kineticEnergyPerCircle()));
        row.put("outside", Integer.toString(outside));
    }
}
