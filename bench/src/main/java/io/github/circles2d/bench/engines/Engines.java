package io.github.circles2d.bench.engines;

import io.github.circles2d.Backend;
import io.github.circles2d.PairIndexing;
import io.github.circles2d.World;
import io.github.circles2d.bench.Devices;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The engines by name. An engine of this library that runs on OpenCL is named {@code engine@device}. */
public final class Engines {
    /** A grid and contacts, as a good Java programmer would write them for one thread. */
    public static final String JAVA_GRID = "java-grid";

    /** Engines of other people, and what a reader would write. */
    public static final List<String> PEERS = List.of("java-all-pairs", "gdx-box2d", "jbox2d", "dyn4j", JAVA_GRID);

    /** World on the JVM, with as many threads as the machine has processors. */
    public static final String WORLD_JVM = "world-jvm";

    private static final String THESIS = "circles2d-";
    private static final String WORLD = "world";

    private Engines() {}

    /** The names of the library's own engines on a device. */
    public static List<String> own(String device) {
        List<String> names = new ArrayList<>();
        names.add(world(device));
        for (PairIndexing indexing : List.of(PairIndexing.LOOKUP_TABLE, PairIndexing.EXACT)) {
            names.add(thesis(indexing) + "@" + device);
        }
        return names;
    }

    /** The name of World on a device. */
    public static String world(String device) {
        return WORLD + "@" + device;
    }

    /** The name of Circles2D with a pair indexing, without a device. */
    public static String thesis(PairIndexing indexing) {
        return THESIS + indexing.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** Creates the engine of a name. */
    public static Engine create(String name) {
        switch (name) {
            case "java-all-pairs":
                return new AllPairsEngine();
            case "gdx-box2d":
                return new GdxBox2dEngine();
            case "jbox2d":
                return new Jbox2dEngine();
            case "dyn4j":
                return new Dyn4jEngine();
            case JAVA_GRID:
                return new GridEngine();
            case WORLD_JVM:
                return new WorldEngine(() -> worldBuilder(name));
            default:
                return createOwn(name);
        }
    }

    static {
        System.setProperty("circles2d.plans.wait", "true"); // or a measurement would begin with a slower plan
    }

    /** A description of a World of its own name: {@code world-jvm}, or {@code world@} and a device. */
    public static World.Builder worldBuilder(String name) {
        if (name.equals(WORLD_JVM)) {
            return World.builder().backend(Backend.JVM);
        }
        if (!name.startsWith(WORLD + "@")) {
            throw new IllegalArgumentException("there is no World '" + name + "'; there is " + WORLD_JVM + ", " + WORLD
                    + "@cpu, " + WORLD + "@best");
        }
        return World.builder().device(Devices.find(name.substring(WORLD.length() + 1)));
    }

    /** World on a number of threads of the JVM. */
    public static Engine worldJvm(int threads) {
        return new WorldEngine(() -> worldBuilder(WORLD_JVM).threads(threads));
    }

    private static Engine createOwn(String name) {
        int at = name.indexOf('@');
        String engine = at < 0 ? name : name.substring(0, at);
        String device = at < 0 ? "best" : name.substring(at + 1);
        if (engine.equals(WORLD)) {
            return new WorldEngine(() -> worldBuilder(world(device)));
        }
        for (PairIndexing indexing : PairIndexing.values()) {
            if (engine.equals(thesis(indexing))) {
                return new ThesisEngine(Devices.find(device), indexing);
            }
        }
        throw new IllegalArgumentException("there is no engine '" + name + "'");
    }

    /** What to know before comparing an engine's figures with those of another. */
    public static String remarks(String name) {
        String engine = name.contains("@") ? name.substring(0, name.indexOf('@')) : name;
        switch (engine) {
            case "java-all-pairs":
                return "the thesis's physics, one Java thread, every pair tested, each overlap resolved once a step";
            case "gdx-box2d":
                return "Box2D 2.3.1 in C++ as libGDX 1.14 wraps it, one thread; 8 velocity and 3 position iterations; rotation locked, no"
                        + " friction, no sleeping; no restitution below 1 m/s at a mean radius of 0.5 m";
            case "jbox2d":
                return "Box2D 2.2 in Java, one thread; 8 velocity and 3 position iterations; rotation locked, no friction, no"
                        + " sleeping; no restitution below 1 m/s at a mean radius of 0.5 m";
            case "dyn4j":
                return "Java, double precision, one thread; its own defaults (6 velocity and 2 position iterations, continuous"
                        + " detection); rotation locked, no friction, no sleeping; no restitution below 1 m/s at a mean radius"
                        + " of 0.5 m";
            case JAVA_GRID:
                return "plain Java, one thread: a uniform grid, 4 sub-steps of soft contacts with warm starting, solved one after"
                        + " the other, restitution once a step; no rotation, no friction, no sleeping";
            case WORLD_JVM:
                return "this library's engine for games in Java, as many threads as the machine has processors; 4 sub-steps; no"
                        + " rotation, no friction, no sleeping; the same bits as world@device";
            case WORLD:
                return "this library's engine for games on an OpenCL device; the same bits as world-jvm";
            default:
                return "this library's engine of the thesis, every pair tested, each overlap resolved once a step, in a race;"
                        + " all circles read back after every step";
        }
    }
}
