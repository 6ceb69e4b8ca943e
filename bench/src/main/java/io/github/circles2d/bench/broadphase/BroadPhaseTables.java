package io.github.circles2d.bench.broadphase;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** The tables of the page. */
final class BroadPhaseTables {
    /** What World's grid is nearest to. */
    private static final BroadPhases LIKE_WORLDS = BroadPhases.HIERARCHICAL_GRID;

    private final BroadPhaseFigures figures;

    BroadPhaseTables(BroadPhaseFigures figures) {
        this.figures = figures;
    }

    /** What the scenes are, and how fast their circles move at the number of circles that all have. */
    String scenes() {
        StringBuilder text = new StringBuilder("| scene | circles | motion a step, mean radii | pairs per circle |\n");
        text.append("|---|---|--:|--:|\n");
        for (Crowds scene : Crowds.values()) {
            text.append(line(List.of(
                    scene.title,
                    scene.description,
                    figures.brief("motion_radii", scene.title, "10000", BroadPhases.UNIFORM_GRID.title),
                    figures.perCircle("pairs", scene.title, "10000", BroadPhases.UNIFORM_GRID.title))));
        }
        return text.toString().stripTrailing();
    }

    /** Milliseconds by broad phase and scene; the fastest of the library's own in bold. */
    String times(int n) {
        String size = Integer.toString(n);
        List<Crowds> scenes = Arrays.stream(Crowds.values())
                .filter(scene -> figures.has(scene.title, size))
                .toList();
        StringBuilder text = header("ms a step, n = " + Numbers.whole(n), scenes);
        for (BroadPhases kind : BroadPhases.values()) {
            if (scenes.stream().anyMatch(scene -> !figures.brief("median_ms", scene.title, size, kind.title)
                    .equals("-"))) {
                text.append(times(kind, size, scenes));
            }
        }
        return text.toString().stripTrailing();
    }

    private String times(BroadPhases kind, String n, List<Crowds> scenes) {
        List<String> cells = new ArrayList<>(List.of(kind.title));
        for (Crowds scene : scenes) {
            String millis = figures.brief("median_ms", scene.title, n, kind.title);
            cells.add(kind == figures.fastest(scene.title, n) ? "**" + millis + "**" : millis);
        }
        return line(cells);
    }

    private static StringBuilder header(String corner, List<Crowds> scenes) {
        List<String> titles = new ArrayList<>(List.of(corner));
        scenes.forEach(scene -> titles.add(scene.title));
        return new StringBuilder(line(titles))
                .append("|---|")
                .append("--:|".repeat(scenes.size()))
                .append('\n');
    }

    /** Pairs tested per circle, and the other work on two scenes. */
    String counts(int n) {
        String size = Integer.toString(n);
        List<Crowds> scenes = List.of(Crowds.values());
        StringBuilder text = header("pairs tested per circle, n = " + Numbers.whole(n), scenes);
        for (BroadPhases kind : BroadPhases.values()) {
            if (!kind.isPeer()) {
                text.append(counts(kind, "tests", size, scenes));
            }
        }
        text.append('\n').append(header("elements moved by the sort, per circle", scenes));
        text.append(counts(BroadPhases.SWEEP_INSERTION, "swaps", size, scenes));
        text.append('\n').append(header("nodes of the tree looked at, per circle", scenes));
        text.append(counts(BroadPhases.DYNAMIC_TREE, "nodes", size, scenes));
        text.append('\n').append(header("estimated bytes per circle", scenes));
        for (BroadPhases kind : BroadPhases.values()) {
            if (!kind.isPeer()) {
                text.append(counts(kind, "estimated_bytes", size, scenes));
            }
        }
        return text.toString().stripTrailing();
    }

    private String counts(BroadPhases kind, String column, String n, List<Crowds> scenes) {
        List<String> cells = new ArrayList<>(List.of(kind.title));
        scenes.forEach(scene -> cells.add(figures.perCircle(column, scene.title, n, kind.title)));
        return line(cells);
    }

    /** A step of World, the part of it that finds and makes contacts, and what the fastest broad phase could save of it. */
    String world() {
        StringBuilder text = new StringBuilder(line(List.of(
                "scene",
                "n",
                "step, ms",
                "finding and making contacts, ms",
                LIKE_WORLDS.title + ", ms",
                "fastest, ms",
                "saves at least, %",
                "at most, %")));
        text.append("|---|--:|--:|--:|--:|---|--:|--:|\n");
        for (Crowds scene : Crowds.values()) {
            for (String n : figures.sizes(scene.title)) {
                if (figures.fastest(scene.title, n) != null) {
                    text.append(world(scene, n));
                }
            }
        }
        return text.toString().stripTrailing();
    }

    private String world(Crowds scene, String n) {
        double step = figures.of("median_ms", scene.title, n, BroadPhaseBench.WORLD_STEP);
        double finding = figures.of("median_ms", scene.title, n, BroadPhaseBench.WORLD_FINDING);
        double grid = figures.of("median_ms", scene.title, n, LIKE_WORLDS.title);
        BroadPhases best = figures.fastest(scene.title, n);
        double least = figures.of("median_ms", scene.title, n, best.title);
        return line(List.of(
                scene.title,
                Numbers.whole(Long.parseLong(n)),
                Numbers.brief(step),
                Numbers.brief(finding),
                Numbers.brief(grid),
                best.title + ", " + Numbers.brief(least),
                percent((grid - least) / step),
                percent((finding - least) / step)));
    }

    private static String percent(double share) {
        return Double.isNaN(share) ? "-" : Long.toString(Math.round(100 * Math.max(0, share)));
    }

    /** The sweep on OpenCL devices, from all folders that have figures of it. */
    static String devices(List<ResultsFolder> folders) {
        StringBuilder text = new StringBuilder("| machine | device | scene | n | ms a step | ns per circle |\n");
        text.append("|---|---|---|--:|--:|--:|\n");
        for (ResultsFolder folder : folders) {
            for (Map<String, String> row : folder.table(Kind.BROADPHASE).rows()) {
                int at = row.get("broad_phase").indexOf('@');
                if (at >= 0) {
                    double millis = Numbers.parse(row.get("median_ms"));
                    long n = Long.parseLong(row.get("n"));
                    text.append(line(List.of(
                            folder.name(),
                            row.get("broad_phase").substring(at + 1),
                            row.get("scene"),
                            Numbers.whole(n),
                            Numbers.brief(millis),
                            Numbers.brief(1e6 * millis / n))));
                }
            }
        }
        return text.toString().stripTrailing();
    }

    private static String line(List<String> cells) {
        return "| " + String.join(" | ", cells) + " |\n";
    }
}
