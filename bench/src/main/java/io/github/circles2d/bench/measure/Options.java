package io.github.circles2d.bench.measure;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * The command line.
 *
 * @param parts what is measured
 * @param charts whether charts are drawn at the end
 * @param missing whether what the results folder has a figure for is left alone
 * @param budgetSeconds for everything; infinite if none were given
 * @param patience seconds for a figure of a series
 * @param scenes the series
 * @param devices names; empty for all
 * @param engines names; empty for all
 * @param sizes numbers of circles; empty for those that are planned
 * @param out parent of the results folder
 * @param folder the results folder, or the name of one in {@code out}; null for that of the machine
 * @param write where scenes are to be written, or null
 * @param take the list of figures from outside Maven, or null
 */
public record Options(
        Set<Part> parts,
        boolean quick,
        boolean list,
        boolean help,
        boolean charts,
        boolean missing,
        double budgetSeconds,
        double patience,
        List<Series> scenes,
        List<String> devices,
        List<String> engines,
        List<Integer> sizes,
        Path out,
        Path folder,
        Path write,
        Path take) {
    /** What can be measured, in the order in which it is. The series are a command by themselves. */
    public enum Part {
        COPY,
        ACCURACY,
        STRATEGIES,
        TRANSFER,
        WORLD,
        PEERS,
        SERIES
    }

    /** What {@code --help} prints. */
    public static final String HELP = """
            Measures the strategies of the thesis and World on every OpenCL device, and other engines on the same scenes.

            usage: benchmarks.jar [OPTIONS]                  runs the sweep
                   benchmarks.jar series [OPTIONS] [FOLDER]  measures World and others on scenes at growing n: ms a step with a
                                                             wait after it; FOLDER is that of the results
                   benchmarks.jar jmh ARGUMENTS              runs JMH itself (jmh -h for its help)
                   benchmarks.jar smoke                      executes every benchmark once at its smallest size
                   benchmarks.jar physics ARGUMENTS          measures World's physics (physics --help for its help)
                   benchmarks.jar broadphase ARGUMENTS       compares broad phases (broadphase --help for its help)
                   benchmarks.jar games [BACKEND N...]       measures what features for games cost World
                   benchmarks.jar table DIR                  prints the table of a results folder
                   benchmarks.jar charts DIR                 draws the charts of a results folder, or of all in DIR/machines.txt
                   benchmarks.jar page RESULTS PAGE          writes the results page from the folders in RESULTS

              --time-budget TIME   ends in about this time (90s, 9m, 2h; series: 9m); what does not fit is left out and named
              --engine NAMES       only these engines, such as world-jvm,gdx-box2d
              --sizes NUMBERS      only these numbers of circles; in series for every engine
              --missing            only what has no figure yet in the results folder
              --list               prints what would be measured

            of the sweep alone:
              --quick              a short look, less than three minutes on two cores
              --only PARTS         some of copy,accuracy,strategies,transfer,world,peers
              --device NAMES       only these devices, by the names that --list prints
              --machine NAME       name of the results folder (default: processor, cores and graphics processor)
              --out DIR            parent of the results folder (default: bench/results, or results; in it the folder quick
                                   for a short look)
              --no-charts          writes no charts

            of series alone:
              --patience TIME      for one figure (default: 30s); one that would take longer is left out and named
              --series NAMES       only these: %s
              --write DIR          measures nothing; writes the scenes as files for engines outside Maven, and a list of them
              --take FILE          measures nothing; puts the figures of such an engine into the folder, out of a list of its runs

            A folder that is there is added to: what is measured again replaces what was there.""".formatted(Series.titles());

    private static final String BOTH = "--list --missing --help --time-budget= --engine= --sizes=";
    private static final String OF_SWEEP = BOTH + " --quick --no-charts --only= --device= --machine= --out=";
    private static final String OF_SERIES = BOTH + " --series= --patience= --write= --take=";

    /**
     * Reads the command line of the sweep, or of the series if the first argument says so.
     *
     * @throws IllegalArgumentException with a sentence for the user if it is wrong
     */
    public static Options parse(List<String> arguments) {
        boolean series = !arguments.isEmpty() && arguments.get(0).equals("series");
        Map<String, String> given = given(arguments.subList(series ? 1 : 0, arguments.size()), series);
        boolean quick = given.containsKey("--quick");
        Path results = Path.of(Files.isDirectory(Path.of("bench")) ? "bench/results" : "results");
        return new Options(
                series ? EnumSet.of(Part.SERIES) : parts(given.get("--only")),
                quick,
                given.containsKey("--list"),
                given.containsKey("--help"),
                !series && !given.containsKey("--no-charts"),
                given.containsKey("--missing"),
                seconds("--time-budget", given, series ? 540 : quick ? 165 : Double.POSITIVE_INFINITY),
                seconds("--patience", given, 30),
                given.containsKey("--series")
                        ? list("--series", given).stream().map(Series::titled).toList()
                        : List.of(Series.values()),
                list("--device", given),
                list("--engine", given),
                list("--sizes", given).stream()
                        .map(size -> size(size, given.get("--sizes")))
                        .toList(),
                // A short look must not take the place of a sweep that is kept.
                given.containsKey("--out") ? path("--out", given) : quick ? results.resolve("quick") : results,
                path(series ? "" : "--machine", given),
                path("--write", given),
                path("--take", given));
    }

    /** The arguments by the options' names; the folder's name is empty. */
    private static Map<String, String> given(List<String> arguments, boolean series) {
        List<String> allowed = List.of((series ? OF_SERIES : OF_SWEEP).split(" "));
        Map<String, String> given = new HashMap<>();
        for (int i = 0; i < arguments.size(); i++) {
            String option = arguments.get(i).equals("-h") ? "--help" : arguments.get(i);
            if (series && !option.startsWith("-")) {
                String other = given.put("", option);
                if (other != null) {
                    throw new IllegalArgumentException(
                            "one folder of results is enough: " + other + " or " + option + "?");
                }
            } else if (allowed.contains(option)) {
                given.put(option, "");
            } else if (allowed.contains(option + "=")) {
                if (++i == arguments.size() || arguments.get(i).startsWith("--")) {
                    throw new IllegalArgumentException(option + " needs a value");
                }
                given.put(option, arguments.get(i));
            } else {
                throw new IllegalArgumentException("there is no option " + option + "; --help names them");
            }
        }
        return given;
    }

    private static Path path(String option, Map<String, String> given) {
        return given.containsKey(option) ? Path.of(given.get(option)) : null;
    }

    private static List<String> list(String option, Map<String, String> given) {
        return given.containsKey(option) ? List.of(given.get(option).split(",")) : List.of();
    }

    private static double seconds(String option, Map<String, String> given, double otherwise) {
        String text = given.get(option);
        if (text == null) {
            return otherwise;
        }
        if (!text.matches("[1-9][0-9]{0,5}[smh]")) {
            throw new IllegalArgumentException(option + " takes a number and s, m or h, such as 9m, not " + text);
        }
        int unit = text.endsWith("h") ? 3600 : text.endsWith("m") ? 60 : 1;
        return unit * Double.parseDouble(text.substring(0, text.length() - 1));
    }

    private static Set<Part> parts(String names) {
        Set<Part> all = EnumSet.complementOf(EnumSet.of(Part.SERIES));
        if (names == null) {
            return all;
        }
        Set<Part> parts = EnumSet.noneOf(Part.class);
        for (String name : names.split(",")) {
            parts.add(all.stream()
                    .filter(part -> part.name().equals(name.toUpperCase(Locale.ROOT)))
                    .findFirst()
                    .orElseThrow(() -> new IllegalArgumentException("there is no part " + name + "; there are "
                            + Arrays.toString(all.toArray()).toLowerCase(Locale.ROOT))));
        }
        return parts;
    }

    private static Integer size(String size, String all) {
        if (!size.matches("[1-9][0-9]{0,7}")) {
            throw new IllegalArgumentException("--sizes takes numbers of circles, such as 1250,10000, not " + all);
        }
        return Integer.valueOf(size);
    }

    /** The sizes that are asked for, or else those that are planned. */
    public List<Integer> sizes(List<Integer> planned) {
        return sizes.isEmpty() ? planned : sizes;
    }

    /** Whether an engine is asked for. */
    public boolean wants(String engine) {
        return engines.isEmpty() || engines.contains(engine);
    }

    /** The results folder. */
    public Path folder(String machine) {
        boolean complete = folder != null && parts.contains(Part.SERIES);
        return complete ? folder : out.resolve(folder == null ? machine : folder.toString());
    }
}
