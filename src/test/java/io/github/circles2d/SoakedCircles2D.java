package io.github.circles2d;

import io.github.circles2d.opencl.Session;
import java.lang.reflect.Field;
import java.util.Arrays;
import java.util.SplittableRandom;

/**
 * Circles2D by one indexing after the other, in an engine that is initialised again and again and now and then made anew.
 * Circles in pairs, each pair in a place of its own, must end with the same bits every time; circles in a crowd, which is
 * resolved in a race, must stay finite.
 */
final class SoakedCircles2D implements Soak.Soaked {
    private static final float TIME_STEP = 1 / 60f;
    private static final int STEPS = 100;

    /** Pairs in a row, and rows. */
    private static final int PLACES = 16;

    private static final int ROUNDS_OF_AN_ENGINE = 4;

    private static final PairIndexing[] INDEXINGS = {
        PairIndexing.LOOKUP_TABLE, PairIndexing.ROW_SEARCH, PairIndexing.EXACT, PairIndexing.AUTO
    };

    private final SplittableRandom random = new SplittableRandom(1);
    private final Field session = Circles2D.class.getDeclaredField("session");
    private Circles2D physics = new Circles2D(false);

    /** How the pairs ended the first time. */
    private float[][] control;

    private long rounds;
    private long steps;
    private long engines = 1;

    SoakedCircles2D() throws NoSuchFieldException {
        session.setAccessible(true);
    }

    @Override
    public void round() throws Exception {
        for (PairIndexing indexing : INDEXINGS) {
            addPairs();
            float[][] pairs = run(indexing, 0);
            if (control == null) {
                control = pairs;
            }
            if (!Arrays.deepEquals(control, pairs)) {
                throw new AssertionError(
                        "after " + steps + " steps, by " + indexing + ", pairs end otherwise than at first");
            }
            addCrowd();
            for (float[] row : run(indexing, -1)) {
                for (float value : row) {
                    if (!Float.isFinite(value)) {
                        throw new AssertionError("after " + steps + " steps, by " + indexing + ", there is a " + value);
                    }
                }
            }
        }
        if (++rounds % ROUNDS_OF_AN_ENGINE == 0) {
            physics.close();
            physics = new Circles2D(false);
            engines++;
        }
    }

    private float[][] run(PairIndexing indexing, float gravity) throws Exception {
        physics.init(TIME_STEP, indexing, 0.5f, new float[] {0, gravity});
        float[][] circles = null;
        for (int k = 0; k < STEPS; k++) {
            circles = physics.loop();
        }
        steps += STEPS;
        return circles;
    }

    /** Two circles that meet, bounce and part, in each place. */
    private void addPairs() {
        physics.clear();
        for (int i = 0; i < PLACES * PLACES; i++) {
            float x = (i % PLACES + 0.5f) / PLACES;
            float y = (i / PLACES + 0.5f) / PLACES;
            physics.addCircle(x - 0.012f, y, 0.01f, 1, 0.005f, 0);
            physics.addCircle(x + 0.012f, y, 0.01f, 2, -0.005f, 0);
        }
    }

    private void addCrowd() {
        physics.clear();
        int n = 200 + random.nextInt(600);
        for (int i = 0; i < n; i++) {
            float x = random.nextInt(1 << 24) * 0x1p-24f;
            float y = random.nextInt(1 << 24) * 0x1p-24f;
            physics.addCircle(x, y, 0.01f, 1 + i % 10);
        }
    }

    @Override
    public long steps() {
        return steps;
    }

    @Override
    public long engines() {
        return engines;
    }

    @Override
    public long bytes() throws IllegalAccessException {
        return ((Session) session.get(physics)).allocatedBytes();
    }

    @Override
    public void close() {
        physics.close();
    }
}
