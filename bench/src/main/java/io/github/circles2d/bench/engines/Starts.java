package io.github.circles2d.bench.engines;

import io.github.circles2d.World;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/**
 * The states that World's benchmarks start from: the scene {@code packed} after some steps, as a snapshot. A sweep makes each
 * once, on the fastest engine that it has, and its JVMs read it: it is the same to the bit on all of them, and the steps
 * before it would take longer than those that are measured.
 */
public final class Starts {
    private Starts() {}

    /** Where a sweep with this process id keeps its starts. */
    private static Path folder(long process) {
        return Path.of(System.getProperty("java.io.tmpdir"), "circles2d-starts-" + process);
    }

    private static Path file(long process, int n, int skipped) {
        return folder(process).resolve(n + "-" + skipped);
    }

    /**
     * Makes a start and keeps it for the JVMs that this one starts, until this one ends.
     *
     * @param engine World's name, out of {@link Engines}
     * @param skipped steps before the state
     */
    public static void keep(String engine, int n, int skipped) throws IOException {
        long self = ProcessHandle.current().pid();
        Path file = file(self, n, skipped);
        if (Files.exists(file)) {
            return;
        }
        ByteBuffer state = make(engine, n, skipped);
        Files.createDirectories(folder(self));
        // In this order: what is registered last is deleted first.
        folder(self).toFile().deleteOnExit();
        file.toFile().deleteOnExit();
        Path half = file.resolveSibling(file.getFileName() + ".half");
        half.toFile().deleteOnExit();
        Files.write(half, state.array());
        Files.move(half, file, StandardCopyOption.ATOMIC_MOVE);
    }

    /** The start that the sweep has kept which started this JVM; made here where there is none. */
    public static ByteBuffer get(String engine, int n, int skipped) throws IOException {
        long parent = ProcessHandle.current()
                .parent()
                .map(ProcessHandle::pid)
                .orElse(ProcessHandle.current().pid());
        Path file = file(parent, n, skipped);
        return Files.exists(file) ? ByteBuffer.wrap(Files.readAllBytes(file)) : make(engine, n, skipped);
    }

    private static ByteBuffer make(String engine, int n, int skipped) {
        Scene scene = Scenes.packed(n, Scenes.SEED);
        try (World world = WorldEngine.load(scene, Engines.worldBuilder(engine))) {
            world.step(scene.timeStep(), skipped);
            ByteBuffer state = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(state);
            return state.flip();
        }
    }
}
