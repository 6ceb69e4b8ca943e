package io.github.circles2d.world.jvm.state;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class HeapSortTest {
    @Test
    void keysAscendAsThoseOfTheLibraryDo() {
        SplittableRandom random = new SplittableRandom(7);
        for (int n = 0; n < 300; n++) {
            long[] keys = random.longs(n + 3L, n % 2 == 0 ? Long.MIN_VALUE : -5, n % 2 == 0 ? Long.MAX_VALUE : 5)
                    .toArray();
            long[] expected = keys.clone();
            Arrays.sort(expected, 0, n);
            HeapSort.ascending(keys, n);
            assertThat(keys).isEqualTo(expected);
        }
    }
}
