package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.Outline;
import io.github.circles2d.World;
import io.github.circles2d.scenes.Scenes;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/**
 * What bodies cost that are pushed, on the JVM, and there beside a device. The main method prints a line of a CSV file for each scene. It needs the library and no other
 * class.
 */
public final class BodyCosts {
    /**
     * The scenes: a pyramid of 20 rows of crates at rest ({@code pyramid}); a thousand crates that fall into a basin ({@code pour}); a heap of
     * ten thousand circles at rest with ten crates among them ({@code crates}), and the same circles without crates ({@code circles}).
     */
    public static final List<String> CASES = List.of("pyramid", "pour", "crates", "circles");

    private static final String ASLEEP = "crates asleep";
    private static final String WAKING = "a crate falls on sleepers";

    /**
     * Those for a device: ten times as many circles, with ten and with a hundred crates, and without; and the ten thousand circles with ten crates
     * in a world that sleeps, all asleep, and as another crate falls on them.
     */
    static final List<String> CASES_OF_DEVICES = List.of(
            "circles", "crates", ASLEEP, WAKING, "many circles", "ten crates in many", "a hundred crates in many");

    static final String HEADER = "scene,bodies,circles,ms";
    static final String HEADER_OF_DEVICES = "scene,bodies,circles,jvm_ms,device_ms";

    private static final float STEP = 1 / 60f;
    private static final float DENSITY = 1f;
    private static final int ROWS = 20;
    private static final int POURED = 1000;
    private static final int COLUMNS = 20;
    private static final int CIRCLES = 10_000;
    private static final int MANY_CIRCLES = 100_000;
    private static final int COLUMNS_OF_HEAP = 142;
    private static final int MANY_COLUMNS = 450;
    private static final float WIDTH = 150;
    private static final float MANY_WIDTH = 475;
    private static final int CRATES_IN_ROW = 50;
    private static final int CRATES = 10;
    private static final int SETTLING = 300;

    /** Steps after which all sleep at the latest. */
    private static final int FALLING_ASLEEP = 6000;

    private static final int STEPS = 600;

    private BodyCosts() {}

    /**
     * Prints what bodies cost.
     *
     * @param arguments as {@link #run}
     */
    public static void main(String[] arguments) {
        InTurn.main(arguments, BodyCosts::run);
    }

    /**
     * Prints what bodies cost: the median of steps of settled scenes, and the mean of the steps if something falls.
     *
     * @param arguments scenes on the JVM with two threads, by default all; or a back end, for all that it is measured beside the JVM with its usual
     *     number of threads
     * @param out takes the lines of a CSV file
     * @throws IllegalArgumentException where the arguments are others
     */
    public static void run(List<String> arguments, PrintStream out) {
        if (arguments.equals(List.of(Backend.OPENCL_GPU.name()))
                || arguments.equals(List.of(Backend.OPENCL_CPU.name()))) {
            out.println(HEADER_OF_DEVICES);
            for (String each : CASES_OF_DEVICES) {
                out.println(beside(each, Backend.valueOf(arguments.get(0)), SETTLING, SETTLING));
            }
            return;
        }
        for (String each : arguments) {
            if (!CASES.contains(each)) {
                throw new IllegalArgumentException("a scene is one of " + CASES + ", not '" + each + "'");
            }
        }
        out.println(HEADER);
        for (String each : arguments.isEmpty() ? CASES : arguments) {
            measure(each, SETTLING, STEPS); // for the JVM's compiler
            out.println(measure(each, SETTLING, STEPS));
        }
    }

    /** The line of a scene. */
    static String measure(String scene, int settling, int steps) {
        try (World world = world(scene)) {
            return String.format(
                    Locale.ROOT,
                    "%s,%d,%d,%.2f",
                    scene,
                    world.bodies().size(),
                    world.size(),
                    millis(world, scene, settling, steps));
        }
    }

    /** The line of a scene on the JVM and on a device, which end in the same state. */
    static String beside(String scene, Backend device, int settling, int steps) {
        try (World jvm = world(scene, usual().backend(Backend.JVM));
                World other = world(scene, usual().backend(device))) {
            double ofJvm = millis(jvm, scene, settling, steps);
            double ofOther = millis(other, scene, settling, steps);
            if (jvm.hash() != other.hash()) {
                throw new IllegalStateException(scene + " is not the same on the JVM and on " + device);
            }
            return String.format(
                    Locale.ROOT, "%s,%d,%d,%.2f,%.2f", scene, jvm.bodies().size(), jvm.size(), ofJvm, ofOther);
        }
    }

    /** A step of a settled scene, the median; if something falls, the mean. */
    private static double millis(World world, String scene, int settling, int steps) {
        boolean falls = scene.equals("pour") || scene.equals(WAKING);
        world.step(STEP, scene.equals("pour") ? 1 : settling);
        if (sleeps(scene)) {
            awaitSleep(world);
        }
        if (scene.equals(WAKING)) {
            Outline crate = Outline.box(2, 2);
            long fallen = world.bodies().add(crate, WIDTH / 2, 100, 0, mass(crate));
            world.bodies().setVelocity(fallen, 0, -30);
        }
        double[] ms = new double[steps];
        for (int k = 0; k < steps; k++) {
            world.finish();
            long from = System.nanoTime();
            world.step(STEP);
            world.finish();
            ms[k] = (System.nanoTime() - from) / 1e6;
        }
        double mean = Arrays.stream(ms).average().orElseThrow();
        Arrays.sort(ms);
        return falls ? mean : ms[steps / 2];
    }

    private static boolean sleeps(String scene) {
        return scene.equals(ASLEEP) || scene.equals(WAKING);
    }

    private static void awaitSleep(World world) {
        for (int step = 0; step < FALLING_ASLEEP; step += SETTLING) {
            if (world.stats().awake() == 0 && world.bodies().awake() == 0) {
                return;
            }
            world.step(STEP, SETTLING);
        }
        throw new IllegalStateException(
                world.stats().awake() + " circles and " + world.bodies().awake() + " bodies are still awake");
    }

    /** A world of a scene, at its start. */
    static World world(String scene) {
        return world(scene, usual().backend(Backend.JVM).threads(2));
    }

    private static World.Builder usual() {
        return World.builder().gravity(0, -10).friction(0.6f);
    }

    private static World world(String scene, World.Builder builder) {
        return switch (scene) {
            case "pyramid" -> pyramid(builder);
            case "pour" -> pour(builder);
            case "crates" -> heap(builder, CIRCLES, CRATES);
            case ASLEEP, WAKING -> heap(builder.sleep(true), CIRCLES, CRATES);
            case "many circles" -> heap(builder, MANY_CIRCLES, 0);
            case "ten crates in many" -> heap(builder, MANY_CIRCLES, CRATES);
            case "a hundred crates in many" -> heap(builder, MANY_CIRCLES, 10 * CRATES);
            default -> heap(builder, CIRCLES, 0);
        };
    }

    private static World pyramid(World.Builder builder) {
        World world = builder.bounds(0, 0, 100, 60).build();
        Outline crate = Outline.box(1, 1);
        for (int row = 0; row < ROWS; row++) {
            for (int k = 0; k < ROWS - row; k++) {
                world.bodies().add(crate, 50 + 1.1f * (k - 0.5f * (ROWS - row - 1)), 0.5f + row, 0, mass(crate));
            }
        }
        return world;
    }

    private static World pour(World.Builder builder) {
        World world = builder.bounds(0, 0, 26, 100).build();
        Outline crate = Outline.box(1, 1);
        Random random = new Random(Scenes.SEED);
        for (int k = 0; k < POURED; k++) {
            float x = 1.5f + 1.2f * (k % COLUMNS) + 0.1f * random.nextFloat();
            float y = 2 + 1.5f * (k / COLUMNS);
            world.bodies().add(crate, x, y, random.nextFloat() - 0.5f, mass(crate));
        }
        return world;
    }

    private static float mass(Outline outline) {
        return DENSITY * outline.area();
    }

    /** Rows of circles; some crates lie between the tenth and the fourteenth row, where circles are left out. */
    private static World heap(World.Builder builder, int circles, int crates) {
        int columns = circles == CIRCLES ? COLUMNS_OF_HEAP : MANY_COLUMNS;
        float width = circles == CIRCLES ? WIDTH : MANY_WIDTH;
        World world =
                builder.bounds(0, 0, width, width).rollingResistance(0.02f).build();
        Outline crate = Outline.box(2, 2);
        List<float[]> places = new ArrayList<>();
        for (int k = 0; k < crates; k++) {
            int inRow = Math.min(crates, CRATES_IN_ROW);
            float[] place = {10 + (width - 10) / inRow * (k % CRATES_IN_ROW), 12 + 9 * (k / CRATES_IN_ROW)};
            places.add(place);
            world.bodies().add(crate, place[0], place[1], 0, mass(crate));
        }
        Random random = new Random(Scenes.SEED);
        for (int k = 0; k < circles; k++) {
            float x = 1.05f * (k % columns + 0.5f) + 0.1f * (random.nextFloat() - 0.5f);
            float y = 0.5f + k / columns;
            float radius = 0.4f + 0.1f * random.nextFloat();
            boolean free = places.stream()
                    .noneMatch(place -> Math.abs(place[0] - x) < 1 + radius && Math.abs(place[1] - y) < 1 + radius);
            if (free) {
                world.add(x, y, radius, radius * radius);
            }
        }
        return world;
    }
}
