package io.github.circles2d.bench.report;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** A table of texts with a header, for the console and for Markdown. */
final class Grid {
    private final List<List<String>> rows = new ArrayList<>();
    private final boolean prose;

    private Grid(boolean prose, String... header) {
        this.prose = prose;
        rows.add(List.of(header));
    }

    /** A table whose first column is set left and the others right. */
    static Grid ofNumbers(String... header) {
        return new Grid(false, header);
    }

    /** A table whose columns are all set left. */
    static Grid ofProse(String... header) {
        return new Grid(true, header);
    }

    void add(List<String> row) {
        if (row.size() != rows.get(0).size()) {
            throw new IllegalArgumentException(row + " has not as many cells as " + rows.get(0));
        }
        rows.add(List.copyOf(row));
    }

    boolean isEmpty() {
        return rows.size() == 1;
    }

    /** For a screen: columns padded with spaces, in plain ASCII, since not every console has more. */
    String text() {
        List<List<String>> ascii = new ArrayList<>();
        for (List<String> row : rows) {
            ascii.add(row.stream()
                    .map(cell -> cell.replace("±", "+/-").replace("µ", "u"))
                    .collect(Collectors.toList()));
        }
        int[] widths = new int[rows.get(0).size()];
        for (List<String> row : ascii) {
            for (int i = 0; i < widths.length; i++) {
                widths[i] = Math.max(widths[i], row.get(i).length());
            }
        }
        StringBuilder text = new StringBuilder();
        for (List<String> row : ascii) {
            StringBuilder line = new StringBuilder();
            for (int i = 0; i < widths.length; i++) {
                String padding = " ".repeat(widths[i] - row.get(i).length());
                line.append(i == 0 ? "" : "  ").append(i == 0 || prose ? row.get(i) + padding : padding + row.get(i));
            }
            text.append(line.toString().stripTrailing()).append('\n');
        }
        return text.toString();
    }

    /** For a Markdown page. */
    String markdown() {
        StringBuilder text = new StringBuilder();
        for (int r = 0; r < rows.size(); r++) {
            text.append("| ").append(String.join(" | ", rows.get(r))).append(" |\n");
            if (r == 0) {
                text.append("|---|")
                        .append((prose ? "---|" : "--:|").repeat(rows.get(0).size() - 1))
                        .append('\n');
            }
        }
        return text.toString();
    }
}
