package io.github.circles2d.bench.broadphase;

import io.github.circles2d.bench.report.BroadPhaseCharts;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Writes the page: a template, in which {@code {{word word ..}}} stands for what comes from a results folder. Within a
 * sentence these are {@code {{ms SCENE N NAME}}}, {@code {{ratio SCENE N NAME NAME}}} of two times, and a count per circle
 * such as {@code {{tests SCENE N NAME}}}, or {@code {{motion SCENE N}}}; on a line alone the name of a table, with its n if it has
 * one.
 */
final class BroadPhasePage {
    private static final String TEMPLATE = "/io/github/circles2d/bench/broad-phases.md";
    private static final Pattern PLACE = Pattern.compile("\\{\\{([^}]+)}}");

    private BroadPhasePage() {}

    /** The page for the figures of a folder. */
    static String of(ResultsFolder folder) throws IOException {
        BroadPhaseFigures figures = new BroadPhaseFigures(folder);
        StringBuilder page = new StringBuilder();
        Matcher place = PLACE.matcher(template());
        while (place.find()) {
            String[] words = place.group(1).split(" ");
            place.appendReplacement(page, Matcher.quoteReplacement(text(words, figures, folder)));
        }
        return place.appendTail(page).toString();
    }

    private static String template() throws IOException {
        try (InputStream file = BroadPhasePage.class.getResourceAsStream(TEMPLATE)) {
            return new String(file.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static String text(String[] words, BroadPhaseFigures figures, ResultsFolder folder) throws IOException {
        BroadPhaseTables tables = new BroadPhaseTables(figures);
        switch (words[0]) {
            case "machine":
                return folder.machine("processor") + ", " + folder.machine("java");
            case "folder":
                return folder.name();
            case "scenes":
                return tables.scenes();
            case "times":
                return tables.times(Integer.parseInt(words[1]));
            case "counts":
                return tables.counts(Integer.parseInt(words[1]));
            case "world":
                return tables.world();
            case "devices":
                return BroadPhaseTables.devices(folders(folder));
            case "charts":
                return charts(folder);
            case "motion":
                return figures.brief("motion_radii", words[1], words[2], BroadPhases.UNIFORM_GRID.title);
            case "ms":
                return figures.brief("median_ms", words[1], words[2], words[3]);
            case "ratio":
                return figures.ratio(words[1], words[2], words[3], words[4]);
            default:
                return figures.perCircle(words[0], words[1], words[2], words[3]);
        }
    }

    /** All machines that have figures of broad phases, by name. */
    private static List<ResultsFolder> folders(ResultsFolder one) throws IOException {
        List<ResultsFolder> folders = new ArrayList<>();
        try (Stream<Path> all = Files.list(one.path().toAbsolutePath().getParent())) {
            for (Path path : all.filter(p -> Files.exists(p.resolve(Kind.BROADPHASE.file())))
                    .sorted()
                    .toList()) {
                folders.add(ResultsFolder.open(path));
            }
        }
        return folders;
    }

    private static String charts(ResultsFolder folder) {
        return BroadPhaseCharts.SCENES.stream()
                .map(scene -> "![ns per circle and step on the scene " + scene + "](../bench/results/" + folder.name()
                        + "/" + BroadPhaseCharts.file(scene) + ".svg)")
                .collect(Collectors.joining("\n\n", "", ""));
    }
}
