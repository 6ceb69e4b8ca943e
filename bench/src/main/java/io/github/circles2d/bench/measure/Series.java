package io.github.circles2d.bench.measure;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.Collectors;

/** A scene at growing n, and which of its steps count. The first is the headline. To add one, add a line. */
public enum Series {
    PACKED_SIMILAR(
            "packed-similar",
            "like radii, fill 0.62, gravity times sqrt(1250 / n), so that n alone changes; steps 100 to 200",
            100,
            n -> Scenes.packedSimilar(n, Scenes.SEED)),
    MIXED_10(
            "mixed-10",
            "radii log-uniform over 1:10, fill 0.62, mass as r squared; steps 100 to 200",
            100,
            n -> Scenes.mixed(n, 10, Scenes.SEED)),
    MIXED_100(
            "mixed-100",
            "radii log-uniform over 1:100, fill 0.62, mass as r squared; steps 100 to 200",
            100,
            n -> Scenes.mixed(n, 100, Scenes.SEED)),
    OVER_FULL(
            "over-full",
            "packed, whose gravity stays the same: the larger n, the more layers press on the lowest, until they give way; steps"
                    + " 300 to 400",
            300,
            n -> Scenes.packed(n, Scenes.SEED)),
    BOULDER(
            "boulder",
            "one circle of a thousand radii on a bed of grains; steps 100 to 200",
            100,
            n -> Scenes.boulder(n, Scenes.SEED));

    /** Steps that count. */
    public static final int STEPS = 100;

    private static final List<Integer> SIZES = List.of(1250, 10_000, 100_000, 1_000_000);

    private static final List<Integer> BOULDER_SIZES = List.of(100_000);

    /** In files and tables. */
    public final String title;

    /** In a few words. */
    public final String description;

    /** Steps before those that count. */
    public final int skipped;

    private final IntFunction<Scene> factory;

    Series(String title, String description, int skipped, IntFunction<Scene> factory) {
        this.title = title;
        this.description = description;
        this.skipped = skipped;
        this.factory = factory;
    }

    /** The scene. */
    public Scene scene(int n) {
        return factory.apply(n);
    }

    /** The published sizes. */
    public List<Integer> sizes() {
        return this == BOULDER ? BOULDER_SIZES : SIZES;
    }

    /**
     * Finds one by its title.
     *
     * @throws IllegalArgumentException with all titles if there is none of this one
     */
    static Series titled(String title) {
        return Arrays.stream(values())
                .filter(series -> series.title.equals(title))
                .findFirst()
                .orElseThrow(
                        () -> new IllegalArgumentException("there is no series " + title + "; there are " + titles()));
    }

    /** All titles, with commas. */
    static String titles() {
        return Arrays.stream(values()).map(series -> series.title).collect(Collectors.joining(","));
    }
}
