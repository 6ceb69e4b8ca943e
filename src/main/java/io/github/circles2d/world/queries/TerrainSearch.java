package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.TerrainStep;

/** The searches among pieces of terrain. */
public final class TerrainSearch extends BoxSearch<PieceShape> {
    private TerrainStep terrain;

    public TerrainSearch() {
        super(new PieceShape());
    }

    /** Says which terrain the searches to come look at, as it is then. */
    public void show(TerrainStep pieces, Bounds bounds) {
        terrain = pieces;
        show(pieces.nodes, pieces.boxes, pieces.links, pieces.pieces, bounds);
    }

    @Override
    void take(int piece, double byX, double byY) {
        shape.take(terrain.rows, terrain.traits, piece, isOneSided(piece), byX, byY);
    }

    private boolean isOneSided(int piece) {
        int traits = PieceRow.traits(piece);
        int form = PieceRow.form(terrain.traits[traits + PieceRow.SHAPE]);
        int kind = terrain.traits[traits + PieceRow.KIND];
        return form != PieceRow.SEGMENT || terrain.kinds.rows[KindTerrain.of(kind) + KindTerrain.ONE_WAY] != 0f;
    }
}
