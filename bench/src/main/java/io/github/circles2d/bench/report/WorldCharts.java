package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.awt.Font;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
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
        if (!folder.table(Kind.WORLD).rows("mode", "steps", "status", "ok").isEmpty()) {
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
        XYChart chart = Charts.chart("A step on the scene packed", "circles", "ms a step");
        int index = 0;
        for (ResultsFolder folder : folders) {
            for (String engine : worlds(folder)) {
                index += line(chart, label(folder, engine), worldMillis(folder, engine), index, false);
            }
        }
        for (ResultsFolder folder : folders) {
            List<String> peers = folder.table(Kind.PEERS).rows("scene", "packed", "status", "ok").stream()
                    .map(row -> row.get("engine"))
                    .filter(Engines.PEERS::contains)
                    .distinct()
                    .collect(Collectors.toList());
            for (String engine : peers) {
                index += line(chart, label(folder, engine), peerMillis(folder, engine), index, true);
            }
            if (!peers.isEmpty()) {
                break;
            }
        }
        return chart;
    }

    private static int line(XYChart chart, String name, Map<Integer, Double> millis, int index, boolean thin) {
        if (millis.isEmpty() || chart.getSeriesMap().containsKey(name)) {
            return 0;
        }
        Charts.line(chart, name, new ArrayList<>(millis.keySet()), new ArrayList<>(millis.values()), index, thin);
        return 1;
    }

    /** World's engines in a folder, those on GPUs first. */
    private static List<String> worlds(ResultsFolder folder) {
        List<String> engines = new ArrayList<>();
        for (Kind kind : List.of(Kind.WORLD, Kind.PEERS)) {
            for (Map<String, String> row : folder.table(kind).rows("status", "ok")) {
                if (row.get("engine").startsWith("world") && !engines.contains(row.get("engine"))) {
                    engines.add(row.get("engine"));
                }
            }
        }
        return engines;
    }

    /** Ms a step by n: steps in one call; where there are none of these, the steps of the comparison. */
    private static Map<Integer, Double> worldMillis(ResultsFolder folder, String engine) {
        Map<Integer, Double> millis = new TreeMap<>();
        for (Map<String, String> row :
                folder.table(Kind.WORLD).rows("engine", engine, "mode", "steps", "status", "ok")) {
            millis.put(Integer.valueOf(row.get("n")), Numbers.parse(row.get("mean_ms")));
        }
        return millis.isEmpty() ? peerMillis(folder, engine) : millis;
    }

    private static Map<Integer, Double> peerMillis(ResultsFolder folder, String engine) {
        Map<Integer, Double> millis = new TreeMap<>();
        for (Map<String, String> row :
                folder.table(Kind.PEERS).rows("engine", engine, "scene", "packed", "status", "ok")) {
            millis.put(Integer.valueOf(row.get("n")), Numbers.parse(row.get("mean_ms")));
        }
        return millis;
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
        List<Label> taken = new ArrayList<>(labels.stream()
                .map(label -> new Label("*", label.x(), label.y()))
                .collect(Collectors.toList()));
        for (Label label : labels) {
            for (int k = 1; ; k++) {
                // above, below, farther above, ..
                double y = label.y() + (k % 2 == 1 ? 1 : -1) * ((k + 1) / 2) * LINE_HEIGHT * perPixelY;
                boolean free = taken.stream()
                        .allMatch(other -> Math.abs(other.y() - y) > 0.8 * LINE_HEIGHT * perPixelY
                                || Math.abs(other.x() - label.x())
                                        > 0.5
                                                * LETTER_WIDTH
                                                * perPixelX
                                                * (other.name().length()
                                                        + label.name().length()));
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
