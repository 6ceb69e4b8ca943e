package io.github.circles2d.bench.report;

import java.util.ArrayList;
import java.util.List;

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

    void add(String... row) {
        add(List.of(row));
    }

    boolean isEmpty() {
        return rows.size() == 1;
    }

    /** For a screen: columns padded with spaces, in plain ASCII, since not every console has more. */
    String text() {
        int[] widths = new int[rows.get(0).size()];
        List<List<String>> ascii = new ArrayList<>();
        for (List<String> row : rows) {
            ascii.add(row.stream()
                    .map(cell -> cell.replace("±", "+/-").replace("µ", "u"))
                    .toList());
            for (int i = 0; i < widths.length; i++) {
                widths[i] =
                        Math.max(widths[i], ascii.get(ascii.size() - 1).get(i).length());
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

    /** For a Markdown page; empty if there is no row. */
    String markdown() {
        StringBuilder text = new StringBuilder();
        for (List<String> row : isEmpty() ? List.<List<String>>of() : rows) {
            boolean first = text.isEmpty();
            text.append("| ").append(String.join(" | ", row)).append(" |\n");
            if (first) {
                text.append("|---|")
                        .append((prose ? "---|" : "--:|").repeat(row.size() - 1))
                        .append('\n');
            }
        }
        return text.toString();
    }
}
