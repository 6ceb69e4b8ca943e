package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.TerrainStep;
import java.util.Arrays;

/** Terrain that is made of rows, for searches, with a tree of two pieces or fewer in a leaf's parent. */
final class PieceRows {
    final TerrainStep step = new TerrainStep();

    int count() {
        return step.pieces;
    }

    /** Adds a line, and returns its number. */
    int line(int form, float x, float y, float toX, float toY, float thickness) {
        int row = add(form);
        float ex = toX - x;
        float ey = toY - y;
        float length = (float) Math.hypot(ex, ey);
        step.rows[row + PieceRow.X] = x;
        step.rows[row + PieceRow.Y] = y;
        step.rows[row + PieceRow.TX] = ex / length;
        step.rows[row + PieceRow.TY] = ey / length;
        step.rows[row + PieceRow.LENGTH] = length;
        step.rows[row + PieceRow.THICKNESS] = thickness;
        step.rows[row + PieceRow.END_X] = ex;
        step.rows[row + PieceRow.END_Y] = ey;
        return step.pieces - 1;
    }

    /** Adds an arc from one angle to a greater one. */
    int arc(boolean isInner, float x, float y, float radius, double from, double to) {
        int row = add(isInner ? PieceRow.ARC | PieceRow.SOLID_OUTSIDE : PieceRow.ARC);
        double middle = 0.5 * (from + to);
        boolean isAllAround = to - from >= 2 * Math.PI;
        step.rows[row + PieceRow.X] = x;
        step.rows[row + PieceRow.Y] = y;
        step.rows[row + PieceRow.TX] = (float) Math.cos(middle);
        step.rows[row + PieceRow.TY] = (float) Math.sin(middle);
        step.rows[row + PieceRow.LENGTH] = radius;
        step.rows[row + PieceRow.SPREAD] = isAllAround ? PieceRow.ALL_AROUND : (float) Math.cos(0.5 * (to - from));
        double start = isInner ? to : from;
        double end = isInner ? from : to;
        step.rows[row + PieceRow.START_X] = (float) (radius * Math.cos(start));
        step.rows[row + PieceRow.START_Y] = (float) (radius * Math.sin(start));
        step.rows[row + PieceRow.END_X] = (float) (radius * Math.cos(end));
        step.rows[row + PieceRow.END_Y] = (float) (radius * Math.sin(end));
        return step.pieces - 1;
    }

    /** Sets what a piece is joined to at its ends. */
    void join(int piece, int start, int end) {
        step.traits[PieceRow.traits(piece) + PieceRow.SHAPE] |= start << PieceRow.START_LOG | end << PieceRow.END_LOG;
    }

    void setKind(int piece, int kind) {
        step.traits[PieceRow.traits(piece) + PieceRow.KIND] = kind;
    }

    private int add(int shape) {
        int piece = step.pieces++;
        step.rows = Arrays.copyOf(step.rows, PieceRow.of(step.pieces));
        step.traits = Arrays.copyOf(step.traits, PieceRow.traits(step.pieces));
        step.traits[PieceRow.traits(piece) + PieceRow.SHAPE] = shape;
        return PieceRow.of(piece);
    }

    /** Makes the tree: two trees, one after the other, if there are many pieces. */
    void build() {
        int n = step.pieces;
        step.nodes = 0;
        step.boxes = new float[8 * n];
        step.links = new int[4 * n];
        if (n > 10) {
            build(0, n / 3);
            build(n / 3, n);
        } else if (n > 0) {
            build(0, n);
        }
    }

    private void build(int from, int to) {
        int node = step.nodes++;
        if (to - from == 1) {
            box(from, 4 * node);
            step.links[2 * node + 1] = from;
        } else {
            int middle = (from + to) >>> 1;
            int second = node + 1;
            build(from, middle);
            int third = step.nodes;
            build(middle, to);
            step.links[2 * node + 1] = -1;
            for (int k = 0; k < 2; k++) {
                step.boxes[4 * node + k] = Math.min(step.boxes[4 * second + k], step.boxes[4 * third + k]);
                step.boxes[4 * node + 2 + k] = Math.max(step.boxes[4 * second + 2 + k], step.boxes[4 * third + 2 + k]);
            }
        }
        step.links[2 * node] = step.nodes;
    }

    /** The box of an arc is that of its circle. */
    private void box(int piece, int at) {
        int row = PieceRow.of(piece);
        float[] rows = step.rows;
        boolean isArc = PieceRow.form(step.traits[PieceRow.traits(piece)]) == PieceRow.ARC;
        for (int k = 0; k < 2; k++) {
            double a = rows[row + PieceRow.X + k];
            double b = isArc ? a : a + rows[row + PieceRow.END_X + k];
            double wide = isArc ? rows[row + PieceRow.LENGTH] : rows[row + PieceRow.THICKNESS];
            step.boxes[at + k] = (float) (Math.min(a, b) - wide);
            step.boxes[at + 2 + k] = (float) (Math.max(a, b) + wide);
        }
    }
}
