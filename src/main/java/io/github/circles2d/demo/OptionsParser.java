package io.github.circles2d.demo;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;

/**
 * Reads a command line. One table holds what every option is called, takes, means and checks; the usage text is made
 * from it.
 */
final class OptionsParser {
    private int circles = 1250;
    private boolean packed;
    private int strategy = 2;
    private float restitution = 0.5f;
    private float gravityX;
    private float gravityY = -0.01f;
    private String device = "best";
    private long seed = 1;
    private int frames;
    private Path png;
    private int size = 480;
    private boolean overlay = true;
    private boolean quiet;
    private boolean help;

    /** Takes an option's value; what its exception says follows the option's name. */
    @FunctionalInterface
    private interface Setter {
        void set(String value) throws UsageException;
    }

    /**
     * @param alias another name, or empty
     * @param value what the value is called in the usage text; empty where the option takes none
     */
    private record Option(String name, String alias, String value, String meaning, Setter setter) {
        boolean isCalled(String given) {
            return given.equals(name) || !alias.isEmpty() && given.equals(alias);
        }

        String usage() {
            String names = (alias.isEmpty() ? "    " : alias + ", ") + name + (value.isEmpty() ? "" : " " + value);
            return String.format("  %-28s%s%n", names, meaning);
        }
    }

    private final List<Option> table = List.of(
            new Option("--circles", "-n", "N", "number of circles (1250)", v -> circles = integer(v, 1, 10_000_000)),
            new Option(
                    "--packed",
                    "",
                    "",
                    "radii that shrink with N, so that any number fits as 1250 do",
                    v -> packed = true),
            new Option(
                    "--strategy",
                    "",
                    "0|1|2|3",
                    "0 computed, 1 look-up table, 2 row search, 3 exact (2)",
                    v -> strategy = integer(v, 0, 3)),
            new Option("--restitution", "", "E", "0, inelastic, to 1, elastic (0.5)", v -> restitution = real(v, 0, 1)),
            new Option("--gravity", "", "X,Y", "arena sides per second squared, y up (0,-0.01)", this::gravity),
            new Option("--device", "", "DEVICE", "best, gpu, cpu, a number or a part of a name (best)", this::device),
            new Option("--seed", "", "S", "seed of the random start (1)", this::seed),
            new Option("--frames", "", "N", "end after N frames", v -> frames = integer(v, 1, Integer.MAX_VALUE)),
            new Option("--png", "", "FILE", "no window: write the last frame (600) to FILE", this::png),
            new Option("--size", "", "PIXELS", "side of the arena (480)", v -> size = integer(v, 100, 8192)),
            new Option("--no-overlay", "", "", "start without the text over the arena", v -> overlay = false),
            new Option("--quiet", "-q", "", "do not print the time of each frame", v -> quiet = true),
            new Option("--help", "-h", "", "print this text", v -> help = true));

    /** The text of --help. */
    static String usage() {
        StringBuilder text = new StringBuilder(String.format("usage: CirclesTest [options]%n%n"
                + "Shows circles that fall in a square, and how long the engine takes for each frame.%n%n"
                + "Options (in brackets: what holds without them):%n"));
        new OptionsParser().table.forEach(option -> text.append(option.usage()));
        return text.append(String.format("%nKeys: " + String.join("   ", DemoCanvas.KEYS) + "%n"))
                .toString();
    }

    /** What has been read so far. */
    Options options() {
        return new Options(
                circles,
                packed,
                strategy,
                restitution,
                gravityX,
                gravityY,
                device,
                seed,
                frames,
                png,
                size,
                overlay,
                quiet,
                help);
    }

    /**
     * Reads {@code --name value} and {@code --name=value}; the last one counts where an option comes twice, and nothing
     * after --help does.
     */
    Options parse(String... arguments) throws UsageException {
        Iterator<String> rest = List.of(arguments).iterator();
        while (rest.hasNext() && !help) {
            String argument = rest.next();
            int equals = argument.startsWith("--") ? argument.indexOf('=') : -1;
            Option option = find(equals < 0 ? argument : argument.substring(0, equals));
            String value = "";
            if (option.value().isEmpty()) {
                if (equals >= 0) {
                    throw new UsageException(option.name() + " takes no value");
                }
            } else if (equals >= 0) {
                value = argument.substring(equals + 1);
            } else if (rest.hasNext()) {
                value = rest.next();
            } else {
                throw new UsageException(option.name() + " needs a value: " + option.value());
            }
            try {
                option.setter().set(value);
            } catch (UsageException e) {
                throw new UsageException(option.name() + " " + e.getMessage());
            }
        }
        return options();
    }

    private Option find(String name) throws UsageException {
        for (Option option : table) {
            if (option.isCalled(name)) {
                return option;
            }
        }
        throw new UsageException((name.startsWith("-") ? "unknown option " : "unexpected argument ") + name);
    }

    private void gravity(String value) throws UsageException {
        String[] parts = value.split(",", -1);
        if (parts.length != 2) {
            throw new UsageException(
                    "takes two numbers with a comma between them, such as 0,-0.01, not '" + value + "'");
        }
        gravityX = real(parts[0], -1e6f, 1e6f);
        gravityY = real(parts[1], -1e6f, 1e6f);
    }

    private void device(String value) throws UsageException {
        if (value.isBlank()) {
            throw new UsageException("takes best, gpu, cpu, a number or a part of a name, not nothing");
        }
        device = value.strip();
    }

    private void seed(String value) throws UsageException {
        try {
            seed = Long.parseLong(value);
        } catch (NumberFormatException e) {
            throw new UsageException("takes a whole number of at most 64 bits, not '" + value + "'");
        }
    }

    private void png(String value) throws UsageException {
        try {
            Path file = Path.of(value);
            Path folder = file.toAbsolutePath().getParent();
            if (value.isBlank() || Files.isDirectory(file) || folder == null) {
                throw new UsageException("takes the name of a file, not '" + value + "'");
            }
            if (!Files.isDirectory(folder)) {
                throw new UsageException("takes a file in a folder that exists, which " + folder + " does not");
            }
            if (!Files.isWritable(Files.exists(file) ? file : folder)) {
                throw new UsageException("takes a file that may be written, which " + value + " may not");
            }
            png = file;
        } catch (InvalidPathException e) {
            throw new UsageException("takes the name of a file, not '" + value + "'");
        }
    }

    private static int integer(String value, int least, int most) throws UsageException {
        try {
            int number = Integer.parseInt(value);
            if (number >= least && number <= most) {
                return number;
            }
        } catch (NumberFormatException e) {
            // the message below holds for it as well
        }
        throw new UsageException("takes a whole number from " + least + " to " + most + ", not '" + value + "'");
    }

    private static float real(String value, float least, float most) throws UsageException {
        try {
            float number = Float.parseFloat(value);
            if (number >= least && number <= most) { // false for NaN
                return number;
            }
        } catch (NumberFormatException e) {
            // the message below holds for it as well
        }
        throw new UsageException("takes a number from " + least + " to " + most + ", not '" + value + "'");
    }
}
