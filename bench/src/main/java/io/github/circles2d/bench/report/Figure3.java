package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;

/**
 * Figure 3 of the thesis (S. Young, "Memory Organization and Buffer Construction for GPGPU for 2D Physics", Memorial
 * University of Newfoundland, 2014): mean ms of an iteration over 1,000, read-back included.
 */
final class Figure3 {
    private static final Table TABLE = read();

    private Figure3() {}

    /** The thesis's text for a strategy and n on a kind of device: a number, "&lt;1", "failed", or empty where it has none. */
    static String millis(String kind, int n, int strategy) {
        List<Map<String, String>> rows =
                TABLE.rows("kind", kind, "n", Integer.toString(n), "strategy", Integer.toString(strategy));
        return rows.isEmpty() ? "" : rows.get(0).get("mean_ms");
    }

    /** The thesis's device of a kind, or an empty text. */
    static String device(String kind) {
        List<Map<String, String>> rows = TABLE.rows("kind", kind);
        return rows.isEmpty() ? "" : rows.get(0).get("device");
    }

    private static Table read() {
        try (InputStream in = Figure3.class.getResourceAsStream("/io/github/circles2d/bench/figure3.csv")) {
            return Table.parse(new String(in.readAllBytes(), StandardCharsets.UTF_8), List.of("kind", "n", "strategy"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
