package io.github.circles2d.world.jvm;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.model.Cells;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Velocity;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The broad phase as its definition says it: every pair is tested, with no grid. */
final class AllPairs {
    private final SavedState s;
    private final float[] speculativeDistance;
    private final int[] level;
    private final float periodX;
    private final float periodY;

    /** Continuous collision has shortened the speculative distance of some circles. */
    private AllPairs(SavedState s, JvmPipeline pipeline) {
        this.s = s;
        periodX = pipeline.constants.arena.periodX();
        periodY = pipeline.constants.arena.periodY();
        speculativeDistance = new float[s.circles];
        level = new int[s.circles];
        Map<Integer, Integer> slotOf = new HashMap<>();
        for (int slot = 0; slot < s.circles; slot++) {
            slotOf.put(pipeline.state.id[slot], slot);
        }
        StepConstants k = pipeline.constants;
        for (int i = 0; i < s.circles; i++) {
            float r = s.circle[4 * i + 2];
            float px = Velocity.plan(s.motion[4 * i + 2], k.dt, isStatic(i) ? 0 : k.fallX);
            float py = Velocity.plan(s.motion[4 * i + 3], k.dt, isStatic(i) ? 0 : k.fallY);
            if (isStatic(i)) {
                px = CircleMath.within(s.circle[4 * i], px, k.bounds.minX(), k.bounds.maxX());
                py = CircleMath.within(s.circle[4 * i + 1], py, k.bounds.minY(), k.bounds.maxY());
            }
            float path = CircleMath.length(px, py);
            float most = Paths.speculativeDistance(r, path);
            int slot = slotOf.get(s.id[i]);
            speculativeDistance[i] = slot < pipeline.state.awake ? pipeline.grid.speculativeDistance[slot] : most;
            assertThat(speculativeDistance[i]).isBetween(Paths.speculativeDistance(r, 0), most);
            if (isStatic(i) || !Paths.isFast(path, r)) {
                assertThat(speculativeDistance[i]).isIn(Paths.speculativeDistance(r, 0), most);
            }
            level[i] = pipeline.levels.level(r);
        }
    }

    /** The pairs that the step behind a state listed as contacts, lower id above higher, in ascending order. */
    static List<Long> of(SavedState s, JvmPipeline pipeline) {
        return new AllPairs(s, pipeline).list();
    }

    private boolean isStatic(int i) {
        return s.traits[4 * i] == 0;
    }

    private boolean near(int i, int j) {
        float dx = CircleMath.shortWay(s.circle[4 * j] - s.circle[4 * i], periodX);
        float dy = CircleMath.shortWay(s.circle[4 * j + 1] - s.circle[4 * i + 1], periodY);
        float limit = speculativeDistance[i] + speculativeDistance[j];
        return dx * dx + dy * dy < limit * limit && !(isStatic(i) && isStatic(j));
    }

    private List<Long> list() {
        int[] candidates = new int[s.circles];
        for (int i = 0; i < s.circles; i++) {
            for (int j = i + 1; j < s.circles; j++) {
                if (near(i, j)) {
                    candidates[i] += level[i] >= level[j] ? 1 : 0;
                    candidates[j] += level[j] >= level[i] ? 1 : 0;
                }
            }
        }
        List<Long> pairs = new ArrayList<>();
        for (int i = 0; i < s.circles; i++) {
            for (int j = i + 1; j < s.circles; j++) {
                int hash = Cells.pairHash(s.id[i], s.id[j]);
                if (near(i, j) && Cells.keeps(hash, Math.min(candidates[i], candidates[j]))) {
                    pairs.add((long) s.id[i] << 32 | s.id[j]);
                }
            }
        }
        Collections.sort(pairs);
        return pairs;
    }
}
