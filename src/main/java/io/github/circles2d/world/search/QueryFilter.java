package io.github.circles2d.world.search;

import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.queries.RemoteSearch;
import java.util.Arrays;
import java.util.function.IntPredicate;

/** Admits things whose kind's category has a bit of a mask, by kinds and categories as of now, and leaves out one of them. */
public final class QueryFilter implements IntPredicate {
    private final KindTable kinds;
    private final View view;

    /** Whether the mask counts; else things of all kinds are admitted. */
    private final boolean masked;

    private final int mask;

    /** A handle, which may be stale; 0 of none. */
    private final long leftOut;

    private int[] words;

    private QueryFilter(KindTable kinds, View view, boolean masked, int mask, long leftOut) {
        this.kinds = kinds;
        this.view = view;
        this.masked = masked;
        this.mask = mask;
        this.leftOut = leftOut;
    }

    /** A null filter before admits all. */
    static QueryFilter masked(KindTable kinds, View view, QueryFilter before, int mask) {
        return new QueryFilter(kinds, view, true, mask, before == null ? 0 : before.leftOut);
    }

    /** Likewise. */
    static QueryFilter without(KindTable kinds, View view, QueryFilter before, long leftOut) {
        return new QueryFilter(kinds, view, before != null && before.masked, before == null ? 0 : before.mask, leftOut);
    }

    @Override
    public boolean test(int id) {
        return admitsKind(view.kind(id)) && id != view.find(leftOut);
    }

    private boolean admitsKind(int kind) {
        return !masked || (kinds.get(KindField.CATEGORY, kind) & mask) != 0;
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
        words[RemoteSearch.LEFT_OUT] = view.find(leftOut);
        return words;
    }
}
