package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.engines.Motion;
import io.github.circles2d.bench.results.Table;
import io.github.circles2d.scenes.Scene;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Scenes and end states as files, for engines outside Maven. A scene is the number of circles as an int, then x, y, radius and mass
 * of each as floats; an end state is x, y, vx and vy of each, in the scene's units. All little-endian. The arena is the unit square,
 * and every circle starts at rest.
 */
public final class SceneFiles {
    /** The list of the scenes. */
    static final String LIST = "scenes.csv";

    /** For engines that think in metres: the mean radius that they should see. */
    private static final double MEAN_RADIUS_METRES = 0.5;

    private SceneFiles() {}

    /** Writes the scenes that are asked for, and the list. */
    static void write(Options options, PrintStream out) throws IOException {
        Path folder = options.write();
        Files.createDirectories(folder);
        Table list = new Table(
                List.of("file"),
                List.of("file", "series", "n", "arena_metres", "gravity", "restitution", "skipped", "steps"));
        for (Series series : options.scenes()) {
            for (int n : options.sizes(series.sizes())) {
                Scene scene = series.scene(n);
                Path file = folder.resolve(series.title + "-" + n + ".scene");
                Files.write(file, bytes(scene));
                Map<String, String> row =
                        Table.columns("file", file.getFileName().toString(), "series", series.title);
                row.put("n", Integer.toString(n));
                row.put("arena_metres", Float.toString((float) arenaMetres(scene)));
                row.put("gravity", Float.toString(-scene.gravityY()));
                row.put("restitution", Float.toString(scene.restitution()));
                row.put("skipped", Integer.toString(series.skipped));
                row.put("steps", Integer.toString(Series.STEPS));
                list.put(row);
                out.println("wrote " + file);
            }
        }
        list.save(folder.resolve(LIST));
        out.println("wrote " + folder.resolve(LIST));
    }

    /** The width of the arena in metres, for an engine that thinks in metres. */
    public static double arenaMetres(Scene scene) {
        double sum = 0;
        for (int i = 0; i < scene.size(); i++) {
            sum += scene.radius(i);
        }
        return MEAN_RADIUS_METRES * scene.size() / sum;
    }

    /** A scene as its file has it. */
    public static byte[] bytes(Scene scene) {
        ByteBuffer bytes = ByteBuffer.allocate(4 + 16 * scene.size()).order(ByteOrder.LITTLE_ENDIAN);
        bytes.putInt(scene.size());
        for (int i = 0; i < scene.size(); i++) {
            bytes.putFloat(scene.x(i)).putFloat(scene.y(i));
            bytes.putFloat(scene.radius(i)).putFloat(scene.mass(i));
        }
        return bytes.array();
    }

    /** An end state as its file has it. */
    public static byte[] bytes(Motion end) {
        int n = end.x.length;
        ByteBuffer bytes = ByteBuffer.allocate(16 * n).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < n; i++) {
            bytes.putFloat(end.x[i]).putFloat(end.y[i]);
            bytes.putFloat(end.vx[i]).putFloat(end.vy[i]);
        }
        return bytes.array();
    }

    /**
     * Reads an end state.
     *
     * @throws IllegalArgumentException if the file has another length than n circles give
     */
    public static Motion endState(Path file, int n) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
        if (bytes.remaining() != 16L * n) {
            throw new IllegalArgumentException(
                    file + " has " + bytes.remaining() + " bytes; the end state of " + n + " circles has " + 16L * n);
        }
        Motion end = new Motion(n);
        for (int i = 0; i < n; i++) {
            end.x[i] = bytes.getFloat();
            end.y[i] = bytes.getFloat();
            end.vx[i] = bytes.getFloat();
            end.vy[i] = bytes.getFloat();
        }
        return end;
    }
}
