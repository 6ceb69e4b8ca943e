package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** A crowd that grows and shrinks in a world that moves and in two that stay, from the folder {@code moves} of the results. */
final class Moves {
    /** File name, without ending, of the chart. */
    static final String FILE = "crowd";

    /** Column and name of each world. */
    private static final String[][] WORLDS = {{"auto", "AUTO"}, {"jvm", "the JVM alone"}, {"gpu", "the GPU alone"}};

    private Moves() {}

    private static List<Map<String, String>> rows(Path folder) {
        return Table.rowsOf(folder.resolve("crowd.csv"), List.of("frame"));
    }

    /** What all frames took, and the longest. Empty if the folder has no such file. */
    static String totals(Path folder) {
        List<Map<String, String>> rows = rows(folder);
        StringBuilder text =
                new StringBuilder("| world | frames | seconds | longest frame, ms | moves |\n|---|--:|--:|--:|--:|\n");
        for (String[] world : WORLDS) {
            double frames = 0;
            double seconds = 0;
            double longest = 0;
            String moves = "";
            for (Map<String, String> row : rows) {
                double count = Numbers.parse(row.get("frames"));
                frames += count;
                seconds += 1e-3 * count * Numbers.parse(row.get(world[0] + "_ms"));
                longest = Math.max(longest, Numbers.parse(row.get(world[0] + "_longest_ms")));
                moves = row.get("moves");
            }
            text.append(String.format(
                    Locale.ROOT,
                    "| %s | %,.0f | %.1f | %.0f | %s |%n",
                    world[1],
                    frames,
                    seconds,
                    longest,
                    world[0].equals("auto") ? moves : "0"));
        }
        return rows.isEmpty() ? "" : text.toString();
    }

    /** How long starts and moves take. Empty if the folder has no such file. */
    static String times(Path folder) {
        StringBuilder text = new StringBuilder("| what | time |\n|---|--:|\n");
        List<Map<String, String>> rows = Table.rowsOf(folder.resolve("times.csv"), List.of("what"));
        for (Map<String, String> row : rows) {
            text.append("| ")
                    .append(row.get("what"))
                    .append(" | ")
                    .append(row.get("time"))
                    .append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }

    /** Draws the times of frames, if the folder has some. */
    static void draw(Path folder) throws IOException {
        XYChart chart = Charts.chart("A crowd that grows to 200,000 circles and shrinks again", "frame", "ms a frame");
        chart.getStyler().setXAxisLogarithmic(false);
        List<Map<String, String>> rows = rows(folder);
        for (int k = 0; k < WORLDS.length; k++) {
            Map<Integer, Double> millis = new TreeMap<>();
            for (Map<String, String> row : rows) {
                millis.put(Integer.valueOf(row.get("frame")), Numbers.parse(row.get(WORLDS[k][0] + "_ms")));
            }
            Charts.line(chart, WORLDS[k][1], millis, k, k > 0);
        }
        for (XYSeries series : chart.getSeriesMap().values()) {
            series.setMarker(SeriesMarkers.NONE);
        }
        if (!rows.isEmpty()) {
            Charts.saveByTime(chart, folder, FILE);
        }
    }
}
