package io.github.circles2d.playground;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;

/**
 * Where the panels over the circles are: within the canvas, and none over another. In a small window the graphs move under the others,
 * and what has no room is left out: first the graphs, then the legend, and the figures only for a message.
 *
 * @param figures the panel of figures; null if it is left out
 * @param legend what the colours mean; null if it is left out
 * @param steps the graph of the times; null if it is left out
 * @param energy the graph of the energy; null if it is left out
 * @param message the message; null if there is none
 */
record HudLayout(Rectangle figures, Rectangle legend, Rectangle steps, Rectangle energy, Rectangle message) {
    static final int MARGIN = 14;
    private static final int GAP = 8;

    /** In a narrower window there are no cards at the right. */
    static final int CARDS_FROM = 640;

    private static final Dimension GRAPH = new Dimension(240, 74);

    /** Pixels between a message and the lower end of the canvas. */
    private static final int EDGE = 4;

    private static final int MESSAGE_TOP = 144;

    private enum Graphs {
        BESIDE,
        BELOW,
        NONE
    }

    /** Lays out panels of these sizes; null for a legend or a message that is not there. */
    static HudLayout of(int width, int height, Dimension figures, Dimension legend, Dimension message, boolean graphs) {
        List<Graphs> places = graphs ? List.of(Graphs.values()) : List.of(Graphs.NONE);
        List<Dimension> legends = new ArrayList<>();
        legends.add(legend);
        if (legend != null) {
            legends.add(null);
        }
        for (Dimension shown : legends) {
            for (Graphs place : places) {
                HudLayout layout = place(width, height, figures, shown, message, place);
                if (layout.fits(width, height)) {
                    return layout;
                }
            }
        }
        Rectangle alone = message == null ? null : centred(width, MARGIN, message);
        return new HudLayout(message == null ? at(MARGIN, figures) : null, null, null, null, alone);
    }

    private static HudLayout place(
            int width, int height, Dimension figures, Dimension legend, Dimension message, Graphs graphs) {
        Rectangle panel = at(MARGIN, figures);
        Rectangle colours = legend == null ? null : at(bottom(panel), legend);
        Rectangle steps = null;
        Rectangle energy = null;
        if (graphs == Graphs.BESIDE) {
            steps = new Rectangle(new Point(width - MARGIN - GRAPH.width, MARGIN), GRAPH);
            energy = new Rectangle(new Point(steps.x, bottom(steps)), GRAPH);
        } else if (graphs == Graphs.BELOW) {
            steps = at(bottom(colours == null ? panel : colours), GRAPH);
            boolean row = width >= 2 * (MARGIN + GRAPH.width) + GAP;
            energy = row
                    ? new Rectangle(new Point(steps.x + steps.width + GAP, steps.y), GRAPH)
                    : at(bottom(steps), GRAPH);
        }
        Rectangle text = null;
        if (message != null) {
            text = centred(width, Math.min(MESSAGE_TOP, height - EDGE - message.height), message);
            for (Rectangle other : present(panel, colours, steps, energy)) {
                text.y = text.intersects(other) ? bottom(other) : text.y;
            }
        }
        return new HudLayout(panel, colours, steps, energy, text);
    }

    private static Rectangle at(int top, Dimension size) {
        return new Rectangle(MARGIN, top, size.width, size.height);
    }

    private static Rectangle centred(int width, int top, Dimension size) {
        return new Rectangle(Math.max((width - size.width) / 2, MARGIN), top, size.width, size.height);
    }

    private static int bottom(Rectangle above) {
        return above.y + above.height + GAP;
    }

    private static List<Rectangle> present(Rectangle... all) {
        List<Rectangle> present = new ArrayList<>();
        for (Rectangle one : all) {
            if (one != null) {
                present.add(one);
            }
        }
        return present;
    }

    /** What is shown. */
    List<Rectangle> panels() {
        return present(figures, legend, steps, energy, message);
    }

    /** A place at the right for a card, below what is there; null if there is none. A card keeps its width while its numbers change. */
    Rectangle right(int width, int height, Dimension size) {
        int wide = Math.max(size.width, GRAPH.width);
        Rectangle card = new Rectangle(width - MARGIN - wide, MARGIN, wide, size.height);
        for (boolean moved = true; moved; ) {
            moved = false;
            for (Rectangle other : panels()) {
                if (card.intersects(other)) {
                    card.y = bottom(other);
                    moved = true;
                }
            }
        }
        return width >= CARDS_FROM && card.y + card.height <= height - EDGE ? card : null;
    }

    private boolean fits(int width, int height) {
        Rectangle canvas = new Rectangle(width, height);
        List<Rectangle> panels = panels();
        for (int k = 0; k < panels.size(); k++) {
            if (!canvas.contains(panels.get(k)) || panels.subList(0, k).stream().anyMatch(panels.get(k)::intersects)) {
                return false;
            }
        }
        return true;
    }
}
