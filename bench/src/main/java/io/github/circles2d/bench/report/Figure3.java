package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Table;
import java.util.List;
import java.util.Map;

/**
 * Figure 3 of the thesis (S. Young, "Memory Organization and Buffer Construction for GPGPU for 2D Physics", Memorial
 * University of Newfoundland, 2014): mean ms of an iteration over 1,000, read-back included.
 */
final class Figure3 {
    private static final Table TABLE = Table.ofResource("figure3.csv", List.of("kind", "n", "strategy"));

    private Figure3() {}

    /** The thesis's text for a strategy and n on a kind of device: a number, "&lt;1", "failed", or empty where it has none. */
    static String millis(String kind, int n, int strategy) {
        Map<String, String> row =
                TABLE.row("kind", kind, "n", Integer.toString(n), "strategy", Integer.toString(strategy));
        return row == null ? "" : row.get("mean_ms");
    }

    /** The thesis's device of a kind, or an empty text. */
    static String device(String kind) {
        Map<String, String> row = TABLE.row("kind", kind);
        return row == null ? "" : row.get("device");
    }
}
