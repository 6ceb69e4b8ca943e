package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * A figure that is to be measured: steps of one engine on one scene, or a benchmark with one set of parameters.
 *
 * @param kind the table that it goes to
 * @param key the columns of that table which name it
 * @param growth exponent with which its time grows with n
 * @param benchmark full name of the benchmark method; empty if JMH does not measure it
 * @param parameters its JMH parameters
 * @param skipped steps of a run that do not count
 * @param steps steps of a run that count
 * @param firstGuess ms a step, for as long as nothing of its family has run
 */
record Task(
        Kind kind,
        Map<String, String> key,
        double growth,
        String benchmark,
        Map<String, String> parameters,
        int skipped,
        int steps,
        double firstGuess) {
    /** What costs about the same by n: its first runs tell how long its later ones take. */
    static String family(Kind kind, Map<String, String> row) {
        List<String> sizes = List.of("n", "bytes", "steps", kind == Kind.STRATEGIES ? "mode" : "");
        return kind.keys().stream()
                .filter(column -> !sizes.contains(column))
                .map(row::get)
                .collect(Collectors.joining(" ", kind + " ", ""));
    }

    String family() {
        return family(kind, key);
    }

    /** Size: number of circles, or bytes. */
    long n() {
        return Long.parseLong(key.containsKey("n") ? key.get("n") : key.get("bytes"));
    }

    /**
     * Seconds of a run beside its steps: a World is put back, and its end checked; or the host writes the look-up table, slot by
     * slot.
     */
    double setUpSeconds() {
        if (kind == Kind.WORLD) {
            return 6e-7 * n();
        }
        return "LOOKUP_TABLE".equals(parameters.get("indexing")) ? 2.5e-9 * n() * (n() - 1) / 2 : 0;
    }

    /** For the progress line. */
    String label() {
        return String.join(" ", key.values());
    }

    /** A row of the table that has the key and a status. */
    Map<String, String> row(String status) {
        Map<String, String> row = new LinkedHashMap<>(key);
        row.putAll(Table.columns("status", status));
        return row;
    }
}
