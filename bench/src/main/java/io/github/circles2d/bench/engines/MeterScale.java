package io.github.circles2d.bench.engines;

import io.github.circles2d.scenes.Scene;

/**
 * Lengths for engines that think in metres. Box2D and dyn4j have tolerances of some millimetres built in and want bodies
 * of about 0.1 to 10 metres, so the scene is enlarged until its mean radius is half a metre. Times, masses and the motion
 * in radii stay the same.
 */
final class MeterScale {
    private static final double MEAN_RADIUS = 0.5;

    /** Metres a unit of length of the scene. */
    final double factor;

    private final Scene scene;

    MeterScale(Scene scene) {
        this.scene = scene;
        double sum = 0;
        for (int i = 0; i < scene.size(); i++) {
            sum += scene.radius(i);
        }
        factor = MEAN_RADIUS * scene.size() / sum;
    }

    /** Density that gives circle i its mass at its enlarged radius. */
    double density(int i) {
        double r = scene.radius(i) * factor;
        return scene.mass(i) / (Math.PI * r * r);
    }

    /**
     * The four walls as boxes (centre x, centre y, half width, half height) in metres. They are as thick as the arena is
     * wide: an over-full crowd pushes circles through thin ones.
     */
    double[][] walls() {
        double width = (scene.maxX() - scene.minX()) * factor;
        double height = (scene.maxY() - scene.minY()) * factor;
        double thick = Math.max(width, height) / 2;
        double midX = scene.minX() * factor + width / 2;
        double midY = scene.minY() * factor + height / 2;
        return new double[][] {
            {scene.minX() * factor - thick, midY, thick, height / 2 + 2 * thick},
            {scene.maxX() * factor + thick, midY, thick, height / 2 + 2 * thick},
            {midX, scene.minY() * factor - thick, width / 2, thick},
            {midX, scene.maxY() * factor + thick, width / 2, thick}
        };
    }
}
