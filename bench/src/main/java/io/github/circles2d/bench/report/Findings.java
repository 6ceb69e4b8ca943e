package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Holds the thesis's three findings against the results, device by device. */
final class Findings {
    private Findings() {}

    static Grid grid(List<ResultsFolder> folders) {
        Grid grid = Grid.ofProse("finding of the thesis", "machine, device", "held here", "because");
        for (ResultsFolder folder : folders) {
            for (String device : Tables.devices(folder)) {
                String where = folder.name() + ", " + device;
                boolean gpu = Tables.kind(folder, device).equals("GPU");
                addOrder(grid, folder, device, where, gpu);
                addBreak(grid, folder, device, where);
                Map<String, String> run = Tables.run(folder, device, 0, 15_000, "loop");
                if (!gpu && run != null && !LeftOut.is(run)) {
                    boolean ok = Tables.ok(run);
                    grid.add(
                            "strategy 0 does not run at 15,000 circles on the CPU",
                            where,
                            ok ? "no" : "yes",
                            ok
                                    ? "a step takes " + Tables.millis(run) + " ms; wrong slots are skipped"
                                    : run.get("status"));
                }
            }
        }
        return grid;
    }

    /** GPU: strategy 0 is the fastest and 2 the slowest. CPU: 1 is the fastest, by about two. At the thesis's greatest n. */
    private static void addOrder(Grid grid, ResultsFolder folder, String device, String where, boolean gpu) {
        List<Integer> sizes = Tables.sizes(folder, device).stream()
                .filter(n -> n <= 15_000
                        && IntStream.range(0, 3)
                                .allMatch(strategy -> Tables.ok(Tables.run(folder, device, strategy, n, "loop"))))
                .toList();
        if (sizes.isEmpty()) {
            return;
        }
        int n = Collections.max(sizes);
        double[] ms = new double[4];
        double[] error = new double[4];
        int fastest = 0;
        for (int strategy = 0; strategy < 4; strategy++) {
            Map<String, String> run = Tables.run(folder, device, strategy, n, "loop");
            ms[strategy] = WorldTables.number(run, "mean_ms");
            error[strategy] = WorldTables.number(run, "se_ms");
            fastest = ms[strategy] < ms[fastest] ? strategy : fastest;
        }
        boolean held = gpu ? less(ms, error, 0, 1) && less(ms, error, 1, 2) : Math.min(ms[0], ms[2]) / ms[1] >= 1.5;
        grid.add(
                gpu
                        ? "on the GPU strategy 0 is fastest and 2 is slowest"
                        : "on the CPU strategy 1 is fastest, by about two",
                where,
                held ? "yes" : "no",
                "at n = " + Numbers.whole(n) + " strategies 0, 1, 2 take " + Numbers.brief(ms[0]) + ", "
                        + Numbers.brief(ms[1]) + ", " + Numbers.brief(ms[2]) + " ms; the fastest of all four is "
                        + Tables.STRATEGIES.get(fastest));
    }

    /** Whether a is faster than b by more than twice what their standard errors leave open. */
    private static boolean less(double[] ms, double[] error, int a, int b) {
        return ms[a] + 2 * Math.hypot(error[a], error[b]) < ms[b];
    }

    private static void addBreak(Grid grid, ResultsFolder folder, String device, String where) {
        String because = "";
        boolean anyWrong = false;
        for (Map<String, String> row : folder.table(Kind.ACCURACY).rows("device", device)) {
            String slots = row.get("wrong_slots");
            boolean wrong = !slots.isEmpty() && !slots.equals("0");
            String n = Numbers.whole(row.get("circles"));
            if (row.get("n").startsWith("first")) {
                because = (wrong ? "the first wrong slot comes at n = " : "no slot is wrong up to n = ") + n + because;
            } else if (wrong && !anyWrong) {
                because = "; " + Numbers.whole(slots) + " are wrong at " + n;
            }
            anyWrong |= wrong;
        }
        if (!because.isEmpty()) {
            grid.add("strategy 0 misses collisions above 2,116 circles", where, anyWrong ? "in kind" : "no", because);
        }
    }
}
