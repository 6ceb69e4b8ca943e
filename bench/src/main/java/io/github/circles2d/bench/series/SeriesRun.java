package io.github.circles2d.bench.series;

import io.github.circles2d.bench.engines.Engine;
import io.github.circles2d.opencl.DeviceMemoryException;
import java.util.Map;
import java.util.logging.Level;
import java.util.logging.Logger;

/** The main class of the JVM that measures one cell. It writes the row, a column a line; other lines are whatever engines write. */
final class SeriesRun {
    /** Begins a line with a column: name, a space, value. */
    static final String MARK = "circles2d-series: ";

    /** Held, or it would be forgotten with its level. */
    private static final Logger LIBRARY_LOG = Logger.getLogger("io.github.circles2d");

    private SeriesRun() {}

    /**
     * Measures one cell.
     *
     * @param arguments engine, threads, series, n, seconds of patience
     */
    public static void main(String[] arguments) {
        LIBRARY_LOG.setLevel(Level.SEVERE);
        row(arguments).forEach((column, value) -> System.out.println(MARK + column + " " + value));
        System.out.flush();
        // OpenCL drivers have threads that would go on.
        System.exit(0);
    }

    private static Map<String, String> row(String[] arguments) {
        Contender who = new Contender(arguments[0], arguments[1]);
        try (Engine engine = who.create()) {
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
