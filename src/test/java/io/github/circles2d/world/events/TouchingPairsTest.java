package io.github.circles2d.world.events;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Pairs that come and go, against a map of them. */
class TouchingPairsTest {
    private static final int IDS = 60;

    private final TouchingPairs pairs = new TouchingPairs();
    private final Map<List<Integer>, Long> expected = new HashMap<>();

    private void add(int lower, int higher, long handle) {
        pairs.ensure(pairs.count + 1);
        pairs.add(lower, higher, handle, -handle);
        expected.put(List.of(lower, higher), handle);
    }

    private void check() {
        assertThat(pairs.count).isEqualTo(expected.size());
        for (int lower = 0; lower < IDS; lower++) {
            for (int higher = lower + 1; higher < IDS; higher++) {
                int pair = pairs.find(lower, higher);
                assertThat(pair != TouchingPairs.NONE).isEqualTo(expected.containsKey(List.of(lower, higher)));
                if (pair != TouchingPairs.NONE) {
                    assertThat(pair).isBetween(0, pairs.count - 1);
                    assertThat(pairs.lower(pair)).isEqualTo(lower);
                    assertThat(pairs.higher(pair)).isEqualTo(higher);
                }
            }
        }
    }

    @Test
    void pairsAreFoundAsLongAsTheyAreThere() {
        Random random = new Random(1);
        for (int round = 0; round < 40; round++) {
            for (int k = 0; k < 60; k++) {
                int lower = random.nextInt(IDS - 1);
                int higher = lower + 1 + random.nextInt(IDS - 1 - lower);
                if (!expected.containsKey(List.of(lower, higher))) {
                    add(lower, higher, k);
                }
            }
            check();
            List<List<Integer>> all = new ArrayList<>(expected.keySet());
            for (int k = 0; k < 50 && !all.isEmpty(); k++) {
                List<Integer> gone = all.remove(random.nextInt(all.size()));
                pairs.remove(pairs.find(gone.get(0), gone.get(1)));
                expected.remove(gone);
            }
            check();
        }
        pairs.clear();
        expected.clear();
        check();
        add(3, 7, 1);
        check();
    }
}
