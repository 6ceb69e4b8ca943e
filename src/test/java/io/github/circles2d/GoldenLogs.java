package io.github.circles2d;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Writes logs of the scenes on record, for platforms that cannot run these tests: a browser replays them, and must come to the hashes
 * on record. The file {@code expected.txt} has a line for each log: its number of steps, "same" and the hash.
 */
final class GoldenLogs {
    /** {@link GoldenScene#cost} times steps that one log may take. */
    private static final long AFFORDABLE = 150_000;

    /** Steps between two hashes in a log. */
    private static final int HASH_EVERY = 100;

    private GoldenLogs() {}

    /** Writes to the folder that is named. */
    public static void main(String[] arguments) throws IOException {
        Path folder = Files.createDirectories(Path.of(arguments[0]));
        GoldenHashes golden = GoldenHashes.load();
        try (PrintStream expected =
                new PrintStream(folder.resolve("expected.txt").toFile(), StandardCharsets.US_ASCII)) {
            int number = 100; // three digits, so that the files have the order of the lines
            for (GoldenScene scene : GoldenHashes.scenes()) {
                int steps = 0;
                for (int mark : GoldenHashes.MARKS) {
                    steps = (long) mark * scene.cost() <= AFFORDABLE ? mark : steps;
                }
                write(scene, steps, folder.resolve(number++ + "-" + scene + ".log"));
                expected.printf("%d same %x%n", steps, golden.hash(scene, steps));
            }
        }
    }

    private static void write(GoldenScene scene, int steps, Path file) throws IOException {
        try (OutputStream out = Files.newOutputStream(file);
                World world = scene.builder().threads(1).build();
                Recording recording = new Recording(world, out, HASH_EVERY)) {
            scene.start(world).advanceTo(steps);
            if (recording.steps() != steps) {
                throw new IllegalStateException("the log of " + scene + " has " + recording.steps() + " steps");
            }
        }
    }
}
