package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.Events;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Recording;
import io.github.circles2d.Rewind;
import io.github.circles2d.StaleHandles;
import io.github.circles2d.World;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.scenes.Scenes;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.Set;

/**
 * A world that uses one feature for games in each step, to measure what that costs. All worlds start from one state: the scene
 * {@code packed} after {@value #SETTLING} steps. The main method prints a table of all features.
 *
 * <p>This class needs the library and no other class, so that it runs on a machine with nothing but a JVM and the library.
 */
public final class GameCosts implements AutoCloseable {
    /** The feature that all others are compared with: steps, and nothing besides. */
    public static final String NOTHING = "nothing";

    /** A frame is saved in each step. */
    public static final String REWIND = "rewind";

    /** All features. */
    public static final List<String> FEATURES = List.of(
            NOTHING,
            "positions",
            "hits",
            "hits-later",
            "kind",
            "walls",
            "half-ignored",
            "sensors",
            "forces",
            "record",
            REWIND,
            "fixed-step");

    /** Features that change how circles move, so their worlds end in other states than the silent one. */
    private static final Set<String> OTHER_STATES = Set.of("half-ignored", "sensors", "forces");

    /** The table leaves the rewind out for more circles than this: no game keeps so large a frame in each step. */
    private static final int GREATEST_REWIND = 15_000;

    private static final int SETTLING = 300;
    private static final float TIME_STEP = 1 / 60f;
    private static final int REPORTED = Events.BEGIN | Events.HIT | Events.END;

    /** Circles to a sensor. */
    private static final int PER_SENSOR = 500;

    private static final int SENSOR = 3;

    /** A kind that no circle has. */
    private static final int NOBODY = 4;

    /** Forces on circles, in parts of their weight. */
    private static final float FORCE = 0.1f;

    private static final int REWIND_FRAMES = 60;
    private static final int HASH_EVERY = 60;

    private static final int STEPS = 120;

    /** Steps before the measured ones, in which arrays grow and memory is touched. */
    private static final int WARM_STEPS = 30;

    /** Rounds in which the JVM compiles; fewer if they take {@value #WARM_SECONDS} seconds. */
    private static final int WARM_ROUNDS = 2;

    private static final double WARM_SECONDS = 5;
    private static final int LEAST_ROUNDS = 3;
    private static final int MOST_ROUNDS = 31;

    /** Runs of one world, of which the median counts; fewer if they take {@value #RUN_SECONDS} seconds. */
    private static final int RUNS = 5;

    private static final double RUN_SECONDS = 0.4;

    /** After this time no further round begins. */
    private static final double SECONDS_PER_SIZE = 60;

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final String feature;
    private final ByteBuffer start;
    private final World world;
    private final Runnable frame;
    private long[] handles;
    private float[] forces;
    private FixedStep loop;
    private Rewind rewind;
    private Recording recording;
    private int frames;
    private long events;

    /** Takes what is read, so that no read is left out. */
    private double sum;

    /**
     * A world with a feature.
     *
     * @param feature one of {@link #FEATURES}
     * @param builder says what the world runs on
     * @param start the state of {@link #start}
     * @throws IllegalArgumentException where there is no such feature
     */
    public GameCosts(String feature, World.Builder builder, ByteBuffer start) {
        this.feature = feature;
        this.start = start.duplicate();
        frame = frame();
        world = builder.build();
    }

    /**
     * Makes the state that all measurements start from. It knows which pairs touch, so a world that reports them does not begin with a
     * burst of events.
     *
     * @param builder says what makes it; the state is the same on all back ends
     * @param n the number of circles
     * @return a snapshot
     */
    public static ByteBuffer start(World.Builder builder, int n) {
        Scene scene = Scenes.packed(n, Scenes.SEED);
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        try (World world = builder.build()) {
            SceneLoader.circles(scene, world::add, world::setRestitution);
            world.step(TIME_STEP, SETTLING - 1);
            world.report(REPORTED | Events.WALL);
            world.step(TIME_STEP);
            ByteBuffer state = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(state);
            return state.flip();
        }
    }

    private Runnable frame() {
        switch (feature) {
            case NOTHING:
            case "half-ignored":
            case "record":
                return this::step;
            case "positions":
                return () -> {
                    step();
                    look(world.positions());
                };
            case "hits":
            case "walls":
            case "sensors":
            case "kind":
                return () -> {
                    step();
                    look(world.events());
                };
            case "hits-later":
                return () -> {
                    step();
                    if (frames > 0) {
                        look(world.takeEvents());
                    }
                    world.requestEvents();
                };
            case "forces":
                return () -> {
                    world.setForces(handles, handles.length, forces, StaleHandles.REFUSE);
                    step();
                };
            case REWIND:
                return () -> {
                    rewind.save(frames);
                    step();
                };
            case "fixed-step":
                return () -> {
                    loop.advance(TIME_STEP, null);
                    look(loop.positions(null));
                };
            default:
                throw new IllegalArgumentException("there is no feature '" + feature + "'; there are " + FEATURES);
        }
    }

    /** Puts the world back to the start, and prepares the feature. */
    public void prepare() throws IOException {
        endRecording();
        if (feature.startsWith("hits")) {
            world.report(REPORTED);
        } else if (feature.equals("kind")) {
            world.report(NOBODY, NOBODY, REPORTED);
        } else if (feature.equals("walls")) {
            world.report(REPORTED | Events.WALL);
        } else if (feature.equals("sensors")) {
            world.report(SENSOR, 0, Events.BEGIN | Events.END);
        }
        world.restore(start.rewind());
        handles = new long[world.size()];
        world.readHandles(handles);
        frames = 0;
        events = 0;
        switch (feature) {
            case "half-ignored":
                ignoreHalf();
                break;
            case "sensors":
                world.kind(SENSOR).setSensor(true);
                for (int i = 0; i < handles.length; i += PER_SENSOR) {
                    world.setKind(handles[i], SENSOR);
                }
                break;
            case "forces":
                makeForces();
                break;
            case "record":
                recording = new Recording(world, OutputStream.nullOutputStream(), HASH_EVERY);
                break;
            case REWIND:
                rewind = new Rewind(world, REWIND_FRAMES);
                break;
            case "fixed-step":
                loop = new FixedStep(world, TIME_STEP);
                // From here on each frame makes one step, and positions lie half-way.
                loop.advance(TIME_STEP / 2, null);
                break;
            default:
        }
        world.finish();
    }

    /** Makes two kinds that ignore each other, with about as many circles each: so half of the pairs that are near ignore each other. */
    private void ignoreHalf() {
        world.kind(1).setCategory(1).setMask(1);
        world.kind(2).setCategory(2).setMask(2);
        Random random = new Random(Scenes.SEED);
        int[] kinds = new int[handles.length];
        Arrays.setAll(kinds, i -> 1 + random.nextInt(2));
        world.setKinds(handles, handles.length, kinds, StaleHandles.REFUSE);
    }

    private void makeForces() {
        float[] circles = new float[4 * handles.length];
        world.read(circles);
        float gravity = Math.abs(world.gravityY());
        Random random = new Random(Scenes.SEED);
        forces = new float[2 * handles.length];
        for (int k = 0; k < forces.length; k++) {
            float mass = circles[4 * (k / 2) + 3];
            forces[k] = FORCE * mass * gravity * (2 * random.nextFloat() - 1);
        }
    }

    /**
     * Makes steps and uses the feature in each, as a game does that has a step a frame. Waits for the last.
     *
     * @param steps how many
     */
    public void frames(int steps) {
        for (int k = 0; k < steps; k++) {
            frame.run();
            frames++;
        }
        world.finish();
    }

    private void step() {
        world.step(TIME_STEP);
    }

    private void look(FloatBuffer positions) {
        sum += positions.get(positions.limit() - 1);
    }

    private void look(Events happened) {
        int size = happened.size();
        for (int i = 0; i < size; i++) {
            if (happened.type(i) != Events.END) {
                sum += happened.speed(i);
            }
        }
        events += size;
    }

    /** Ends a recording, which must have taken all steps, and returns the hash of the state. */
    public long end() throws IOException {
        if (Double.isNaN(sum)) {
            throw new IllegalStateException(feature + ": a number that was read is no number");
        }
        if (recording != null && (recording.hasFailed() || recording.steps() != frames)) {
            throw new IllegalStateException(recording.steps() + " steps are in the log, not " + frames);
        }
        endRecording();
        return world.hash();
    }

    /** Whether a world with a feature moves as the silent one does, to the bit. */
    public static boolean keepsState(String feature) {
        return !OTHER_STATES.contains(feature);
    }

    private void endRecording() throws IOException {
        if (recording != null) {
            recording.close();
            recording = null;
        }
    }

    /** Closes the world. */
    @Override
    public void close() {
        world.close();
    }

    /**
     * Prints what features cost.
     *
     * @param arguments a name of {@link Backend}, and numbers of circles
     */
    public static void main(String[] arguments) {
        try {
            run(List.of(arguments), System.out);
        } catch (IllegalArgumentException e) {
            System.err.println(e.getMessage());
            System.exit(2);
        }
    }

    /**
     * Prints what features cost.
     *
     * @param arguments a name of {@link Backend}, numbers of circles and features; by default JVM, 1250 and 15000, and all features
     * @param out takes the tables
     * @throws IllegalArgumentException where the arguments are others
     */
    public static void run(List<String> arguments, PrintStream out) {
        Backend backend = arguments.isEmpty() ? Backend.JVM : backend(arguments.get(0));
        List<Integer> sizes = new ArrayList<>();
        List<String> features = new ArrayList<>(List.of(NOTHING));
        for (String word : arguments.subList(Math.min(1, arguments.size()), arguments.size())) {
            if (!FEATURES.contains(word)) {
                sizes.add(size(word));
            } else if (!features.contains(word)) {
                features.add(word);
            }
        }
        try {
            for (int n : sizes.isEmpty() ? List.of(1250, 15_000) : sizes) {
                measure(backend, n, features.size() > 1 ? features : FEATURES, out);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Backend backend(String name) {
        for (Backend backend : Backend.values()) {
            if (backend.name().equals(name) && backend != Backend.AUTO) {
                return backend;
            }
        }
        throw new IllegalArgumentException("the back end is JVM, OPENCL_CPU or OPENCL_GPU, not '" + name + "'");
    }

    private static int size(String text) {
        int n = text.matches("\\d{1,9}") ? Integer.parseInt(text) : 0;
        if (n < 1) {
            throw new IllegalArgumentException(
                    "a number of circles is 1 to 999999999, a feature one of " + FEATURES + ", not '" + text + "'");
        }
        return n;
    }

    /** On the JVM one thread makes the steps, so that its processor time is what they take. */
    private static World.Builder builder(Backend backend) {
        World.Builder builder = World.builder().backend(backend);
        return backend == Backend.JVM ? builder.threads(1) : builder;
    }

    private static void measure(Backend backend, int n, List<String> wanted, PrintStream out) throws IOException {
        ByteBuffer start = start(World.builder().backend(backend), n);
        List<String> features = new ArrayList<>(wanted);
        if (n > GREATEST_REWIND) {
            features.remove(REWIND);
        }
        Map<String, List<Double>> millis = new HashMap<>();
        Map<String, List<Double>> ratios = new HashMap<>();
        Map<String, Long> hashes = new HashMap<>();
        Map<String, Double> events = new HashMap<>();
        String device = "";
        int rounds = -WARM_ROUNDS;
        long began = System.nanoTime();
        while (rounds < LEAST_ROUNDS || rounds < MOST_ROUNDS && secondsSince(began) < SECONDS_PER_SIZE) {
            double silent = 0;
            for (String feature : features) {
                try (GameCosts costs = new GameCosts(feature, builder(backend), start)) {
                    costs.prepare();
                    costs.frames(WARM_STEPS);
                    double time = costs.time(backend, hashes);
                    events.put(feature, (double) costs.events / STEPS);
                    device = String.valueOf(costs.world.stats().device());
                    silent = feature.equals(NOTHING) ? time : silent;
                    if (rounds >= 0) {
                        millis.computeIfAbsent(feature, any -> new ArrayList<>())
                                .add(time);
                        ratios.computeIfAbsent(feature, any -> new ArrayList<>())
                                .add(time / silent);
                    }
                }
            }
            rounds = rounds < 0 && secondsSince(began) > WARM_SECONDS ? 0 : rounds + 1;
        }
        out.printf(
                Locale.ROOT,
                "%d circles, %s %s, %d steps, %d rounds, %s%n",
                n,
                backend,
                device,
                STEPS,
                rounds,
                backend == Backend.JVM ? "one thread, its processor time" : "time on the wall");
        out.println("| feature | ms a step | ratio to nothing | least to greatest | events a step | end state |");
        out.println("|---|---|---|---|---|---|");
        for (String feature : features) {
            List<Double> ratio = ratios.get(feature);
            out.printf(
                    Locale.ROOT,
                    "| %s | %.3f | %.2f | %.2f to %.2f | %.1f | %016x |%n",
                    feature,
                    quantile(millis.get(feature), 0.5),
                    quantile(ratio, 0.5),
                    quantile(ratio, 0),
                    quantile(ratio, 1),
                    events.get(feature),
                    hashes.get(feature));
        }
        out.flush();
    }

    /** Ms a step: the median of some runs, whose end states are checked. */
    private double time(Backend backend, Map<String, Long> hashes) throws IOException {
        List<Double> runs = new ArrayList<>();
        long began = System.nanoTime();
        do {
            prepare();
            long from = nanos(backend);
            frames(STEPS);
            runs.add((nanos(backend) - from) / 1e6 / STEPS);
            check(hashes, feature, end());
        } while (runs.size() < RUNS && secondsSince(began) < RUN_SECONDS);
        return quantile(runs, 0.5);
    }

    private static void check(Map<String, Long> hashes, String feature, long hash) {
        Long before = hashes.putIfAbsent(feature, hash);
        if (before != null && before != hash) {
            throw new IllegalStateException(feature + " ended the same run in another state");
        }
        checkAgainstSilent(feature, hash, hashes.get(NOTHING));
    }

    /**
     * Checks an end state against that of the silent world.
     *
     * @throws IllegalStateException where it differs and should not, or where a feature that changes circles has changed none
     */
    public static void checkAgainstSilent(String feature, long hash, long silent) {
        if (keepsState(feature) != (hash == silent)) {
            throw new IllegalStateException(
                    feature + " ended in " + (hash == silent ? "the same" : "another") + " state as nothing");
        }
    }

    private static double quantile(List<Double> values, double share) {
        double[] sorted =
                values.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        double at = share * (sorted.length - 1);
        int below = (int) at;
        int above = Math.min(below + 1, sorted.length - 1);
        return sorted[below] + (at - below) * (sorted[above] - sorted[below]);
    }

    private static double secondsSince(long began) {
        return (System.nanoTime() - began) / 1e9;
    }

    private static long nanos(Backend backend) {
        return backend == Backend.JVM && THREADS.isCurrentThreadCpuTimeSupported()
                ? THREADS.getCurrentThreadCpuTime()
                : System.nanoTime();
    }
}
