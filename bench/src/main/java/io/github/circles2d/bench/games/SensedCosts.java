package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.Events;
import io.github.circles2d.Response;
import io.github.circles2d.World;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/**
 * What it costs to report sensed pairs: two worlds of the same circles make their steps in turn, of which the first reports begins and ends, and
 * its game reads them after each step. The main method prints a line of a CSV file for each case.
 *
 * <p>This class and {@link InTurn} need the library and no other class.
 */
public final class SensedCosts {
    /**
     * The cases: {@code grains} are sensors beside fewer, far larger circles that they notice; {@code solid} ones push these; {@code sensors} notice
     * each other alone.
     */
    public static final List<String> CASES = List.of("grains", "solid", "sensors");

    static final String HEADER = "machine,case,n,others,silent_ms,reporting_ms,ratio,ratio_of_minima,asked";

    private static final String ASKED = "1.2";
    private static final int GRAIN = 1;
    private static final float RADIUS = 2;
    private static final float SPEED = 60;

    /** Grains to a large circle. */
    private static final int TO_ONE = 34;

    private static final float LEAST = 6;
    private static final float GREATEST = 36;
    private static final int SETTLING = 60;

    private SensedCosts() {}

    /**
     * Prints what sensed pairs cost.
     *
     * @param arguments as {@link #run}
     */
    public static void main(String[] arguments) {
        InTurn.main(arguments, SensedCosts::run);
    }

    /**
     * Prints what sensed pairs cost.
     *
     * @param arguments a name of {@link Backend}, numbers of grains and cases, by default JVM, 2700, and all cases
     * @param out takes the lines of a CSV file
     * @throws IllegalArgumentException where the arguments are others
     */
    public static void run(List<String> arguments, PrintStream out) {
        InTurn.Arguments asked = InTurn.Arguments.read(arguments, 2700, CASES);
        out.println(HEADER);
        for (String each : asked.cases()) {
            for (int n : asked.sizes()) {
                compare(each, asked.backend(), n, InTurn.WARM_ROUNDS, InTurn.ROUNDS, out);
            }
        }
    }

    static void compare(String name, Backend backend, int n, int warm, int rounds, PrintStream out) {
        int others = others(name, n);
        try (World reports = world(name, backend, n);
                World silent = world(name, backend, n)) {
            reports.report(GRAIN, name.equals("sensors") ? GRAIN : 0, Events.BEGIN | Events.END);
            InTurn.settle(reports, SETTLING);
            InTurn.settle(silent, SETTLING);
            InTurn times = InTurn.measure(reports, reports::events, silent, () -> {}, warm, rounds);
            out.printf(
                    Locale.ROOT,
                    "\"%s\",%s,%d,%d,%.4f,%.4f,%.3f,%.3f,%s%n",
                    silent.stats().device(),
                    name,
                    n,
                    others,
                    times.otherMedian(),
                    times.median(),
                    times.ratio(),
                    times.ratioOfMinima(),
                    ASKED);
            out.flush();
        }
    }

    private static int others(String name, int n) {
        return name.equals("sensors") ? 0 : Math.max(1, n / TO_ONE);
    }

    /** A gas, in which nothing slows down. */
    static World world(String name, Backend backend, int n) {
        int others = others(name, n);
        float side = (float) Math.sqrt(40 * Math.PI * RADIUS * RADIUS * n);
        World.Builder builder = World.builder().backend(backend).bounds(0, 0, side, side);
        builder.gravity(0, 0).restitution(1);
        World world = (backend == Backend.JVM ? builder.threads(2) : builder).build();
        world.kind(GRAIN).setSensor(!name.equals("solid"));
        if (name.equals("sensors")) {
            world.setResponse(GRAIN, GRAIN, Response.SENSE);
        }
        Random random = new Random(7);
        for (int k = 0; k < others; k++) {
            float r = LEAST + (GREATEST - LEAST) * random.nextFloat();
            add(world, random, side, r, 0);
        }
        for (int k = 0; k < n; k++) {
            add(world, random, side, RADIUS, GRAIN);
        }
        return world;
    }

    private static void add(World world, Random random, float side, float r, int kind) {
        float x = r + (side - 2 * r) * random.nextFloat();
        float y = r + (side - 2 * r) * random.nextFloat();
        float vx = SPEED * (2 * random.nextFloat() - 1);
        float vy = SPEED * (2 * random.nextFloat() - 1);
        world.add(x, y, r, r * r, vx, vy, kind);
    }
}
