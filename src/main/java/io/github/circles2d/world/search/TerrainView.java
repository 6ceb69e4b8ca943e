package io.github.circles2d.world.search;

import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.queries.TerrainSearch;
import io.github.circles2d.world.shared.WorldParts;
import java.util.function.IntPredicate;

/** The terrain as it is now, to be searched. Pieces are on the host on every back end. */
public final class TerrainView implements View {
    private final WorldParts world;
    private final TerrainStep step;
    private final TerrainSearch search = new TerrainSearch();

    /** Admits the pieces that stop circles and bodies of the kind. */
    private final IntPredicate stopping = this::stops;

    private int kind;

    public TerrainView(WorldParts world) {
        this.world = world;
        step = world.input.terrain;
    }

    @Override
    public TerrainSearch show() {
        world.terrain.makeRoom(world.settings.subSteps());
        world.terrain.refresh();
        step.kinds.update(world.kinds, world.kinds.version());
        search.show(step, world.settings.bounds());
        return search;
    }

    @Override
    public long handle(int piece) {
        return world.terrain.pieces.ids.handle(piece);
    }

    @Override
    public int find(long handle) {
        return world.terrain.pieces.ids.find(handle);
    }

    @Override
    public int kind(int piece) {
        return world.terrain.pieces.kindOf(piece);
    }

    /** Begins with questions about terrain that is in the way; false if there is none. */
    public boolean look() {
        if (world.terrain.isThere()) {
            show();
        }
        return world.terrain.isThere();
    }

    /** Whether a piece that stops what is of a kind is between a place and another one, which is so far from there. */
    public boolean isHidden(int ofKind, float x, float y, float dx, float dy) {
        kind = ofKind;
        return search.isBlocked(x, y, dx, dy, stopping);
    }

    private boolean stops(int piece) {
        return PairTable.get(world.kinds.responses(), kind, kind(piece)) == PairTable.SOLID;
    }
}
