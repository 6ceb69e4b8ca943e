package io.github.circles2d.bench.web;

import io.github.circles2d.bench.results.Table;
import java.util.List;
import java.util.Map;

/**
 * An engine and what it runs in. To add an engine for JavaScript, add a line and a module in {@code bench/web/engines}.
 *
 * @param engine its name in the table
 * @param runsIn {@link #JVM}, {@link #NODE}, {@link #CHROMIUM} or {@link #UNCHECKED}
 */
record Entrant(String engine, String runsIn) {
    static final String WORLD = "world";
    static final String JVM = "JVM";
    static final String NODE = "Node";
    static final String CHROMIUM = "Chromium";

    /** Node that looks at no bounds of arrays and at no null in WebAssembly, which no page can ask for: it tells what that costs. */
    static final String UNCHECKED = "Node without checks";

    static final List<Entrant> ALL = List.of(
            new Entrant(WORLD, JVM),
            new Entrant(WORLD, NODE),
            new Entrant(WORLD, CHROMIUM),
            new Entrant(WORLD, UNCHECKED),
            new Entrant("box2d-wasm", NODE),
            new Entrant("rapier2d-deterministic", NODE),
            new Entrant("planck", NODE),
            new Entrant("matter-js", NODE));

    boolean isWorld() {
        return engine.equals(WORLD);
    }

    /** The columns of the table that name a figure. */
    Map<String, String> key(int n) {
        return Table.columns("engine", engine, "runs_in", runsIn, "n", Integer.toString(n));
    }

    @Override
    public String toString() {
        return engine + " in " + runsIn;
    }
}
