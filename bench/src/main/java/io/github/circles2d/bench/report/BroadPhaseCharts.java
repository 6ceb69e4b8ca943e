package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
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
        List<Map<String, String>> rows = folder.table(Kind.BROADPHASE).rows("scene", scene);
        // A time on the wall of a device is no processor time of a thread.
        List<String> names = rows.stream()
                .map(row -> row.get("broad_phase"))
                .filter(name -> !name.contains("@"))
                .distinct()
                .toList();
        for (String name : names) {
            List<Integer> sizes = new ArrayList<>();
            List<Double> nanos = new ArrayList<>();
            for (Map<String, String> row : rows) {
                if (row.get("broad_phase").equals(name)) {
                    int n = Integer.parseInt(row.get("n"));
                    sizes.add(n);
                    nanos.add(1e6 * Numbers.parse(row.get("median_ms")) / n);
                }
            }
            Charts.line(chart, name, sizes, nanos, names.indexOf(name), name.startsWith("world"));
        }
        return chart;
    }
}
