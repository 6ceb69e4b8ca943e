package io.github.circles2d.bench.broadphase;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import java.util.List;
import java.util.Map;

/** The figures of a results folder by scene, n and broad phase. */
final class BroadPhaseFigures {
    private final Table table;

    BroadPhaseFigures(ResultsFolder folder) {
        table = folder.table(Kind.BROADPHASE);
    }

    /** NaN if it is not known. */
    double of(String column, String scene, String n, String name) {
        List<Map<String, String>> rows = table.rows("scene", scene, "n", n, "broad_phase", name);
        return rows.isEmpty() ? Double.NaN : Numbers.parse(rows.get(0).get(column));
    }

    /** Two digits; a dash if it is not known. */
    String brief(String column, String scene, String n, String name) {
        return Numbers.brief(of(column, scene, n, name));
    }

    String perCircle(String column, String scene, String n, String name) {
        return Numbers.brief(of(column, scene, n, name) / Double.parseDouble(n));
    }

    /** How many times as long the first takes as the second. */
    String ratio(String scene, String n, String name, String other) {
        return Numbers.brief(of("median_ms", scene, n, name) / of("median_ms", scene, n, other));
    }

    boolean has(String scene, String n) {
        return !table.rows("scene", scene, "n", n).isEmpty();
    }

    /** The numbers of circles of a scene, in the order in which they were measured. */
    List<String> sizes(String scene) {
        return table.rows("scene", scene).stream()
                .map(row -> row.get("n"))
                .distinct()
                .toList();
    }

    /** The fastest of the library's own; null if there is none. */
    BroadPhases fastest(String scene, String n) {
        BroadPhases best = null;
        for (BroadPhases kind : BroadPhases.values()) {
            double millis = of("median_ms", scene, n, kind.title);
            if (!kind.isPeer()
                    && !Double.isNaN(millis)
                    && (best == null || millis < of("median_ms", scene, n, best.title))) {
                best = kind;
            }
        }
        return best;
    }
}
