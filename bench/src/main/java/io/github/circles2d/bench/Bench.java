package io.github.circles2d.bench;

import io.github.circles2d.bench.broadphase.BroadPhaseBench;
import io.github.circles2d.bench.games.BlobSwarm;
import io.github.circles2d.bench.games.BodyCosts;
import io.github.circles2d.bench.games.GameCosts;
import io.github.circles2d.bench.games.JointCosts;
import io.github.circles2d.bench.games.MovingCrowd;
import io.github.circles2d.bench.games.SensedCosts;
import io.github.circles2d.bench.games.SleepCosts;
import io.github.circles2d.bench.games.SurfaceCosts;
import io.github.circles2d.bench.games.TerrainCosts;
import io.github.circles2d.bench.games.TerrainLevels;
import io.github.circles2d.bench.measure.Measurements;
import io.github.circles2d.bench.physics.PhysicsBench;
import io.github.circles2d.bench.report.Charts;
import io.github.circles2d.bench.report.ConsoleTable;
import io.github.circles2d.bench.report.Page;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.web.WebBench;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.logging.Level;
import java.util.logging.Logger;

/** The main class of {@code benchmarks.jar}. */
public final class Bench {
    /** Every benchmark once, at a size at which each takes a moment; fails if one fails. */
    private static final List<String> SMOKE = List.of(
            "-foe",
            "true",
            "-wi",
            "0",
            "-i",
            "1",
            "-opi",
            "2",
            "-p",
            "n=100",
            "-p",
            "bytes=65536",
            "-p",
            "scene=packed");

    /** In this JVM: to start one for each of some forty runs takes minutes. */
    private static final List<String> WITHOUT_FORKS = List.of("-f", "0");

    /** One benchmark in a JVM of its own, with the options that all of them ask for. */
    private static final List<String> WITH_A_FORK = List.of("-f", "1", "CopyBenchmark");

    /** Held, or it would be forgotten with its level. */
    private static final Logger LIBRARY_LOG = Logger.getLogger("io.github.circles2d");

    private Bench() {}

    /**
     * Runs what the first argument names, or else measures.
     *
     * @param arguments see {@code --help}
     */
    public static void main(String[] arguments) throws IOException {
        System.setProperty("java.awt.headless", "true");
        // What the library warns of, wrong slots above all, is what the tables say.
        LIBRARY_LOG.setLevel(Level.SEVERE);
        List<String> all = List.of(arguments);
        List<String> rest = all.isEmpty() ? all : all.subList(1, all.size());
        try {
            switch (all.isEmpty() ? "" : all.get(0)) {
                case "jmh":
                    org.openjdk.jmh.Main.main(rest.toArray(new String[0]));
                    break;
                case "smoke":
                    smoke(WITHOUT_FORKS);
                    smoke(WITH_A_FORK);
                    break;
                case "physics":
                    PhysicsBench.run(rest, System.out);
                    break;
                case "broadphase":
                    BroadPhaseBench.run(rest, System.out);
                    break;
                case "games":
                    GameCosts.run(rest, System.out);
                    break;
                case "surfaces":
                    SurfaceCosts.run(rest, System.out);
                    break;
                case "sensed":
                    SensedCosts.run(rest, System.out);
                    break;
                case "sleep":
                    SleepCosts.run(rest, System.out);
                    break;
                case "terrain":
                    TerrainCosts.run(rest, System.out);
                    break;
                case "joints":
                    JointCosts.run(rest, System.out);
                    break;
                case "moves":
                    MovingCrowd.run(rest, System.out);
                    break;
                case "bodies":
                    BodyCosts.run(rest, System.out);
                    break;
                case "blobs":
                    BlobSwarm.run(rest, System.out);
                    break;
                case "levels":
                    TerrainLevels.run(rest, System.out);
                    break;
                case "web":
                    WebBench.run(rest, System.out);
                    break;
                case "table":
                    ConsoleTable.print(folder(rest), System.out);
                    break;
                case "charts":
                    drawCharts(rest);
                    break;
                case "page":
                    writePage(rest);
                    break;
                default:
                    Measurements.run(all, System.out);
            }
        } catch (IllegalArgumentException e) {
            System.err.println(e.getMessage());
            System.exit(2);
        }
    }

    private static void smoke(List<String> more) throws IOException {
        List<String> all = new ArrayList<>(SMOKE);
        all.addAll(more);
        org.openjdk.jmh.Main.main(all.toArray(new String[0]));
    }

    private static ResultsFolder folder(List<String> arguments) throws IOException {
        if (arguments.size() != 1 || !Files.isDirectory(Path.of(arguments.get(0)))) {
            throw new IllegalArgumentException("one results folder is needed, not " + arguments);
        }
        return ResultsFolder.open(Path.of(arguments.get(0)));
    }

    private static void drawCharts(List<String> arguments) throws IOException {
        if (arguments.size() == 1 && Files.exists(Path.of(arguments.get(0)).resolve(Page.MACHINES))) {
            Path results = Path.of(arguments.get(0));
            List<ResultsFolder> folders = Page.folders(results);
            for (ResultsFolder folder : folders) {
                Charts.draw(folder, System.out);
            }
            Charts.drawAll(results, folders, System.out);
        } else {
            Charts.draw(folder(arguments), System.out);
        }
    }

    private static void writePage(List<String> arguments) throws IOException {
        if (arguments.size() != 2) {
            throw new IllegalArgumentException(
                    "the folder of all results and the page are needed, such as: page bench/results docs/benchmarks.md; not "
                            + Arrays.toString(arguments.toArray()));
        }
        for (Map.Entry<Path, String> page :
                Page.all(Path.of(arguments.get(0)), Path.of(arguments.get(1))).entrySet()) {
            Files.writeString(page.getKey(), page.getValue());
            System.out.println("wrote " + page.getKey());
        }
    }
}
