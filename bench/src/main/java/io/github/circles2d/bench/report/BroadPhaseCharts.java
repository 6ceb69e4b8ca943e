package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import java.util.Map;
import org.knowm.xchart.XYChart;

/** Draws what a circle costs each broad phase in a step, by the number of circles: one chart per scene. */
public final class BroadPhaseCharts {
    /** The scenes that are drawn. */
    public static final List<String> SCENES = List.of("packed", "pile", "mixed-100");

    private BroadPhaseCharts() {}

    /** File name, without ending, of the chart of a scene. */
    public static String file(String scene) {
        return "broadphase-" + scene;
    }

    /** Draws what there are figures for; says so if this JVM cannot draw. */
    public static void draw(ResultsFolder folder, PrintStream out) throws IOException {
        Charts.tryTo(
                () -> {
                    for (String scene : SCENES) {
                        Charts.save(chart(folder, scene), folder.path(), file(scene));
                    }
                },
                folder.path(),
                out);
    }

    private static XYChart chart(ResultsFolder folder, String scene) {
        XYChart chart = Charts.chart("Broad phases on the scene " + scene, "circles", "ns per circle and step");
        Table table = folder.table(Kind.BROADPHASE);
        // A time on the wall of a device is no processor time of a thread.
        List<String> names = table.values("broad_phase", "scene", scene).stream()
                .filter(name -> !name.contains("@"))
                .toList();
        for (String name : names) {
            Map<Integer, Double> nanos = Charts.points(table.rows("scene", scene, "broad_phase", name), "median_ms");
            nanos.replaceAll((n, millis) -> 1e6 * millis / n);
            Charts.line(chart, name, nanos, names.indexOf(name), name.startsWith("world"));
        }
        return chart;
    }
}
