package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.scenes.Scenes;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/**
 * What circles cost that sleep or are static: two worlds make their steps in turn, a call a step. The main method prints a line of a CSV
 * file for each scene.
 *
 * <p>This class and {@link InTurn} need the library and no other class, so that they run on a machine with nothing but a JVM and the library.
 */
public final class SleepCosts {
    /**
     * The scenes. In all but {@code level} the second world is the first one without sleep: a settled heap ({@code pile}), on which a ball
     * rolls ({@code ball}), or onto which one falls every 20 steps ({@code pour}); a wide heap of ten rows, on which a ball rolls
     * ({@code layer}); and a gas that never rests ({@code moving}). {@code level} has static circles and 100 that move; the second world has
     * these alone.
     */
    public static final List<String> CASES = List.of("pile", "ball", "pour", "layer", "level", "moving");

    static final String HEADER = "machine,scene,n,awake,without_us,with_us";

    private static final float FRICTION = 0.6f;
    private static final int SETTLING = 1200;
    private static final int MOVERS = 100;
    private static final int BETWEEN_BALLS = 20;
    private static final int LAYER_ROWS = 10;

    private SleepCosts() {}

    /**
     * Prints what circles cost that sleep or are static.
     *
     * @param arguments as {@link #run}
     */
    public static void main(String[] arguments) {
        InTurn.main(arguments, SleepCosts::run);
    }

    /**
     * Prints what circles cost that sleep or are static.
     *
     * @param arguments a name of {@link Backend}, numbers of circles and scenes; by default JVM, 10000, and all scenes
     * @param out takes the lines of a CSV file
     * @throws IllegalArgumentException where the arguments are others
     */
    public static void run(List<String> arguments, PrintStream out) {
        InTurn.Arguments asked = InTurn.Arguments.read(arguments, 10_000, CASES);
        out.println(HEADER);
        for (String each : asked.cases()) {
            for (int n : asked.sizes()) {
                compare(each, asked.backend(), n, SETTLING, InTurn.WARM_ROUNDS, InTurn.ROUNDS, out);
            }
        }
    }

    static void compare(String scene, Backend backend, int n, int settling, int warm, int rounds, PrintStream out) {
        try (World world = world(scene, backend, n, true);
                World other = world(scene, backend, n, false)) {
            int steps = scene.equals("level") || scene.equals("moving") ? settling / 10 : settling;
            InTurn.settle(world, steps);
            InTurn.settle(other, steps);
            Game game = game(scene, world, n);
            InTurn times = InTurn.measure(world, game, other, game(scene, other, n), warm, rounds);
            out.printf(
                    Locale.ROOT,
                    "\"%s\",%s,%d,%.0f,%.1f,%.1f%n",
                    world.stats().device(),
                    scene,
                    n,
                    game.meanAwake(),
                    1000 * times.otherMedian(),
                    1000 * times.median());
            out.flush();
        }
    }

    private static Game game(String scene, World world, int n) {
        switch (scene) {
            case "ball":
                return new Game(world, width(n), heapTop(n), 300, false);
            case "pour":
                return new Game(world, width(n), heapTop(n), BETWEEN_BALLS, true);
            case "layer":
                return new Game(world, world.maxX(), LAYER_ROWS + 1, 300, false);
            default:
                return new Game(world, 0, 0, Integer.MAX_VALUE, false);
        }
    }

    /** A world of a scene, at its start; first: which of the two. */
    static World world(String scene, Backend backend, int n, boolean first) {
        World.Builder builder = World.builder().backend(backend);
        if (backend == Backend.JVM) {
            builder.threads(2);
        }
        switch (scene) {
            case "level":
                return level(builder, n, first);
            case "moving":
                return gas(builder.sleep(first), n);
            case "layer":
                return layer(builder.sleep(first), n);
            default:
                return pile(builder.sleep(first), n);
        }
    }

    /** Rows of circles that fall on each other from where they almost touch, in a box of so many to a row that there are half as many rows. */
    private static World pile(World.Builder builder, int n) {
        int columns = columns(n);
        World world = rough(builder.bounds(0, 0, width(n), width(n)));
        Random random = new Random(Scenes.SEED);
        for (int k = 0; k < n; k++) {
            float x = 1.05f * (k % columns + 0.5f) + 0.1f * (random.nextFloat() - 0.5f);
            float radius = 0.4f + 0.1f * random.nextFloat();
            world.add(x, 0.5f + k / columns, radius, radius * radius);
        }
        return world;
    }

    private static World rough(World.Builder builder) {
        return builder.gravity(0, -10)
                .friction(FRICTION)
                .rollingResistance(0.02f)
                .build();
    }

    private static int columns(int n) {
        return (int) Math.ceil(Math.sqrt(2.0 * n));
    }

    private static float width(int n) {
        return 1.05f * columns(n);
    }

    /** Above the heap, which is about 0.43 as high as wide. */
    private static float heapTop(int n) {
        return 0.43f * width(n) + 2;
    }

    /** Ten rows, each in the gaps of the one below, as wide as n circles need. */
    private static World layer(World.Builder builder, int n) {
        int columns = Math.max(2, n / LAYER_ROWS);
        World world =
                rough(builder.bounds(0, 0, columns + 0.02f, 4 * LAYER_ROWS).capacity(n + 1));
        Random random = new Random(Scenes.SEED);
        for (int k = 0; k < LAYER_ROWS * columns; k++) {
            int row = k / columns;
            float x = 0.51f + k % columns + (row % 2 == 0 ? 0 : 0.5f);
            if (x < columns) {
                float radius = 0.5f - 0.002f * random.nextFloat();
                world.add(x, 0.5f + 0.8665f * row, radius, radius * radius);
            }
        }
        return world;
    }

    /** Balls without gravity fly among posts, which the second world lacks. */
    private static World level(World.Builder builder, int n, boolean first) {
        int side = (int) Math.ceil(Math.sqrt(n));
        World world = builder.bounds(0, 0, 2 * side, 2 * side).restitution(1).build();
        for (int k = 0; k < n && first; k++) {
            world.add(2 * (k % side) + 1, 2 * (k / side) + 1, 0.3f, Float.POSITIVE_INFINITY);
        }
        Random random = new Random(Scenes.SEED);
        for (int k = 0; k < MOVERS; k++) {
            world.add(
                    2 * random.nextInt(side - 1) + 2,
                    2 * random.nextInt(side - 1) + 2,
                    0.3f,
                    1,
                    10 * random.nextFloat() - 5,
                    10 * random.nextFloat() - 5);
        }
        return world;
    }

    private static World gas(World.Builder builder, int n) {
        Scene scene = Scenes.gas(n, Scenes.SEED);
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        World world = builder.build();
        SceneLoader.circles(scene, world::add, world::setRestitution);
        return world;
    }

    /** What a game does before each step: now and then a ball rolls or falls. */
    private static final class Game implements Runnable {
        private final World world;
        private final float width;
        private final float top;
        private final int period;
        private final boolean pours;
        private final Random random = new Random(Scenes.SEED);
        private long ball = -1;
        private int steps;
        private double awake;

        /** width: of the heap; top: where a ball begins. */
        Game(World world, float width, float top, int period, boolean pours) {
            this.world = world;
            this.width = width;
            this.top = top;
            this.period = period;
            this.pours = pours;
        }

        @Override
        public void run() {
            if (steps % 60 == 0) {
                awake += world.stats().awake();
            }
            if (period < Integer.MAX_VALUE && steps % period == 0) {
                start();
            }
            steps++;
        }

        private void start() {
            if (pours) {
                world.add(width * (0.45f + 0.1f * random.nextFloat()), top, 0.45f, 0.2f);
            } else if (ball < 0) {
                ball = world.add(2, top, 0.5f, 0.25f, 5, 0);
            } else {
                world.setPosition(ball, 2, top);
                world.setVelocity(ball, 5, 0);
            }
        }

        /** How many were awake at the start of a round. */
        double meanAwake() {
            return awake / Math.ceil(steps / 60.0);
        }
    }
}
