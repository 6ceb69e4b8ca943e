package io.github.circles2d.world.search;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.queries.IdFilter;
import io.github.circles2d.world.queries.TerrainSearch;
import io.github.circles2d.world.shared.WorldSettings;
import io.github.circles2d.world.terrain.TerrainTables;

/** The terrain as it is now, to be searched. Pieces are on the host on every back end. */
public final class TerrainView {
    private final TerrainTables terrain;
    private final TerrainStep step;
    private final KindTable kinds;
    private final CircleFields fields;
    private final WorldSettings settings;
    private final TerrainSearch search = new TerrainSearch();

    /** Admits the pieces that stop circles of the kind. */
    private final IdFilter stopping = this::stops;

    private int kind;

    public TerrainView(
            TerrainTables terrain, TerrainStep step, KindTable kinds, CircleFields fields, WorldSettings settings) {
        this.terrain = terrain;
        this.step = step;
        this.kinds = kinds;
        this.fields = fields;
        this.settings = settings;
    }

    /** Makes the search one of what there is now. */
    TerrainSearch show() {
        terrain.makeRoom(settings.subSteps());
        terrain.refresh();
        step.kinds.update(kinds, kinds.version());
        search.show(step, settings.bounds());
        return search;
    }

    long handle(int piece) {
        return terrain.pieces.ids.handle(piece);
    }

    int kindOf(int piece) {
        return terrain.pieces.kindOf(piece);
    }

    /** Begins with questions about terrain that is in the way of circles; false if there is none. */
    public boolean look() {
        if (terrain.isThere()) {
            show();
        }
        return terrain.isThere();
    }

    /** Whether a piece that stops a circle is between a place and its centre, which is so far from there. */
    public boolean isHidden(int circle, float x, float y, float dx, float dy) {
        kind = fields.getInt(CircleField.KIND, circle);
        return search.isBlocked(x, y, dx, dy, stopping);
    }

    private boolean stops(int piece) {
        return PairTable.get(kinds.responses(), kind, kindOf(piece)) == PairTable.SOLID;
    }
}
