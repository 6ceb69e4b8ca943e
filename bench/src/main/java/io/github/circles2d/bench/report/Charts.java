package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
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
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
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
            if (!folder.table(Kind.STRATEGIES)
                    .rows("device", device, "mode", "loop", "status", "ok")
                    .isEmpty()) {
                save(strategies(folder, device), folder.path(), strategiesFile(device));
            }
        }
        for (String scene : List.of("packed", "thesis")) {
            save(peers(folder, scene), folder.path(), peersFile(scene));
        }
        WorldCharts.draw(folder);
    }

    /** Draws what compares machines, into the folder of their folders; says so where it cannot, as {@link #draw} does. */
    public static void drawAll(Path results, List<ResultsFolder> folders, PrintStream out) throws IOException {
        tryTo(
                () -> {
                    save(WorldCharts.steps(folders), results, WorldCharts.FILE);
                    SeriesCharts.draw(results, folders);
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
            List<Integer> sizes = new ArrayList<>();
            List<Double> millis = new ArrayList<>();
            List<Integer> thesisSizes = new ArrayList<>();
            List<Double> thesisMillis = new ArrayList<>();
            for (int n : Tables.sizes(folder, device)) {
                add(Tables.run(folder, device, strategy, n, "loop"), n, sizes, millis);
                String thesis = Figure3.millis(kind, n, strategy);
                if (thesis.matches("[0-9]+")) {
                    thesisSizes.add(n);
                    thesisMillis.add(Double.valueOf(thesis));
                }
            }
            line(chart, Tables.STRATEGIES.get(strategy), sizes, millis, strategy, false);
            String name = "thesis: " + strategy + ", " + Figure3.device(kind);
            line(chart, name, thesisSizes, thesisMillis, strategy, true);
            if (chart.getSeriesMap().containsKey(name)) {
                chart.getSeriesMap().get(name).setMarker(SeriesMarkers.NONE);
            }
        }
        return chart;
    }

    private static XYChart peers(ResultsFolder folder, String scene) {
        XYChart chart = chart("A step on the scene " + scene, "circles", "ms a step");
        List<Map<String, String>> rows = folder.table(Kind.PEERS).rows("scene", scene);
        List<String> engines =
                rows.stream().map(row -> row.get("engine")).distinct().collect(Collectors.toList());
        for (int e = 0; e < engines.size(); e++) {
            List<Integer> sizes = new ArrayList<>();
            List<Double> millis = new ArrayList<>();
            for (Map<String, String> row : rows) {
                if (row.get("engine").equals(engines.get(e))) {
                    add(row, Integer.parseInt(row.get("n")), sizes, millis);
                }
            }
            line(chart, engines.get(e), sizes, millis, e, false);
        }
        return chart;
    }

    private static void add(Map<String, String> run, int n, List<Integer> sizes, List<Double> millis) {
        if (run != null && run.get("status").equals("ok")) {
            sizes.add(n);
            millis.add(Numbers.parse(run.get("mean_ms")));
        }
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

    /** A line of the chart; nothing where it has no points. */
    static void line(XYChart chart, String name, List<Integer> sizes, List<Double> millis, int index, boolean dashed) {
        if (sizes.isEmpty()) {
            return;
        }
        XYSeries series = chart.addSeries(name, sizes, millis);
        mark(series, index);
        float[] dashes = {6, 6};
        series.setLineStyle(
                dashed
                        ? new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dashes, 0)
                        : new BasicStroke(2));
    }

    static void save(XYChart chart, Path folder, String name) throws IOException {
        if (chart.getSeriesMap().isEmpty()) {
            return;
        }
        toWholeDecades(chart);
        String file = folder.resolve(name).toString();
        BitmapEncoder.saveBitmap(chart, file, BitmapEncoder.BitmapFormat.PNG);
        VectorGraphicsEncoder.saveVectorGraphic(chart, file, VectorGraphicsEncoder.VectorGraphicsFormat.SVG);
        Path svg = folder.resolve(name + ".svg");
        Files.writeString(svg, slim(Files.readString(svg)));
    }

    /** Only whole powers of ten get labels: both axes run from one to another. */
    private static void toWholeDecades(XYChart chart) {
        double[] x = chart.getSeriesMap().values().stream()
                .flatMapToDouble(series -> Arrays.stream(series.getXData()))
                .toArray();
        double[] y = chart.getSeriesMap().values().stream()
                .flatMapToDouble(series -> Arrays.stream(series.getYData()))
                .toArray();
        chart.getStyler()
                .setXAxisMin(decade(Arrays.stream(x).min().orElseThrow(), RoundingMode.FLOOR))
                .setXAxisMax(decade(Arrays.stream(x).max().orElseThrow(), RoundingMode.CEILING))
                .setYAxisMin(decade(Arrays.stream(y).min().orElseThrow(), RoundingMode.FLOOR))
                .setYAxisMax(decade(Arrays.stream(y).max().orElseThrow(), RoundingMode.CEILING));
    }

    private static double decade(double value, RoundingMode rounding) {
        double power = Math.log10(value);
        return Math.pow(10, rounding == RoundingMode.FLOOR ? Math.floor(power) : Math.ceil(power));
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
