package io.github.circles2d.world.search;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.KindField;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.queries.IdFilter;
import io.github.circles2d.world.queries.RemoteSearch;
import io.github.circles2d.world.shared.WorldParts;
import java.util.Arrays;

/** Admits the circles whose kind's category has a bit of a mask, by kinds and categories as of now. */
public final class CategoryFilter implements IdFilter {
    private final WorldParts world;
    private final CircleFields fields;
    private int mask;
    private int[] words;

    public CategoryFilter(WorldParts world, int mask) {
        this.world = world;
        this.mask = mask;
        fields = world.handles.fields();
    }

    public void setMask(int to) {
        mask = to;
    }

    @Override
    public boolean admits(int id) {
        return admitsKind(fields.getInt(CircleField.KIND, id));
    }

    boolean admitsKind(int kind) {
        return (world.kinds.get(KindField.CATEGORY, kind) & mask) != 0;
    }

    /** The kinds that it admits, a bit for each; valid until the next call. */
    int[] kinds() {
        if (words == null) {
            words = new int[RemoteSearch.KIND_WORDS];
        }
        Arrays.fill(words, 0);
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            words[kind / Integer.SIZE] |= admitsKind(kind) ? 1 << kind : 0;
        }
        return words;
    }
}
