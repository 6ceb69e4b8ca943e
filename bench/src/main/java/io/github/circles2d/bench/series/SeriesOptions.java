package io.github.circles2d.bench.series;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** What the command line asks of the series. */
final class SeriesOptions {
    static final String HELP = String.join(
            "\n",
            "Measures World and other engines on the same scenes at growing n: ms a step with a wait after it.",
            "",
            "usage: bench series [OPTIONS] [FOLDER]     FOLDER: of the results (default: bench/results, or results, and the",
            "                                           machine's name)",
            "",
            "  --time-budget TIME   ends in about this time (90s, 9m, 2h; default: 9m); what does not fit is left out and named",
            "  --patience TIME      for one figure (default: 30s); one that would take longer is left out and named",
            "  --series NAMES       only these: " + Series.titles(),
            "  --engine NAMES       only these engines, such as world-jvm,gdx-box2d",
            "  --sizes NUMBERS      only these numbers of circles, of any size and for every engine",
            "  --missing            only what has no figure yet in the folder",
            "  --list               prints what would be measured",
            "  --write DIR          measures nothing; writes the scenes as files for engines outside Maven, and a list of them",
            "  --take FILE          measures nothing; puts the figures of such an engine into the folder, out of a list of its runs",
            "",
            "A folder that is there is added to: what is measured again replaces what was there.");

    private Path folder;
    private double budgetSeconds = 540;
    private double patience = 30;
    private List<Series> series = List.of(Series.values());
    private List<String> engines = List.of();
    private List<Integer> sizes = List.of();
    private boolean missing;
    private boolean list;
    private boolean help;
    private Path write;
    private Path take;

    private SeriesOptions() {}

    /**
     * Reads the command line.
     *
     * @throws IllegalArgumentException with a sentence for the user if it is wrong
     */
    static SeriesOptions parse(List<String> arguments) {
        SeriesOptions options = new SeriesOptions();
        List<String> rest = new ArrayList<>(arguments);
        while (!rest.isEmpty()) {
            options.take(rest.remove(0), rest);
        }
        return options;
    }

    private void take(String option, List<String> rest) {
        switch (option) {
            case "--time-budget" -> budgetSeconds = seconds(option, rest);
            case "--patience" -> patience = seconds(option, rest);
            case "--series" ->
                series = Arrays.stream(value(option, rest).split(","))
                        .map(Series::titled)
                        .toList();
            case "--engine" -> engines = List.of(value(option, rest).split(","));
            case "--sizes" ->
                sizes = Arrays.stream(value(option, rest).split(","))
                        .map(SeriesOptions::size)
                        .toList();
            case "--missing" -> missing = true;
            case "--list" -> list = true;
            case "--write" -> write = Path.of(value(option, rest));
            case "--take" -> take = Path.of(value(option, rest));
            case "--help", "-h" -> help = true;
            default -> takeFolder(option);
        }
    }

    private void takeFolder(String argument) {
        if (argument.startsWith("-")) {
            throw new IllegalArgumentException("there is no option " + argument + "; --help names them");
        }
        if (folder != null) {
            throw new IllegalArgumentException("one folder of results is enough: " + folder + " or " + argument + "?");
        }
        folder = Path.of(argument);
    }

    private static String value(String option, List<String> rest) {
        if (rest.isEmpty() || rest.get(0).startsWith("--")) {
            throw new IllegalArgumentException(option + " needs a value");
        }
        return rest.remove(0);
    }

    private static double seconds(String option, List<String> rest) {
        String text = value(option, rest);
        if (!text.matches("[1-9][0-9]{0,5}[smh]")) {
            throw new IllegalArgumentException(option + " takes a number and s, m or h, such as 9m, not " + text);
        }
        int unit = text.endsWith("h") ? 3600 : text.endsWith("m") ? 60 : 1;
        return unit * Double.parseDouble(text.substring(0, text.length() - 1));
    }

    private static Integer size(String text) {
        if (!text.matches("[1-9][0-9]{0,7}")) {
            throw new IllegalArgumentException("--sizes takes numbers of circles, such as 1250,10000, not " + text);
        }
        return Integer.valueOf(text);
    }

    /** The folder of the results, or null for that of the machine. */
    Path folder() {
        return folder;
    }

    double budgetSeconds() {
        return budgetSeconds;
    }

    double patience() {
        return patience;
    }

    List<Series> series() {
        return series;
    }

    /** The sizes of a series. */
    List<Integer> sizes(Series one) {
        return sizes.isEmpty() ? one.sizes() : sizes;
    }

    /** Whether an engine is asked for at a size: a million circles are World's unless sizes are named. */
    boolean wants(Contender who, int n) {
        boolean large = n >= 1_000_000 && sizes.isEmpty();
        return (engines.isEmpty() || engines.contains(who.engine())) && (who.isWorld() || !large);
    }

    boolean missing() {
        return missing;
    }

    boolean list() {
        return list;
    }

    boolean help() {
        return help;
    }

    /** Where scenes are to be written, or null. */
    Path write() {
        return write;
    }

    /** The list of figures that are to be taken, or null. */
    Path take() {
        return take;
    }
}
