package io.github.circles2d.fuzz;

import io.github.circles2d.Backend;
import io.github.circles2d.BodyQueries;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Queries;
import io.github.circles2d.Recording;
import io.github.circles2d.Rewind;
import io.github.circles2d.Rollback;
import io.github.circles2d.TerrainQueries;
import io.github.circles2d.World;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenCl;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** A world on a back end, and what programs use with it. */
final class Player implements AutoCloseable {
    private static final float STEP = 1 / 60f;

    final Api api;
    final String name;
    final World world;
    final Rewind rewind;
    final FixedStep fixedStep;
    final Rollback rollback;
    final Recording recording;
    final ByteArrayOutputStream log = new ByteArrayOutputStream();
    final List<ByteBuffer> snapshots = new ArrayList<>();

    // with the mask that a program has set last
    Queries queries;
    TerrainQueries terrainQueries;
    BodyQueries bodyQueries;

    /** Handles of bodies that the program has added, some of which may have gone. */
    final List<Long> bodies = new ArrayList<>();

    /** Handles that the program has named. */
    final List<Long> seen = new ArrayList<>();

    /** Whose snapshots and logs this one gets. */
    Player next = this;

    /** moving: who lets the world on the JVM move; null if it stays. */
    Player(Api api, Setting setting, Backend backend, int threads, int number, Ready ready, Consumer<World> moving)
            throws Throwable {
        this.api = api;
        name = (backend == Backend.JVM ? "JVM on " + threads + " threads" : backend.toString())
                + (moving == null ? "" : ", from where it moves");
        World.Builder builder = (World.Builder) api.call(World.class.getMethod("builder"), null);
        for (Object[] call : setting.calls) {
            Object[] arguments = java.util.Arrays.copyOfRange(call, 1, call.length);
            api.named(builder, (String) call[0], arguments);
        }
        if (setting.capacities > 0) {
            api.named(builder, "capacity", setting.capacities == 1 ? 0 : 100 * number);
        }
        if (backend != Backend.JVM && setting.frames % 2 == 0) {
            api.named(builder, "device", device(backend));
        } else {
            api.named(builder, "backend", backend);
        }
        if (backend == Backend.JVM) {
            api.named(builder, "threads", threads);
        }
        world = (World) api.named(builder, "build");
        if (moving != null) {
            moving.accept(world);
        }
        ready.make(world);
        queries = world.queries();
        terrainQueries = queries.terrain();
        bodyQueries = queries.bodies();
        rewind = new Rewind(world, setting.frames);
        fixedStep = new FixedStep(world, STEP);
        rollback = new Rollback(world, new Pushes(this), STEP, 2, setting.frames);
        recording = setting.recorded ? new Recording(world, log, setting.hashEvery) : null;
    }

    /** The device that the back end takes of itself. */
    static Device device(Backend backend) {
        return OpenCl.devices().stream()
                .filter(device -> (device.kind() == Device.Kind.GPU) == (backend == Backend.OPENCL_GPU))
                .findFirst()
                .orElseThrow();
    }

    /** Its state, as bytes. */
    ByteBuffer snapshot() {
        ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(bytes);
        return bytes.flip();
    }

    /** Takes up what a call has given. */
    void keep(Object result) {
        if (result instanceof Queries masked) {
            queries = masked;
        } else if (result instanceof TerrainQueries masked) {
            terrainQueries = masked;
        } else if (result instanceof BodyQueries masked) {
            bodyQueries = masked;
        } else if (result instanceof io.github.circles2d.TerrainBody body && !bodies.contains(body.handle())) {
            bodies.add(body.handle());
        }
    }

    @Override
    public void close() throws IOException {
        world.close();
    }
}
