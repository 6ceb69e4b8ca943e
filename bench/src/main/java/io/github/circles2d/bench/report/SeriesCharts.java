package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.series.Contender;
import io.github.circles2d.bench.series.Series;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
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
                if (who.engine().startsWith("world") && !who.threads().equals("1")) {
                    index += line(chart, WorldCharts.label(folder, who.engine()), folder, who, series, index, false);
                }
            }
        }
        for (ResultsFolder folder : folders) {
            int before = index;
            for (Contender who : SeriesTables.contenders(folder)) {
                boolean oneCore =
                        who.engine().equals(Engines.WORLD_JVM) && who.threads().equals("1");
                if (!who.engine().startsWith("world") || oneCore) {
                    index += line(chart, label(who), folder, who, series, index, true);
                }
            }
            if (index > before) {
                break;
            }
        }
        return chart;
    }

    private static String label(Contender who) {
        String threads = who.threads() + (who.threads().equals("1") ? " thread" : " threads");
        return (who.engine().equals(Engines.WORLD_JVM) ? "World, Java" : who.engine()) + ", " + threads;
    }

    private static int line(
            XYChart chart, String name, ResultsFolder folder, Contender who, Series series, int index, boolean thin) {
        List<Integer> sizes = new ArrayList<>();
        List<Double> millis = new ArrayList<>();
        for (int n : series.sizes()) {
            Map<String, String> run = SeriesTables.run(folder, who, series, n);
            if (SeriesTables.ok(run)) {
                sizes.add(n);
                millis.add(Numbers.parse(run.get("median_ms")));
            }
        }
        if (sizes.isEmpty() || chart.getSeriesMap().containsKey(name)) {
            return 0;
        }
        Charts.line(chart, name, sizes, millis, index, thin);
        return 1;
    }
}
