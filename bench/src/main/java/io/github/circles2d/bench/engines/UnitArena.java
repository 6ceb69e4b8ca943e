package io.github.circles2d.bench.engines;

import io.github.circles2d.scenes.Scene;

/** The thesis's physics knows one arena and no static circles. */
final class UnitArena {
    private UnitArena() {}

    static void require(Scene scene, String engine) {
        boolean unit = scene.minX() == 0 && scene.minY() == 0 && scene.maxX() == 1 && scene.maxY() == 1;
        boolean free = true;
        for (int i = 0; i < scene.size(); i++) {
            free &= !scene.fixed(i);
        }
        if (!unit || !free) {
            throw new IllegalArgumentException(
                    engine + " runs scenes in the arena [0, 1] x [0, 1] without static circles, not " + scene);
        }
    }
}
