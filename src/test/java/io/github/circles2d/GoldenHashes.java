package io.github.circles2d;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * The hashes on record: by scene and number of steps. {@link #main} computes them anew on the JVM back end.
 */
final class GoldenHashes {
    /** The numbers of steps at which there is a hash on record. */
    static final int[] MARKS = {1, 10, 100, 300, 1000};

    private static final String FILE = "/golden/world.txt";

    private final Map<String, Long> hashes = new TreeMap<>();

    private GoldenHashes() {}

    static GoldenHashes load() throws IOException {
        GoldenHashes golden = new GoldenHashes();
        try (InputStream in = GoldenHashes.class.getResourceAsStream(FILE)) {
            for (String line : new String(in.readAllBytes(), StandardCharsets.US_ASCII).split("\n")) {
                if (!line.startsWith("#")) {
                    String[] words = line.split(" ");
                    golden.hashes.put(words[0] + " " + words[1], Long.parseUnsignedLong(words[2], 16));
                }
            }
        }
        return golden;
    }

    /** The scenes on record. */
    static List<GoldenScene> scenes() throws IOException {
        GoldenHashes golden = load();
        return GoldenScene.all().stream()
                .filter(scene -> golden.hashes.containsKey(scene.name() + " 1"))
                .toList();
    }

    /** The hash of a scene after so many steps. */
    long hash(GoldenScene scene, int steps) {
        return hashes.get(scene.name() + " " + steps);
    }

    /**
     * Prints the file; if beginnings of names are given, only the lines of such scenes. If the first argument is the file, these lines replace those
     * in it, or come behind them: {@code GoldenHashes src/test/resources/golden/world.txt bodies-} records what has bodies that are pushed.
     */
    public static void main(String[] arguments) throws IOException {
        Path file = arguments.length > 0 ? Path.of(arguments[0]) : Path.of("");
        boolean records = Files.isRegularFile(file);
        List<String> names = List.of(arguments).subList(records ? 1 : 0, arguments.length);
        if (records) {
            List<String> lines = new ArrayList<>(Files.readAllLines(file, StandardCharsets.US_ASCII));
            lines.removeIf(line -> !line.startsWith("#") && isNamed(line, names));
            print(names, lines::add);
            Files.write(file, lines, StandardCharsets.US_ASCII);
        } else {
            if (names.isEmpty()) {
                System.out.println(
                        "# Hashes of the state of World: scene, steps, World.hash(). Every back end must give these.");
            }
            print(names, System.out::println);
        }
    }

    private static boolean isNamed(String name, List<String> beginnings) {
        return beginnings.isEmpty() || beginnings.stream().anyMatch(name::startsWith);
    }

    private static void print(List<String> names, Consumer<String> to) {
        for (GoldenScene scene : GoldenScene.all()) {
            if (isNamed(scene.name(), names)) {
                try (GoldenScene.Run run = scene.start(scene.builder().build())) {
                    for (int mark : MARKS) {
                        run.advanceTo(mark);
                        to.accept(String.format(
                                "%s %d %016x", scene, mark, run.world().hash()));
                    }
                }
            }
        }
    }
}
