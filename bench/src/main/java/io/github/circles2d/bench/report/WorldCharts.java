package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.awt.Font;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;

/** World's charts: ms by n beside other engines, on one machine and on all; and speed against quality. */
final class WorldCharts {
    /** File name, without ending, of the chart of ms by n. */
    static final String FILE = "world";

    /** Sizes at which speed is drawn against quality. */
    static final List<Integer> QUALITY_SIZES = List.of(1250, 5000);

    // About, in pixels: for keeping names clear of each other.
    private static final int PLOT_WIDTH = 800;
    private static final int PLOT_HEIGHT = 500;
    private static final int LINE_HEIGHT = 18;
    private static final int LETTER_WIDTH = 8;

    private WorldCharts() {}

    /** File name, without ending, of the chart of speed against quality. */
    static String qualityFile(int n) {
        return "quality-" + n;
    }

    /** The charts of one machine. */
    static void draw(ResultsFolder folder) throws IOException {
        if (folder.table(Kind.WORLD).row("mode", "steps", "status", "ok") != null) {
            Charts.save(steps(List.of(folder)), folder.path(), FILE);
        }
        for (int n : QUALITY_SIZES) {
            XYChart chart = quality(folder, n);
            // One engine alone is no comparison.
            if (chart.getSeriesMap().size() > 1) {
                Charts.save(chart, folder.path(), qualityFile(n));
            }
        }
    }

    /**
     * World on all machines, of machines that are alike the first; other engines on the first machine that has some.
     */
    static XYChart steps(List<ResultsFolder> folders) {
        return Charts.compare(
                Charts.chart("A step on the scene packed", "circles", "ms a step"),
                folders,
                folder -> lines(folder, engine -> engine.startsWith("world")),
                folder -> lines(folder, Engines.PEERS::contains));
    }

    private static Map<String, Map<Integer, Double>> lines(ResultsFolder folder, Predicate<String> wanted) {
        Map<String, Map<Integer, Double>> lines = new LinkedHashMap<>();
        Stream.of(Kind.WORLD, Kind.PEERS)
                .flatMap(kind -> folder.table(kind).values("engine", "status", "ok").stream())
                .filter(wanted)
                .forEach(engine -> lines.merge(label(folder, engine), millis(folder, engine), Charts::drawn));
        return lines;
    }

    /** Ms a step by n: steps in one call; if there are none of these, the steps of the comparison. */
    private static Map<Integer, Double> millis(ResultsFolder folder, String engine) {
        List<Map<String, String>> rows =
                folder.table(Kind.WORLD).rows("engine", engine, "mode", "steps", "status", "ok");
        return Charts.points(
                rows.isEmpty()
                        ? folder.table(Kind.PEERS).rows("engine", engine, "scene", "packed", "status", "ok")
                        : rows,
                "mean_ms");
    }

    /** A name for people: engine and what it runs on. */
    static String label(ResultsFolder folder, String engine) {
        String cores = folder.machine("cores") + " cores";
        if (engine.equals(Engines.WORLD_JVM)) {
            return "World, Java, " + cores;
        }
        if (engine.startsWith("world@")) {
            String device = engine.substring(engine.indexOf('@') + 1);
            String name = folder.machine("device " + device);
            return Tables.kind(folder, device).equals("CPU")
                    ? "World, OpenCL, " + cores
                    : "World, " + (name.contains(" (") ? name.substring(0, name.indexOf(" (")) : device);
        }
        return engine.replaceAll("@.*", "");
    }

    private static XYChart quality(ResultsFolder folder, int n) {
        XYChart chart = Charts.chart(
                "Speed and quality, scene packed, n = " + Numbers.whole(n)
                        + ": the nearer to the lower left the better",
                "ms a step",
                "mean depth of overlaps, radii");
        chart.getStyler().setXAxisDecimalPattern("#,##0.###");
        chart.getStyler().setYAxisDecimalPattern("0.#####");
        chart.getStyler().setLegendVisible(false);
        chart.getStyler().setAnnotationTextFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
        List<Label> labels = new ArrayList<>();
        for (Map<String, String> row :
                folder.table(Kind.PEERS).rows("scene", "packed", "n", Integer.toString(n), "status", "ok")) {
            double millis = Numbers.parse(row.get("mean_ms"));
            double depth = Numbers.parse(row.get("mean_depth"));
            String name = label(folder, row.get("engine"));
            if (depth > 0 && !chart.getSeriesMap().containsKey(name)) {
                XYSeries series = chart.addSeries(name, List.of(millis), List.of(depth));
                series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
                Charts.mark(series, labels.size());
                labels.add(new Label(name, Math.log10(millis), Math.log10(depth)));
            }
        }
        place(labels, chart);
        return chart;
    }

    /** A point's name, in decades. */
    private record Label(String name, double x, double y) {}

    /** Writes each name above its point, or as far above or below it as keeps it clear of the others and of their points. */
    private static void place(List<Label> labels, XYChart chart) {
        double perPixelX = decades(labels.stream().mapToDouble(Label::x).toArray()) / PLOT_WIDTH;
        double perPixelY = decades(labels.stream().mapToDouble(Label::y).toArray()) / PLOT_HEIGHT;
        List<Label> taken = new ArrayList<>();
        labels.forEach(label -> taken.add(new Label("*", label.x(), label.y())));
        for (Label label : labels) {
            for (int k = 1; ; k++) {
                // above, below, farther above, ..
                double y = label.y() + (k % 2 == 1 ? 1 : -1) * ((k + 1) / 2) * LINE_HEIGHT * perPixelY;
                double letter = 0.5 * LETTER_WIDTH * perPixelX;
                double own = letter * label.name().length();
                boolean free = taken.stream()
                        .allMatch(other -> Math.abs(other.y() - y) > 0.8 * LINE_HEIGHT * perPixelY
                                || Math.abs(other.x() - label.x())
                                        > own + letter * other.name().length());
                if (free || k > 10) {
                    taken.add(new Label(label.name(), label.x(), y));
                    chart.addAnnotation(
                            new AnnotationText(label.name(), Math.pow(10, label.x()), Math.pow(10, y), false));
                    break;
                }
            }
        }
    }

    private static double decades(double[] logarithms) {
        double min = Arrays.stream(logarithms).map(Math::floor).min().orElse(0);
        double max = Arrays.stream(logarithms).map(Math::ceil).max().orElse(1);
        return Math.max(1, max - min);
    }
}
