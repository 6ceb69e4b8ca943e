package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.Chain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.Scanner;

/**
 * Levels for World and for engines outside Maven. A file of a level is a list of words:
 *
 * <pre>
 * bounds WIDTH HEIGHT            walls; the lower left corner is (0, 0)
 * body X Y OMEGA                 what follows belongs to it and turns around (X, Y), where its coordinates are (0, 0)
 * chain CLOSED POINTS X Y ...    circles are on its right, as in Box2D: ground runs from right to left
 * segment X1 Y1 X2 Y2
 * circle X Y RADIUS              of mass 1
 * </pre>
 */
public final class TerrainLevels {
    /** The levels; {@code pile} has no terrain. */
    public static final List<String> LEVELS = List.of("ground", "funnel", "drum", "pile");

    static final float FRICTION = 0.6f;
    private static final float TIME_STEP = 1 / 60f;
    private static final float RADIUS = 0.5f;
    private static final int SUB_STEPS = 4;
    private static final int DRUM = 128;
    private static final int PADDLES = 12;

    private TerrainLevels() {}

    /**
     * Writes levels, or makes the steps of one.
     *
     * @param arguments {@code write FOLDER N...}, or {@code run FILE BACKEND THREADS SETTLING STEPS}
     */
    public static void main(String[] arguments) throws IOException {
        try {
            run(List.of(arguments), System.out);
        } catch (IllegalArgumentException e) {
            System.err.println(e.getMessage());
            System.exit(2);
        }
    }

    /**
     * Writes levels, or makes the steps of one and prints the median and the least ms a step.
     *
     * @param arguments as of {@link #main}
     * @param out takes the figures
     * @throws IllegalArgumentException where the arguments are others
     */
    public static void run(List<String> arguments, PrintStream out) throws IOException {
        if (arguments.size() > 2 && arguments.get(0).equals("write")) {
            Path folder = Files.createDirectories(Path.of(arguments.get(1)));
            for (String n : arguments.subList(2, arguments.size())) {
                for (String level : LEVELS) {
                    Files.writeString(folder.resolve(level + "-" + n + ".level"), level(level, Integer.parseInt(n)));
                }
            }
        } else if (arguments.size() == 6 && arguments.get(0).equals("run")) {
            int threads = Integer.parseInt(arguments.get(3));
            World.Builder builder = World.builder().backend(Backend.valueOf(arguments.get(2)));
            int settling = Integer.parseInt(arguments.get(4));
            int steps = Integer.parseInt(arguments.get(5));
            String text = Files.readString(Path.of(arguments.get(1)));
            // the first run is for the JVM's compiler
            time(text, builder, threads, settling, steps);
            double[] ms = time(text, builder, threads, settling, steps);
            out.printf(Locale.ROOT, "%.4f,%.4f%n", ms[steps / 2], ms[0]);
        } else {
            throw new IllegalArgumentException(
                    "arguments are: write FOLDER N..., or: run FILE BACKEND THREADS SETTLING STEPS; not " + arguments);
        }
    }

    private static double[] time(String level, World.Builder builder, int threads, int settling, int steps) {
        try (World world = load(level, builder, threads)) {
            world.step(TIME_STEP, settling);
            world.finish();
            double[] ms = new double[steps];
            for (int k = 0; k < steps; k++) {
                long from = System.nanoTime();
                world.step(TIME_STEP);
                world.finish();
                ms[k] = (System.nanoTime() - from) / 1e6;
            }
            Arrays.sort(ms);
            return ms;
        }
    }

    /** Makes the world of a level; a number of threads is for the JVM, 0 for another back end. */
    static World load(String level, World.Builder builder, int threads) {
        Scanner words = new Scanner(level).useLocale(Locale.ROOT);
        words.next();
        builder.bounds(0, 0, words.nextFloat(), words.nextFloat()).gravity(0, -10);
        builder.friction(FRICTION).restitution(0).subSteps(SUB_STEPS);
        World world = (threads > 0 ? builder.threads(threads) : builder).build();
        TerrainBody body = world.terrain().ground();
        while (words.hasNext()) {
            switch (words.next()) {
                case "body":
                    body = world.terrain().addBody(words.nextFloat(), words.nextFloat(), 0);
                    body.setAngularVelocity(words.nextFloat());
                    break;
                case "chain":
                    boolean closed = words.nextInt() == 1;
                    float[] points = new float[2 * words.nextInt()];
                    for (int i = 0; i < points.length; i++) {
                        points[i] = words.nextFloat();
                    }
                    Chain chain = Chain.of(points);
                    body.addChain(closed ? chain.close() : chain);
                    break;
                case "segment":
                    body.addSegment(words.nextFloat(), words.nextFloat(), words.nextFloat(), words.nextFloat());
                    break;
                default:
                    world.add(words.nextFloat(), words.nextFloat(), words.nextFloat(), 1);
            }
        }
        return world;
    }

    static String level(String name, int n) {
        StringBuilder text = new StringBuilder();
        Random random = new Random(7);
        switch (name) {
            case "ground": // hills, over which circles lie some layers deep
                float width = (float) Math.ceil(n / 8.0);
                line(text, "bounds", width, 60);
                chain(text, false, hills(width, random));
                heap(text, n, 1, width - 1, 16, random);
                break;
            case "funnel": // two slopes, between which few circles fall through
                float half = (float) Math.ceil(1.1 * Math.sqrt(n));
                float height = 1.2f * half;
                line(text, "bounds", 2 * half, 4 * half + height);
                chain(text, false, slope(2 * half, height, half + 1.5f, 10));
                chain(text, false, slope(half - 1.5f, 10, 0, height));
                heap(text, n, 1, 2 * half - 1, height + 2, random);
                break;
            case "drum": // turns, with paddles, a third full
                float radius = (float) Math.sqrt(0.9 * n);
                line(text, "bounds", 2 * radius + 4, 2 * radius + 4);
                line(text, "body", radius + 2, radius + 2, 0.3f);
                float[] points = new float[2 * DRUM];
                for (int i = 0; i < DRUM; i++) {
                    points[2 * i] = (float) (radius * Math.cos(-2 * Math.PI * i / DRUM));
                    points[2 * i + 1] = (float) (radius * Math.sin(-2 * Math.PI * i / DRUM));
                }
                chain(text, true, points);
                for (int i = 0; i < PADDLES; i++) {
                    float x = (float) Math.cos(2 * Math.PI * (i + 0.5) / PADDLES);
                    float y = (float) Math.sin(2 * Math.PI * (i + 0.5) / PADDLES);
                    line(text, "segment", 0.97f * radius * x, 0.97f * radius * y, 0.8f * radius * x, 0.8f * radius * y);
                }
                float side = 0.55f * radius; // all within the paddles
                heap(text, n, radius + 2 - side, radius + 2 + side, radius + 2 - side, random);
                break;
            case "pile": // in a box, half as high as wide
                int columns = (int) Math.ceil(Math.sqrt(2.0 * n));
                line(text, "bounds", 1.05f * columns, 1.05f * columns);
                for (int i = 0; i < n; i++) {
                    float x = 1.05f * (i % columns + 0.5f) + 0.1f * (random.nextFloat() - 0.5f);
                    line(text, "circle", x, 0.5f + i / columns, 0.4f + 0.1f * random.nextFloat());
                }
                break;
            default:
                throw new IllegalArgumentException("there is no level '" + name + "'; there are " + LEVELS);
        }
        return text.toString();
    }

    /** From the right to the left. */
    private static float[] hills(float width, Random random) {
        int steps = (int) (width / 2);
        float[] points = new float[2 * steps + 2];
        for (int i = 0; i <= steps; i++) {
            points[2 * i] = width - i * width / steps;
            points[2 * i + 1] = 8 + 4 * (float) Math.sin(0.15 * i) + 0.5f * random.nextFloat();
        }
        return points;
    }

    private static float[] slope(float x1, float y1, float x2, float y2) {
        int steps = 50;
        float[] points = new float[2 * steps + 2];
        for (int i = 0; i <= steps; i++) {
            points[2 * i] = x1 + (x2 - x1) * i / steps;
            points[2 * i + 1] = y1 + (y2 - y1) * i / steps;
        }
        return points;
    }

    /** Circles in rows from a height on. */
    private static void heap(StringBuilder text, int n, float from, float to, float y, Random random) {
        int columns = Math.max(1, (int) ((to - from) / 1.02f));
        for (int i = 0; i < n; i++) {
            float shift = 0.01f * random.nextFloat();
            line(text, "circle", from + 0.51f + i % columns * 1.02f + shift, y + i / columns * 1.01f, RADIUS);
        }
    }

    private static void chain(StringBuilder text, boolean closed, float[] points) {
        text.append("chain ").append(closed ? 1 : 0).append(' ').append(points.length / 2);
        line(text, "", points);
    }

    private static void line(StringBuilder text, String word, float... numbers) {
        text.append(word);
        for (float number : numbers) {
            text.append(' ').append(number);
        }
        text.append('\n');
    }
}
