package io.github.circles2d.world.jvm;

import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** The broad phase as its definition says it: every pair is tested, with no grid. */
final class AllPairs {
    private final SavedState s;
    private final float[] speculativeDistance;
    private final int[] level;

    private AllPairs(SavedState s, GridLevels levels, StepConstants k) {
        this.s = s;
        speculativeDistance = new float[s.circles];
        level = new int[s.circles];
        for (int i = 0; i < s.circles; i++) {
            float r = s.circle[4 * i + 2];
            float px = CircleMath.plan(s.motion[4 * i + 2], k.dt, isStatic(i) ? 0 : k.fallX);
            float py = CircleMath.plan(s.motion[4 * i + 3], k.dt, isStatic(i) ? 0 : k.fallY);
            speculativeDistance[i] = CircleMath.speculativeDistance(r, CircleMath.norm(px, py));
            level[i] = levels.level(r);
        }
    }

    /** The pairs that the next step of a state lists as contacts, lower id above higher, in ascending order. */
    static List<Long> of(SavedState s, GridLevels levels, StepConstants k) {
        return new AllPairs(s, levels, k).list();
    }

    private boolean isStatic(int i) {
        return s.traits[4 * i] == 0;
    }

    private boolean near(int i, int j) {
        float dx = s.circle[4 * j] - s.circle[4 * i];
        float dy = s.circle[4 * j + 1] - s.circle[4 * i + 1];
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
                int hash = CircleMath.pairHash(s.id[i], s.id[j]);
                if (near(i, j) && CircleMath.keeps(hash, Math.min(candidates[i], candidates[j]))) {
                    pairs.add((long) s.id[i] << 32 | s.id[j]);
                }
            }
        }
        Collections.sort(pairs);
        return pairs;
    }
}
