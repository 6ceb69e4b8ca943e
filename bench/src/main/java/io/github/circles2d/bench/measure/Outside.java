package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.engines.Motion;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import io.github.circles2d.scenes.Scene;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Takes the figures of an engine outside Maven. Its list has a line a run: engine, series, n, threads, run, the median and the mean
 * of the steps that count in ms, the file of the end state, the date, and what the engine is: its version and commit, the
 * compiler's flags, its settings.
 */
public final class Outside {
    /** Begins the remarks of every such row. */
    public static final String MARK = "outside Maven: ";

    private static final List<String> KEY = List.of("engine", "series", "n", "threads", "run");

    private static final List<String> KEY_OF_ROW = KEY.subList(0, 4);

    private static final List<String> VALUES = List.of("median_ms", "mean_ms", "state", "date", "made_with");

    private Outside() {}

    static void take(Path file, ResultsFolder folder, PrintStream out) throws IOException {
        Table list = read(file);
        Map<List<String>, List<Map<String, String>>> cells = new LinkedHashMap<>();
        for (Map<String, String> run : list.rows()) {
            cells.computeIfAbsent(KEY_OF_ROW.stream().map(run::get).toList(), key -> new ArrayList<>())
                    .add(run);
        }
        for (List<Map<String, String>> runs : cells.values()) {
            Map<String, String> row = row(runs, file);
            folder.put(Kind.SERIES, row);
            out.println(row.get("engine") + " " + row.get("series") + " " + row.get("n") + " on " + row.get("threads")
                    + ": " + row.get("median_ms") + " ms, mean depth " + row.get("mean_depth"));
        }
    }

    private static Table read(Path file) throws IOException {
        String text = Files.readString(file, StandardCharsets.UTF_8);
        String header = text.lines().findFirst().orElse("");
        List<String> all = new ArrayList<>(KEY);
        all.addAll(VALUES);
        if (!header.equals(String.join(",", all))) {
            throw new IllegalArgumentException(
                    file + " must begin with the line " + String.join(",", all) + ", not with " + header);
        }
        return Table.parse(text, KEY);
    }

    private static Map<String, String> row(List<Map<String, String>> runs, Path file) throws IOException {
        Map<String, String> first = runs.get(0);
        Series series = Series.titled(first.get("series"));
        Scene scene = series.scene(Integer.parseInt(first.get("n")));
        Motion end = SceneFiles.endState(file.toAbsolutePath().resolveSibling(first.get("state")), scene.size());
        Map<String, String> row = new LinkedHashMap<>();
        KEY_OF_ROW.forEach(column -> row.put(column, first.get(column)));
        row.put("skipped", Integer.toString(series.skipped));
        row.put("steps", Integer.toString(Series.STEPS));
        EndState.put(row, scene, end);
        Stopwatch.putTimes(
                row,
                runs.stream().map(run -> Double.valueOf(run.get("median_ms"))).toList(),
                runs.stream()
                        .mapToDouble(run -> Double.parseDouble(run.get("mean_ms")))
                        .min()
                        .orElseThrow());
        row.put("date", first.get("date"));
        row.put("status", "ok");
        row.put("remarks", MARK + first.get("made_with"));
        return row;
    }
}
