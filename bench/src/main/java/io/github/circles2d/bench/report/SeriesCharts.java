package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.measure.Contender;
import io.github.circles2d.bench.measure.Series;
import io.github.circles2d.bench.results.ResultsFolder;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.knowm.xchart.XYChart;

/** A chart for each series: World on all machines, other engines on the first that has figures of them. */
final class SeriesCharts {
    private SeriesCharts() {}

    /** File name, without ending, of the chart of a series. */
    static String file(Series series) {
        return "series-" + series.title;
    }

    /** Draws the series that have several sizes and at least one figure of World: without it there is no comparison. */
    static void draw(Path results, List<ResultsFolder> folders) throws IOException {
        for (Series series : Series.values()) {
            XYChart chart = steps(folders, series);
            boolean world = chart.getSeriesMap().keySet().stream().anyMatch(name -> name.startsWith("World"));
            if (world && series.sizes().size() > 1) {
                Charts.save(chart, results, file(series));
            }
        }
    }

    static XYChart steps(List<ResultsFolder> folders, Series series) {
        XYChart chart = Charts.chart("A step of the series " + series.title, "circles", "ms a step");
        int index = 0;
        for (ResultsFolder folder : folders) {
            for (Contender who : SeriesTables.contenders(folder)) {
                if (isHeadlined(who)) {
                    String name = WorldCharts.label(folder, who.engine());
                    index += Charts.line(chart, name, millis(folder, who, series), index, false);
                }
            }
        }
        for (ResultsFolder folder : folders) {
            int before = index;
            for (Contender who : SeriesTables.contenders(folder)) {
                boolean oneCore = who.equals(new Contender(Engines.WORLD_JVM, "1"));
                if (!who.isWorld() || oneCore) {
                    String threads = who.threads() + (who.threads().equals("1") ? " thread" : " threads");
                    String name = (oneCore ? "World, Java" : who.engine()) + ", " + threads;
                    index += Charts.line(chart, name, millis(folder, who, series), index, true);
                }
            }
            if (index > before) {
                break;
            }
        }
        return chart;
    }

    /** Whether it is World with all that a machine has. */
    private static boolean isHeadlined(Contender who) {
        return who.isWorld() && !who.threads().equals("1");
    }

    private static Map<Integer, Double> millis(ResultsFolder folder, Contender who, Series series) {
        return Charts.points(
                series.sizes().stream()
                        .map(n -> SeriesTables.run(folder, who, series, n))
                        .filter(Tables::ok)
                        .toList(),
                "median_ms");
    }
}
