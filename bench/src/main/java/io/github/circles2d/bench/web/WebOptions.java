package io.github.circles2d.bench.web;

import io.github.circles2d.bench.measure.Machine;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** What the command line asks of the comparison. */
final class WebOptions {
    static final String HELP = String.join(
            "\n",
            "Compares World on the JVM, in Node and in Chromium with engines for JavaScript, all on one thread.",
            "",
            "usage: ./circles2d bench web [OPTIONS]",
            "",
            "  --quick              two runs of each at 1,250 circles; goes to bench/results/quick/web",
            "  --sizes N,N,..       numbers of circles (default: 1250,5000,20000)",
            "  --only ENGINE,..     some of the engines: " + String.join(", ", engines()),
            "  --out DIR            folder of web.csv and the chart (default: bench/results and the machine's name)",
            "",
            "The launcher installs Node, Chromium and the engines, and adds where they are:",
            "",
            "  --node FILE          the program of Node",
            "  --chromium FILE      the program of Chromium",
            "  --driver DIR         the folder in which puppeteer-core was installed",
            "  --programs DIR       the folder bench/web, in which the engines were installed and World was built",
            "",
            "Figures that are measured again replace those that are in the file; the others stay.");

    private static final List<String> UNCHECKED_FLAGS =
            List.of("--experimental-wasm-skip-bounds-checks", "--experimental-wasm-skip-null-checks");

    private List<Integer> sizes = List.of(1250, 5000, 20_000);
    private List<String> engines = engines();
    private boolean help;
    private boolean quick;
    private Path out;
    private String node = "";
    private String chromium = "";
    private String driver = "";
    private String programs = "";

    private WebOptions() {}

    /**
     * Reads the command line.
     *
     * @throws IllegalArgumentException with a sentence for the user if it is wrong
     */
    static WebOptions parse(List<String> arguments) {
        WebOptions options = new WebOptions();
        List<String> rest = new ArrayList<>(arguments);
        while (!rest.isEmpty()) {
            options.take(rest.remove(0), rest);
        }
        if (options.out == null) {
            Path results = Path.of(Files.isDirectory(Path.of("bench")) ? "bench/results" : "results");
            // A short look must not take the place of figures that are kept.
            options.out = results.resolve(options.quick ? "quick/web" : Machine.name(Map.of()));
        }
        boolean allThere = List.of(options.node, options.chromium, options.driver, options.programs).stream()
                .noneMatch(String::isEmpty);
        if (!options.help && !allThere) {
            throw new IllegalArgumentException("./circles2d bench web says where Node, Chromium and the engines are");
        }
        return options;
    }

    private void take(String option, List<String> rest) {
        switch (option) {
            case "--help", "-h" -> help = true;
            case "--quick" -> {
                quick = true;
                sizes = List.of(1250);
            }
            case "--sizes" ->
                sizes = List.of(value(option, rest).split(",")).stream()
                        .map(WebOptions::size)
                        .toList();
            case "--only" -> engines = known(List.of(value(option, rest).split(",")));
            case "--out" -> out = Path.of(value(option, rest));
            case "--node" -> node = value(option, rest);
            case "--chromium" -> chromium = value(option, rest);
            case "--driver" -> driver = value(option, rest);
            case "--programs" -> programs = value(option, rest);
            default ->
                throw new IllegalArgumentException("there is no option " + option + "; --help names the options");
        }
    }

    private static List<String> engines() {
        return Entrant.ALL.stream().map(Entrant::engine).distinct().toList();
    }

    private static List<String> known(List<String> names) {
        for (String name : names) {
            if (!engines().contains(name)) {
                throw new IllegalArgumentException(
                        "there is no engine " + name + "; there are " + String.join(", ", engines()));
            }
        }
        return names;
    }

    private static String value(String option, List<String> rest) {
        if (rest.isEmpty() || rest.get(0).startsWith("--")) {
            throw new IllegalArgumentException(option + " needs a value");
        }
        return rest.remove(0);
    }

    private static int size(String text) {
        if (!text.matches("[1-9][0-9]{1,4}")) {
            throw new IllegalArgumentException("--sizes takes numbers from 10 to 99999, not " + text);
        }
        return Integer.parseInt(text);
    }

    boolean help() {
        return help;
    }

    boolean quick() {
        return quick;
    }

    List<Integer> sizes() {
        return sizes;
    }

    /** Those to measure. */
    List<Entrant> entrants() {
        return Entrant.ALL.stream()
                .filter(entrant -> engines.contains(entrant.engine()))
                .toList();
    }

    Path out() {
        return out;
    }

    /** The program and arguments that run an entrant on a scene. */
    List<String> command(Entrant entrant, int n, Path scene, String settings, Path state) {
        return switch (entrant.runsIn()) {
            case Entrant.JVM ->
                List.of(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        JvmRunner.class.getName(),
                        Integer.toString(n),
                        state.toString());
            case Entrant.CHROMIUM ->
                with(List.of(node, programs + "/chromium.mjs", chromium, driver), scene, settings, state);
            case Entrant.UNCHECKED -> with(node(entrant, UNCHECKED_FLAGS), scene, settings, state);
            default -> with(node(entrant, List.of()), scene, settings, state);
        };
    }

    private List<String> node(Entrant entrant, List<String> flags) {
        List<String> command = new ArrayList<>(List.of(node));
        command.addAll(flags);
        command.addAll(List.of(programs + "/node.mjs", entrant.engine()));
        return command;
    }

    private static List<String> with(List<String> command, Path scene, String settings, Path state) {
        List<String> all = new ArrayList<>(command);
        all.addAll(List.of(scene.toString(), settings, state.toString()));
        return all;
    }
}
