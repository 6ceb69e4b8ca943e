package io.github.circles2d.world.jvm;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;

/** A pipeline with a scene in it, driven as World drives it, for tests that look inside. */
final class JvmWorld implements AutoCloseable {
    final JvmPipeline pipeline;
    final HandleTable roster = new HandleTable();
    final GridLevels levels = new GridLevels();
    final StepConstants constants = new StepConstants();
    private final Commands commands = new Commands();
    private final Bounds bounds;
    private final float gravityX;
    private final float gravityY;
    private final float timeStep;

    JvmWorld(Scene scene, int threads) {
        bounds = new Bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY());
        gravityX = scene.gravityX();
        gravityY = scene.gravityY();
        timeStep = scene.timeStep();
        pipeline = new JvmPipeline(threads, 1, scene.size(), false);
        for (int i = 0; i < scene.size(); i++) {
            add(
                    scene.x(i),
                    scene.y(i),
                    scene.radius(i),
                    scene.fixed(i) ? Float.POSITIVE_INFINITY : scene.mass(i),
                    scene.restitution(i),
                    scene.vx(i),
                    scene.vy(i));
        }
    }

    int add(float x, float y, float r, float mass, float restitution, float vx, float vy) {
        int id = roster.add(r);
        commands.add(id, x, y, r, mass, restitution, vx, vy);
        return id;
    }

    void remove(int id) {
        roster.remove(id);
        commands.remove(id);
    }

    /** Computes what the next step starts from: the levels and the constants. */
    void prepare() {
        pipeline.makeRoom(commands);
        pipeline.apply(commands);
        commands.clear();
        constants.set(timeStep, 4, gravityX, gravityY, bounds, timeStep);
        levels.layOut(bounds, roster.greatestRadius(), roster.population());
    }

    void step(int steps) {
        prepare();
        pipeline.step(constants, levels, steps);
    }

    SavedState save() {
        SavedState saved = new SavedState();
        roster.save(saved);
        pipeline.save(saved);
        return saved;
    }

    @Override
    public void close() {
        pipeline.close();
    }
}
