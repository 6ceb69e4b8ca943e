package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.io.PrintStream;
import java.util.List;
import java.util.Map;

/** Prints a results folder. */
public final class ConsoleTable {
    private ConsoleTable() {}

    /** Prints our table beside the thesis's, the wrong slots, the engines, and what failed or did not fit. */
    public static void print(ResultsFolder folder, PrintStream out) {
        for (String device : Tables.devices(folder)) {
            String title = "Figure 3 of the thesis (" + Figure3.device(Tables.kind(folder, device)) + ") and here ("
                    + device + "): mean ms a step with read-back";
            print(title, Tables.figure3(folder, device), out);
        }
        print("Slots that the computed indexing maps wrongly", Tables.accuracy(List.of(folder)), out);
        for (String device : Tables.devices(folder)) {
            print("Kernels and the memory's roof, " + device, Tables.roof(folder, device), out);
        }
        for (String device : Tables.devices(folder)) {
            print("Transfers, " + device, WorldTables.transfers(folder, device), out);
        }
        print("World on the scene packed: mean ms a step", WorldTables.steps(folder), out);
        print("World while circles come and go: mean ms a step", WorldTables.storms(folder), out);
        for (String engine : WorldTables.engines(folder)) {
            print("Stages of " + engine + " and the memory's roof", WorldTables.stages(folder, engine), out);
        }
        for (String scene : List.of("packed", "thesis")) {
            print("Engines on the scene " + scene, Tables.peers(folder, scene), out);
        }
        Grid missing = Grid.ofProse("Without a figure");
        for (Kind kind : List.of(Kind.COPY, Kind.ACCURACY, Kind.STRATEGIES, Kind.TRANSFER, Kind.WORLD, Kind.PEERS)) {
            for (Map<String, String> row : folder.table(kind).rows()) {
                if (!Tables.ok(row)) {
                    missing.add(String.join(" ", folder.table(kind).key(row)) + ": " + row.get("status"));
                }
            }
        }
        out.print(missing.isEmpty() ? "" : "\n" + missing.text());
    }

    private static void print(String title, Grid grid, PrintStream out) {
        if (!grid.isEmpty()) {
            out.println("\n" + title);
            out.print(grid.text());
        }
    }
}
