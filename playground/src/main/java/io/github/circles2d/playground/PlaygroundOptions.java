package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** What a person asked for on the command line. */
final class PlaygroundOptions {
    private static final int LEAST_SIZE = 100;
    private static final int GREATEST_SIZE = 8192;

    private Stage stage = Stages.all().get(0);
    private Backend backend = Backend.JVM;
    private PaintMode paint = PaintMode.SPEED;
    private int frames = 300;
    private int width = 1280;
    private int height = 720;
    private Path picture;
    private Path film;
    private Path gallery;
    private Path save;
    private boolean link;
    private String page = "";
    private boolean help;

    private PlaygroundOptions() {}

    /** A command line that is not accepted. */
    static final class UsageException extends Exception {
        private static final long serialVersionUID = 1;

        UsageException(String message) {
            super(message);
        }
    }

    static PlaygroundOptions parse(String... arguments) throws UsageException {
        PlaygroundOptions options = new PlaygroundOptions();
        Iterator<String> rest = List.of(arguments).iterator();
        while (rest.hasNext() && !options.help) {
            String name = rest.next();
            if (name.equals("--help") || name.equals("-h")) {
                options.help = true;
            } else {
                options.set(name, rest);
            }
        }
        return options;
    }

    private void set(String name, Iterator<String> rest) throws UsageException {
        switch (name) {
            case "--scene" -> stage = stage(value(name, rest));
            case "--backend" -> backend = backend(value(name, rest));
            case "--paint" -> paint = paint(value(name, rest));
            case "--frames" -> frames = number(name, value(name, rest), 1, 1_000_000);
            case "--size" -> size(value(name, rest));
            case "--picture" -> picture = path(name, value(name, rest));
            case "--film" -> film = path(name, value(name, rest));
            case "--save" -> save = path(name, value(name, rest));
            case "--gallery" -> gallery = path(name, value(name, rest));
            case "--link" -> link = true;
            case "--page" -> page = page(value(name, rest));
            default -> throw new UsageException("there is no option '" + name + "'");
        }
    }

    private static String value(String name, Iterator<String> rest) throws UsageException {
        if (!rest.hasNext()) {
            throw new UsageException(name + " needs a value");
        }
        return rest.next();
    }

    private static Stage stage(String name) throws UsageException {
        Stage found = Stages.named(name);
        if (found == null) {
            throw new UsageException("there is no scene '" + name + "': there are " + stageNames());
        }
        return found;
    }

    private static String stageNames() {
        return Stages.all().stream().map(Stage::name).collect(Collectors.joining(", "));
    }

    private static Backend backend(String name) throws UsageException {
        return switch (name.toLowerCase(Locale.ROOT)) {
            case "auto" -> Backend.AUTO;
            case "jvm" -> Backend.JVM;
            case "cpu", "opencl_cpu" -> Backend.OPENCL_CPU;
            case "gpu", "opencl_gpu" -> Backend.OPENCL_GPU;
            default -> throw new UsageException("--backend takes auto, jvm, cpu or gpu, not '" + name + "'");
        };
    }

    private static PaintMode paint(String name) throws UsageException {
        for (PaintMode mode : PaintMode.values()) {
            if (mode.label().equals(name)) {
                return mode;
            }
        }
        throw new UsageException("--paint takes plain, speed, pressure or contacts, not '" + name + "'");
    }

    private void size(String value) throws UsageException {
        String[] sides = value.split("x", -1);
        if (sides.length != 2) {
            throw new UsageException("--size takes WIDTHxHEIGHT, not '" + value + "'");
        }
        width = number("--size", sides[0], LEAST_SIZE, GREATEST_SIZE);
        height = number("--size", sides[1], LEAST_SIZE, GREATEST_SIZE);
    }

    private static String page(String address) throws UsageException {
        if (!address.matches("https?://[^#\\s]+")) {
            throw new UsageException(
                    "--page takes an address such as https://host/toy/, without #, not '" + address + "'");
        }
        return address;
    }

    private static int number(String name, String value, int least, int greatest) throws UsageException {
        try {
            int number = Integer.parseInt(value);
            if (number >= least && number <= greatest) {
                return number;
            }
        } catch (NumberFormatException e) {
            // The message below says it.
        }
        throw new UsageException(
                name + " takes a whole number from " + least + " to " + greatest + ", not '" + value + "'");
    }

    private static Path path(String name, String value) throws UsageException {
        try {
            return Path.of(value);
        } catch (InvalidPathException e) {
            throw new UsageException(name + " takes a file, not '" + value + "'");
        }
    }

    static String usage() {
        return String.format("usage: Playground [options]%n%n"
                        + "Circles to grab, throw, pour and blow up.%n%n"
                        + "Options (in brackets: what holds without them):%n"
                        + "  --scene NAME          what to start with (sandbox), one of:%n"
                        + wrapped()
                        + "  --backend NAME        auto, jvm, cpu or gpu (jvm)%n"
                        + "  --paint WHAT          plain, speed, pressure or contacts (speed)%n"
                        + "  --size WIDTHxHEIGHT   of the picture in pixels (1280x720)%n"
                        + "  --picture FILE        no window: write the last frame to a PNG file%n"
                        + "  --save FILE           no window: write the last world to a file, and print its hash%n"
                        + "  --link                no window: print the last world as a link for the page in a browser%n"
                        + "  --frames N            frames before the picture, file or link (300)%n"
                        + "  --page ADDRESS        of that page: links begin with it (they are what goes behind it)%n"
                        + "  --film FILE           no window: write the short film of the README, an animated PNG%n"
                        + "  --gallery FOLDER      no window: write a small picture of each scene%n"
                        + "  --help, -h            print this text%n%n"
                        + "Keys and mouse:%n")
                + Help.text();
    }

    private static String wrapped() {
        StringBuilder text = new StringBuilder();
        StringBuilder line = new StringBuilder();
        for (Stage stage : Stages.all()) {
            if (line.length() + stage.name().length() > 76) {
                text.append("                        ").append(line).append("%n");
                line.setLength(0);
            }
            line.append(line.length() == 0 ? "" : " ").append(stage.name());
        }
        return text.append("                        ").append(line).append("%n").toString();
    }

    Stage stage() {
        return stage;
    }

    Backend backend() {
        return backend;
    }

    PaintMode paint() {
        return paint;
    }

    int frames() {
        return frames;
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** The picture to write instead of showing a window; null for none. */
    Path picture() {
        return picture;
    }

    /** The film to write instead of showing a window; null for none. */
    Path film() {
        return film;
    }

    /** The folder to write a picture of each scene to instead of showing a window; null for none. */
    Path gallery() {
        return gallery;
    }

    /** The file to write the world to instead of showing a window; null for none. */
    Path save() {
        return save;
    }

    /** Whether to print a link instead of showing a window. */
    boolean link() {
        return link;
    }

    /** Whether files or links come in place of a window. */
    boolean writes() {
        return film != null || gallery != null || picture != null || save != null || link;
    }

    /** The address that links begin with; may be empty. */
    String page() {
        return page;
    }

    boolean help() {
        return help;
    }
}
