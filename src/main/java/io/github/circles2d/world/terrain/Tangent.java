package io.github.circles2d.world.terrain;

import io.github.circles2d.world.model.Rotation;

/** The unit direction in which a piece leaves its start, or comes to its end, in the frame of its body. */
final class Tangent {
    double x;
    double y;

    void atStart(PieceTable pieces, int piece) {
        at(pieces, piece, -1);
    }

    void atEnd(PieceTable pieces, int piece) {
        at(pieces, piece, 1);
    }

    private void at(PieceTable pieces, int piece, int end) {
        int at = PieceTable.FORM * piece;
        float[] form = pieces.form;
        if (!pieces.isArc(piece)) {
            double dx = (double) form[at + PieceTable.X2] - form[at + PieceTable.X];
            double dy = (double) form[at + PieceTable.Y2] - form[at + PieceTable.Y];
            double length = Math.sqrt(dx * dx + dy * dy);
            x = dx / length;
            y = dy / length;
            return;
        }
        // from the centre to that end, turned anticlockwise, or clockwise if the arc goes so
        int way = pieces.isSolidOutside(piece) ? -1 : 1;
        double cos = Rotation.cos(pieces.half[piece]);
        double sin = way * end * Rotation.sin(pieces.half[piece]);
        double middleX = form[at + PieceTable.MIDDLE_X];
        double middleY = form[at + PieceTable.MIDDLE_Y];
        x = way * (-1 * (middleY * cos + middleX * sin));
        y = way * (middleX * cos - middleY * sin);
    }
}
