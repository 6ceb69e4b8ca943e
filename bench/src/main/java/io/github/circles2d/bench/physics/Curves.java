package io.github.circles2d.bench.physics;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** Energy, depth and rest over time of some scenes, on World and on Box2D: kept as CSV, then drawn from it. */
final class Curves {
    static final String FILE = "curves.csv";

    private static final List<String> KEYS = List.of("curve", "engine", "seconds");
    private static final List<String> COLUMNS = List.of("curve", "engine", "seconds", "energy", "deepest", "rms");

    /** Those drawn. */
    static final List<Curve> ALL = List.of(
            new Curve("jam", "Jam without gravity, fill 0.86, e = 0.5", Jams.boiling(), 1, 0, 20),
            new Curve(
                    "time-step",
                    "Pile of 1,250 at rest, steps of 1/240 s from 50 s on",
                    TimeSteps.changed(),
                    0,
                    49.5,
                    52.5),
            new Curve(
                    "growth",
                    "Pile of 1,250 at rest, every tenth radius 0.8 from 50 s on",
                    Growth.sudden(),
                    0,
                    49.5,
                    60),
            new Curve("elastic", "100 elastic balls under gravity", ElasticBalls.keepMoving(), 0, 0, 50),
            new Curve("poured", "Poured pile of 1,250", Resting.soon(), 0, 0, 25));

    private Curves() {}

    /**
     * A scene and the time that is drawn.
     *
     * @param name of its chart's file
     */
    record Curve(String name, String title, Row row, int scene, double from, double to) {
        private Recorder run(Physics physics) {
            Recorder recorder = new Recorder(physics, from, to);
            row.cases().get(scene).run().figures(recorder, 1, Effort.FULL);
            return recorder;
        }
    }

    static void record(PhysicsOptions options, PrintStream out) throws IOException {
        Table table = new Table(KEYS, COLUMNS);
        for (Curve curve : ALL) {
            add(curve, options.world(), table);
            if (options.box2d()) {
                add(curve, new Box2dPhysics(), table);
            }
            out.println("curve " + curve.name());
        }
        Files.createDirectories(options.out());
        table.save(options.out().resolve(FILE));
        draw(options.out(), out);
    }

    private static void add(Curve curve, Physics physics, Table table) {
        for (Recorder.Sample sample : curve.run(physics).samples()) {
            table.put(Map.of(
                    "curve", curve.name(),
                    "engine", physics.name(),
                    "seconds", Numbers.exact(sample.seconds()),
                    "energy", Numbers.exact(sample.energy()),
                    "deepest", Numbers.exact(sample.deepest()),
                    "rms", Numbers.exact(sample.rms())));
        }
    }

    /** Draws what the folder's file has, if there is one; says so if this JVM cannot draw (a machine without fonts). */
    static void draw(Path folder, PrintStream out) throws IOException {
        if (!Files.exists(folder.resolve(FILE))) {
            return;
        }
        Table table = Table.parse(Files.readString(folder.resolve(FILE), StandardCharsets.UTF_8), KEYS);
        try {
            for (Curve curve : ALL) {
                CurveCharts.draw(curve, table, folder);
            }
        } catch (LinkageError | InternalError | RuntimeException e) {
            out.println("no charts: this JVM cannot draw here (" + e + ")");
        }
    }
}
