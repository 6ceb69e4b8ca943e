package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.io.IOException;
import java.io.PrintStream;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.VectorGraphicsEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Draws a results folder, each chart as PNG and as SVG: ms by n on logarithmic axes. */
public final class Charts {
    /** Colours that people with any kind of colour vision can tell apart (Okabe and Ito). */
    private static final Color[] COLOURS = {
        new Color(0x0072B2),
        new Color(0xD55E00),
        new Color(0x009E73),
        new Color(0xCC79A7),
        new Color(0xE69F00),
        new Color(0x56B4E9),
        new Color(0x000000)
    };

    private static final Marker[] MARKERS = {
        SeriesMarkers.CIRCLE, SeriesMarkers.SQUARE, SeriesMarkers.DIAMOND, SeriesMarkers.TRIANGLE_UP
    };

    private Charts() {}

    /**
     * Draws what there are figures for, and says where. Where this JVM cannot draw (a machine without fonts) it says so and goes
     * on.
     */
    public static void draw(ResultsFolder folder, PrintStream out) throws IOException {
        tryTo(
                () -> {
                    draw(folder);
                    try (DirectoryStream<Path> pictures = Files.newDirectoryStream(folder.path(), "*.png")) {
                        pictures.forEach(picture -> out.println("chart " + picture));
                    }
                },
                folder.path(),
                out);
    }

    private static void draw(ResultsFolder folder) throws IOException {
        for (String device : Tables.devices(folder)) {
            if (folder.table(Kind.STRATEGIES).row("device", device, "mode", "loop", "status", "ok") != null) {
                save(strategies(folder, device), folder.path(), strategiesFile(device));
            }
        }
        for (String scene : List.of("packed", "thesis")) {
            save(peers(folder, scene), folder.path(), peersFile(scene));
        }
        WorldCharts.draw(folder);
        WebCharts.draw(folder);
    }

    /** Draws what compares machines, into the folder of their folders; says so where it cannot, as {@link #draw} does. */
    public static void drawAll(Path results, List<ResultsFolder> folders, PrintStream out) throws IOException {
        tryTo(
                () -> {
                    save(WorldCharts.steps(folders), results, WorldCharts.FILE);
                    SeriesCharts.draw(results, folders);
                    Moves.draw(results.resolve("moves"));
                },
                results,
                out);
    }

    interface Drawing {
        void run() throws IOException;
    }

    static void tryTo(Drawing drawing, Path where, PrintStream out) throws IOException {
        try {
            drawing.run();
        } catch (LinkageError | InternalError | RuntimeException e) {
            out.println("no charts: this JVM cannot draw here (" + e + "); draw them elsewhere with: charts " + where);
        }
    }

    /** File name, without ending, of the chart of a device. */
    static String strategiesFile(String device) {
        return "strategies-" + device;
    }

    /** File name, without ending, of the chart of a scene. */
    static String peersFile(String scene) {
        return "peers-" + scene;
    }

    private static XYChart strategies(ResultsFolder folder, String device) {
        String kind = Tables.kind(folder, device);
        XYChart chart = chart("A step of the thesis's engine on " + device, "circles", "ms a step");
        for (int strategy = 0; strategy < 4; strategy++) {
            Map<Integer, Double> thesis = new TreeMap<>();
            for (int n : Tables.sizes(folder, device)) {
                String millis = Figure3.millis(kind, n, strategy);
                if (millis.matches("[0-9]+")) {
                    thesis.put(n, Double.valueOf(millis));
                }
            }
            String number = Integer.toString(strategy);
            Table table = folder.table(Kind.STRATEGIES);
            List<Map<String, String>> rows =
                    table.rows("device", device, "strategy", number, "mode", "loop", "status", "ok");
            line(chart, Tables.STRATEGIES.get(strategy), points(rows, "mean_ms"), strategy, false);
            String name = "thesis: " + strategy + ", " + Figure3.device(kind);
            if (line(chart, name, thesis, strategy, true) > 0) {
                chart.getSeriesMap().get(name).setMarker(SeriesMarkers.NONE);
            }
        }
        return chart;
    }

    private static XYChart peers(ResultsFolder folder, String scene) {
        XYChart chart = chart("A step on the scene " + scene, "circles", "ms a step");
        Table peers = folder.table(Kind.PEERS);
        int index = 0;
        for (String engine : peers.values("engine", "scene", scene)) {
            line(
                    chart,
                    engine,
                    points(peers.rows("scene", scene, "engine", engine, "status", "ok"), "mean_ms"),
                    index++,
                    false);
        }
        return chart;
    }

    /** What some rows have in a column, by n. */
    static Map<Integer, Double> points(List<Map<String, String>> rows, String column) {
        Map<Integer, Double> points = new TreeMap<>();
        rows.forEach(row -> points.put(Integer.valueOf(row.get("n")), Numbers.parse(row.get(column))));
        return points;
    }

    static XYChart chart(String title, String xTitle, String yTitle) {
        XYChart chart = new XYChartBuilder()
                .width(900)
                .height(600)
                .title(title)
                .xAxisTitle(xTitle)
                .yAxisTitle(yTitle)
                .build();
        Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 14);
        chart.getStyler()
                .setXAxisLogarithmic(true)
                .setYAxisLogarithmic(true)
                .setXAxisDecimalPattern("#,##0")
                .setYAxisDecimalPattern("#,##0.###")
                .setAxisTickLabelsFont(font)
                .setLegendPosition(Styler.LegendPosition.OutsideE)
                .setLegendFont(font)
                .setChartBackgroundColor(Color.WHITE)
                .setChartTitleBoxVisible(false);
        return chart;
    }

    /** Colour and marker: no two of the first 28 series have both in common. */
    static void mark(XYSeries series, int index) {
        series.setLineColor(COLOURS[index % COLOURS.length]);
        series.setMarkerColor(COLOURS[index % COLOURS.length]);
        series.setMarker(MARKERS[index % MARKERS.length]);
    }

    /** Draws a line, unless it has no points or the chart has one of its name; returns how many lines came to the chart. */
    static int line(XYChart chart, String name, Map<Integer, Double> points, int index, boolean dashed) {
        if (points.isEmpty() || chart.getSeriesMap().containsKey(name)) {
            return 0;
        }
        XYSeries series = chart.addSeries(name, new ArrayList<>(points.keySet()), new ArrayList<>(points.values()));
        mark(series, index);
        float[] dashes = {6, 6};
        series.setLineStyle(
                dashed
                        ? new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dashes, 0)
                        : new BasicStroke(2));
        return 1;
    }

    /** Draws World on all machines, and other engines on the first that has some; of lines of one name the first alone. */
    static XYChart compare(
            XYChart chart,
            List<ResultsFolder> folders,
            Function<ResultsFolder, Map<String, Map<Integer, Double>>> worlds,
            Function<ResultsFolder, Map<String, Map<Integer, Double>>> others) {
        int index = 0;
        for (ResultsFolder folder : folders) {
            for (Map.Entry<String, Map<Integer, Double>> line :
                    worlds.apply(folder).entrySet()) {
                index += line(chart, line.getKey(), line.getValue(), index, false);
            }
        }
        for (ResultsFolder folder : folders) {
            int before = index;
            for (Map.Entry<String, Map<Integer, Double>> line :
                    others.apply(folder).entrySet()) {
                index += line(chart, line.getKey(), line.getValue(), index, true);
            }
            if (index > before) {
                break;
            }
        }
        return chart;
    }

    /** Of two lines of one name, the one that is drawn: the first that has points. */
    static Map<Integer, Double> drawn(Map<Integer, Double> first, Map<Integer, Double> second) {
        return first.isEmpty() ? second : first;
    }

    /** Only whole powers of ten get labels on a logarithmic axis, which runs from one to another. */
    static void save(XYChart chart, Path folder, String name) throws IOException {
        if (chart.getSeriesMap().isEmpty()) {
            return;
        }
        double[] x = exponents(chart, XYSeries::getXData);
        chart.getStyler().setXAxisMin(Math.pow(10, Math.floor(x[0]))).setXAxisMax(Math.pow(10, Math.ceil(x[1])));
        saveByTime(chart, folder, name);
    }

    /** Saves a chart of which only the vertical axis is logarithmic. */
    static void saveByTime(XYChart chart, Path folder, String name) throws IOException {
        double[] y = exponents(chart, XYSeries::getYData);
        chart.getStyler().setYAxisMin(Math.pow(10, Math.floor(y[0]))).setYAxisMax(Math.pow(10, Math.ceil(y[1])));
        String file = folder.resolve(name).toString();
        BitmapEncoder.saveBitmap(chart, file, BitmapEncoder.BitmapFormat.PNG);
        VectorGraphicsEncoder.saveVectorGraphic(chart, file, VectorGraphicsEncoder.VectorGraphicsFormat.SVG);
        Path svg = folder.resolve(name + ".svg");
        Files.writeString(svg, slim(Files.readString(svg)));
    }

    /** The decades of the least and the greatest value of all lines. */
    private static double[] exponents(XYChart chart, Function<XYSeries, double[]> axis) {
        DoubleSummaryStatistics all = chart.getSeriesMap().values().stream()
                .flatMapToDouble(series -> Arrays.stream(axis.apply(series)))
                .summaryStatistics();
        return new double[] {Math.log10(all.getMin()), Math.log10(all.getMax())};
    }

    /** Letters are drawn as outlines, with a dozen digits a coordinate: one digit after the point is enough. */
    static String slim(String svg) {
        return Pattern.compile("-?[0-9]+\\.[0-9]{2,}")
                .matcher(svg)
                .replaceAll(number -> new BigDecimal(number.group())
                        .setScale(1, RoundingMode.HALF_UP)
                        .stripTrailingZeros()
                        .toPlainString())
                .replaceAll("clip[0-9]+", "clip")
                .replaceAll("\n +", "\n");
    }
}
