package io.github.circles2d;

import io.github.circles2d.BusyMachine.Beside;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Arrays;

/** Prints what becomes of steps beside busy threads. Argument: {@code bits} or {@code times}. */
final class BusySteps {
    private static final int ROUNDS = 9;

    private BusySteps() {}

    public static void main(String[] arguments) {
        System.out.println(arguments[0].equals("bits") ? "same bits: " + haveTheSameBits() : "factor " + factor());
    }

    private static boolean haveTheSameBits() {
        Scene scene = Scenes.packed(1250, 1);
        BusyMachine.Others others = new BusyMachine.Others(Beside.BUSY);
        try (World expected = BusyMachine.world(scene, BusyMachine.DEFAULT);
                World world = BusyMachine.world(scene, BusyMachine.DEFAULT)) {
            expected.step(scene.timeStep(), 40);
            for (int step = 0; step < 20; step++) {
                world.step(scene.timeStep());
                world.positions();
            }
            world.step(scene.timeStep(), 20);
            return world.hash() == expected.hash();
        } finally {
            others.stop();
        }
    }

    /** The greatest factor between steps with the default number of threads and with one, both beside the same threads. */
    private static double factor() {
        double greatest = 0;
        for (int circles : new int[] {1250, 2800, 10_000}) {
            Scene scene = Scenes.packed(circles, 1);
            try (World one = BusyMachine.world(scene, 1);
                    World all = BusyMachine.world(scene, BusyMachine.DEFAULT)) {
                BusyMachine.round(one, scene.timeStep(), Beside.NOTHING);
                BusyMachine.round(all, scene.timeStep(), Beside.NOTHING);
                for (Beside beside : new Beside[] {Beside.BUSY, Beside.TWICE_AS_BUSY}) {
                    greatest = Math.max(greatest, factor(one, all, scene.timeStep(), beside));
                }
            }
        }
        return greatest;
    }

    /** The one in the middle of several rounds. */
    private static double factor(World one, World all, float timeStep, Beside beside) {
        double[] factors = new double[ROUNDS];
        for (int round = 0; round < ROUNDS; round++) {
            double ofOne = BusyMachine.round(one, timeStep, beside).median();
            factors[round] = BusyMachine.round(all, timeStep, beside).median() / ofOne;
        }
        Arrays.sort(factors);
        return factors[ROUNDS / 2];
    }
}
