package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.engines.Engine;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.opencl.DeviceMemoryException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.logging.Level;
import java.util.logging.Logger;

/**
 * A figure of the series by a {@link Stopwatch} in a JVM of its own, with the class path of this one: so no engine warms another up, or
 * takes its memory. That JVM writes the row, a column a line; other lines are whatever engines write.
 */
record SeriesWork(Task task, double patience, ResultsFolder folder) implements Work {
    /** With less time than this it is not begun. */
    private static final double LEAST_SECONDS = 3;

    /** For the JVM, the scene, and the kernels of a device that has not compiled them yet. */
    private static final double START_SECONDS = 60;

    /** Begins a line with a column: name, a space, value. */
    private static final String MARK = "circles2d-series: ";

    /** Held, or it would be forgotten with its level. */
    private static final Logger LIBRARY_LOG = Logger.getLogger("io.github.circles2d");

    @Override
    public String label() {
        return task.label();
    }

    @Override
    public double seconds(Pace pace) {
        return Math.min(patience, Math.max(LEAST_SECONDS, pace.seconds(task, Stopwatch.RUNS)));
    }

    @Override
    public String run(Pace pace, double secondsLeft) throws IOException {
        long before = System.nanoTime();
        Map<String, String> figures = secondsLeft < LEAST_SECONDS
                ? Map.of("status", "left out: the time was up")
                : measure(Math.min(patience, secondsLeft));
        String status = figures.get("status");
        boolean ok = status.equals("ok");
        if (!ok && folder.hasFigure(task.kind(), task.key())) {
            return status + "; the earlier figure stays";
        }
        Map<String, String> row = task.row(status);
        row.put("skipped", Integer.toString(task.skipped()));
        row.put("steps", Integer.toString(task.steps()));
        row.putAll(figures);
        row.put("date", LocalDate.now(ZoneOffset.UTC).toString());
        row.put("remarks", Engines.remarks(row.get("engine")));
        folder.put(task.kind(), row);
        if (ok) {
            double seconds = (System.nanoTime() - before) / 1e9;
            pace.learn(task, Numbers.parse(row.get("median_ms")), seconds, Integer.parseInt(row.get("runs")));
        }
        return ok
                ? Numbers.brief(row.get("median_ms")) + " ms, mean depth " + Numbers.brief(row.get("mean_depth"))
                : status;
    }

    private Map<String, String> measure(double seconds) throws IOException {
        Path log = Files.createTempFile("circles2d-series", ".log");
        try {
            Process process = new ProcessBuilder(command(seconds))
                    .redirectErrorStream(true)
                    .redirectOutput(log.toFile())
                    .start();
            Thread withThisOne = new Thread(process::destroyForcibly);
            Runtime.getRuntime().addShutdownHook(withThisOne);
            try {
                long limit = (long) Math.ceil(2 * seconds + START_SECONDS);
                if (!process.waitFor(limit, TimeUnit.SECONDS)) {
                    process.destroyForcibly().waitFor();
                    return Map.of("status", "left out: no figure after " + limit + " s");
                }
            } catch (InterruptedException e) {
                process.destroyForcibly();
                Thread.currentThread().interrupt();
                return Map.of("status", "left out: interrupted");
            }
            Runtime.getRuntime().removeShutdownHook(withThisOne);
            return row(Files.readString(log, StandardCharsets.UTF_8), process.exitValue());
        } finally {
            Files.delete(log);
        }
    }

    private List<String> command(double seconds) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        if (Runtime.version().feature() >= 22) {
            command.add("--enable-native-access=ALL-UNNAMED");
        }
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), SeriesWork.class.getName()));
        for (String column : List.of("engine", "threads", "series", "n")) {
            command.add(task.key().get(column));
        }
        command.add(Double.toString(seconds));
        return command;
    }

    /** The row in what a run has written. */
    static Map<String, String> row(String log, int exit) {
        Map<String, String> row = new LinkedHashMap<>();
        log.lines().filter(line -> line.startsWith(MARK)).forEach(line -> {
            String[] column = line.substring(MARK.length()).split(" ", 2);
            row.put(column[0], column[1]);
        });
        row.putIfAbsent("status", "failed: the JVM ended with exit code " + exit);
        return row;
    }

    /**
     * Measures one figure and writes it.
     *
     * @param arguments engine, threads, series, n, seconds of patience
     */
    public static void main(String[] arguments) {
        LIBRARY_LOG.setLevel(Level.SEVERE);
        figures(arguments).forEach((column, value) -> System.out.println(MARK + column + " " + value));
        System.out.flush();
        // OpenCL drivers have threads that would go on.
        System.exit(0);
    }

    private static Map<String, String> figures(String[] arguments) {
        try (Engine engine = new Contender(arguments[0], arguments[1]).create()) {
            return Stopwatch.measure(
                    Series.titled(arguments[2]),
                    Integer.parseInt(arguments[3]),
                    engine,
                    Double.parseDouble(arguments[4]));
        } catch (DeviceMemoryException | OutOfMemoryError e) {
            return Map.of("status", "does not fit: " + said(e));
        } catch (RuntimeException | LinkageError e) {
            return Map.of("status", "failed: " + said(e));
        }
    }

    private static String said(Throwable e) {
        return (e.getClass().getSimpleName() + ": " + e.getMessage())
                .lines()
                .findFirst()
                .orElseThrow();
    }
}
