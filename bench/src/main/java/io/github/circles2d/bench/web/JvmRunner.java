package io.github.circles2d.bench.web;

import io.github.circles2d.bench.engines.Engine;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.engines.Motion;
import io.github.circles2d.bench.measure.SceneFiles;
import io.github.circles2d.bench.measure.Series;
import io.github.circles2d.bench.results.Statistics;
import io.github.circles2d.scenes.Scene;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Runs World on one thread of the JVM, and obeys the benchmark as {@code commands.mjs} does in Node. */
final class JvmRunner {
    private JvmRunner() {}

    /**
     * Makes a run for each line of the input.
     *
     * @param arguments n, and the file for the end state
     */
    public static void main(String[] arguments) throws IOException {
        Scene scene = WebBench.SERIES.scene(Integer.parseInt(arguments[0]));
        Path state = Path.of(arguments[1]);
        BufferedReader lines = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        say("ready Java " + System.getProperty("java.version"));
        try (Engine engine = Engines.worldJvm(1)) {
            while (lines.readLine() != null) {
                Statistics micros = run(engine, scene);
                Motion end = new Motion(scene.size());
                engine.read(end);
                Files.write(state, SceneFiles.bytes(end));
                say("ok " + micros.median() + " " + micros.mean());
            }
        }
    }

    private static Statistics run(Engine engine, Scene scene) {
        engine.load(scene);
        double[] micros = new double[Series.STEPS];
        for (int step = -WebBench.SERIES.skipped; step < micros.length; step++) {
            long from = System.nanoTime();
            engine.step();
            engine.finish();
            if (step >= 0) {
                micros[step] = (System.nanoTime() - from) / 1e3;
            }
        }
        return Statistics.of(micros);
    }

    private static void say(String line) {
        System.out.println(Runner.MARK + line);
        System.out.flush();
    }
}
