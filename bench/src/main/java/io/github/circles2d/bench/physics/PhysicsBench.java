package io.github.circles2d.bench.physics;

import io.github.circles2d.Backend;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;

/** Runs the rows of the table and prints each figure as soon as it is known. */
public final class PhysicsBench {
    private PhysicsBench() {}

    /**
     * Runs rows.
     *
     * @param arguments see {@code --help}
     */
    public static void main(String[] arguments) {
        run(List.of(arguments), System.out);
    }

    private static void run(List<String> arguments, PrintStream out) {
        Effort effort = Effort.FULL;
        Physics physics = new WorldPhysics(Backend.JVM, 1);
        if (arguments.contains("--quick")) {
            effort = Effort.QUICK;
        }
        for (Row row : Rows.ALL) {
            boolean named = arguments.contains(Integer.toString(row.number()));
            if (named || arguments.stream().noneMatch(argument -> argument.matches("[0-9]+"))) {
                run(row, physics, effort, out);
            }
        }
    }

    private static void run(Row row, Physics physics, Effort effort, PrintStream out) {
        out.printf("%n%d %s%n", row.number(), row.scene());
        for (Case scene : row.cases()) {
            long start = System.nanoTime();
            for (Figure figure : Figure.of(row, scene, physics, effort)) {
                out.printf(
                        Locale.ROOT,
                        "   %-60s %-55s %10.4g  %-14s %s%n",
                        scene.name(),
                        figure.measure().what(),
                        figure.median(),
                        figure.measure().bound(),
                        figure.measure().bound().isNone() ? "" : figure.met() ? "met" : "NOT MET");
            }
            out.printf(Locale.ROOT, "   %.1f s%n", (System.nanoTime() - start) / 1e9);
        }
    }
}
