package io.github.circles2d.demo;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import io.github.circles2d.WorldStats;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;

/**
 * {@link World}, the engine for games, as the demo sees it. What a person may switch between is what it runs on: a switch
 * takes a snapshot along, so the circles go on as if nothing had happened.
 */
final class WorldEngine implements Engine {
    private final Options options;
    private final Scene scene;

    /** By strategy number, from 1 on: the device. Number 0 is the JVM. */
    private final List<Device> devices;

    private World world;
    private WorldStats stats;
    private int strategy;
    private float[] packed = new float[0];
    private float[][] now;

    private WorldEngine(Options options, List<Device> devices) {
        this.options = options;
        this.scene = options.scene();
        this.devices = devices;
    }

    static WorldEngine open(Options options) throws EngineException {
        WorldEngine engine = new WorldEngine(options, devices());
        try {
            engine.world = engine.builder(options.device()).build();
            engine.stats = engine.world.stats();
            engine.strategy = engine.strategyInUse();
            engine.restart();
            return engine;
        } catch (OpenClException | IllegalArgumentException e) {
            engine.close();
            throw new EngineException(e.getMessage(), e);
        }
    }

    private static List<Device> devices() {
        try {
            return OpenCl.devices();
        } catch (OpenClException e) {
            return List.of(); // World needs none
        }
    }

    private World.Builder builder(String device) throws EngineException {
        World.Builder builder = builder();
        return switch (device) {
            case "best" -> builder.backend(Backend.AUTO);
            case "jvm" -> builder.backend(Backend.JVM);
            default -> builder.device(DeviceChoice.find(device));
        };
    }

    private World.Builder builder() {
        World.Builder builder = World.builder();
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        SceneLoader.radii(scene, builder::radii);
        return builder.gravity(options.gravityX(), options.gravityY()).restitution(options.restitution());
    }

    private int strategyInUse() {
        for (int k = 0; k < devices.size() && stats.backend() != Backend.JVM; k++) {
            if (devices.get(k).toString().equals(stats.device())) {
                return k + 1;
            }
        }
        return 0;
    }

    @Override
    public float[][] loop() throws EngineException {
        try {
            world.step(Options.TIME_STEP);
            now = read();
            return now;
        } catch (OpenClException e) {
            throw new EngineException(e.getMessage(), e);
        }
    }

    private float[][] read() {
        int n = world.size();
        if (packed.length < 4 * n) {
            packed = new float[4 * n];
        }
        world.read(packed);
        float[][] circles = new float[4][n];
        for (int i = 0; i < n; i++) {
            for (int d = 0; d < 4; d++) {
                circles[d][i] = packed[4 * i + d];
            }
        }
        return circles;
    }

    @Override
    public float[][] circles() {
        return now;
    }

    @Override
    public void restart() throws EngineException {
        try {
            long[] handles = new long[world.size()];
            world.readHandles(handles);
            for (long handle : handles) {
                world.remove(handle);
            }
            SceneLoader.circles(scene, world::add, world::setRestitution);
            now = read();
        } catch (OpenClException e) {
            throw new EngineException(e.getMessage(), e);
        }
    }

    @Override
    public String name() {
        return "World";
    }

    @Override
    public String device() {
        return stats.device();
    }

    @Override
    public List<String> strategies() {
        List<String> names = new ArrayList<>();
        names.add("back end JVM");
        devices.forEach(device -> names.add("back end OpenCL on a " + device.kind()));
        return names;
    }

    @Override
    public int strategy() {
        return strategy;
    }

    @Override
    public void switchTo(int wanted) throws EngineException {
        World next = null;
        try {
            World.Builder builder = builder();
            next = (wanted == 0 ? builder.backend(Backend.JVM) : builder.device(devices.get(wanted - 1))).build();
            ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(snapshot);
            next.restore(snapshot.flip());
            WorldStats nextStats = next.stats();
            world.close();
            world = next;
            stats = nextStats;
            strategy = wanted;
            next = null;
        } catch (OpenClException e) {
            throw new EngineException(e.getMessage(), e);
        } finally {
            if (next != null) {
                next.close();
            }
        }
    }

    @Override
    public String remark() {
        return "";
    }

    @Override
    public void close() {
        if (world != null) {
            world.close();
        }
    }
}
