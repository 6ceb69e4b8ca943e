package io.github.circles2d.bench.results;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.openjdk.jmh.results.RunResult;

/** The results of one machine: the tables and the JMH JSON of a folder. What a new run does not measure stays. */
public final class ResultsFolder {
    /** The status of what was not tried because less of the same did not fit into the device's memory. */
    public static final String SMALLER_DOES_NOT_FIT = "does not fit: a smaller size does not";

    private static final String TIMES = "runs mean_ms se_ms min_ms median_ms ";

    private static final String PROCESS = "allocated_bytes peak_rss_mib ";

    /** The tables of a folder: the columns that tell rows apart, and the others. */
    public enum Kind {
        /** What the machine is, and how it was measured: a name and a value a row. */
        MACHINE("property", "value"),
        /** Copy bandwidth by device and size. */
        COPY("device bytes", TIMES + "gb_per_s status"),
        /** Wrong slots of the computed indexing by device and n. */
        ACCURACY("device n", "circles slots wrong_slots status"),
        /** The strategies by device, indexing, n and mode. */
        STRATEGIES(
                "device strategy n mode",
                "indexing steps " + TIMES + "update_us detect_us resolve_us collision_bytes table_bytes " + PROCESS
                        + "status"),
        /** Kernel time against the time that its bytes take at the copy bandwidth. */
        ROOF("device strategy n", "moved_bytes copy_gb_per_s roof_ms kernels_ms share_of_roof"),
        /** Engines by scene and n. */
        PEERS(
                "engine scene n steps",
                "skipped " + TIMES + "mean_depth max_depth overlapping_pairs deep_pairs kinetic_energy " + PROCESS
                        + "status remarks"),
        /** World by engine, n, and what is done beside the steps. */
        WORLD(
                "engine n mode",
                "skipped steps " + TIMES
                        + "grid_us scan_us sweep_us contacts_us solver_us resident_us other_us contacts"
                        + " candidate_pairs mean_depth max_depth deep_pairs kinetic_energy bytes_held " + PROCESS
                        + "state_hash status"),
        /** World's stages against the time that their bytes take at the copy bandwidth. */
        WORLD_STAGES("engine n stage", "time_us moved_bytes copy_gb_per_s roof_us share_of_roof"),
        /** Transfers between host and device by the kind of the host's memory. */
        TRANSFER("device direction memory bytes", TIMES + "gb_per_s status"),
        /** World and other engines by series and n: a step with a wait after it. */
        SERIES(
                "engine series n threads",
                "skipped steps runs median_ms middle_median_ms mean_ms mean_depth max_depth deep_pairs kinetic_energy"
                        + " outside state_hash date status remarks"),
        /** World on the JVM and in WebAssembly, and engines for JavaScript, by n: a step on one thread. */
        WEB(
                "engine runs_in n",
                "skipped steps runs median_us middle_median_us mean_us mean_depth max_depth deep_pairs kinetic_energy outside"
                        + " state_hash date status remarks"),
        /** Broad phases by scene and n: processor time of one thread, and work, both a step. */
        BROADPHASE("scene n broad_phase", "motion_radii " + TIMES + "pairs tests swaps nodes estimated_bytes");

        private final List<String> keys;
        private final List<String> columns;

        Kind(String keys, String values) {
            this.keys = List.of(keys.split(" "));
            columns = List.of((keys + " " + values).split(" "));
        }

        /** The columns that tell rows apart. */
        public List<String> keys() {
            return keys;
        }

        Table empty() {
            return new Table(keys, columns);
        }

        /** The name of the file. */
        public String file() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-') + ".csv";
        }
    }

    private static final String JSON = "jmh.json";

    private final Path path;
    private final Map<Kind, Table> tables = new EnumMap<>(Kind.class);
    private final JmhJson json;
    private boolean sealed;

    private ResultsFolder(Path path, JmhJson json) {
        this.path = path;
        this.json = json;
    }

    /** Opens a folder with whatever is in it; one that is not there counts as empty. */
    public static ResultsFolder open(Path path) throws IOException {
        ResultsFolder folder = new ResultsFolder(path, JmhJson.read(path.resolve(JSON)));
        for (Kind kind : Kind.values()) {
            Path file = path.resolve(kind.file());
            folder.tables.put(kind, Files.exists(file) ? Table.read(file, kind.empty()) : kind.empty());
        }
        return folder;
    }

    /** Where the folder is. */
    public Path path() {
        return path;
    }

    /** The folder's name, which is the machine's. */
    public String name() {
        return path.getFileName().toString();
    }

    /** A table of the folder. */
    public Table table(Kind kind) {
        return tables.get(kind);
    }

    /** Whether a table has a figure for a key: its columns and their values. */
    public boolean hasFigure(Kind kind, Map<String, String> key) {
        return table(kind).rows("status", "ok").stream()
                .anyMatch(row -> row.entrySet().containsAll(key.entrySet()));
    }

    /** Keeps a row and writes its file; does nothing once the folder is sealed. */
    public synchronized void put(Kind kind, Map<String, String> row) throws IOException {
        if (sealed) {
            return;
        }
        table(kind).put(row);
        Files.createDirectories(path);
        table(kind).save(path.resolve(kind.file()));
    }

    /** Forgets the rows of a table that follows from others, before they are written anew; the file stays until then. */
    public synchronized void clear(Kind derived) {
        tables.put(derived, derived.empty());
    }

    /** Keeps a run for the JSON and writes it; does nothing once the folder is sealed. */
    public synchronized void put(RunResult result) throws IOException {
        if (sealed) {
            return;
        }
        json.put(result);
        Files.createDirectories(path);
        json.save(path.resolve(JSON));
    }

    /** Takes no more results: what a run that is being killed reports is not one. */
    public synchronized void seal() {
        sealed = true;
    }

    /** Whether {@link #seal} was called. */
    public synchronized boolean sealed() {
        return sealed;
    }

    /** What is known of a property of the machine, or an empty text. */
    public String machine(String property) {
        Map<String, String> row = table(Kind.MACHINE).row("property", property);
        return row == null ? "" : row.get("value");
    }
}
