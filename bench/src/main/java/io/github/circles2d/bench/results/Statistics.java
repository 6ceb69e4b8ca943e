package io.github.circles2d.bench.results;

import java.util.Arrays;

/** Mean, standard error of the mean, minimum and median of some runs. */
public record Statistics(int runs, double mean, double standardError, double min, double median) {
    /** Of at least one value. With one alone the standard error is not known: NaN. */
    public static Statistics of(double... values) {
        int n = values.length;
        if (n == 0) {
            throw new IllegalArgumentException("no values");
        }
        double mean = Arrays.stream(values).average().orElseThrow();
        double squares = Arrays.stream(values).map(v -> (v - mean) * (v - mean)).sum();
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        double median = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
        return new Statistics(n, mean, n == 1 ? Double.NaN : Math.sqrt(squares / (n - 1) / n), sorted[0], median);
    }
}
