package io.github.circles2d.bench.sweep;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** What the command line asks of a sweep. */
public final class Options {
    /** The parts of a sweep, in the order in which they run. */
    public enum Part {
        /** Copy bandwidth of every device. */
        COPY,
        /** Wrong slots of the computed indexing. */
        ACCURACY,
        /** The thesis's strategies. */
        STRATEGIES,
        /** Transfers between host and device. */
        TRANSFER,
        /** World by back end, size and read-back. */
        WORLD,
        /** The engines on the same scenes. */
        PEERS
    }

    /** What {@code --help} prints. */
    public static final String HELP = String.join(
            "\n",
            "Measures the strategies of the thesis and World on every OpenCL device, and other engines on the same scenes.",
            "",
            "usage: benchmarks.jar [OPTIONS]            runs the sweep",
            "       benchmarks.jar jmh ARGUMENTS        runs JMH itself (jmh -h for its help)",
            "       benchmarks.jar smoke                executes every benchmark once at its smallest size",
            "       benchmarks.jar physics ARGUMENTS    measures World's physics (physics --help for its help)",
            "       benchmarks.jar series ARGUMENTS     measures World and others on scenes at growing n (series --help)",
            "       benchmarks.jar games [BACKEND N...] measures what features for games cost World",
            "       benchmarks.jar table DIR            prints the table of a results folder",
            "       benchmarks.jar charts DIR           draws the charts of a results folder, or of all in DIR/machines.txt",
            "       benchmarks.jar page RESULTS PAGE    writes the results page from the folders in RESULTS",
            "",
            "  --quick              a short look, less than three minutes on two cores",
            "  --time-budget TIME   ends in about this time (90s, 9m, 2h); what does not fit is left out and named",
            "  --only PARTS         some of copy,accuracy,strategies,transfer,world,peers",
            "  --device NAMES       only these devices, by the names that --list prints",
            "  --engine NAMES       only these engines, such as world-jvm,gdx-box2d",
            "  --sizes NUMBERS      only these numbers of circles",
            "  --machine NAME       name of the results folder (default: processor, cores and graphics processor)",
            "  --out DIR            parent of the results folder (default: bench/results, or results; in it the folder quick",
            "                       for a short look)",
            "  --no-charts          writes no charts",
            "  --missing            only what has no figure yet in the results folder",
            "  --list               prints the devices and the runs that there would be",
            "",
            "A folder that is there is added to: what is measured again replaces what was there.");

    private boolean quick;
    private boolean list;
    private boolean help;
    private boolean missing;
    private boolean charts = true;
    private double budgetSeconds = Double.POSITIVE_INFINITY;
    private Set<Part> parts = EnumSet.allOf(Part.class);
    private List<String> devices = List.of();
    private List<String> engines = List.of();
    private List<Integer> sizes = List.of();
    private String machine = "";
    private Path out;

    private Options() {}

    /**
     * Reads the command line.
     *
     * @throws IllegalArgumentException with a sentence for the user where it is wrong
     */
    public static Options parse(List<String> arguments) {
        Options options = new Options();
        List<String> rest = new ArrayList<>(arguments);
        while (!rest.isEmpty()) {
            options.take(rest.remove(0), rest);
        }
        if (options.quick && options.budgetSeconds == Double.POSITIVE_INFINITY) {
            options.budgetSeconds = 165;
        }
        if (options.out == null) {
            Path results = Path.of(Files.isDirectory(Path.of("bench")) ? "bench/results" : "results");
            // A short look must not take the place of a sweep that is kept.
            options.out = options.quick ? results.resolve("quick") : results;
        }
        return options;
    }

    private void take(String option, List<String> rest) {
        switch (option) {
            case "--quick":
                quick = true;
                break;
            case "--list":
                list = true;
                break;
            case "--missing":
                missing = true;
                break;
            case "--no-charts":
                charts = false;
                break;
            case "--help":
            case "-h":
                help = true;
                break;
            case "--time-budget":
                budgetSeconds = seconds(value(option, rest));
                break;
            case "--only":
                parts = parts(value(option, rest));
                break;
            case "--device":
                devices = List.of(value(option, rest).split(","));
                break;
            case "--engine":
                engines = List.of(value(option, rest).split(","));
                break;
            case "--sizes":
                sizes = sizes(value(option, rest));
                break;
            case "--machine":
                machine = value(option, rest);
                break;
            case "--out":
                out = Path.of(value(option, rest));
                break;
            default:
                throw new IllegalArgumentException("there is no option " + option + "; --help names them");
        }
    }

    private static String value(String option, List<String> rest) {
        if (rest.isEmpty() || rest.get(0).startsWith("--")) {
            throw new IllegalArgumentException(option + " needs a value");
        }
        return rest.remove(0);
    }

    private static double seconds(String text) {
        if (!text.matches("[0-9]+[smh]")) {
            throw new IllegalArgumentException("--time-budget takes a number and s, m or h, such as 9m, not " + text);
        }
        int unit = text.endsWith("h") ? 3600 : text.endsWith("m") ? 60 : 1;
        return unit * Double.parseDouble(text.substring(0, text.length() - 1));
    }

    private static Set<Part> parts(String text) {
        Set<Part> parts = EnumSet.noneOf(Part.class);
        for (String name : text.split(",")) {
            try {
                parts.add(Part.valueOf(name.toUpperCase(Locale.ROOT)));
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException(
                        "there is no part " + name + "; there are "
                                + Arrays.toString(Part.values()).toLowerCase(Locale.ROOT),
                        e);
            }
        }
        return parts;
    }

    private static List<Integer> sizes(String text) {
        List<Integer> sizes = new ArrayList<>();
        for (String size : text.split(",")) {
            if (!size.matches("[1-9][0-9]{0,7}")) {
                throw new IllegalArgumentException("--sizes takes numbers of circles, such as 1250,5000, not " + text);
            }
            sizes.add(Integer.valueOf(size));
        }
        return sizes;
    }

    public boolean quick() {
        return quick;
    }

    public boolean list() {
        return list;
    }

    public boolean help() {
        return help;
    }

    /** Whether what the results folder has a figure for is left alone. */
    public boolean missing() {
        return missing;
    }

    public boolean charts() {
        return charts;
    }

    /** Seconds that the sweep may take; infinite where none were given. */
    public double budgetSeconds() {
        return budgetSeconds;
    }

    public Set<Part> parts() {
        return parts;
    }

    /** Names of devices; empty for all. */
    public List<String> devices() {
        return devices;
    }

    /** Names of engines to compare; empty for all. */
    public List<String> engines() {
        return engines;
    }

    /** The sizes out of those planned that are asked for. */
    public List<Integer> sizes(List<Integer> planned) {
        return sizes.isEmpty() ? planned : sizes;
    }

    /** The folder's name, or an empty text for the machine's own. */
    public String machine() {
        return machine;
    }

    public Path out() {
        return out;
    }
}
