package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.scenes.Scenes;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * What surfaces cost: two worlds make their steps in turn, of which the first grips and the second does not; then one that has rolling
 * resistance, too. The main method prints a line of a CSV file for each crowd, or times one world for a comparison with engines outside
 * Maven.
 *
 * <p>This class and {@link InTurn} need the library and no other class, so that they run on a machine with nothing but a JVM and the library.
 */
public final class SurfaceCosts {
    /** The crowds: {@code packed} with like radii, and one with radii of 1:10. */
    public static final List<String> CASES = List.of("like", "mixed");

    static final String HEADER =
            "machine,radii,n,without_us,friction_us,friction_ratio,friction_ratio_of_minima,rolling_ratio,asked";

    private static final float FRICTION = 0.6f;
    private static final float ROLLING = 0.1f;
    private static final int SETTLING = 300;

    /** From here on a processor makes few rounds: one takes it seconds, or a minute. */
    private static final int CROWD = 100_000;

    private static final int SETTLING_OF_CROWD = 100;
    private static final int ROUNDS_OF_CROWD = 5;

    private static final String ASKED = "1.35";

    private SurfaceCosts() {}

    /**
     * Prints what surfaces cost.
     *
     * @param arguments as {@link #run}
     */
    public static void main(String[] arguments) {
        InTurn.main(arguments, SurfaceCosts::run);
    }

    /**
     * Prints what surfaces cost, or the median and the least ms a step of one world that grips.
     *
     * @param arguments a name of {@link Backend}, numbers of circles and cases, by default JVM, 15000, and all cases; or
     *     {@code run N THREADS SKIPPED STEPS}
     * @param out takes the lines of a CSV file
     * @throws IllegalArgumentException where the arguments are others
     */
    public static void run(List<String> arguments, PrintStream out) {
        if (!arguments.isEmpty() && arguments.get(0).equals("run")) {
            int[] numbers = arguments.subList(1, arguments.size()).stream()
                    .mapToInt(Integer::parseInt)
                    .toArray();
            if (numbers.length != 4 || numbers[3] < 1) {
                throw new IllegalArgumentException(
                        "arguments are: run N THREADS SKIPPED STEPS, a step or more, not " + arguments);
            }
            time(numbers, out);
            return;
        }
        InTurn.Arguments asked = InTurn.Arguments.read(arguments, 15_000, CASES);
        out.println(HEADER);
        for (String each : asked.cases()) {
            for (int n : asked.sizes()) {
                boolean few = n >= CROWD && asked.backend() == Backend.JVM;
                compare(
                        each,
                        asked.backend(),
                        n,
                        few ? SETTLING_OF_CROWD : SETTLING,
                        few ? 1 : InTurn.WARM_ROUNDS,
                        few ? ROUNDS_OF_CROWD : InTurn.ROUNDS,
                        out);
            }
        }
    }

    static void compare(String radii, Backend backend, int n, int settling, int warm, int rounds, PrintStream out) {
        String device;
        InTurn friction;
        try (World grips = world(radii, backend, n, FRICTION, 0);
                World silent = world(radii, backend, n, 0, 0)) {
            friction = InTurn.measure(grips, silent, settling, warm, rounds);
            device = silent.stats().device();
        }
        InTurn rolling;
        try (World rolls = world(radii, backend, n, FRICTION, ROLLING);
                World silent = world(radii, backend, n, 0, 0)) {
            rolling = InTurn.measure(rolls, silent, settling, warm, rounds);
        }
        out.printf(
                Locale.ROOT,
                "\"%s\",%s,%d,%.0f,%.0f,%.2f,%.2f,%.2f,%s%n",
                device,
                radii.equals("mixed") ? "1:10" : radii,
                n,
                1000 * friction.otherMedian(),
                1000 * friction.median(),
                friction.ratio(),
                friction.ratioOfMinima(),
                rolling.ratio(),
                ASKED);
        out.flush();
    }

    static World world(String radii, Backend backend, int n, float friction, float rolling) {
        Scene scene = radii.equals("mixed") ? Scenes.mixed(n, 10, Scenes.SEED) : Scenes.packed(n, Scenes.SEED);
        World.Builder builder = World.builder().backend(backend);
        return load(scene, backend == Backend.JVM ? builder.threads(2) : builder, friction, rolling);
    }

    private static World load(Scene scene, World.Builder builder, float friction, float rolling) {
        builder.friction(friction).rollingResistance(rolling);
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        World world = builder.build();
        SceneLoader.circles(scene, world::add, world::setRestitution);
        return world;
    }

    /** The scene {@code packed} on the JVM: a call a step, with a wait after it. */
    private static void time(int[] numbers, PrintStream out) {
        double[] ms = new double[numbers[3]];
        // the first run is for the JVM's compiler
        for (int run = 0; run < 2; run++) {
            Scene scene = Scenes.packed(numbers[0], Scenes.SEED);
            World.Builder builder = World.builder().backend(Backend.JVM).threads(numbers[1]);
            try (World world = load(scene, builder, FRICTION, 0)) {
                world.step(InTurn.TIME_STEP, numbers[2]);
                world.finish();
                for (int k = 0; k < ms.length; k++) {
                    long from = System.nanoTime();
                    world.step(InTurn.TIME_STEP);
                    world.finish();
                    ms[k] = (System.nanoTime() - from) / 1e6;
                }
            }
        }
        Arrays.sort(ms);
        out.printf(Locale.ROOT, "%.4f,%.4f%n", ms[ms.length / 2], ms[0]);
    }
}
