package io.github.circles2d.bench.physics;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Draws a scene's curves below each other in one picture. */
final class CurveCharts {
    /** What is smaller is drawn here on the logarithmic axes, which have no zero. */
    private static final double LEAST = 1e-5;

    private static final Map<String, Color> COLOURS =
            Map.of("World", new Color(0x0072B2), "Box2D", new Color(0xD55E00));

    private CurveCharts() {}

    static void draw(Curves.Curve curve, Table table, Path folder) throws IOException {
        List<XYChart> charts = List.of(
                chart(curve.title(), "energy, J", "energy", false, curve, table),
                chart("", "deepest pair, r", "deepest", true, curve, table),
                chart("", "rms speed, m/s", "rms", true, curve, table));
        if (!charts.get(0).getSeriesMap().isEmpty()) {
            String file = folder.resolve(curve.name()).toString();
            BitmapEncoder.saveBitmap(charts, 3, 1, file, BitmapEncoder.BitmapFormat.PNG);
        }
    }

    private static XYChart chart(
            String title, String axis, String column, boolean logarithmic, Curves.Curve curve, Table table) {
        XYChart chart = new XYChartBuilder()
                .width(800)
                .height(260)
                .title(title)
                .xAxisTitle("s")
                .yAxisTitle(axis)
                .build();
        chart.getStyler()
                .setYAxisLogarithmic(logarithmic)
                .setYAxisDecimalPattern(logarithmic ? "0.#####" : "#,##0.##")
                .setAxisTickLabelsFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12))
                .setLegendPosition(Styler.LegendPosition.OutsideE)
                .setChartBackgroundColor(Color.WHITE)
                .setChartTitleBoxVisible(false);
        for (String engine : List.of("World", "Box2D")) {
            List<Double> seconds = new ArrayList<>();
            List<Double> values = new ArrayList<>();
            for (Map<String, String> row : table.rows("curve", curve.name(), "engine", engine)) {
                double value = Numbers.parse(row.get(column));
                seconds.add(Numbers.parse(row.get("seconds")));
                values.add(logarithmic ? Math.max(value, LEAST) : value);
            }
            if (!seconds.isEmpty()) {
                XYSeries series = chart.addSeries(engine, seconds, values);
                series.setLineColor(COLOURS.get(engine));
                series.setLineStyle(new BasicStroke(1.5f));
                series.setMarker(SeriesMarkers.NONE);
            }
        }
        if (logarithmic) {
            toWholeDecades(chart);
        }
        return chart;
    }

    /** Only whole powers of ten get labels: the axis runs from one to another. */
    private static void toWholeDecades(XYChart chart) {
        double[] values = chart.getSeriesMap().values().stream()
                .flatMapToDouble(series -> Arrays.stream(series.getYData()))
                .toArray();
        if (values.length > 0) {
            double least = Math.log10(Arrays.stream(values).min().orElseThrow());
            double greatest = Math.log10(Arrays.stream(values).max().orElseThrow());
            chart.getStyler()
                    .setYAxisMin(Math.pow(10, Math.floor(least)))
                    .setYAxisMax(Math.pow(10, Math.max(Math.ceil(greatest), Math.floor(least) + 1)));
        }
    }
}
