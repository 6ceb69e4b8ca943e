package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.calibration.Curve;
import io.github.circles2d.opencl.Device;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * What a calibration would pick on the machines of the benchmark page: it is given the committed figures nearest to the sizes at
 * which it measures, and its picks are held against all others.
 */
class CalibrationFiguresTest {
    private static final Path RESULTS = Path.of("bench/results");
    private static final double ALLOWED = 1.1;

    @Test
    void theIndexingPickedIsWithinTenPercentOfTheBestAtEveryMeasuredSize() throws IOException {
        int compared = 0;
        for (Map.Entry<String, Map<String, NavigableMap<Integer, Double>>> device : loops().entrySet()) {
            Map<PairIndexing, Curve> calibrated = new LinkedHashMap<>();
            for (PairIndexing indexing : IndexingChoice.CANDIDATES) {
                calibrated.put(indexing, calibrated(device.getValue().get(indexing.name())));
            }
            for (int n : sizesToCompare(device.getValue())) {
                PairIndexing pick = IndexingChoice.of(calibrated, Device.Kind.GPU, n, indexing -> true)
                        .indexing();
                requireNearBest(device.getKey(), n, pick.name(), device.getValue());
                compared++;
            }
        }
        assertThat(compared).isGreaterThan(15);
    }

    @Test
    void theRuleForIndexingsIsWithinTenPercentOfTheBestTooAtEveryMeasuredSize() throws IOException {
        for (Map.Entry<String, Map<String, NavigableMap<Integer, Double>>> device : loops().entrySet()) {
            Device.Kind kind = device.getKey().startsWith("cpu") ? Device.Kind.CPU : Device.Kind.GPU;
            for (int n : sizesToCompare(device.getValue())) {
                IndexingChoice choice = IndexingChoice.of(Map.of(), kind, n, indexing -> true);
                assertThat(choice.reason()).contains("not calibrated");
                requireNearBest(device.getKey(), n, choice.indexing().name(), device.getValue());
            }
        }
    }

    /** The figures at the sizes that are nearest, as a ratio, to those of a calibration. */
    private static Curve calibrated(NavigableMap<Integer, Double> figures) {
        Map<Integer, Double> taken = new HashMap<>();
        for (int size : Calibration.SIZES) {
            int nearest = figures.keySet().stream()
                    .min(Comparator.comparing(n -> Math.abs(Math.log((double) n / size))))
                    .orElseThrow();
            taken.put(nearest, figures.get(nearest));
        }
        return new Curve(taken);
    }

    /** The sizes at which every candidate was measured: what was left out cannot be compared. */
    private static List<Integer> sizesToCompare(Map<String, NavigableMap<Integer, Double>> candidates) {
        TreeSet<Integer> sizes = new TreeSet<>();
        candidates.values().forEach(figures -> sizes.addAll(figures.keySet()));
        candidates.values().forEach(figures -> sizes.retainAll(figures.keySet()));
        return List.copyOf(sizes);
    }

    private static void requireNearBest(
            String where, int n, String pick, Map<String, NavigableMap<Integer, Double>> candidates) {
        double best = candidates.values().stream()
                .filter(figures -> figures.containsKey(n))
                .mapToDouble(figures -> figures.get(n))
                .min()
                .orElseThrow();
        assertThat(candidates.get(pick).get(n))
                .as("ms of %s for %d circles on %s; the best takes %s", pick, n, where, best)
                .isNotNull()
                .isLessThanOrEqualTo(ALLOWED * best);
    }

    /** Mean ms of a loop by device (its name begins with what it is), indexing and n: all four, also the one that is never picked. */
    private static Map<String, Map<String, NavigableMap<Integer, Double>>> loops() throws IOException {
        Map<String, Map<String, NavigableMap<Integer, Double>>> loops = new TreeMap<>();
        for (String machine : machines()) {
            for (Map<String, String> row : rows(machine, "strategies.csv")) {
                if (row.get("mode").equals("loop")) {
                    put(
                            loops,
                            row.get("device") + " of " + machine,
                            PairIndexing.ofStrategy(Integer.parseInt(row.get("strategy")))
                                    .name(),
                            row);
                }
            }
        }
        assertThat(loops).hasSizeGreaterThanOrEqualTo(3);
        return loops;
    }

    private static void put(
            Map<String, Map<String, NavigableMap<Integer, Double>>> figures,
            String where,
            String candidate,
            Map<String, String> row) {
        if (!row.get("mean_ms").isEmpty()) {
            figures.computeIfAbsent(where, key -> new LinkedHashMap<>())
                    .computeIfAbsent(candidate, key -> new TreeMap<>())
                    .put(Integer.valueOf(row.get("n")), Double.valueOf(row.get("mean_ms")));
        }
    }

    private static List<String> machines() throws IOException {
        return Files.readAllLines(RESULTS.resolve("machines.txt"));
    }

    /** Rows of a table; commas in quotes come behind all columns that are read here. */
    private static List<Map<String, String>> rows(String machine, String table) throws IOException {
        List<String> lines = Files.readAllLines(RESULTS.resolve(machine).resolve(table));
        String[] columns = lines.get(0).split(",", -1);
        List<Map<String, String>> rows = new ArrayList<>();
        for (String line : lines.subList(1, lines.size())) {
            String[] cells = line.split(",", -1);
            Map<String, String> row = new HashMap<>();
            for (int k = 0; k < columns.length && k < cells.length; k++) {
                row.put(columns[k], cells[k]);
            }
            rows.add(row);
        }
        return rows;
    }
}
