package io.github.circles2d.toy;

import io.github.circles2d.Edge;
import io.github.circles2d.World;
import java.util.ArrayList;
import java.util.List;

/** What of a world the page does not draw as it is. */
final class Undrawn {
    private static final int KINDS = 256;

    private Undrawn() {}

    /** A sentence for each; empty if there is nothing. */
    static String of(World world) {
        List<String> lines = new ArrayList<>();
        if (world.edgeX() == Edge.WRAP || world.edgeY() == Edge.WRAP) {
            lines.add("What crosses an edge that wraps is shown on one side only.");
        }
        boolean sensors = false;
        boolean oneWay = false;
        for (int kind = 0; kind < KINDS; kind++) {
            sensors |= world.kind(kind).isSensor();
            oneWay |= world.kind(kind).isOneWay();
        }
        if (sensors) {
            lines.add("Sensors look like what is solid.");
        }
        if (oneWay) {
            lines.add("Ground that is passed from behind looks like other ground.");
        }
        return String.join(" ", lines);
    }
}
