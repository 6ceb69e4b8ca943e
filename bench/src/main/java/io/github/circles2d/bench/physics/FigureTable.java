package io.github.circles2d.bench.physics;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** A table of scenes with exact figures, from a CSV file that the library's tests write ({@code RowFigures}). */
final class FigureTable {
    /** Smaller figures are rounding. */
    private static final double LEAST = 1e-6;

    private FigureTable() {}

    /** The lines for the page; none if a folder has no such file. */
    static String of(Path folder, String name) throws IOException {
        Path file = folder.resolve(name);
        if (!Files.exists(file)) {
            return "";
        }
        StringBuilder text = new StringBuilder("| row | scene and figure | exact | Box2D v3 | World |\n");
        text.append("|---|---|--:|--:|--:|\n");
        String last = "";
        for (Map<String, String> figure : Table.parse(
                        Files.readString(file, StandardCharsets.UTF_8), List.of("row", "figure"))
                .rows()) {
            String row = figure.get("row");
            String world = brief(figure.get("world"));
            text.append("| ").append(row.equals(last) ? "" : row).append(" | ");
            text.append(figure.get("figure")).append(" | ");
            text.append(brief(figure.get("exact"))).append(" | ");
            text.append(brief(figure.get("box2d"))).append(" | ");
            text.append(figure.get("met").equals("no") ? "**" + world + "**" : world)
                    .append(" |\n");
            last = row;
        }
        return text.toString();
    }

    private static String brief(String value) {
        double number = Numbers.parse(value);
        return Math.abs(number) < LEAST ? "0" : Numbers.exact(number);
    }
}
