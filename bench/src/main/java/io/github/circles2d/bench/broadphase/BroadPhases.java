package io.github.circles2d.bench.broadphase;

import java.util.Arrays;
import java.util.function.Supplier;

/** The broad phases that are compared, by the names of the table. To add one, add a line. */
enum BroadPhases {
    ALL_PAIRS("all-pairs", 10_000, AllPairs::new),
    UNIFORM_GRID("uniform-grid", UniformGrid::new),
    HIERARCHICAL_GRID("hierarchical-grid", HierarchicalGrid::new),
    SWEEP_INSERTION("sweep-insertion", () -> new SweepAndPrune(SweepAndPrune.Sorting.INSERTION)),
    SWEEP_RADIX("sweep-radix", () -> new SweepAndPrune(SweepAndPrune.Sorting.RADIX)),
    SWEEP_SUBDIVIDED("sweep-subdivided", SubdividedSweepAndPrune::new),
    DYNAMIC_TREE("dynamic-tree", 100_000, DynamicTree::new),
    NEIGHBOUR_LIST("neighbour-list", NeighbourList::new),
    DYN4J_TREE("dyn4j-tree", 10_000, Dyn4jBroadPhase::new),
    JBOX2D_TREE("jbox2d-tree", 10_000, Jbox2dBroadPhase::new);

    /** In the table. */
    final String title;

    /** The greatest number of circles that it is measured with unless it is asked for: more would take most of the whole time. */
    final int greatest;

    private final Supplier<BroadPhase> factory;

    BroadPhases(String title, Supplier<BroadPhase> factory) {
        this(title, Integer.MAX_VALUE, factory);
    }

    BroadPhases(String title, int greatest, Supplier<BroadPhase> factory) {
        this.title = title;
        this.greatest = greatest;
        this.factory = factory;
    }

    BroadPhase create() {
        return factory.get();
    }

    /** Whether it is that of another engine. */
    boolean isPeer() {
        return this == DYN4J_TREE || this == JBOX2D_TREE;
    }

    /**
     * Finds one by its name.
     *
     * @throws IllegalArgumentException with all names if there is none of this one
     */
    static BroadPhases named(String title) {
        return Arrays.stream(values())
                .filter(phase -> phase.title.equals(title))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("there is no broad phase " + title + "; there are "
                        + String.join(
                                ", ", Arrays.stream(values()).map(p -> p.title).toList())));
    }
}
