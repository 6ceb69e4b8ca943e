package io.github.circles2d.bench.engines;

import io.github.circles2d.scenes.Scene;

/** An engine that finds circles where the scene's units say. It answers one query after the other, as a game would ask. */
public interface SearchEngine extends Engine {
    /**
     * Builds the circles of a scene anew, without its walls: a tree of boxes that takes in walls before circles may be several
     * times as slow, and World has none to find.
     */
    void loadCircles(Scene scene);

    /**
     * Finds the circles that discs overlap, tested exactly. What the engine has to build for it after a step is built again.
     *
     * @param discs x, y, radius of one after the other
     * @return how many there are, of all discs together
     */
    long overlaps(float[] discs);

    /**
     * Finds the first circle that each ray meets. What the engine has to build for it after a step is built again.
     *
     * @param rays x, y, dx, dy of one after the other; none starts in a circle
     * @return how many rays meet one
     */
    long rayHits(float[] rays);
}
