package io.github.circles2d.world;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.shared.Pipeline;

/** Simulations made of scenes, for tests of one pipeline or another. */
public final class SimulationScenes {
    private SimulationScenes() {}

    /** A simulation with a scene's circles, in the scene's order. */
    public static Simulation simulation(Scene scene, int subSteps, Pipeline pipeline) {
        WorldParameters parameters = new WorldParameters(
                new Bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY()),
                scene.gravityX(),
                scene.gravityY(),
                scene.restitution(),
                subSteps,
                0);
        Simulation simulation = new Simulation(pipeline, parameters);
        SceneLoader.circles(
                scene,
                (x, y, radius, mass, vx, vy) -> simulation.newCircles.add(x, y, radius, mass, vx, vy, 0),
                (handle, restitution) -> simulation.circles.set(Commands.RESTITUTION, handle, restitution, 0));
        return simulation;
    }
}
