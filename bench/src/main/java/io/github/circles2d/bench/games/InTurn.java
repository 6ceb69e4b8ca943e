package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.DoubleSupplier;

/** Two worlds that make their steps in turn, so that other work on the machine slows both. Times are in ms a step, the shortest first. */
record InTurn(double[] ms, double[] otherMs) {
    static final float TIME_STEP = 1 / 60f;

    /** Rounds that do not count, in which the JVM compiles. */
    static final int WARM_ROUNDS = 5;

    static final int ROUNDS = 21;

    /** Steps of a call: nothing changes between steps. */
    private static final int CALL = 10;

    private static final int STEPS = 60;

    /** What a command line asks for. */
    record Arguments(Backend backend, List<Integer> sizes, List<String> cases) {
        static Arguments read(List<String> words, int usualSize, List<String> all) {
            Backend backend = Backend.JVM;
            List<Integer> sizes = new ArrayList<>();
            List<String> cases = new ArrayList<>();
            for (String word : words) {
                if (all.contains(word)) {
                    cases.add(word);
                } else if (word.matches("[1-9]\\d{2,6}")) {
                    sizes.add(Integer.parseInt(word));
                } else if (Arrays.stream(Backend.values())
                        .anyMatch(b -> b.name().equals(word))) {
                    backend = Backend.valueOf(word);
                } else {
                    throw new IllegalArgumentException("an argument is one of " + Arrays.toString(Backend.values())
                            + ", a number of circles from 100 to 9999999, or one of " + all + ", not '" + word + "'");
                }
            }
            return new Arguments(backend, sizes.isEmpty() ? List.of(usualSize) : sizes, cases.isEmpty() ? all : cases);
        }
    }

    /** What a main method does: arguments that are refused end the program with 2, and a line that says why. */
    static void main(String[] arguments, BiConsumer<List<String>, PrintStream> run) {
        try {
            run.accept(List.of(arguments), System.out);
        } catch (IllegalArgumentException e) {
            System.err.println(e.getMessage());
            System.exit(2);
        }
    }

    /** Makes so many steps first, and then rounds. */
    static InTurn measure(World world, World other, int settling, int warm, int rounds) {
        settle(world, settling);
        settle(other, settling);
        return measure(() -> time(world), () -> time(other), warm, rounds);
    }

    /** Makes rounds of 60 steps, a call a step, as a game does; before each step of a world its game does something. */
    static InTurn measure(World world, Runnable game, World other, Runnable otherGame, int warm, int rounds) {
        return measure(() -> time(world, game), () -> time(other, otherGame), warm, rounds);
    }

    private static InTurn measure(DoubleSupplier time, DoubleSupplier otherTime, int warm, int rounds) {
        double[] ms = new double[rounds];
        double[] otherMs = new double[rounds];
        for (int round = -warm; round < rounds; round++) {
            double a = time.getAsDouble();
            double b = otherTime.getAsDouble();
            if (round >= 0) {
                ms[round] = a;
                otherMs[round] = b;
            }
        }
        Arrays.sort(ms);
        Arrays.sort(otherMs);
        return new InTurn(ms, otherMs);
    }

    static void settle(World world, int steps) {
        world.step(TIME_STEP, steps);
        world.finish();
    }

    private static double time(World world) {
        long from = System.nanoTime();
        for (int k = 0; k < STEPS; k += CALL) {
            world.step(TIME_STEP, CALL);
        }
        world.finish();
        return (System.nanoTime() - from) / 1e6 / STEPS;
    }

    private static double time(World world, Runnable game) {
        long from = System.nanoTime();
        for (int k = 0; k < STEPS; k++) {
            game.run();
            world.step(TIME_STEP);
        }
        world.finish();
        return (System.nanoTime() - from) / 1e6 / STEPS;
    }

    double median() {
        return ms[ms.length / 2];
    }

    double otherMedian() {
        return otherMs[otherMs.length / 2];
    }

    double ratio() {
        return median() / otherMedian();
    }

    double ratioOfMinima() {
        return ms[0] / otherMs[0];
    }
}
