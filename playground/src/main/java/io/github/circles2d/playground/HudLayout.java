package io.github.circles2d.playground;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Where the scene and the panels beside it are: within the canvas, and none over another. The panels are a column at the right or rows
 * above the scene, whichever leaves it larger, or a line above it where both would make it small. What has no room is left out. Nothing
 * here depends on the numbers that are shown, nor on messages and the card of a circle, so the scene stays where it is while a person clicks.
 *
 * @param canvas all there is
 * @param scene the room of the scene; above it is a line for messages
 * @param arena the part of it that the arena fills
 * @param figures the panel of figures, which is a line or as high as {@link #FIGURES}
 * @param legend what the colours mean; null if it is left out
 * @param steps the graph of the times; null if it is left out
 * @param energy the graph of the energy; null if it is left out
 */
record HudLayout(
        Rectangle canvas,
        Rectangle scene,
        Rectangle arena,
        Rectangle figures,
        Rectangle legend,
        Rectangle steps,
        Rectangle energy) {
    static final int MARGIN = 14;
    static final int GAP = 8;

    /** The width of a panel. */
    static final int COLUMN = 264;

    /** The height of a line of text on a panel. */
    static final int LINE = 28;

    static final int FIGURES = 90;
    private static final int GRAPH = 74;

    /** Pixels around the scene, and below a panel. */
    private static final int EDGE = 8;

    /** Pixels of the line for messages with those around it. */
    private static final int TOP = EDGE + LINE + EDGE;

    /** A scene beside a column is as wide as this at least: messages are as wide as the scene at most. */
    private static final int LEAST_SCENE = 300;

    /** Panels beside the scene may make it smaller by this factor than a line does. */
    private static final double LEAST_SCALE = 0.8;

    /** The same while a card is open that a person has opened to look at. */
    private static final double LEAST_SCALE_FOR_CARD = 0.6;

    /** In a narrower canvas no card lies over the scene. */
    static final int CARDS_FROM = 560;

    /** Whether a person wants graphs. */
    enum Graphs {
        NO,
        IF_THERE_IS_ROOM,
        OVER_THE_SCENE
    }

    /**
     * Lays out a canvas.
     *
     * @param aspect the width of the arena over its height
     * @param legend whether there is one
     * @param card whether a card is open that stays, so that the scene may be smaller
     */
    static HudLayout of(int width, int height, double aspect, boolean legend, Graphs graphs, boolean card) {
        Rectangle canvas = new Rectangle(Math.max(width, 1), Math.max(height, 1));
        HudLayout line = line(canvas, aspect, legend, graphs == Graphs.OVER_THE_SCENE);
        for (boolean shown : choices(graphs)) {
            HudLayout column = column(canvas, aspect, legend, shown);
            HudLayout rows = rows(canvas, aspect, legend, shown);
            HudLayout larger = rows.size() > column.size() ? rows : column;
            if (larger.size() >= (card ? LEAST_SCALE_FOR_CARD : LEAST_SCALE) * line.size()) {
                return larger;
            }
        }
        return line;
    }

    private static boolean[] choices(Graphs graphs) {
        return switch (graphs) {
            case NO -> new boolean[] {false};
            case IF_THERE_IS_ROOM -> new boolean[] {true, false};
            case OVER_THE_SCENE -> new boolean[] {true};
        };
    }

    private static HudLayout column(Rectangle canvas, double aspect, boolean legend, boolean graphs) {
        int x = canvas.width - MARGIN - COLUMN;
        Rectangle scene = new Rectangle(EDGE, TOP, x - MARGIN - EDGE, canvas.height - TOP - EDGE);
        Rectangle figures = new Rectangle(x, MARGIN, COLUMN, FIGURES);
        Rectangle colours = below(figures, LINE);
        Rectangle steps = below(colours, GRAPH);
        Rectangle energy = below(steps, GRAPH);
        boolean fits = scene.width >= LEAST_SCENE && bottom(graphs ? energy : colours) <= canvas.height;
        return new HudLayout(
                canvas,
                scene,
                arena(fits ? scene : new Rectangle(), aspect, 0.5),
                figures,
                legend ? colours : null,
                graphs ? steps : null,
                graphs ? energy : null);
    }

    private static HudLayout rows(Rectangle canvas, double aspect, boolean legend, boolean graphs) {
        int columns = (canvas.width - 2 * MARGIN + GAP) / (COLUMN + GAP);
        Rectangle figures = new Rectangle(MARGIN, MARGIN, COLUMN, FIGURES);
        Rectangle colours = below(figures, LINE);
        Rectangle steps = columns < 2 ? below(colours, GRAPH) : new Rectangle(right(figures), MARGIN, COLUMN, GRAPH);
        Rectangle energy = columns < 3 ? below(steps, GRAPH) : new Rectangle(right(steps), MARGIN, COLUMN, GRAPH);
        int top = graphs ? Math.max(bottom(colours), bottom(energy)) : bottom(colours);
        Rectangle scene = new Rectangle(EDGE, top + TOP - EDGE, canvas.width - 2 * EDGE, canvas.height - top - TOP);
        boolean fits = columns > 0 && scene.height > 0;
        return new HudLayout(
                canvas,
                scene,
                arena(fits ? scene : new Rectangle(), aspect, 0),
                figures,
                legend ? colours : null,
                graphs ? steps : null,
                graphs ? energy : null);
    }

    private static HudLayout line(Rectangle canvas, double aspect, boolean legend, boolean graphs) {
        Rectangle scene = new Rectangle(EDGE, TOP, canvas.width - 2 * EDGE, canvas.height - TOP - EDGE);
        int right = canvas.width - MARGIN - COLUMN;
        boolean both = legend && right > MARGIN + COLUMN;
        Rectangle steps = new Rectangle(right, TOP + EDGE, COLUMN, GRAPH);
        Rectangle energy = below(steps, GRAPH);
        boolean fits = graphs && right >= MARGIN && bottom(energy) <= canvas.height;
        return new HudLayout(
                canvas,
                scene,
                arena(scene, aspect, 0.5),
                new Rectangle(MARGIN, EDGE, (both ? right - GAP : canvas.width - MARGIN) - MARGIN, LINE),
                both ? new Rectangle(right, EDGE, COLUMN, LINE) : null,
                fits ? steps : null,
                fits ? energy : null);
    }

    /** As much of a room as an arena can fill, in its middle; from above there is such a part of what is left. */
    private static Rectangle arena(Rectangle room, double aspect, double part) {
        int height = (int) Math.max(Math.min(room.height, room.width / aspect), 0);
        int width = (int) Math.max(Math.min(room.width, room.height * aspect), 0);
        return new Rectangle(
                room.x + (room.width - width) / 2, room.y + (int) ((room.height - height) * part), width, height);
    }

    private static Rectangle below(Rectangle above, int height) {
        return new Rectangle(above.x, bottom(above), above.width, height);
    }

    private static int bottom(Rectangle above) {
        return above.y + above.height + GAP;
    }

    private static int right(Rectangle left) {
        return left.x + left.width + GAP;
    }

    /** A measure of how large the arena is; 0 if it has no place. */
    private double size() {
        return Math.hypot(arena.width, arena.height);
    }

    /** What is shown. */
    List<Rectangle> panels() {
        return Stream.of(figures, legend, steps, energy)
                .filter(panel -> panel != null)
                .toList();
    }

    /** The width that a message may have. */
    int messageWidth() {
        return Math.max(scene.width - 2 * EDGE, 1);
    }

    /** The place of a message, on the line above the scene. Where the figures are a line, it takes the place of that. */
    Rectangle message(Dimension size) {
        int y = Math.max(Math.min(scene.y - EDGE - LINE, canvas.height - size.height), 0);
        return new Rectangle(scene.x + Math.max((scene.width - size.width) / 2, 0), y, size.width, size.height);
    }

    /** What may give way to a card, from the last to the first. */
    private List<Rectangle> graphs() {
        return Stream.of(energy, steps).filter(graph -> graph != null).toList();
    }

    /**
     * Places for cards of these heights: beside the arena, if need be in place of graphs, else over it at the right; null for a height of 0, and
     * where there is no place.
     */
    Rectangle[] cards(int... heights) {
        Rectangle[] cards = new Rectangle[heights.length];
        List<Rectangle> before = new ArrayList<>();
        for (int k = 0; k < heights.length; k++) {
            cards[k] = heights[k] == 0 ? null : card(heights[k], before);
            if (cards[k] != null) {
                before.add(cards[k]);
            }
        }
        return cards;
    }

    private Rectangle card(int height, List<Rectangle> cards) {
        List<Rectangle> taken = new ArrayList<>(cards);
        taken.add(new Rectangle(scene.x, scene.y - EDGE - LINE, scene.width, LINE)); // a message may come
        taken.addAll(panels());
        Rectangle over = canvas.width < CARDS_FROM ? null : place(height, taken);
        taken.add(arena);
        Rectangle card = place(height, taken);
        for (Rectangle graph : graphs()) {
            if (card == null) {
                taken.remove(graph);
                card = place(height, taken);
            }
        }
        return card == null ? over : card;
    }

    /** The first place from the right in which nothing is in the way; null if there is none. */
    private Rectangle place(int height, List<Rectangle> taken) {
        for (int x = canvas.width - MARGIN - COLUMN; x >= MARGIN; x -= COLUMN + GAP) {
            Rectangle card = fall(x, height, taken);
            if (card != null) {
                return card;
            }
        }
        return canvas.width < COLUMN + 2 * MARGIN ? null : fall(MARGIN, height, taken);
    }

    private Rectangle fall(int x, int height, List<Rectangle> taken) {
        Rectangle card = new Rectangle(x, MARGIN, COLUMN, height);
        for (boolean moved = true; moved; ) {
            moved = false;
            for (Rectangle other : taken) {
                if (card.intersects(other)) {
                    card.y = bottom(other);
                    moved = true;
                }
            }
        }
        return card.y + height + EDGE <= canvas.height ? card : null;
    }
}
