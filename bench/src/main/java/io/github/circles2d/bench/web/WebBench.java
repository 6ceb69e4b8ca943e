package io.github.circles2d.bench.web;

import io.github.circles2d.bench.measure.SceneFiles;
import io.github.circles2d.bench.measure.Series;
import io.github.circles2d.bench.report.WebCharts;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.scenes.Scene;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Lets all entrants run in turns, size by size, and keeps their figures. */
public final class WebBench {
    /** The scene. */
    static final Series SERIES = Series.PACKED_SIMILAR;

    private static final int QUICK_ROUNDS = 2;

    private final WebOptions options;
    private final ResultsFolder folder;
    private final PrintStream out;

    private WebBench(WebOptions options, PrintStream out) throws IOException {
        this.options = options;
        this.out = out;
        folder = ResultsFolder.open(options.out());
    }

    /**
     * Runs what the arguments ask for.
     *
     * @throws IllegalArgumentException with a sentence for the user if they are wrong
     */
    public static void run(List<String> arguments, PrintStream out) throws IOException {
        WebOptions options = WebOptions.parse(arguments);
        if (options.help()) {
            out.println(WebOptions.HELP);
            return;
        }
        WebBench bench = new WebBench(options, out);
        for (int n : options.sizes()) {
            bench.measure(n);
        }
        WebCharts.draw(bench.folder, out);
    }

    private void measure(int n) throws IOException {
        Scene scene = SERIES.scene(n);
        Path files = Files.createTempDirectory("circles2d-web");
        List<Turns> all = new ArrayList<>();
        try {
            Path sceneFile = files.resolve("scene");
            Files.write(sceneFile, SceneFiles.bytes(scene));
            for (Entrant entrant : options.entrants()) {
                Path state = files.resolve("state-" + all.size());
                List<String> command = options.command(entrant, n, sceneFile, settings(scene), state);
                all.add(new Turns(entrant, scene, command, state, options.quick() ? QUICK_ROUNDS : Turns.MOST_RUNS));
            }
            boolean another = true;
            while (another) {
                another = false;
                for (Turns turns : all) {
                    another |= turns.take();
                }
            }
            requireTheSameBits(all);
            for (Turns turns : all) {
                folder.put(Kind.WEB, turns.row());
                out.println(turns);
            }
        } finally {
            for (Turns turns : all) {
                turns.close();
            }
            delete(files);
        }
    }

    /** What a scene file does not have, as JSON. */
    private static String settings(Scene scene) {
        return "{\"gravity\":" + -scene.gravityY() + ",\"restitution\":" + scene.restitution() + ",\"skipped\":"
                + SERIES.skipped + ",\"steps\":" + Series.STEPS + ",\"arenaMetres\":" + SceneFiles.arenaMetres(scene)
                + "}";
    }

    private static void requireTheSameBits(List<Turns> all) {
        List<String> hashes = all.stream()
                .filter(turns -> turns.entrant().isWorld())
                .map(Turns::hash)
                .distinct()
                .toList();
        if (hashes.size() > 1) {
            throw new IllegalStateException("World ended in other states: " + hashes);
        }
    }

    private static void delete(Path files) throws IOException {
        try (DirectoryStream<Path> all = Files.newDirectoryStream(files)) {
            for (Path file : all) {
                Files.delete(file);
            }
        }
        Files.delete(files);
    }
}
