package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.engines.Engine;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Table;
import io.github.circles2d.opencl.Device;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * An engine and the threads that it runs on.
 *
 * @param engine a name out of {@link Engines}
 * @param threads a number, or {@link #NO_THREADS}
 */
public record Contender(String engine, String threads) {
    /** In place of a number of threads, for an engine on a GPU. */
    public static final String NO_THREADS = "-";

    /** Engines of other people that Maven has. Each runs on one thread. */
    public static final List<String> PEERS = List.of("gdx-box2d", "dyn4j", "jbox2d");

    /** World on GPUs, on the JVM and on processors by OpenCL. */
    static List<Contender> worlds(Map<String, Device> devices) {
        List<Contender> worlds = new ArrayList<>();
        worlds.add(new Contender(
                Engines.WORLD_JVM, Integer.toString(Runtime.getRuntime().availableProcessors())));
        devices.forEach((name, device) -> {
            boolean cpu = device.kind() == Device.Kind.CPU;
            String threads = cpu ? Integer.toString(device.computeUnits()) : NO_THREADS;
            long onGpus = worlds.stream().filter(Contender::isOnGpu).count();
            worlds.add(cpu ? worlds.size() : (int) onGpus, new Contender(Engines.world(name), threads));
        });
        return worlds;
    }

    /** All on a machine, the fastest first. */
    static List<Contender> all(Map<String, Device> devices) {
        List<Contender> all = worlds(devices);
        Contender oneThread = new Contender(Engines.WORLD_JVM, "1");
        if (!all.contains(oneThread)) {
            all.add(oneThread);
        }
        PEERS.forEach(peer -> all.add(new Contender(peer, "1")));
        return all;
    }

    /** The columns of the table of the series that name a figure. */
    Map<String, String> key(Series series, int n) {
        return Table.columns("engine", engine, "series", series.title, "n", Integer.toString(n), "threads", threads);
    }

    /** Whether it is World. */
    public boolean isWorld() {
        return engine.startsWith("world");
    }

    /** Whether it runs on a graphics processor. */
    public boolean isOnGpu() {
        return threads.equals(NO_THREADS);
    }

    /** A new engine. */
    Engine create() {
        return engine.equals(Engines.WORLD_JVM) ? Engines.worldJvm(Integer.parseInt(threads)) : Engines.create(engine);
    }

    @Override
    public String toString() {
        return isOnGpu() ? engine : engine + " on " + threads + (threads.equals("1") ? " thread" : " threads");
    }
}
