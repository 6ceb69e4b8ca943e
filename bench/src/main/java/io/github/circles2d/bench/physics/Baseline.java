package io.github.circles2d.bench.physics;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;

/** The figures of row 18 before the physics was tuned against this table: none may be worse by more than a tenth. */
final class Baseline {
    /** The row of the table that it bounds. */
    static final int ROW = 18;

    static final List<String> KEYS = List.of("scene", "figure");
    static final List<String> COLUMNS = List.of("scene", "figure", "value");

    private static final String FILE = "/io/github/circles2d/bench/physics-baseline.csv";
    private static final double WORSE = 1.1;
    private static final Table FIGURES = read();

    private Baseline() {}

    /**
     * A measure for which less is better.
     *
     * @param good a figure up to this is good enough, whatever it was before
     */
    static Measure measure(String scene, String what, double good) {
        List<Map<String, String>> found = FIGURES.rows("scene", scene, "figure", what);
        double before = found.isEmpty() ? 0 : Numbers.parse(found.get(0).get("value"));
        return Measure.atMost(what, Math.max(WORSE * before, good));
    }

    /** A figure as a row of the file. */
    static Map<String, String> row(Figure figure) {
        return Map.of(
                "scene", figure.scene().name(),
                "figure", figure.measure().what(),
                "value", Numbers.exact(figure.median()));
    }

    private static Table read() {
        try (InputStream file = Baseline.class.getResourceAsStream(FILE)) {
            if (file == null) {
                throw new IllegalStateException("the file " + FILE + " is missing");
            }
            return Table.parse(new String(file.readAllBytes(), StandardCharsets.UTF_8), KEYS);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
