package io.github.circles2d.world.reads;

import io.github.circles2d.world.circles.IdTable;
import io.github.circles2d.world.shared.WorldParts;

/** Reads which pieces of terrain, bodies or joints there are. */
public final class IdReads {
    private final WorldParts world;
    private final IdTable ids;

    public IdReads(WorldParts world, IdTable ids) {
        this.world = world;
        this.ids = ids;
    }

    /** Joints that have broken are not there. */
    private void look() {
        world.guard.enter();
        try (world.guard) {
            if (ids == world.joints.table.ids) {
                world.pending.settleJoints();
            }
        }
    }

    public boolean contains(long handle) {
        look();
        return ids.find(handle) >= 0;
    }

    public int size() {
        look();
        return ids.size();
    }

    /** One more than the greatest id that one of them has had. */
    public int limit() {
        world.guard.check();
        return ids.end();
    }

    /** The handle of the one that has an id; 0 if there is none. */
    public long handle(int id) {
        look();
        return ids.handleOrNone(id);
    }
}
