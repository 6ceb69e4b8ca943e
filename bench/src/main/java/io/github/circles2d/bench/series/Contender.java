package io.github.circles2d.bench.series;

import io.github.circles2d.bench.engines.Engine;
import io.github.circles2d.bench.engines.Engines;
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

    /** All on a machine, the fastest first, so that little is missing where the time ends. */
    static List<Contender> all(Map<String, Device> devices, int processors) {
        List<Contender> all = new ArrayList<>();
        devices.forEach((name, device) -> {
            if (device.kind() != Device.Kind.CPU) {
                all.add(new Contender(Engines.world(name), NO_THREADS));
            }
        });
        devices.forEach((name, device) -> {
            if (device.kind() == Device.Kind.CPU) {
                all.add(new Contender(Engines.world(name), Integer.toString(device.computeUnits())));
            }
        });
        all.add(new Contender(Engines.WORLD_JVM, Integer.toString(processors)));
        if (processors > 1) {
            all.add(new Contender(Engines.WORLD_JVM, "1"));
        }
        PEERS.forEach(peer -> all.add(new Contender(peer, "1")));
        return all;
    }

    /** Whether it is World, which alone is measured with a million circles: a step takes the others seconds. */
    boolean isWorld() {
        return engine.startsWith("world");
    }

    /** A new engine. */
    Engine create() {
        return engine.equals(Engines.WORLD_JVM) ? Engines.worldJvm(Integer.parseInt(threads)) : Engines.create(engine);
    }

    @Override
    public String toString() {
        return threads.equals(NO_THREADS)
                ? engine
                : engine + " on " + threads + (threads.equals("1") ? " thread" : " threads");
    }
}
