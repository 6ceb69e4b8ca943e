package io.github.circles2d.bench.series;

import io.github.circles2d.bench.Devices;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.sweep.Machine;
import io.github.circles2d.opencl.Device;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;

/** Measures the series of a machine cell by cell, small sizes first, and keeps each figure as soon as it is known. */
public final class SeriesBench {
    /** A cell with less time than this is not begun. */
    private static final double LEAST_SECONDS = 3;

    private final SeriesOptions options;
    private final PrintStream out;
    private final long start = System.nanoTime();

    private SeriesBench(SeriesOptions options, PrintStream out) {
        this.options = options;
        this.out = out;
    }

    /**
     * Does what the command line asks.
     *
     * @throws IllegalArgumentException with a sentence for the user if it is wrong
     */
    public static void run(List<String> arguments, PrintStream out) throws IOException {
        SeriesOptions options = SeriesOptions.parse(arguments);
        if (options.help()) {
            out.println(SeriesOptions.HELP);
        } else if (options.write() != null) {
            SceneFiles.write(options, out);
        } else {
            new SeriesBench(options, out).run();
        }
    }

    private void run() throws IOException {
        Map<String, Device> devices = Devices.all();
        List<Cell> cells =
                cells(options, Contender.all(devices, Runtime.getRuntime().availableProcessors()));
        if (options.list()) {
            cells.forEach(out::println);
            return;
        }
        Path results = Path.of(Files.isDirectory(Path.of("bench")) ? "bench/results" : "results");
        ResultsFolder folder = ResultsFolder.open(
                options.folder() == null ? results.resolve(Machine.name(devices)) : options.folder());
        if (options.take() != null) {
            Outside.take(options.take(), folder, out);
            return;
        }
        if (folder.table(Kind.MACHINE).rows().isEmpty()) {
            for (Map.Entry<String, String> property :
                    Machine.properties(devices).entrySet()) {
                folder.put(Kind.MACHINE, Map.of("property", property.getKey(), "value", property.getValue()));
            }
        }
        cells.removeIf(cell -> options.missing() && folder.hasFigure(Kind.SERIES, cell.key()));
        out.println(cells.size() + " figures, in " + Numbers.brief(options.budgetSeconds() / 60)
                + " minutes at the most; results go to " + folder.path());
        for (Cell cell : cells) {
            out.print(cell + ": ");
            out.flush();
            out.println(measure(cell, folder));
        }
    }

    /** All cells: small sizes first, then series by series. */
    static List<Cell> cells(SeriesOptions options, List<Contender> all) {
        TreeSet<Integer> sizes = new TreeSet<>();
        options.series().forEach(series -> sizes.addAll(options.sizes(series)));
        List<Cell> cells = new ArrayList<>();
        for (int n : sizes) {
            for (Series series : options.series()) {
                for (Contender who : all) {
                    if (options.sizes(series).contains(n) && options.wants(who, n)) {
                        cells.add(new Cell(who, series, n));
                    }
                }
            }
        }
        return cells;
    }

    private String measure(Cell cell, ResultsFolder folder) throws IOException {
        double left = options.budgetSeconds() - (System.nanoTime() - start) / 1e9;
        Map<String, String> figures = left < LEAST_SECONDS
                ? Map.of("status", "left out: the time was up")
                : SeriesProcess.measure(cell, Math.min(options.patience(), left));
        String status = figures.get("status");
        boolean ok = status.equals("ok");
        if (!ok && folder.hasFigure(Kind.SERIES, cell.key())) {
            return status + "; the earlier figure stays";
        }
        Map<String, String> row = new LinkedHashMap<>(cell.key());
        row.put("skipped", Integer.toString(cell.series().skipped));
        row.put("steps", Integer.toString(cell.series().steps()));
        row.putAll(figures);
        row.put("date", LocalDate.now(ZoneOffset.UTC).toString());
        row.put("remarks", Engines.remarks(cell.who().engine()));
        folder.put(Kind.SERIES, row);
        return ok
                ? Numbers.brief(Numbers.parse(row.get("median_ms"))) + " ms, mean depth "
                        + Numbers.brief(Numbers.parse(row.get("mean_depth")))
                : status;
    }
}
