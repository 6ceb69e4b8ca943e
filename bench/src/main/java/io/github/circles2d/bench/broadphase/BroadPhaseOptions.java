package io.github.circles2d.bench.broadphase;

import io.github.circles2d.bench.Devices;
import io.github.circles2d.bench.measure.Machine;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** What the command line asks of the comparison. */
final class BroadPhaseOptions {
    static final String HELP = String.join(
            "\n",
            "Compares broad phases: the pairs of circles that World moves, by processor time of one thread.",
            "",
            "usage: bench broadphase [OPTIONS]",
            "",
            "  --quick              up to 10,000 circles, and little time for each figure",
            "  --sizes N,N,..       numbers of circles (default: 1250,10000,100000,1000000)",
            "  --scenes NAME,..     some of the scenes: " + titles(Crowds.values()),
            "  --only NAME,..       some of the broad phases, at any size: " + titles(BroadPhases.values()),
            "  --seconds NUMBER     processor time for each figure (default: 0.3)",
            "  --device NAME        the subdivided sweep on an OpenCL device (best, cpu, or a name that `bench --help` explains),",
            "                       and nothing else; by the time on the wall, with the positions there and the pairs left there",
            "  --out DIR            folder of broadphase.csv and the charts (default: bench/results and the machine's name; for a",
            "                       quick look bench/results/quick/broadphase)",
            "  --page FILE          draws the charts and writes the page from what is in that folder, and runs nothing",
            "",
            "Figures that are measured again replace those that are in the file; the others stay.");

    private List<Integer> sizes = List.of(1250, 10_000, 100_000, 1_000_000);
    private List<Crowds> scenes = List.of(Crowds.values());
    private List<BroadPhases> kinds = List.of();
    private double seconds = 0.3;
    private boolean help;
    private boolean quick;
    private String device = "";
    private Path out;
    private Path page;

    private BroadPhaseOptions() {}

    /**
     * Reads the command line.
     *
     * @throws IllegalArgumentException with a sentence for the user if it is wrong
     */
    static BroadPhaseOptions parse(List<String> arguments) {
        BroadPhaseOptions options = new BroadPhaseOptions();
        List<String> rest = new ArrayList<>(arguments);
        while (!rest.isEmpty()) {
            options.take(rest.remove(0), rest);
        }
        if (options.out == null) {
            Path results = Path.of(Files.isDirectory(Path.of("bench")) ? "bench/results" : "results");
            // A short look must not take the place of figures that are kept.
            options.out = results.resolve(
                    options.quick
                            ? "quick/broadphase"
                            : Machine.name(options.device.isEmpty() ? Map.of() : Devices.all()));
        }
        return options;
    }

    private void take(String option, List<String> rest) {
        switch (option) {
            case "--help", "-h" -> help = true;
            case "--quick" -> {
                quick = true;
                sizes = List.of(1250, 10_000);
                seconds = 0.1;
            }
            case "--sizes" ->
                sizes = values(option, rest).stream()
                        .map(BroadPhaseOptions::size)
                        .toList();
            case "--scenes" ->
                scenes = values(option, rest).stream().map(Crowds::named).toList();
            case "--only" ->
                kinds = values(option, rest).stream().map(BroadPhases::named).toList();
            case "--seconds" -> seconds = seconds(value(option, rest));
            case "--device" -> device = value(option, rest);
            case "--out" -> out = Path.of(value(option, rest));
            case "--page" -> page = Path.of(value(option, rest));
            default ->
                throw new IllegalArgumentException("there is no option " + option + "; --help names the options");
        }
    }

    private static String titles(Crowds[] all) {
        return String.join(", ", Arrays.stream(all).map(c -> c.title).toList());
    }

    private static String titles(BroadPhases[] all) {
        return String.join(", ", Arrays.stream(all).map(p -> p.title).toList());
    }

    private static List<String> values(String option, List<String> rest) {
        return List.of(value(option, rest).split(","));
    }

    private static String value(String option, List<String> rest) {
        if (rest.isEmpty() || rest.get(0).startsWith("--")) {
            throw new IllegalArgumentException(option + " needs a value");
        }
        return rest.remove(0);
    }

    private static int size(String text) {
        if (!text.matches("[1-9][0-9]{1,6}") || Integer.parseInt(text) > 4_000_000) {
            throw new IllegalArgumentException("--sizes takes numbers from 10 to 4000000, not " + text);
        }
        return Integer.parseInt(text);
    }

    private static double seconds(String text) {
        if (!text.matches("[0-9]{1,3}(\\.[0-9]{1,6})?")) {
            throw new IllegalArgumentException("--seconds takes a number from 0 to 999, such as 0.5, not " + text);
        }
        return Double.parseDouble(text);
    }

    boolean help() {
        return help;
    }

    List<Integer> sizes() {
        return sizes;
    }

    List<Crowds> scenes() {
        return scenes;
    }

    /** Those to measure, all if none is named. */
    List<BroadPhases> kinds() {
        return kinds.isEmpty() ? List.of(BroadPhases.values()) : kinds;
    }

    /** Whether one is named. */
    boolean asksFor(BroadPhases kind) {
        return kinds.contains(kind);
    }

    double seconds() {
        return seconds;
    }

    /** The device to measure; empty for none. */
    String device() {
        return device;
    }

    Path out() {
        return out;
    }

    /** The page to write; null for none. */
    Path page() {
        return page;
    }
}
