package io.github.circles2d.bench.engines;

import io.github.circles2d.Queries;
import io.github.circles2d.World;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import java.util.function.Supplier;

/** This library's engine for games, on one back end. Nothing is read back before {@link #read}. */
final class WorldEngine implements SearchEngine {
    private final Supplier<World.Builder> backend;
    private World world;
    private float timeStep;
    private long first;
    private int[] ends = new int[0];
    private long[] found = new long[0];
    private float[] hits = new float[0];

    WorldEngine(Supplier<World.Builder> backend) {
        this.backend = backend;
    }

    @Override
    public void load(Scene scene) {
        close();
        timeStep = scene.timeStep();
        world = load(scene, backend.get());
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        first = handles[0];
    }

    /** A world with a scene in it. */
    static World load(Scene scene, World.Builder builder) {
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        World world = builder.build();
        SceneLoader.circles(scene, world::add, world::setRestitution);
        return world;
    }

    @Override
    public void step() {
        world.step(timeStep);
    }

    @Override
    public void finish() {
        world.finish();
    }

    @Override
    public void read(Motion motion) {
        int n = world.size();
        float[] circles = new float[4 * n];
        float[] velocities = new float[2 * n];
        world.read(circles);
        world.readVelocities(velocities);
        for (int i = 0; i < n; i++) {
            motion.x[i] = circles[4 * i];
            motion.y[i] = circles[4 * i + 1];
            motion.vx[i] = velocities[2 * i];
            motion.vy[i] = velocities[2 * i + 1];
        }
    }

    @Override
    public void loadCircles(Scene scene) {
        load(scene);
    }

    @Override
    public long overlaps(float[] discs) {
        int n = discs.length / 3;
        if (ends.length < n) {
            ends = new int[n];
        }
        forgetIndex();
        int count = world.queries().overlapCircle(discs, n, ends, found);
        if (count > found.length) {
            found = new long[count];
        }
        return count;
    }

    @Override
    public long rayHits(float[] rays) {
        int n = rays.length / 4;
        if (hits.length < Queries.HIT_STRIDE * n) {
            found = new long[Math.max(n, found.length)];
            hits = new float[Queries.HIT_STRIDE * n];
        }
        forgetIndex();
        return world.queries().rayCast(rays, n, found, hits);
    }

    /** Makes a change that leaves all as it is, after which the next query reads the circles and builds its index. */
    private void forgetIndex() {
        world.setPosition(first, world.x(first), world.y(first));
    }

    @Override
    public boolean repeatable() {
        return true;
    }

    @Override
    public void close() {
        if (world != null) {
            world.close();
            world = null;
        }
    }
}
