package io.github.circles2d.bench.sweep;

import io.github.circles2d.bench.results.ResultsFolder;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One JMH run: a benchmark with one set of parameters.
 *
 * @param kind the table that its result goes to
 * @param key the columns of that table which name it
 * @param series what costs about the same by n: its first runs tell how long its later ones take
 * @param n size: number of circles, or bytes
 * @param growth exponent with which its time grows with n
 * @param benchmark full name of the benchmark method
 * @param parameters its JMH parameters
 * @param skipped steps of an iteration that do not count
 * @param steps steps of an iteration that count
 * @param firstGuess ms a step, for as long as the series has not run
 */
record Task(
        ResultsFolder.Kind kind,
        Map<String, String> key,
        String series,
        long n,
        double growth,
        String benchmark,
        Map<String, String> parameters,
        int skipped,
        int steps,
        double firstGuess) {

    /**
     * Seconds of an iteration beside its steps: a World is put back, and its end checked; or the host writes the look-up
     * table, slot by slot.
     */
    double setUpSeconds() {
        if (kind == ResultsFolder.Kind.WORLD) {
            return 6e-7 * n;
        }
        return "LOOKUP_TABLE".equals(parameters.get("indexing")) ? 2.5e-9 * n * (n - 1) / 2 : 0;
    }

    /** For the progress line. */
    String label() {
        return String.join(" ", key.values());
    }

    /** A row of the table that has the key and a status. */
    Map<String, String> row(String status) {
        Map<String, String> row = new LinkedHashMap<>(key);
        row.put("status", status);
        return row;
    }
}
