package io.github.circles2d.bench.series;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** Measures a cell in a JVM of its own, with the class path of this one: so no engine warms another up, or takes its memory. */
final class SeriesProcess {
    /** For the JVM, the scene, and the kernels of a device that has not compiled them yet. */
    private static final double START_SECONDS = 60;

    private SeriesProcess() {}

    /**
     * Measures a cell.
     *
     * @param patience see {@link Stopwatch}
     * @return columns of the table, a status among them
     */
    static Map<String, String> measure(Cell cell, double patience) throws IOException {
        Path log = Files.createTempFile("circles2d-series", ".log");
        try {
            Process process = new ProcessBuilder(command(cell, patience))
                    .redirectErrorStream(true)
                    .redirectOutput(log.toFile())
                    .start();
            Thread withThisOne = new Thread(process::destroyForcibly);
            Runtime.getRuntime().addShutdownHook(withThisOne);
            try {
                long limit = (long) Math.ceil(2 * patience + START_SECONDS);
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

    private static List<String> command(Cell cell, double patience) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        if (Runtime.version().feature() >= 22) {
            command.add("--enable-native-access=ALL-UNNAMED");
        }
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), SeriesRun.class.getName()));
        command.addAll(List.of(cell.who().engine(), cell.who().threads(), cell.series().title));
        command.addAll(List.of(Integer.toString(cell.n()), Double.toString(patience)));
        return command;
    }

    /** The row in what a run has written. */
    static Map<String, String> row(String log, int exit) {
        Map<String, String> row = new LinkedHashMap<>();
        log.lines().filter(line -> line.startsWith(SeriesRun.MARK)).forEach(line -> {
            String column = line.substring(SeriesRun.MARK.length());
            int space = column.indexOf(' ');
            row.put(column.substring(0, space), column.substring(space + 1));
        });
        if (!row.containsKey("status")) {
            row.put("status", "failed: the JVM ended with exit code " + exit);
        }
        return row;
    }
}
