package io.github.circles2d.bench.physics;

import io.github.circles2d.Backend;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;

/** What the command line asks of the measure of the physics. */
final class PhysicsOptions {
    static final String HELP = String.join(
            "\n",
            "Measures World's physics: runs scenes with a bound each on World, some of them on Box2D, too.",
            "",
            "usage: bench physics [OPTIONS] [NUMBERS OF ROWS]",
            "",
            "  --quick              one seed and a quarter of the steps; other figures than those that the bounds are for",
            "  --seeds NUMBER       runs of a scene that draws random numbers (default: 3); their median counts",
            "  --backend NAME       JVM (default), OPENCL_CPU, OPENCL_GPU or AUTO",
            "  --threads NUMBER     threads of the JVM back end (default: 1)",
            "  --no-box2d           World alone",
            "  --curves             also keeps and draws energy, depth and rest over time (as without numbers of rows)",
            "  --baseline FILE      writes the figures of row 18 as its new baseline",
            "  --out DIR            folder of the CSV files and charts (default: bench/results/physics, or results/physics; for",
            "                       a quick look quick/physics in place of physics)",
            "  --page FILE          draws the curves and writes the page from what is in that folder, and runs nothing",
            "",
            "Rows that are run again replace those that are in the files; the others stay.");

    private final Set<Integer> rows = new TreeSet<>();
    private boolean help;
    private boolean quick;
    private boolean curves;
    private boolean box2d = true;
    private int seeds;
    private int threads = 1;
    private Backend backend = Backend.JVM;
    private Path out;
    private Path page;
    private Path baseline;

    private PhysicsOptions() {}

    /**
     * Reads the command line.
     *
     * @throws IllegalArgumentException with a sentence for the user if it is wrong
     */
    static PhysicsOptions parse(List<String> arguments) {
        PhysicsOptions options = new PhysicsOptions();
        List<String> rest = new ArrayList<>(arguments);
        while (!rest.isEmpty()) {
            options.take(rest.remove(0), rest);
        }
        if (options.out == null) {
            Path results = Path.of(Files.isDirectory(Path.of("bench")) ? "bench/results" : "results");
            // A short look must not take the place of figures that are kept.
            options.out = results.resolve(options.quick ? "quick/physics" : "physics");
        }
        return options;
    }

    private void take(String option, List<String> rest) {
        switch (option) {
            case "--help", "-h" -> help = true;
            case "--quick" -> quick = true;
            case "--curves" -> curves = true;
            case "--no-box2d" -> box2d = false;
            case "--seeds" -> seeds = number(option, rest);
            case "--threads" -> threads = number(option, rest);
            case "--backend" -> backend = backend(value(option, rest));
            case "--out" -> out = Path.of(value(option, rest));
            case "--page" -> page = Path.of(value(option, rest));
            case "--baseline" -> baseline = Path.of(value(option, rest));
            default -> rows.add(row(option));
        }
    }

    private static int row(String text) {
        boolean known = Rows.ALL.stream().anyMatch(row -> text.equals(Integer.toString(row.number())));
        if (!known) {
            throw new IllegalArgumentException("there is no option and no row " + text + "; --help names the options");
        }
        return Integer.parseInt(text);
    }

    private static String value(String option, List<String> rest) {
        if (rest.isEmpty() || rest.get(0).startsWith("--")) {
            throw new IllegalArgumentException(option + " needs a value");
        }
        return rest.remove(0);
    }

    private static int number(String option, List<String> rest) {
        String text = value(option, rest);
        if (!text.matches("[1-9][0-9]{0,2}")) {
            throw new IllegalArgumentException(option + " takes a number from 1 to 999, not " + text);
        }
        return Integer.parseInt(text);
    }

    private static Backend backend(String text) {
        try {
            return Backend.valueOf(text.toUpperCase(Locale.ROOT));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    "there is no back end " + text + "; there are " + Arrays.toString(Backend.values()), e);
        }
    }

    boolean help() {
        return help;
    }

    /** Whether a row is asked for; without numbers, all are. */
    boolean asksFor(Row row) {
        return rows.isEmpty() || rows.contains(row.number());
    }

    Effort effort() {
        Effort effort = quick ? Effort.QUICK : Effort.FULL;
        return seeds == 0 ? effort : new Effort(seeds, effort.share());
    }

    Physics world() {
        return new WorldPhysics(backend, threads);
    }

    boolean box2d() {
        return box2d;
    }

    boolean curves() {
        return curves || rows.isEmpty();
    }

    Path out() {
        return out;
    }

    /** The page to write; null for none. */
    Path page() {
        return page;
    }

    /** The file for the baseline; null for none. */
    Path baseline() {
        return baseline;
    }
}
