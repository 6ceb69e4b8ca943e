package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.io.PrintStream;
import java.util.Map;
import org.knowm.xchart.XYChart;

/** Draws a step on one thread by n: World on the JVM and in WebAssembly, and engines for JavaScript. */
public final class WebCharts {
    /** File name, without ending, of the chart. */
    static final String FILE = "web";

    private WebCharts() {}

    /** Draws what there are figures for; says so if this JVM cannot draw. */
    public static void draw(ResultsFolder folder, PrintStream out) throws IOException {
        Charts.tryTo(() -> draw(folder), folder.path(), out);
    }

    static void draw(ResultsFolder folder) throws IOException {
        Charts.save(chart(folder), folder.path(), FILE);
    }

    static XYChart chart(ResultsFolder folder) {
        XYChart chart = Charts.chart("A step of the series packed-similar on one thread", "circles", "µs a step");
        Table web = folder.table(Kind.WEB);
        int index = 0;
        for (Map<String, String> who : WebTables.entrants(folder)) {
            String engine = who.get("engine");
            boolean world = engine.equals(WebTables.WORLD);
            index += Charts.line(
                    chart,
                    (world ? "World" : engine) + ", " + who.get("runs_in"),
                    Charts.points(
                            web.rows("engine", engine, "runs_in", who.get("runs_in"), "status", "ok"), "median_us"),
                    index,
                    !world);
        }
        return chart;
    }
}
