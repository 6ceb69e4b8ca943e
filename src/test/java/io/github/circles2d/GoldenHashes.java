package io.github.circles2d;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The hashes on record: by scene and number of steps. {@link #main} computes them anew on the JVM back end; if scenes are named, only theirs,
 * and without the line above all, so that they can be added to the file.
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

    /** Prints the file. */
    public static void main(String[] arguments) {
        PrintStream out = System.out;
        List<String> names = List.of(arguments);
        if (names.isEmpty()) {
            out.println("# Hashes of the state of World: scene, steps, World.hash(). Every back end must give these.");
        }
        for (GoldenScene scene : GoldenScene.all()) {
            if (!names.isEmpty() && !names.contains(scene.name())) {
                continue;
            }
            try (GoldenScene.Run run = scene.start(scene.builder().build())) {
                for (int mark : MARKS) {
                    run.advanceTo(mark);
                    out.printf("%s %d %016x%n", scene, mark, run.world().hash());
                }
            }
        }
    }
}
