package io.github.circles2d.world.search;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.queries.IdFilter;
import io.github.circles2d.world.queries.RemoteSearch;
import io.github.circles2d.world.shared.WorldParts;
import java.util.Arrays;

/**
 * Admits the circles, pieces or bodies whose kind's category has a bit of a mask, by kinds and categories as of now, and leaves out one circle or
 * body.
 */
public final class CircleFilter implements IdFilter {
    private final WorldParts world;
    private final CircleFields fields;

    /** Whether the mask counts; else circles of all kinds are admitted. */
    private final boolean masked;

    private int mask;

    /** A handle, which may be stale; 0 of none. */
    private final long leftOut;

    private int[] words;

    private CircleFilter(WorldParts world, boolean masked, int mask, long leftOut) {
        this.world = world;
        this.masked = masked;
        this.mask = mask;
        this.leftOut = leftOut;
        fields = world.handles.fields();
    }

    /** Admits by a mask alone. */
    public CircleFilter(WorldParts world, int mask) {
        this(world, true, mask, 0);
    }

    /** A null filter admits all. */
    static CircleFilter masked(WorldParts world, CircleFilter before, int mask) {
        return new CircleFilter(world, true, mask, before == null ? 0 : before.leftOut);
    }

    /** A null filter admits all. */
    static CircleFilter without(WorldParts world, CircleFilter before, long leftOut) {
        return new CircleFilter(world, before != null && before.masked, before == null ? 0 : before.mask, leftOut);
    }

    public void setMask(int to) {
        mask = to;
    }

    @Override
    public boolean admits(int id) {
        return admitsKind(fields.getInt(CircleField.KIND, id)) && id != leftOut();
    }

    /** Whether a body of a kind is admitted. */
    public boolean admitsBody(int body, int kind) {
        return admitsKind(kind) && body != world.rigids.ids.find(leftOut);
    }

    boolean admitsKind(int kind) {
        return !masked || (world.kinds.get(KindField.CATEGORY, kind) & mask) != 0;
    }

    /** The id of the circle that is left out; -1 if there is none. */
    private int leftOut() {
        return world.handles.find(leftOut);
    }

    /** What {@link RemoteSearch} takes; valid until the next call. */
    int[] words() {
        if (words == null) {
            words = new int[RemoteSearch.FILTER_WORDS];
        }
        Arrays.fill(words, 0);
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            words[kind / Integer.SIZE] |= admitsKind(kind) ? 1 << kind : 0;
        }
        words[RemoteSearch.LEFT_OUT] = leftOut();
        return words;
    }
}
