package io.github.circles2d.bench.broadphase;

import io.github.circles2d.bench.Devices;
import io.github.circles2d.bench.measure.Machine;
import io.github.circles2d.bench.report.BroadPhaseCharts;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Statistics;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Measures all broad phases on all scenes, prints each figure as soon as it is known, and keeps it. */
public final class BroadPhaseBench {
    /** In place of a broad phase: a whole step of World, on one thread. */
    static final String WORLD_STEP = "world-step";

    /** The same without continuous collision and solver. */
    static final String WORLD_FINDING = "world-finding";

    /** Steps from the start of a scene, in which overlaps come apart. */
    private static final int SKIPPED = 60;

    /** Fewer in crowds whose steps take long. */
    private static final int SKIPPED_OF_MANY = 10;

    private static final int MANY = 300_000;

    private final BroadPhaseOptions options;
    private final ResultsFolder folder;
    private final PrintStream out;

    private BroadPhaseBench(BroadPhaseOptions options, PrintStream out) throws IOException {
        this.options = options;
        this.out = out;
        folder = ResultsFolder.open(options.out());
    }

    /**
     * Runs {@link #run} alone, so that this package can be tried without the other benchmarks.
     *
     * @param arguments see {@code --help}
     */
    public static void main(String[] arguments) throws IOException {
        System.setProperty("java.awt.headless", "true");
        try {
            run(List.of(arguments), System.out);
        } catch (IllegalArgumentException e) {
            System.err.println(e.getMessage());
            System.exit(2);
        }
    }

    /**
     * Runs what the arguments ask for.
     *
     * @throws IllegalArgumentException with a sentence for the user if they are wrong
     */
    public static void run(List<String> arguments, PrintStream out) throws IOException {
        BroadPhaseOptions options = BroadPhaseOptions.parse(arguments);
        if (options.help()) {
            out.println(BroadPhaseOptions.HELP);
            return;
        }
        BroadPhaseBench bench = new BroadPhaseBench(options, out);
        if (options.page() == null) {
            bench.measure();
        }
        BroadPhaseCharts.draw(bench.folder, out);
        if (options.page() != null) {
            Files.writeString(options.page(), BroadPhasePage.of(bench.folder));
            out.println("wrote " + options.page());
        }
    }

    private void measure() throws IOException {
        if (folder.table(Kind.MACHINE).rows().isEmpty()) {
            for (Map.Entry<String, String> property :
                    Machine.properties(onDevice() ? Devices.all() : Map.of()).entrySet()) {
                folder.put(Kind.MACHINE, Map.of("property", property.getKey(), "value", property.getValue()));
            }
        }
        out.printf(
                Locale.ROOT,
                "%-10s %9s %-18s %10s %9s %9s%n",
                "scene",
                "n",
                "broad phase",
                "ms a step",
                "pairs/n",
                "tests/n");
        // World is measured first: its steps have to be compiled before.
        new Track(Crowds.PACKED.of(1250), 600, 2);
        for (int n : options.sizes()) {
            for (Crowds scene : options.scenes()) {
                if (n < MANY || scene.large) {
                    measure(scene, n);
                }
            }
        }
    }

    private void measure(Crowds scene, int n) throws IOException {
        int untimed = n >= MANY ? 4 : 10;
        int timed = n >= MANY ? 3 : n >= 50_000 ? 10 : 30;
        Track track = new Track(scene.of(n), n >= MANY ? SKIPPED_OF_MANY : SKIPPED, untimed + timed);
        if (onDevice()) {
            measureOnDevice(scene, track);
        } else {
            measure(scene, track, untimed);
        }
    }

    private boolean onDevice() {
        return !options.device().isEmpty();
    }

    private void measureOnDevice(Crowds scene, Track track) throws IOException {
        DeviceMeasurement result = DeviceMeasurement.of(Devices.find(options.device()), track);
        Map<String, String> row = start(scene, track);
        row.put("broad_phase", BroadPhases.SWEEP_SUBDIVIDED.title + "@" + options.device());
        put(row, result.millis());
        row.put("pairs", Numbers.exact(result.pairs()));
        keep(row, Numbers.brief(result.pairs() / track.size()), "");
    }

    private static Map<String, String> start(Crowds scene, Track track) {
        Map<String, String> start = new LinkedHashMap<>();
        start.put("scene", scene.title);
        start.put("n", Integer.toString(track.size()));
        start.put("motion_radii", Numbers.exact(track.motion));
        return start;
    }

    private void measure(Crowds scene, Track track, int untimed) throws IOException {
        int n = track.size();
        Map<String, String> start = start(scene, track);
        put(start, WORLD_STEP, track.worldMillis);
        put(start, WORLD_FINDING, track.worldFindingMillis);
        Long checksum = null;
        for (BroadPhases kind : options.kinds()) {
            if (n > kind.greatest && !options.asksFor(kind)) {
                continue;
            }
            Measurement result = Measurement.of(kind, track, untimed, options.seconds());
            if (checksum != null && checksum != result.checksum()) {
                throw new IllegalStateException(kind.title + " finds other pairs than those before it in " + scene.title
                        + " with " + n + " circles");
            }
            checksum = result.checksum();
            put(start, kind, result);
        }
    }

    private void put(Map<String, String> start, String name, double millis) throws IOException {
        Map<String, String> row = new LinkedHashMap<>(start);
        row.put("broad_phase", name);
        row.put("median_ms", Numbers.exact(millis));
        keep(row, "", "");
    }

    private void put(Map<String, String> start, BroadPhases kind, Measurement result) throws IOException {
        double n = Double.parseDouble(start.get("n"));
        double steps = result.steps();
        Map<String, String> row = new LinkedHashMap<>(start);
        row.put("broad_phase", kind.title);
        put(row, result.millis());
        row.put("pairs", Numbers.exact(result.pairs() / steps));
        row.put("tests", Numbers.exact(result.work().tests / steps));
        if (!kind.isPeer()) {
            row.put("swaps", Numbers.exact(result.work().swaps / steps));
            row.put("nodes", Numbers.exact(result.work().nodes / steps));
            row.put("estimated_bytes", Numbers.exact(result.work().bytes / steps));
        }
        keep(row, Numbers.brief(result.pairs() / steps / n), Numbers.brief(result.work().tests / steps / n));
    }

    private static void put(Map<String, String> row, Statistics millis) {
        row.put("runs", Integer.toString(millis.runs()));
        row.put("mean_ms", Numbers.exact(millis.mean()));
        row.put("se_ms", Numbers.exact(millis.standardError()));
        row.put("min_ms", Numbers.exact(millis.min()));
        row.put("median_ms", Numbers.exact(millis.median()));
    }

    private void keep(Map<String, String> row, String pairs, String tests) throws IOException {
        folder.put(Kind.BROADPHASE, row);
        out.printf(
                Locale.ROOT,
                "%-10s %,9d %-18s %10s %9s %9s%n",
                row.get("scene"),
                Integer.parseInt(row.get("n")),
                row.get("broad_phase"),
                row.get("median_ms"),
                pairs,
                tests);
    }
}
