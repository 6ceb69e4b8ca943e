package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.measure.Contender;
import io.github.circles2d.bench.measure.Series;
import io.github.circles2d.bench.results.ResultsFolder;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
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
        return Charts.compare(
                Charts.chart("A step of the series " + series.title, "circles", "ms a step"),
                folders,
                folder -> lines(folder, series, true),
                folder -> lines(folder, series, false));
    }

    /** By engine: of World with all that a machine has, or of the others and World on one thread. */
    private static Map<String, Map<Integer, Double>> lines(ResultsFolder folder, Series series, boolean ofWorld) {
        Map<String, Map<Integer, Double>> lines = new LinkedHashMap<>();
        for (Contender who : SeriesTables.contenders(folder)) {
            boolean oneThread = who.threads().equals("1");
            String engine = who.engine().equals(Engines.WORLD_JVM) ? "World, Java" : who.engine();
            String name = engine + ", " + who.threads() + (oneThread ? " thread" : " threads");
            if (ofWorld && who.isWorld() && !oneThread) {
                lines.merge(WorldCharts.label(folder, who.engine()), millis(folder, who, series), Charts::drawn);
            } else if (!ofWorld && (!who.isWorld() || oneThread && who.engine().equals(Engines.WORLD_JVM))) {
                lines.merge(name, millis(folder, who, series), Charts::drawn);
            }
        }
        return lines;
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
