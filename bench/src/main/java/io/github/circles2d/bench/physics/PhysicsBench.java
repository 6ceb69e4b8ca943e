package io.github.circles2d.bench.physics;

import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Runs the rows of the table, prints each figure as soon as it is known, and keeps it. */
public final class PhysicsBench {
    private PhysicsBench() {}

    /**
     * Runs {@link #run} alone, so that this package can be tried without the other benchmarks. Unless told otherwise it
     * keeps its files in the system's temporary folder.
     *
     * @param arguments see {@code --help}
     */
    public static void main(String[] arguments) throws IOException {
        System.setProperty("java.awt.headless", "true");
        try {
            List<String> all = new ArrayList<>(List.of(arguments));
            if (!all.contains("--out")) {
                all.addAll(List.of(
                        "--out",
                        Path.of(System.getProperty("java.io.tmpdir"), "circles2d-physics")
                                .toString()));
            }
            run(all, System.out);
        } catch (IllegalArgumentException e) {
            System.err.println(e.getMessage());
            System.exit(2);
        }
    }

    /**
     * Runs what the arguments ask for.
     *
     * @throws IllegalArgumentException with a sentence for the user if they are wrong
     */
    public static void run(List<String> arguments, PrintStream out) throws IOException {
        PhysicsOptions options = PhysicsOptions.parse(arguments);
        if (options.help()) {
            out.println(PhysicsOptions.HELP);
        } else if (options.page() != null) {
            Curves.draw(options.out(), out);
            Files.writeString(options.page(), PhysicsPage.of(options.out()));
            out.println("wrote " + options.page());
        } else {
            measure(options, out);
        }
    }

    private static void measure(PhysicsOptions options, PrintStream out) throws IOException {
        PhysicsTable table = PhysicsTable.open(options.out());
        Table baseline = new Table(Baseline.KEYS, Baseline.COLUMNS);
        out.print(PhysicsTable.header());
        for (Row row : Rows.ALL) {
            if (options.asksFor(row)) {
                for (Case scene : row.cases()) {
                    List<Figure> world = Figure.of(row, scene, options.world(), options.effort());
                    List<Figure> box2d = row.box2d() && options.box2d() ? box2d(row, scene, options) : List.of();
                    for (int i = 0; i < world.size(); i++) {
                        Figure beside = box2d.isEmpty() ? null : box2d.get(i);
                        out.print(PhysicsTable.line(table.put(world.get(i), beside)));
                        if (row.number() == Baseline.ROW) {
                            baseline.put(Baseline.row(world.get(i)));
                        }
                    }
                }
            }
        }
        if (options.baseline() != null) {
            baseline.save(options.baseline());
        }
        if (options.curves()) {
            Curves.record(options, out);
        }
    }

    /** Box2D's figures; none if the scene says nothing about it, or it does not run on this machine. */
    private static List<Figure> box2d(Row row, Case scene, PhysicsOptions options) {
        try {
            return Figure.of(row, scene, new Box2dPhysics(), options.effort());
        } catch (UnsupportedOperationException | LinkageError e) {
            return List.of();
        }
    }
}
