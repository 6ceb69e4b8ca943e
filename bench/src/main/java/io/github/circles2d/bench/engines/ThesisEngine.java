package io.github.circles2d.bench.engines;

import io.github.circles2d.Circles2D;
import io.github.circles2d.PairIndexing;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.scenes.Scene;
import java.io.IOException;
import java.io.UncheckedIOException;

/** Circles2D as the thesis runs it: every step reads all circles back. */
public final class ThesisEngine implements Engine {
    private final Circles2D engine;
    private final PairIndexing indexing;
    private float[][] circles;

    ThesisEngine(Device device, PairIndexing indexing) {
        engine = new Circles2D(device);
        this.indexing = indexing;
    }

    @Override
    public void load(Scene scene) {
        UnitArena.require(scene, "Circles2D");
        init(engine, scene, indexing);
    }

    /** Puts a scene of the unit arena into an engine. */
    public static void init(Circles2D engine, Scene scene, PairIndexing indexing) {
        engine.clear();
        for (int i = 0; i < scene.size(); i++) {
            engine.addCircle(scene.x(i), scene.y(i), scene.radius(i), scene.mass(i), scene.vx(i), scene.vy(i));
        }
        try {
            engine.init(
                    scene.timeStep(), indexing, scene.restitution(), new float[] {scene.gravityX(), scene.gravityY()});
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void step() {
        circles = engine.loop();
    }

    @Override
    public void read(Motion motion) {
        copy(circles, engine.velocities(), motion);
    }

    public static void copy(float[][] circles, float[][] velocities, Motion motion) {
        int n = motion.x.length;
        System.arraycopy(circles[0], 0, motion.x, 0, n);
        System.arraycopy(circles[1], 0, motion.y, 0, n);
        System.arraycopy(velocities[0], 0, motion.vx, 0, n);
        System.arraycopy(velocities[1], 0, motion.vy, 0, n);
    }

    /** Its contacts are resolved in a race. */
    @Override
    public boolean repeatable() {
        return false;
    }

    @Override
    public void close() {
        engine.close();
    }
}
