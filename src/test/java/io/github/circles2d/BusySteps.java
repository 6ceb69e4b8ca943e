package io.github.circles2d;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Arrays;

/** Prints what becomes of steps beside as many busy threads as processors. Argument: {@code bits} or {@code times}. */
final class BusySteps {
    private static final int ROUNDS = 5;
    private static final int PROCESSORS = Runtime.getRuntime().availableProcessors();
    private static final Scene SCENE = Scenes.packed(1250, 1);

    private BusySteps() {}

    public static void main(String[] arguments) {
        System.out.println(arguments[0].equals("bits") ? "same bits: " + haveTheSameBits() : "factor " + factor());
    }

    private static World world() {
        return WorldScenes.world(SCENE, WorldScenes.builder(SCENE).backend(Backend.JVM));
    }

    private static boolean haveTheSameBits() {
        BusyMachine.Others others = new BusyMachine.Others(PROCESSORS);
        try (World expected = world();
                World world = world()) {
            expected.step(SCENE.timeStep(), 40);
            for (int step = 0; step < 20; step++) {
                world.step(SCENE.timeStep());
                world.positions();
            }
            world.step(SCENE.timeStep(), 20);
            return world.hash() == expected.hash();
        } finally {
            others.stop();
        }
    }

    /** Times of steps over those on an idle machine, in the middle one of several rounds. */
    private static double factor() {
        double[] factors = new double[ROUNDS];
        try (World world = world()) {
            BusyMachine.round(world, SCENE.timeStep(), 0);
            for (int round = 0; round < ROUNDS; round++) {
                double idle = BusyMachine.round(world, SCENE.timeStep(), 0).mean();
                factors[round] =
                        BusyMachine.round(world, SCENE.timeStep(), PROCESSORS).mean() / idle;
            }
        }
        Arrays.sort(factors);
        return factors[ROUNDS / 2];
    }
}
